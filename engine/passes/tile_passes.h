#pragma once
// What the `tiles` path finds and shades by compute and by tiles.

#include <optional>

#include "engine/passes/output.h"
#include "engine/passes/primitives.h"

namespace nacre::passes {

/// Compute: writes TileFrame::numbers of the view's tiles that are not empty, one workgroup each.
struct NearestByTiles {
    /// Where it shades, too: what it writes then are colours, row by row of the bins, 0 where nothing is seen.
    std::optional<vk::ImageView> atlas{};
};
void draw(gpu::PassContext& context, const SceneView& view, const NearestByTiles& pass);
/// Asks for the pipelines of that.
void want(gpu::PipelineContext& context, const SceneView& view, const NearestByTiles& pass);

/// Shades every pixel that has a number there, once.
struct TileShading {
    vk::ImageView atlas;
    Output output = Output::color;
    bool depth = false;  ///< goes to the depth buffer, too
    /// One of a view's translucent layers instead, laid over the picture where the depth test lets it; 0: the nearest.
    std::optional<std::uint32_t> layer{};
};
void draw(gpu::PassContext& context, const SceneView& view, const TileShading& pass);
/// Asks for the pipeline of that.
void want(gpu::PipelineContext& context, const SceneView& view, const TileShading& pass);

/// Compute: writes, of each pixel of the view's tiles, the numbers of the nearest triangle and of the next one behind.
/// @param view  of translucent triangles alone
void findLayersByTiles(gpu::PassContext& context, const SceneView& view);

}  // namespace nacre::passes
