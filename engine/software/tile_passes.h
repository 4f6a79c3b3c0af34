#pragma once
// The `tiles` path's visibility and shading, by compute, tile by tile.

#include <optional>

#include "engine/passes/output.h"
#include "engine/passes/primitives.h"

namespace nacre::passes {

/// Compute: writes TileFrame::numbers of the view's non-empty tiles, one workgroup each.
struct NearestByTiles {
    /// If it also shades: then it writes colours, row by row of the bins, 0 where nothing is seen.
    std::optional<vk::ImageView> atlas{};
};
void draw(gpu::PassContext& context, const SceneView& view, const NearestByTiles& pass);
/// Requests the pipelines.
void want(gpu::PipelineContext& context, const SceneView& view, const NearestByTiles& pass);

/// Shades every pixel with a number, once.
struct TileShading {
    vk::ImageView atlas;
    Output output = Output::color;
    bool depth = false;  ///< also writes the depth buffer
    /// Instead composites one translucent layer of a view where the depth test passes; 0: nearest.
    std::optional<std::uint32_t> layer{};
};
void draw(gpu::PassContext& context, const SceneView& view, const TileShading& pass);
/// Requests the pipeline.
void want(gpu::PipelineContext& context, const SceneView& view, const TileShading& pass);

/// Compute: writes for each pixel of the view's tiles the numbers of the nearest triangle and the next one behind.
/// @param view  of translucent triangles only
void findLayersByTiles(gpu::PassContext& context, const SceneView& view);

}  // namespace nacre::passes
