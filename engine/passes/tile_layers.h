#pragma once
// Layers of translucent triangles as the `tiles` path finds and shades them.

#include "engine/passes/primitives.h"

namespace nacre::passes {

/// Compute: writes, of each pixel of the view's tiles, the numbers of the nearest triangle and of the next one behind.
/// @param view  of translucent triangles alone
void findLayersByTiles(gpu::PassContext& context, const SceneView& view);

/// Lays one of them over the picture, where the depth test lets it. @param layer  0: the nearest
void shadeLayerByTiles(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas, std::uint32_t layer);

}  // namespace nacre::passes
