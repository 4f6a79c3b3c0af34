#pragma once
// What the panel's pages keep from frame to frame.

#include "app/panel/panel.h"
#include "app/panel/widgets.h"
#include "app/shared/word_layout.h"

namespace nacre::app {

struct Panel::State {
    State(const Theme& theme, float scale, bool fingers) : ui(theme, scale, fingers) {}

    Widgets ui;
    char input[256] = "";      ///< of the start screen
    char selection[512] = "";  ///< as it is typed
    std::string selected;      ///< what the viewer had when the field was filled last
    char title[256] = "";
    bool typingTitle = false;
    WordMemory wordMemory;
    // Parts of the molecule that is shown
    std::shared_ptr<const Molecule> molecule;
    std::vector<Part> parts;
    std::string unfolded;                 ///< the part whose sequence is shown
    std::vector<std::uint32_t> sequence;  ///< of it
    int dragFrom = -1, dragTo = -1;       ///< of residues of the sequence
    // The picture that is to be saved
    int preset = 0, format = 0;
    int widthMm = 160, heightMm = 120, dpi = 300;
    bool transparent = false;
    char path[512] = "";
};

}  // namespace nacre::app
