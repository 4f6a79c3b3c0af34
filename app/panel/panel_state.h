#pragma once
// Shared state of the panel: what is open, its layout, and data that pages keep between frames; and the pages,
// functions that draw one frame.

#include <mutex>

#include "app/annotation/layout.h"
#include "app/panel/fonts.h"
#include "app/panel/panel.h"
#include "app/panel/widgets.h"
#include "app/viewer/parts.h"

namespace nacre::app {

/// Dear ImGui works on one global context: panels on other threads wait for their turn.
class Turn {
public:
    explicit Turn(ImGuiContext* context) : lock_(turns) { ImGui::SetCurrentContext(context); }
    static inline std::recursive_mutex turns;

private:
    std::lock_guard<std::recursive_mutex> lock_;
};

/// Pixels of the window.
struct Rectangle {
    float left = 0, top = 0, right = 0, bottom = 0;
    float width() const { return right - left; }
    float height() const { return bottom - top; }
    ImVec2 middle() const { return {(left + right) / 2, (top + bottom) / 2}; }
    bool holds(glm::dvec2 p) const { return p.x >= left && p.x < right && p.y >= top && p.y < bottom; }
};

/// The panel's own file dialog (browse.cpp).
struct Browser {
    struct Entry {
        std::string name;
        bool folder;
    };
    bool open = false;
    std::string title;
    const char* button = "Open";  ///< that confirms the path
    PathChosen chosen;            ///< receives a path to write; empty: a file is opened
    bool saving() const { return static_cast<bool>(chosen); }
    std::string folder, typed;
    bool listed = false;  ///< the entries are up to date
    std::vector<Entry> entries;
    std::size_t more = 0;  ///< entries not listed
    std::string error;
};

/// The sequence of a chain among the parts.
struct SequenceState {
    std::string part;  ///< the selection of the part whose sequence is shown
    std::vector<std::uint32_t> residues;
    std::string input;                  ///< as Part::input
    int dragFrom = -1, dragTo = -1;     ///< of residues
    bool focused = false;               ///< arrow keys move along it
    int step = 0;                       ///< of the arrow key
    bool extends = false;               ///< extends the selection
    std::vector<std::uint32_t> colors;  ///< by residue of the molecule
    std::uint64_t colorsScene = 0;      ///< number of the scene with these colours
};

struct Option;

/// Commands and options, found by words (palette.cpp).
struct CommandPalette {
    bool open = false;
    std::string sought;
    int chosen = 0;                  ///< index among the found rows
    const Option* option = nullptr;  ///< if set, `sought` is its value
};

/// An image to save.
struct SaveForm {
    int preset = 0, format = 0;
    int widthMm = 160, heightMm = 120, dpi = 300;
    bool transparent = false, marked = false;
    std::string path;
};

/// A movie to record, and its preview.
struct MovieForm {
    int motion = 0, size = 0, format = 0;
    float seconds = 0;  ///< 0: the motion's duration
    bool loop = false, transparent = false;
    std::string path;
    std::vector<PictureDescription> keys;  ///< its keyframes
    bool keysRecorded = true;
    std::size_t previewed = 0;  ///< keyframe shown in the preview, from 1; 0: no preview
    double previewDue = 0;      ///< time of the next one
};

struct PanelState {
    PanelState(PanelHost lent, double scale, bool fingers, int text)
        : host(std::move(lent)),
          pixelsPerPoint(scale),
          ui(darkTheme(), static_cast<float>(scale * text / 100), fingers),
          foreign(host.fontWith) {
        textPercent = text;
        shown = fingers ? Shown::folded : Shown::open;
        ui.askText = host.askText;
    }

    PanelHost host;
    double pixelsPerPoint;
    Widgets ui;
    ForeignGlyphs foreign;
    bool glyphsChanged = false;
    int restless = 2;       ///< frames that Dear ImGui still needs
    float scroll = 0;       ///< pixels that the finger dragged since the last frame
    bool keyboard = false;  ///< keys move between controls

    // Which parts are open
    enum class Shown { open, folded, hidden } shown;
    std::string page{Panel::pages().front()};
    Panel::Brightness brightness = Panel::Brightness::system;
    bool help = false, licences = false, start = false, saving = false, recording = false, developers = false;
    bool quitting = false;
    bool empty = false;                ///< nothing is open: the start screen stays
    bool asks = false;                 ///< the viewer has a question
    std::vector<std::string> dropped;  ///< files to replace or join the current scene, as the user decides
    Browser browser;
    CommandPalette palette;
    std::optional<ImVec2> context;  ///< pixels: position of a right click's menu
    float contextHeight = 0;        ///< pixels, in the last frame
    bool over() const { return *topCard() != 0; }
    /// The card with the keyboard focus: the window's name; "" for none.
    const char* topCard() const;
    int opening = 0;          ///< frames until the top card's field has the focus
    std::string focusedCard;  ///< the top card of the last frame
    /// A card was opened: keys wait until it has the focus.
    void opened() { opening = 4, restless = 5; }
    /// @param what  title of the card  @param suggested  a file, whose folder is shown; empty: the current folder
    /// @param chosen  receives the path of a file to write; empty: a file is opened
    /// @param button  that confirms the path
    void browse(const std::string& what, const std::string& suggested, PathChosen chosen, const char* button);
    void askWhere(const std::string& what, const std::string& suggested, PathChosen chosen,
                  const char* button = "Save");
    void setSavePath(const std::string& path);
    bool closeTop();
    void toggle();
    void setBrightness(Panel::Brightness to);
    void takeStyle();
    void followCanvas(Viewer& viewer, double now);
    const Theme* styled = nullptr;  ///< of Dear ImGui's style
    bool largeTargets = false;      ///< of Dear ImGui's style
    bool darkCanvas = false;        ///< a dark theme has a dark background
    bool canvasDue = false;         ///< the background has yet to follow the theme
    bool canvasIsOurs = false;      ///< the dark background is from the theme, not the user's
    int textPercent = 100;

    // Layout
    Insets insets;
    Rectangle window{}, panel{};  ///< whole window, and the open panel
    bool sheet = false;           ///< the panel is below the molecule
    Rectangle playBar{};
    float bar = 0;         ///< height of the play bar with its margins, pixels
    float legendRoom = 0;  ///< width at the right reserved for the legend, pixels
    std::vector<Rectangle> occupied;
    bool occupies(glm::dvec2 pixel) const;
    /// The window without the panel.
    Rectangle freeRoom() const;

    bool editing = false;   ///< a control being dragged changed the look
    std::string ruleError;  ///< why the typed text was refused
    /// Applies typed text: while it is invalid, the previous value stays. @param take  @throws std::exception
    template <typename Take>
    void take(Take&& take) {
        try {
            take();
            ruleError.clear();
        } catch (const std::exception& error) {
            ruleError = error.what();
        }
    }
    std::optional<Aim> aim;                    ///< requested by a button in this frame
    std::optional<PictureDescription> wanted;  ///< requested likewise; its molecules are read again
    std::string input;                         ///< on the start screen
    bool together = false;                     ///< add the next file to the current scene
    std::string selection;                     ///< text in the field
    std::string selected;                      ///< the viewer's selection when the field was last filled
    std::string title;
    bool typingTitle = false;
    WordMemory wordMemory;
    // Parts of the molecule
    std::shared_ptr<const Molecule> molecule;
    std::optional<ResidueFacts> facts;  ///< once there is a molecule
    std::vector<Part> parts;
    std::vector<std::uint32_t> partOfResidue;              ///< for each residue its part, or kNoPart
    std::vector<std::optional<std::uint32_t>> partColors;  ///< by part, as drawn; empty: several
    std::uint64_t colorsScene = 0;                         ///< number of the scene with these colours
    std::vector<std::string> fits;                         ///< by structure: its fit on the first
    std::vector<std::string> reading;  ///< sentences about what the reader read, guessed and omitted
    SequenceState sequence;
    int rule = -1;             ///< rule being edited
    std::string ruleAtoms;     ///< its fields as typed
    bool playOptions = false;  ///< options of the play bar are open
    SaveForm save;
    MovieForm movie;
    std::string unsaved;  ///< what quitting would lose
    std::string helpSearch;
    std::string renamed, newName;  ///< the structure being renamed, and its new name as typed
};

/// One frame of the panel, drawn by its pages.
struct PanelFrame {
    PanelState& s;
    Widgets& ui;
    const PanelHost& host;
    Viewer& viewer;
    double now;
    PictureDescription look{}, before{};  ///< the viewer's look: changed by pages, and before
};

// Layout around the pages (chrome.cpp)
// The displayed name of an input: a file's without its folder.
std::string shortName(const std::string& input);
void drawMenuButton(PanelFrame& f);
/// Begins a change of PanelFrame::look; takeLook() passes it to the viewer, with other requests.
void beginLook(PanelFrame& f);
void takeLook(PanelFrame& f);
void drawPanel(PanelFrame& f);
// Pages
void drawLookPage(PanelFrame& f);
void drawEffects(PanelFrame& f);
void drawMaps(PanelFrame& f);
void drawPartsPage(PanelFrame& f);
void drawSequence(PanelFrame& f, const Part& part);
/// For each atom the drawn colour of carbons and meshes; 0: none.
std::vector<std::uint32_t> drawnColors(const Molecule& m, const Representation& scene);
void drawSelectPage(PanelFrame& f);
std::string selectedText(std::size_t atoms);
/// Actions for selected atoms.
void drawSelectionActions(PanelFrame& f, const std::string& selection);
void drawRules(PanelFrame& f);
/// Actions for interactions and pockets of a selection, and the found interactions (contacts.cpp).
void drawContactActions(PanelFrame& f, const std::string& selection);
void drawContactList(PanelFrame& f);
void drawLabelsPage(PanelFrame& f);
void drawMorePage(PanelFrame& f);
// Below and over the picture
void drawPlayBar(PanelFrame& f);
void drawWords(PanelFrame& f);
/// The eye for the commands after a command with a callback.
OverlayEye commandEye(const ImDrawCmd& command);
/// The outline of the selection, and of the atoms that a click would select.
void drawOutline(PanelFrame& f);
void drawAnnotations(PanelFrame& f);
// Cards over everything else
void drawStart(PanelFrame& f);
void drawBrowse(PanelFrame& f);
/// Gives the keyboard focus to the next field of a newly opened card.
void focusField(PanelFrame& f);
/// "Save as" with a path and, if there is a dialog, a button that opens it (save.cpp).
struct PathField {
    const char *name, *hint;
    const char* title;  ///< of the dialog
};
/// @returns whether Enter was pressed
bool fieldOfPath(PanelFrame& f, const PathField& field, std::string& path, PathChosen chosen);
/// As above for the last button.
void focusButton(PanelFrame& f);
/// Opens or adds the input chosen on the start screen.
void openInput(PanelFrame& f, const std::string& input);
void drawSave(PanelFrame& f);
void drawRecord(PanelFrame& f);
void drawHelp(PanelFrame& f);
void drawQuit(PanelFrame& f);
void drawDropped(PanelFrame& f);
void drawPalette(PanelFrame& f);
void drawContext(PanelFrame& f);
void drawRecording(PanelFrame& f);
/// Flies through the keyframes with the movie's timing, then returns to the movie page.
void previewMovie(PanelFrame& f);
void keepView(PanelState& s, const Viewer& viewer);
void drawReading(PanelFrame& f);
void drawFailure(PanelFrame& f);
/// Shows an error, with advice.
void tellFailure(PanelFrame& f);
void drawQuestion(PanelFrame& f);

// Windows (windows.cpp)
void beginWindow(PanelFrame& f, const char* name, int moreFlags);
/// A window whose height fits its contents, limited by its room. @param pivot  0 to 1: the point of the window at `at`
void beginGrown(PanelFrame& f, const char* name, ImVec2 at, ImVec2 pivot, float width, float height);
/// Ends such a window. Its height is known a frame later, which is requested.
void endGrown(PanelFrame& f);
/// A centred window over everything else, with a title and a close button.
/// @returns whether it was closed
bool beginCard(PanelFrame& f, const char* name, const char* title, float points, bool closable = true);
/// At the top of the free area: an operation in progress that can be stopped.
void beginProgress(PanelFrame& f, const char* name);
/// Scrolls the current window with the finger.
void followFinger(PanelFrame& f);

// Controls of options (controls.cpp)
// Rounded, so that saved views are readable.
double inHundredths(float value);
/// For a number that is "off" at its lower end. @returns whether it is on
bool slideOption(PanelFrame& f, std::string_view key, bool byRatio = false);
/// For an option with two choices. @returns whether it is on
bool toggleOption(PanelFrame& f, std::string_view key);
void chooseOption(PanelFrame& f, std::string_view key);
/// For a value that is not an option. @returns whether it changed
bool chooseValue(Widgets& ui, const char* name, std::string_view key, std::string& value);
/// One of the styles, or `none`, if offered. @returns whether it changed
bool chooseStyle(Widgets& ui, const char* name, const char* none, std::optional<Style>& style, float width = -1);

}  // namespace nacre::app
