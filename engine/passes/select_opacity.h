#pragma once
// Separates a scene's opaque primitives from those drawn in translucent layers.

#include "engine/passes/placed_copies.h"
#include "engine/scene/build/translucency.h"

namespace nacre::passes {

/// Selects a scene's primitives.
enum class Opacity : std::uint8_t {
    opaque,
    translucent,
    solid,  ///< all except faint ones: picking reports these
};
/// Keeps the selected primitives of some copies, in order. Wires are opaque.
void select(PlacedCopies& copies, const TranslucentParts& parts, Opacity which);

}  // namespace nacre::passes
