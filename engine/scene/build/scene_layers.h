#pragma once
// Converts the layers of a scene file to primitives. representation.cpp's callers use it instead of represent().

#include "engine/scene/build/representation.h"
#include "engine/scene/build/scene_guide.h"
#include "engine/scene/view/bounds.h"

namespace nacre {

/// The layers of a molecule's guide after rules: `hide` removes atoms, `show` adds a layer, `color` colours atoms
/// wherever they are. A style for all replaces the layers, and a colouring for all their colours.
struct GuidedLayers {
    std::vector<SceneLayer> layers;
    std::vector<Legend> legends;
    std::vector<std::string> warnings;
};
GuidedLayers guidedLayers(const ResidueFacts& facts, std::span<const std::uint32_t> drawn,
                          const RepresentationOptions& options);

/// Splits an appearance into layers: one per style, with its colours.
std::vector<SceneLayer> splitLayers(const Appearance& appearance, const RepresentationOptions& options);

/// The tooltips of a scene for an atom, in the order of its nodes; empty if there are none.
std::string joinTooltips(const SceneGuide& guide, std::uint32_t atom);

/// The bounding sphere of all that layers show, in all copies; of 1 Å at the origin if they show nothing.
Bounds computeBounds(const Molecule& molecule, std::span<const SceneLayer> layers);

/// Builds the layers of a molecule that has a guide. @param frame  centre and radius, as in represent()
/// @throws Error as represent() does
Representation representLayers(const ResidueFacts& facts, const GuidedLayers& layers,
                               const RepresentationOptions& options, const Bounds& frame);

}  // namespace nacre
