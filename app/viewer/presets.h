#pragma once
// Presets that can be chosen by key.

#include <span>

#include "app/picture/saved_view.h"

namespace nacre::app {

struct Preset {
    const char* name;
    RepresentationOptions look;
    std::array<float, 4> background;
    bool pocket = false;  ///< applyPocket() of the ligand
};

std::span<const Preset> presets();
/// Changes styles and colours; file and camera stay, except that a pocket has an aim.
void applyPreset(const Preset& preset, PictureDescription& view);

}  // namespace nacre::app
