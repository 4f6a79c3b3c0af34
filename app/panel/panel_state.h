#pragma once
// What the panel's parts share: what is open, where it stands, and what pages keep from frame to frame; and the pages,
// which are functions of one frame.

#include <mutex>

#include "app/annotation/layout.h"
#include "app/panel/fonts.h"
#include "app/panel/panel.h"
#include "app/panel/widgets.h"
#include "app/viewer/parts.h"

namespace nacre::app {

/// Dear ImGui works on one context, named by a global variable: panels on other threads wait for their turn.
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

/// The panel's own dialog for files (browse.cpp).
struct Browser {
    struct Entry {
        std::string name;
        bool folder;
    };
    bool open = false, saving = false;
    std::string folder, typed;
    bool listed = false;  ///< the entries are those of the folder
    std::vector<Entry> entries;
    std::size_t more = 0;  ///< that are not listed
    std::string error;
};

struct PanelState {
    PanelState(PanelHost lent, double scale, bool fingers)
        : host(std::move(lent)),
          pixelsPerPoint(scale),
          ui(darkTheme(), static_cast<float>(scale), fingers),
          foreign(host.fontWith) {
        shown = fingers ? Shown::folded : Shown::open;
        ui.askText = host.askText;
    }

    PanelHost host;
    double pixelsPerPoint;
    Widgets ui;
    ForeignGlyphs foreign;
    bool glyphsChanged = false;
    int restless = 2;       ///< frames that Dear ImGui needs until nothing reacts any more
    float scroll = 0;       ///< pixels that the finger dragged since the last frame
    bool keyboard = false;  ///< keys go about in the panel

    // What is open
    enum class Shown { open, folded, hidden } shown;
    Panel::Page page = Panel::Page::look;
    Panel::Brightness brightness = Panel::Brightness::system;
    bool help = false, licences = false, start = false, saving = false, recording = false, developers = false;
    bool quitting = false;
    Browser browser;
    bool over() const { return help || saving || recording || start || quitting || browser.open; }
    /// @param suggested  a file, whose folder is shown; empty: the current folder
    /// @param toSave  an image is to be written there; else one is opened
    void browse(const std::string& suggested, bool toSave);
    void setSavePath(const std::string& path);
    bool closeTop();
    void toggle();
    void setBrightness(Panel::Brightness to);

    // Where it stands
    Insets insets;
    Rectangle window{}, panel{};  ///< all, and the panel where it is open
    bool sheet = false;           ///< it stands below the molecule
    Rectangle playBar{};
    float bar = 0;         ///< pixels that the bar for playing takes, with its margins
    float legendRoom = 0;  ///< pixels at the right that the molecule leaves to the legend
    std::vector<Rectangle> occupied;
    bool occupies(glm::dvec2 pixel) const;
    /// What the panel leaves of the window.
    Rectangle freeRoom() const;

    bool editing = false;   ///< a control that is held changed the look
    std::string ruleError;  ///< why what was typed was not taken
    /// Takes what was typed: while it cannot be read, what was there stays. @param take  @throws std::exception
    template <typename Take>
    void take(Take&& take) {
        try {
            take();
            ruleError.clear();
        } catch (const std::exception& error) {
            ruleError = error.what();
        }
    }
    std::optional<Aim> aim;                    ///< that a button asked for in this frame
    std::optional<PictureDescription> wanted;  ///< the same, of which the molecules are read anew
    std::string input;                         ///< of the start screen
    bool together = false;                     ///< what is opened next stands beside what is open
    std::string selection;                     ///< as it is typed
    std::string selected;                      ///< what the viewer had when the field was filled last
    std::string title;
    bool typingTitle = false;
    WordMemory wordMemory;
    // Parts of the molecule that is shown
    std::shared_ptr<const Molecule> molecule;
    std::optional<ResidueFacts> facts;  ///< of the molecule, once there is one
    std::vector<Part> parts;
    std::string unfolded;                            ///< the part whose sequence is shown
    std::vector<std::uint32_t> sequence;             ///< of it
    std::string sequenceInput;                       ///< as Part::input
    int dragFrom = -1, dragTo = -1;                  ///< of residues of the sequence
    bool alongSequence = false;                      ///< arrow keys go along it
    int sequenceStep = 0;                            ///< that one of them asks for
    bool sequenceExtends = false;                    ///< to what is selected
    std::vector<std::uint32_t> residueColors;        ///< of the same
    std::pair<RepresentationOptions, bool> colored;  ///< what they are the colours of
    int rule = -1;                                   ///< that is being edited
    std::string ruleAtoms;                           ///< of it, as they are typed
    bool playOptions = false;                        ///< of the bar for playing are unfolded
    // The picture that is to be saved
    int preset = 0, format = 0;
    int widthMm = 160, heightMm = 120, dpi = 300;
    bool transparent = false;
    std::string path;
    // The film that is to be recorded
    int motion = 0, filmSize = 0, filmFormat = 0;
    float filmSeconds = 0;  ///< 0: what the motion takes
    bool filmLoop = false, filmTransparent = false;
    std::string film;
    std::vector<PictureDescription> keys;  ///< views that it goes through
    bool keysRecorded = true;
    std::string unsaved;  ///< what is lost by quitting
    std::string helpSearch;
    std::size_t previewed = 0;  ///< of them while they are shown in turn, counted from 1; 0: they are not
    double previewDue = 0;      ///< when the next one is flown to
};

/// A frame of the panel, of which its pages are drawn.
struct PanelFrame {
    PanelState& s;
    Widgets& ui;
    const PanelHost& host;
    Viewer& viewer;
    double now;
    PictureDescription look{};  ///< the viewer's, which pages change
};

// The panel about its pages (chrome.cpp)
/// Of an input, as it is shown: a file's without its folder.
std::string shortName(const std::string& input);
void drawMenuButton(PanelFrame& f);
void drawPanel(PanelFrame& f);
// Pages
void drawLookPage(PanelFrame& f);
void drawEffects(PanelFrame& f);
void drawMaps(PanelFrame& f);
void drawPartsPage(PanelFrame& f);
void drawSequence(PanelFrame& f, const Part& part);
void drawSelectPage(PanelFrame& f);
void drawRules(PanelFrame& f);
/// What interactions and pockets are to be shown of a selection, and those that are drawn, to fly to (contacts.cpp).
void drawContactActions(PanelFrame& f, const std::string& selection);
void drawContactList(PanelFrame& f);
void drawLabelsPage(PanelFrame& f);
void drawMorePage(PanelFrame& f);
// Under the picture, and upon it
void drawPlayBar(PanelFrame& f);
void drawWords(PanelFrame& f);
void drawAnnotations(PanelFrame& f);
// Cards, which lie over everything
void drawStart(PanelFrame& f);
void drawBrowse(PanelFrame& f);
/// What was chosen on the start screen, instead of what is open or beside it.
void openInput(PanelFrame& f, const std::string& input);
void drawSave(PanelFrame& f);
void drawRecord(PanelFrame& f);
void drawHelp(PanelFrame& f);
void drawQuit(PanelFrame& f);
void drawRecording(PanelFrame& f);
/// Flies from one kept view to the next, as long as the film takes, and comes back to the film.
void previewFilm(PanelFrame& f);
void keepView(PanelState& s, const Viewer& viewer);
void drawReading(PanelFrame& f);
void drawFailure(PanelFrame& f);
/// What went wrong, and what to do.
void tellFailure(PanelFrame& f);
void drawQuestion(PanelFrame& f);

// Windows (windows.cpp)
void beginWindow(PanelFrame& f, const char* name, int moreFlags);
/// As high as what stands in it, at most as its room. @param pivot  0 to 1: where of the window `at` is
void beginGrown(PanelFrame& f, const char* name, ImVec2 at, ImVec2 pivot, float width, float height);
/// Ends such a window, which shows a frame late how high it is: that frame is asked for.
void endGrown(PanelFrame& f);
/// A window in the middle, over everything else, with a name and a sign that closes it.
/// @returns whether it was closed
bool beginCard(PanelFrame& f, const char* name, const char* title, float points, bool closable = true);
/// At the top of what the panel leaves free: something that goes on, and can be stopped.
void beginProgress(PanelFrame& f, const char* name);
/// The window that is being laid out scrolls with the finger.
void followFinger(PanelFrame& f);

// Controls of options (option_controls.cpp)
/// So that a saved view reads well.
double inHundredths(float value);
/// Of one that is a number, or "off" at its lower end. @returns whether it is on
bool slideOption(PanelFrame& f, std::string_view key, bool byRatio = false);
/// Of one of two choices. @returns whether it is on
bool toggleOption(PanelFrame& f, std::string_view key);
void chooseOption(PanelFrame& f, std::string_view key);
/// The same of a value by itself. @returns whether it is another one
bool chooseValue(Widgets& ui, const char* name, std::string_view key, std::string& value);
/// One of the styles, or `none`, if that is offered. @returns whether it is another one
bool chooseStyle(Widgets& ui, const char* name, const char* none, std::optional<Style>& style, float width = -1);

}  // namespace nacre::app
