#pragma once
// Looks that are one key away.

#include <span>

#include "app/picture/saved_view.h"

namespace nacre::app {

struct Preset {
    const char* name;
    RepresentationOptions look;
    std::array<float, 4> background;
};

std::span<const Preset> presets();
/// Changes what is drawn and its colours; camera and file stay.
void applyPreset(const Preset& preset, PictureDescription& view);

/// How a molecule looks at first where nothing was asked for: proteins, from kFewestOfCartoon amino acids on, as
/// cartoons with their ligands as sticks; a prediction that states its confidence as a cartoon coloured by it. Anything
/// else, and any view that says something of styles, colours or selections, stays as it is.
constexpr std::size_t kFewestOfCartoon = 10;  // shorter peptides show their atoms
void firstLook(const Molecule& molecule, PictureDescription& view);

}  // namespace nacre::app
