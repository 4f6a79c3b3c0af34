#pragma once
// Passes of the `tiles` path for devices whose subgroups exchange values: the lanes of a subgroup draw a tile, and
// compute may shade it and draw samples at edges. Phones' builds are without them (engine/software/absent.cpp).

#include <cstdint>
#include <optional>

#include "engine/gpu/execute.h"
#include "engine/passes/output.h"
#include "engine/passes/resolve.h"
#include "engine/passes/scene_view.h"

namespace nacre::passes {

/// Compute: writes TileFrame::pixels() of the view's non-empty tiles, one workgroup each.
struct NearestByTiles {
    /// For shading: then writes colours, 0 where nothing is seen.
    std::optional<vk::ImageView> atlas{};
};
void draw(gpu::PassContext& context, const SceneView& view, const NearestByTiles& pass);
/// Requests the pipelines.
void want(gpu::PipelineContext& context, const SceneView& view, const NearestByTiles& pass);

/// Shades every pixel that has a number, once.
struct TileShading {
    vk::ImageView atlas;
    Output output = Output::color;
    bool depth = false;  ///< also writes the depth buffer
};
void draw(gpu::PassContext& context, const SceneView& view, const TileShading& pass);
/// Requests the pipeline.
void want(gpu::PipelineContext& context, const SceneView& view, const TileShading& pass);

/// Input of shadeSamples().
struct SampledSpheres {
    vk::ImageView atlas;
    std::optional<vk::ImageView> mask;  ///< as large as the picture: 0 where pixels stay
};
/// Writes a frame of RenderSettings::kBlockSamples x kBlockSamples samples per pixel, whose pixels() are numbers of
/// spheres, into its picture. @param frame  its extent
void shadeSamples(gpu::PassContext& context, const SceneView& view, const SampledSpheres& input, graph::Extent frame,
                  const ResolvePlace& place);

/// Compute: shades what each pixel of the view's tiles shows in front of opaque shapes: TileResult::layers.
/// @param view  of translucent primitives only @param opaque  depth buffer
void drawLayersByTiles(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas, vk::ImageView opaque);
/// Composites a layer over the picture. @param layer  0: nearest, layout::kOrderedLayers: the rest
void drawLayerColor(gpu::PassContext& context, const SceneView& view, std::uint32_t layer);

/// Compute: lists the edge pixels, found from the numbers and colours of the nearest primitives.
void findEdgesByTiles(gpu::PassContext& context, const SceneView& view);
/// Compute: draws edge pixels with RenderSettings::kEdgeSamples samples.
void drawEdgesByTiles(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas);
/// Composites edge pixels over the picture. @param clear  the picture's clear value
void drawEdgeColors(gpu::PassContext& context, const SceneView& view, const graph::Clear& clear);

}  // namespace nacre::passes
