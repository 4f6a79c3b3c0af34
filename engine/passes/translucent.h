#pragma once
// Layers of translucent triangles: which of them is nearest to the viewer, which is next behind that, and what they
// add to the picture of what is opaque.

#include "engine/passes/output.h"
#include "engine/passes/primitives.h"
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

/// How a layer knows whether what is opaque hides it.
struct Opaque {
    NearestFrom from = NearestFrom::depthBuffer;
    vk::ImageView nearest{};  ///< unless the depth test tells
    Encoding encoding{};
};
/// Lays a layer over the picture.
void shadeTranslucentLayer(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas, vk::ImageView numbers,
                           const Opaque& opaque);

}  // namespace nacre::passes
