#pragma once
// Separates a scene's opaque triangles from those drawn in translucent layers.

#include <vector>

#include "engine/passes/placed_copies.h"
#include "engine/scene/build/translucency.h"

namespace nacre::passes {

/// Selects a scene's triangles.
enum class Triangles : std::uint8_t {
    opaque,
    translucent,
    solid,  ///< all but faint ones: those that picking reports
};
/// Keeps the selected triangles of some calls, in order.
void selectTriangles(std::vector<PlacedCopies::Call>& calls, const TranslucentRuns& runs, Triangles which);

}  // namespace nacre::passes
