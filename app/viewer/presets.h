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
/// Changes styles and colours; file and camera stay, but a pocket has an aim.
void applyPreset(const Preset& preset, PictureDescription& view);

/// The default style of a molecule: proteins from kFewestOfCartoon amino acids on as cartoons with their ligands as
/// sticks; predictions with confidence as a cartoon coloured by it. Everything else, and any view that sets styles,
/// colours or selections, stays unchanged.
constexpr std::size_t kFewestOfCartoon = 10;  // shorter peptides show their atoms
void firstLook(const Molecule& molecule, PictureDescription& view);

}  // namespace nacre::app
