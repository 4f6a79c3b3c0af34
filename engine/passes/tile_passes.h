#pragma once

#include "engine/passes/output.h"
#include "engine/passes/primitives.h"

namespace nacre::passes {

/// Compute: writes TileFrame::numbers of the view's tiles that are not empty, one workgroup each.
void findNearestByTiles(gpu::PassContext& context, const SceneView& view);

/// Shades every pixel that has a number there, once.
void shadeTiles(gpu::PassContext& context, const SceneView& view, Output output, vk::ImageView atlas);

}  // namespace nacre::passes
