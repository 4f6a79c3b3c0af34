#pragma once
// The user interface over the picture: start screen, panel, help, marks and labels. Dear ImGui lays it out; the result
// is the engine's Overlay. Independent of the window system. The panel is beside the molecule, or a sheet below it in
// narrow or tall windows, and can be folded. With a mouse, widgets are small and the panel is open; with touch, widgets
// are 48 points high, a button opens the panel, and dragging scrolls it.

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/annotation/system_font.h"
#include "app/panel/controls.h"
#include "app/panel/panel_input.h"
#include "app/viewer/viewer.h"

struct ImGuiContext;

namespace nacre::app {

enum class PanelHand { mouse, fingers };

/// A recently opened file.
struct RecentFile {
    std::string input, name;
    std::uint32_t width = 0, height = 0;  ///< of its picture; 0: none
    std::vector<std::uint32_t> pixels;    ///< sRGB-coded, red in the lowest byte
};

/// Samples by their displayed names. The start screen shows the first as its banner.
constexpr std::pair<const char*, const char*> kSampleNames[] = {
    {"DNA", "sample:dna"}, {"Glucose", "sample:glucose"}, {"Buckyball", "sample:buckyball"}};

/// Options for saving an image.
struct PictureWish {
    PixelSize size;
    bool transparent = false;
    std::string path;
    int dpi = 0;          ///< stored in the file; 0: none
    bool marked = false;  ///< with the outline of the selection
};

using PathChosen = std::function<void(const std::string& path)>;

/// Functions of the shell for its panel. Empty ones are not offered.
struct PanelHost {
    std::function<void(ViewerCommand)> run;  ///< runs a command that the user clicked
    std::function<void()> openDialog;        ///< opens the system's dialog, and then the chosen file
    /// Opens the system's dialog for a file to write. `chosen` is called later, unless the user cancels.
    std::function<void(const std::string& title, const std::string& suggested, PathChosen chosen)> saveDialog;
    bool browses = false;  ///< no system dialogs: the panel shows its own
    /// Opens inputs, or adds them to the current scene; empty: Viewer::open()
    std::function<void(const std::vector<std::string>& inputs, bool beside)> open;
    std::function<const std::vector<RecentFile>&()> recent;   ///< most recent first
    std::function<const std::vector<RecentFile>&()> samples;  ///< with their pictures; empty: only names
    std::string lastView;                                     ///< last session, for the start screen; empty: none
    std::function<void()> goOn;                               ///< restores it
    std::function<std::string(const char*)> freeName;         ///< for a picture, by extension
    std::function<void(const PictureWish&)> savePicture;
    std::function<void()> copyPicture;
    bool savesScenes = false;  ///< ViewerCommand::saveScene works
    /// Records a movie; through key views, if its motion uses them.
    std::function<void(const RecordingWish&, const std::vector<PictureDescription>&)> record;
    std::function<RecordingState()> recording;
    std::function<void()> stopRecording;
    std::function<void()> quit;         ///< without asking
    std::function<void()> saveAndQuit;  ///< asks where to save the view, then quits
    bool videos = false;                ///< the encoder of .mp4 and .webm is available
    std::function<const char*()> clipboard;
    std::function<void(const char*)> setClipboard;
    /// Shows the system's keyboard for a field; typed() gets the result. For touch.
    std::function<void(const std::string& name, const std::string& text)> askText;
    bool downloads = false;                   ///< "pdb:1BNA" can be downloaded
    bool captures = false;                    ///< frames can be captured for RenderDoc
    bool shakes = false;                      ///< shaking the device undoes
    bool scalesText = false;                  ///< Panel::textPercent() has an effect
    std::function<std::string()> statistics;  ///< for developers, in lines
    std::function<void()> copyReport;         ///< copies the device report to the clipboard
    bool dark = true;                         ///< the system's theme
    FindFont fontWith;                        ///< for characters that the panel's font lacks
};

/// Shared state of the panel: PanelInput, and the pages (panel_state.h).
struct PanelState;

class Panel {
public:
    static constexpr int kMostTextPercent = 200;
    /// @param textPercent  size of its text and controls, 100 to kMostTextPercent
    Panel(double pixelsPerPoint, PanelHost host, PanelHand hand = PanelHand::mouse, int textPercent = 100);
    ~Panel();
    Panel(const Panel&) = delete;

    /// Pointer, keys and touches.
    PanelInput& input() { return *input_; }
    /// Glyphs of the font, for the engine.
    OverlayGlyphs glyphs() const;
    /// Whether the glyphs changed since they were last taken: the next frame uses them.
    bool glyphsChanged() const;
    void setInsets(const Insets& insets);

    /// Shows or hides the whole panel.
    void togglePanel();
    void toggleHelp();
    void showStart();
    void showSave();
    void showPalette();
    void showRecord();
    /// Sets the path for a picture from a dialog; its ending decides the format.
    void setSavePath(const std::string& path);
    /// Whether files from a dialog are added to the current scene.
    bool opensTogether() const;
    /// Asks whether dropped files replace the current scene or are added to it.
    void askToOpen(const std::vector<std::string>& paths);
    /// Asks where a file is written. @param suggested  a whole path @param chosen  not called if the user cancels
    void askWhere(const std::string& title, const std::string& suggested, PathChosen chosen);
    /// Adds the current view as a keyframe of a movie; drops keyframes of other molecules.
    void keepView(const Viewer& viewer);
    std::size_t keptViews() const;
    /// Number of keyframes not yet recorded in a movie.
    std::size_t unrecordedViews() const;
    /// Asks whether to quit. @param unsaved  what would be lost, as sentences
    void askToQuit(const std::string& unsaved);
    bool asksToQuit() const;
    bool helpOpen() const;
    bool panelOpen() const;
    /// Closes the topmost card: help, save, start, quit. @returns whether there was one
    bool closeTop();

    /// Whether the panel still reacts to input.
    bool restless() const;
    /// Lays out everything. @returns valid until the next call
    const Overlay* draw(Viewer& viewer, PixelSize size, double now);
    /// Controls of the last frame.
    const std::vector<Control>& controls() const;

    /// The labels of the pages, as on their tabs.
    static std::vector<std::string_view> pages();
    void showPage(std::string_view label);
    enum class Brightness { system, dark, light };
    void setBrightness(Brightness brightness);
    Brightness brightness() const;
    /// A dark theme has a dark background, until the user chooses another one.
    void setDarkCanvas(bool on);
    bool darkCanvas() const;
    /// The text size that the user chose: the shell creates another panel with it.
    int textPercent() const;
    std::string_view page() const;

private:
    ImGuiContext* context_ = nullptr;
    std::unique_ptr<PanelState> state_;
    std::unique_ptr<PanelInput> input_;
    double last_ = 0;
    Overlay overlay_;
};

}  // namespace nacre::app
