#pragma once
// What of a scene's triangles is opaque, and what is drawn in layers over that.

#include "engine/passes/scene_view.h"
#include "engine/scene/translucency.h"

namespace nacre::passes {

/// What of a scene's triangles is drawn.
enum class Triangles : std::uint8_t {
    opaque,
    translucent,
    solid,  ///< all but what is faint: what a pixel is said to show
};
/// Leaves those of some calls, in their order.
void choose(std::vector<PlacedCopies::Call>& calls, const TranslucentRuns& runs, Triangles which);

/// The translucent triangles of a scene, as a view that shows nothing else, and no lines.
/// @param all  a view whose copies are those of the whole scene
void seeTranslucent(SceneView& view, const SceneView& all, const TranslucentRuns& runs);

}  // namespace nacre::passes
