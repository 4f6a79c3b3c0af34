#pragma once
// What a shell shows over the picture: start screen, panel, help, marks and labels. Dear ImGui lays it out; what comes
// of it is the engine's plain Overlay. Knows no window system. The panel stands beside the molecule, or as a sheet
// below it where the window is narrow or tall, and folds away. For a mouse everything is small and the panel stands
// open; for fingers every widget is 48 points high, a button opens the panel, and a drag in it scrolls.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/annotation/system_font.h"
#include "app/panel/controls.h"
#include "app/panel/panel_input.h"
#include "app/panel/recording.h"
#include "app/viewer/viewer.h"

struct ImGuiContext;

namespace nacre::app {

enum class PanelHand { mouse, fingers };

/// A file that was open before.
struct RecentFile {
    std::string input, name;
    std::uint32_t width = 0, height = 0;  ///< of its picture; 0: none is kept
    std::vector<std::uint32_t> pixels;    ///< sRGB-coded, red in the lowest byte
};

/// A picture for a file.
struct PictureWish {
    PixelSize size;
    bool transparent = false;
    std::string path;
    int dpi = 0;  ///< that the file says; 0: none
};

/// What a shell lends to its panel. What is empty is not offered.
struct PanelHost {
    std::function<void(ViewerCommand)> run;                  ///< the commands that the user clicks
    std::function<void()> openDialog;                        ///< the system's, which then opens what it is told
    std::function<void(const std::string&)> saveDialog;      ///< the system's, from a path; setSavePath() hears of it
    bool browses = false;                                    ///< it has no such dialogs: the panel shows its own
    std::function<void(const std::string&)> open;            ///< a file or another input; empty: the viewer's open()
    std::function<void(const std::string&)> add;             ///< the same, beside what is open
    std::function<const std::vector<RecentFile>&()> recent;  ///< the latest first
    std::string lastView;                                    ///< what can be gone on with; empty: nothing
    std::function<void()> goOn;                              ///< with that
    std::function<std::string(const char*)> freeName;        ///< for a picture, by extension
    std::function<void(const PictureWish&)> savePicture;
    std::function<void()> copyPicture;
    /// A film; of key views, if its motion goes through them.
    std::function<void(const RecordingWish&, const std::vector<PictureDescription>&)> record;
    std::function<RecordingState()> recording;
    std::function<void()> stopRecording;
    std::function<void()> quit;  ///< without asking
    bool videos = false;         ///< what .mp4 and .webm need is there
    std::function<const char*()> clipboard;
    std::function<void(const char*)> setClipboard;
    /// Shows the system's keyboard for a field; typed() hears of it. For fingers.
    std::function<void(const std::string& name, const std::string& text)> askText;
    bool downloads = false;                   ///< "pdb:1BNA" can be had
    bool captures = false;                    ///< a frame can be captured for RenderDoc
    bool shakes = false;                      ///< who shakes the device takes something back
    std::function<std::string()> statistics;  ///< for developers, in lines
    std::function<void()> copyReport;         ///< of the device, to the clipboard
    bool dark = true;                         ///< what the system asks for
    FindFont fontWith;                        ///< for characters that the panel's font has not
};

/// What the panel's parts share: PanelInput, and the pages (panel_state.h).
struct PanelState;

class Panel {
public:
    Panel(double pixelsPerPoint, PanelHost host, PanelHand hand = PanelHand::mouse);
    ~Panel();
    Panel(const Panel&) = delete;

    /// What pointer, keys and fingers tell it.
    PanelInput& input() { return *input_; }
    /// Glyphs of the font, for the engine.
    OverlayGlyphs glyphs() const;
    /// Whether there are other glyphs than those that were taken last: the next frame is drawn with them.
    bool glyphsChanged() const;
    void setInsets(const Insets& insets);

    /// Shows the panel, or puts it away altogether.
    void togglePanel();
    void toggleHelp();
    void showStart();
    void showSave();
    void showRecord();
    /// Where a picture is to be saved, as a dialog was told; its end decides the format.
    void setSavePath(const std::string& path);
    /// What a dialog was told to open, or was dropped, stands beside what is open.
    bool opensTogether() const;
    /// Keeps what is seen as a key of a film; forgets those of other molecules.
    void keepView(const Viewer& viewer);
    std::size_t keptViews() const;
    /// Those that no movie was recorded of.
    std::size_t unrecordedViews() const;
    /// Asks whether to quit. @param unsaved  what is lost by it, as sentences
    void askToQuit(const std::string& unsaved);
    bool asksToQuit() const;
    bool helpOpen() const;
    bool panelOpen() const;
    /// Closes what lies over everything: help, save, start, quit. @returns whether something did
    bool closeTop();

    /// Whether something in the panel still reacts to what the user did.
    bool restless() const;
    /// Lays everything out. @returns good until the next call
    const Overlay* draw(Viewer& viewer, PixelSize size, double now);
    /// What the last frame showed.
    const std::vector<Control>& controls() const;

    enum class Page { look, parts, select, labels, more };
    void showPage(Page page);
    enum class Brightness { system, dark, light };
    void setBrightness(Brightness brightness);

private:
    ImGuiContext* context_ = nullptr;
    std::unique_ptr<PanelState> state_;
    std::unique_ptr<PanelInput> input_;
    double last_ = 0;
    Overlay overlay_;
};

}  // namespace nacre::app
