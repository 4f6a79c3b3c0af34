#pragma once
// What the panel's pages keep from frame to frame.

#include "app/annotation/layout.h"
#include "app/panel/fonts.h"
#include "app/panel/panel.h"
#include "app/panel/widgets.h"

namespace nacre::app {

/// Dear ImGui works on one context, named by a global variable: panels on other threads wait for their turn.
class Panel::Turn {
public:
    explicit Turn(ImGuiContext* context) : lock_(turns) { ImGui::SetCurrentContext(context); }
    static inline std::recursive_mutex turns;

private:
    std::lock_guard<std::recursive_mutex> lock_;
};

struct Panel::State {
    State(const Theme& theme, float scale, bool fingers, FindFont find)
        : ui(theme, scale, fingers), foreign(std::move(find)) {}

    Widgets ui;
    ForeignGlyphs foreign;
    char input[256] = "";      ///< of the start screen
    bool together = false;     ///< what is opened next stands beside what is open
    char selection[512] = "";  ///< as it is typed
    std::string selected;      ///< what the viewer had when the field was filled last
    char title[256] = "";
    bool typingTitle = false;
    WordMemory wordMemory;
    float legendRoom = 0;  ///< pixels at the right that the molecule leaves to the legend
    // Parts of the molecule that is shown
    std::shared_ptr<const Molecule> molecule;
    std::vector<Part> parts;
    std::string unfolded;                            ///< the part whose sequence is shown
    std::vector<std::uint32_t> sequence;             ///< of it
    std::string sequenceInput;                       ///< as Part::input
    int dragFrom = -1, dragTo = -1;                  ///< of residues of the sequence
    bool alongSequence = false;                      ///< arrow keys go along it
    int sequenceStep = 0;                            ///< that one of them asks for
    bool sequenceExtends = false;                    ///< to what is selected
    std::vector<SecondaryStructure> folds;           ///< of the molecule's residues
    std::vector<std::uint32_t> residueColors;        ///< of the same
    std::pair<RepresentationOptions, bool> colored;  ///< what they are the colours of
    int rule = -1;                                   ///< that is being edited
    char ruleAtoms[512] = "";                        ///< of it, as they are typed
    bool playOptions = false;                        ///< of the bar for playing are unfolded
    // The picture that is to be saved
    int preset = 0, format = 0;
    int widthMm = 160, heightMm = 120, dpi = 300;
    bool transparent = false;
    char path[512] = "";
    // The film that is to be recorded
    int motion = 0, filmSize = 0, filmFormat = 0;
    float filmSeconds = 0;  ///< 0: what the motion takes
    bool filmLoop = false, filmTransparent = false;
    char film[512] = "";
    std::vector<SavedView> keys;  ///< views that it goes through
    std::size_t previewed = 0;    ///< of them while they are shown in turn, counted from 1; 0: they are not
    double previewDue = 0;        ///< when the next one is flown to
};

}  // namespace nacre::app
