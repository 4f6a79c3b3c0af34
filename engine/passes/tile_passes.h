#pragma once

#include <optional>

#include "engine/passes/output.h"
#include "engine/passes/primitives.h"

namespace nacre::passes {

/// Compute: writes TileFrame::numbers of the view's tiles that are not empty, one workgroup each.
/// @param atlas  where it shades, too: what it writes then are colours, row by row of the bins, 0 where nothing is seen
void findNearestByTiles(gpu::PassContext& context, const SceneView& view, std::optional<vk::ImageView> atlas);

/// Shades every pixel that has a number there, once. @param depth  colour: its depth goes to the depth buffer, too
void shadeTiles(gpu::PassContext& context, const SceneView& view, Output output, vk::ImageView atlas, bool depth);

/// The same by a pipeline of which the fragment stage is set, and what it does to depth and colour.
void shadeSpans(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas, gpu::GraphicsPipeline pipeline);

}  // namespace nacre::passes
