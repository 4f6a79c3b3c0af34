#pragma once

#include "engine/gpu/execute.h"
#include "engine/passes/primitives.h"

namespace nacre::passes {

/// Asks for the pipelines of the next two: while that of the nearest primitives is made.
void wantEdgesByTiles(gpu::PipelineContext& context, const SceneView& view);

/// Compute: lists the pixels through which an edge runs, of the numbers that findNearestByTiles() wrote, and its
/// colours.
void findEdgesByTiles(gpu::PassContext& context, const SceneView& view);

/// Compute: draws them from RenderSettings::kEdgeSamples samples, among those colours or into TileEdges::colors.
void drawEdgesByTiles(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas);

/// Lays them over the picture. @param clear  what that is cleared to
void drawEdgeColors(gpu::PassContext& context, const SceneView& view, const graph::Clear& clear);

}  // namespace nacre::passes
