#pragma once

#include "engine/debug_view.h"
#include "engine/graph/encoded_format.h"
#include "engine/passes/full_screen.h"
#include "engine/passes/scene_view.h"

namespace nacre::passes {

/// Turns an image of the frame into a picture (shaders/debug_view.frag).
/// @param tile   tile width of DebugView::tiles, pixels
/// @param under  null if the view reads one image
void drawDebugView(gpu::PassContext& context, const SceneView& view, DebugView what, std::uint32_t tile,
                   vk::ImageView source, vk::ImageView under);

/// The mean of each tile of an image, one pixel per tile.
void drawTileMean(gpu::PassContext& context, const SceneView& view, std::uint32_t tile, vk::ImageView source);

}  // namespace nacre::passes
