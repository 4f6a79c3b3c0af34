#pragma once
// Separates a scene's opaque triangles from those drawn in translucent layers.

#include "engine/passes/scene_view.h"
#include "engine/scene/build/translucency.h"

namespace nacre::passes {

/// Selects a scene's triangles.
enum class Triangles : std::uint8_t {
    opaque,
    translucent,
    solid,  ///< all but faint ones: those that picking reports
};
/// Keeps the selected triangles of some calls, in order.
void choose(std::vector<PlacedCopies::Call>& calls, const TranslucentRuns& runs, Triangles which);

/// A view of a scene's translucent triangles only, without lines.
/// @param all  a view of the whole scene's copies
void seeTranslucent(SceneView& view, const SceneView& all, const TranslucentRuns& runs);

}  // namespace nacre::passes
