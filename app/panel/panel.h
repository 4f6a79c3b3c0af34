#pragma once
// What a shell shows over the picture: start screen, panel, help, marks and labels. Dear ImGui lays it out; what comes
// of it is the engine's plain Overlay. Knows no window system. The panel stands beside the molecule, or as a sheet
// below it where the window is narrow or tall, and folds away. For a mouse everything is small and the panel stands
// open; for fingers every widget is 48 points high, a button opens the panel, and a drag in it scrolls.

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/annotation/system_font.h"
#include "app/panel/controls.h"
#include "app/panel/recording.h"
#include "app/viewer/parts.h"
#include "app/viewer/viewer.h"

struct ImGuiContext;
struct ImVec2;

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
    std::function<void(const std::string&)> open;            ///< a file or another input; empty: the viewer's open()
    std::function<void(const std::string&)> add;             ///< the same, beside what is open
    std::function<const std::vector<RecentFile>&()> recent;  ///< the latest first
    std::string lastView;                                    ///< what can be gone on with; empty: nothing
    std::function<void()> goOn;                              ///< with that
    std::function<std::string(const char*)> freeName;        ///< for a picture, by extension
    std::function<void(const PictureWish&)> savePicture;
    std::function<void()> copyPicture;
    /// A film; of key views, if its motion goes through them.
    std::function<void(const RecordingWish&, const std::vector<SavedView>&)> record;
    std::function<RecordingState()> recording;
    std::function<void()> stopRecording;
    bool videos = false;  ///< what .mp4 and .webm need is there
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

class Panel {
public:
    Panel(double pixelsPerPoint, PanelHost host, PanelHand hand = PanelHand::mouse);
    ~Panel();
    Panel(const Panel&) = delete;

    /// Glyphs of the font, for the engine.
    OverlayGlyphs glyphs() const;
    /// Whether there are other glyphs than those that were taken last: the next frame is drawn with them.
    bool glyphsChanged() const { return glyphsChanged_; }
    void setInsets(const Insets& insets) { insets_ = insets, restless_ = 2; }

    // Events, in pixels of the window
    void pointer(glm::dvec2 at);
    void button(MouseButton button, bool down);
    void wheel(double steps);
    void character(char32_t c);
    void key(SpecialKey key, bool down, Modifiers with = {});
    /// A letter with Ctrl, for a field that is being typed in.
    void shortcut(char32_t letter);
    /// Whether the pointer or the keys are the panel's, not the molecule's.
    bool ownsPointer() const;
    bool ownsKeys() const;
    /// A finger, in points. @returns whether it is the panel's; who got the beginning gets the rest
    bool touch(const TouchEvent& event);
    /// Forgets the finger, as after a pause.
    void forgetTouch() { finger_.reset(), down_[0] = false; }

    /// Shows the panel, or puts it away altogether.
    void togglePanel();
    void toggleHelp() { help_ = !help_, restless_ = 2; }
    void showStart() { start_ = true, restless_ = 2; }
    /// Where a picture is to be saved, as a dialog was told; its end decides the format.
    void setSavePath(const std::string& path);
    /// What a dialog was told to open, or was dropped, stands beside what is open.
    bool opensTogether() const;
    /// What was typed into the field of a name, where the system's keyboard is asked for it.
    void typed(const std::string& name, const std::string& text);
    void showSave() { saving_ = true, restless_ = 2; }
    void showRecord() { recording_ = static_cast<bool>(host_.record), restless_ = 2; }
    /// Keeps what is seen as a key of a film; forgets those of other molecules.
    void keepView(const Viewer& viewer, double now);
    std::size_t keptViews() const;
    bool helpOpen() const { return help_; }
    bool panelOpen() const { return shown_ == Shown::open; }
    /// Closes what lies over everything: help, save, start. @returns whether something did
    bool closeTop();

    /// Whether something in the panel still reacts to what the user did.
    bool restless() const { return restless_ > 0; }
    /// Lays everything out. @returns good until the next call
    const Overlay* draw(Viewer& viewer, PixelSize size, double now);
    /// What the last frame showed.
    const std::vector<Control>& controls() const;

    enum class Page { look, parts, select, labels, more };
    void showPage(Page page) { page_ = page, restless_ = 2; }
    enum class Brightness { system, dark, light };
    void setBrightness(Brightness brightness);

private:
    class Turn;
    enum class Shown { open, folded, hidden };
    struct Rectangle {
        float left, top, right, bottom;
        bool holds(glm::dvec2 p) const { return p.x >= left && p.x < right && p.y >= top && p.y < bottom; }
    };
    struct Finger {
        std::int64_t id;
        glm::dvec2 start, at;  // points
        bool scrolls;
        bool holds;  ///< what it touched follows it, as a mouse that is held
    };
    float scale() const { return static_cast<float>(pixelsPerPoint_); }
    bool forFingers() const { return hand_ == PanelHand::fingers; }
    bool occupies(glm::dvec2 pixel) const;
    void mapKeys();
    void beginWindow(const char* name, int moreFlags);
    Rectangle freeRoom() const;
    void followFinger();
    void glide(float passed);
    void pressButtons();
    void endKeys();
    void remember();
    void collect();
    void readTexts(const Viewer& viewer);
    void addFonts();

    // panel.cpp
    void placePanel();
    // chrome.cpp
    void drawMenuButton();
    void drawPanel(Viewer& viewer, double now);
    void drawHeader(const Viewer& viewer);
    void drawTools(const Viewer& viewer);
    void drawTabs();
    void drawScrim(const char* below);
    bool beginCard(const char* name, const char* title, float points, bool closable = true);
    void endCard();
    void endGrown();
    // pages
    void drawLookPage(SavedView& look, const Viewer& viewer);
    void drawStyles(SavedView& look);
    void drawColors(SavedView& look);
    void drawEffects(SavedView& look, double radius);
    void drawPartsPage(SavedView& look, Viewer& viewer);
    void drawAssemblies(SavedView& look, const Molecule& molecule);
    void drawFit(const SavedView& look, const std::string& input, const std::string& onto);
    void drawPart(SavedView& look, const Part& part, std::size_t number);
    void drawStyleChoice(SavedView& look, const Part& part, float width);
    void drawColorChoice(SavedView& look, const Part& part);
    void drawSequence(const Part& part, const SavedView& look, Viewer& viewer);
    void drawLetter(int i, ImVec2 place, ImVec2 size, bool chosen, bool hovered);
    void drawResidueNumber(int i, ImVec2 right, float line);
    void selectResidues(Viewer& viewer);
    void drawSelectPage(SavedView& look, Viewer& viewer);
    void drawSelectionActions(SavedView& look, const std::string& selection);
    void drawRules(SavedView& look);
    void drawRuleEditor(Rule& rule);
    void drawLabelsPage(SavedView& look, Viewer& viewer);
    void drawMorePage(Viewer& viewer, double now);
    void drawForDevelopers(Viewer& viewer, double now);
    // play_bar.cpp
    void drawPlayBar(Viewer& viewer, double now);
    void drawPlayRow(Viewer& viewer, double now);
    void drawPlayOptions(Viewer& viewer, double now);
    // over everything
    void drawStart(Viewer& viewer, double now);
    void drawRecent(const RecentFile& recent, float width, Viewer& viewer, double now);
    void beginProgress(const char* name);
    void drawReading(Viewer& viewer, double now);
    void drawFailure(Viewer& viewer);
    void tellFailure(Viewer& viewer);
    void drawSave(const Viewer& viewer);
    void drawHelp();
    // record.cpp
    void drawRecord(Viewer& viewer, double now);
    void drawKeyViews(Viewer& viewer, double now);
    void drawFilmLength(const Viewer& viewer);
    void preview(Viewer& viewer, double now);
    void drawRecording();
    void drawQuestion(Viewer& viewer, double now);
    void openInput(const std::string& input, Viewer& viewer, double now);
    // marks.cpp
    void drawWords(const Viewer& viewer);
    float legendRoom(const PlacedWords& words, const View& view, double size) const;
    void drawAnnotations(const Annotations& annotations);
    float drawStatus(const std::string& text, float bottom, bool strong);
    void drawHint(const std::string& text);
    void noteStatus(const std::string& text, const ImVec2& low, const ImVec2& high, float lines);

    struct State;  // what only some pages need
    ImGuiContext* context_ = nullptr;
    PanelHost host_;
    PanelHand hand_;
    double pixelsPerPoint_, last_ = 0;
    Insets insets_;
    Shown shown_;
    Page page_ = Page::look;
    Brightness brightness_ = Brightness::system;
    bool help_ = false, licences_ = false, start_ = false, saving_ = false, recording_ = false, developers_ = false;
    bool keyboard_ = false;  // keys go about in the panel
    int restless_ = 2;
    mutable bool glyphsChanged_ = false;
    bool down_[3] = {false, false, false}, pressed_[3] = {false, false, false};
    std::optional<Finger> finger_;
    std::deque<glm::dvec2> taps_;      // pixels: not yet pressed
    std::optional<glm::dvec2> tap_;    // pressed in the last frame
    float scroll_ = 0;                 // pixels that the finger dragged since the last frame
    float dragged_ = 0, gliding_ = 0;  // pixels a second: of the finger, and that the list goes on with
    std::vector<Rectangle> occupied_;
    Rectangle window_{}, panel_{};  // pixels: all, and the panel where it is open
    bool sheet_ = false;
    Rectangle playBar_{};
    float bar_ = 0;         // pixels that the bar for playing takes, with its margins
    bool editing_ = false;  // a control that is held changed the look
    std::string ruleError_;
    std::optional<Aim> aim_;           // that a button asked for in this frame
    std::optional<SavedView> wanted_;  // the same, of which the molecules are read anew
    std::unique_ptr<State> state_;
    Overlay overlay_;
};

}  // namespace nacre::app
