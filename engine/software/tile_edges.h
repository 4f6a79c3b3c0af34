#pragma once

#include "engine/gpu/execute.h"
#include "engine/passes/primitives.h"

namespace nacre::passes {

/// Requests the pipelines of the next two functions, while that of the nearest primitives is made.
void wantEdgesByTiles(gpu::PipelineContext& context, const SceneView& view);

/// Compute: lists the edge pixels among the numbers that findNearestByTiles() wrote, and its colours.
void findEdgesByTiles(gpu::PassContext& context, const SceneView& view);

/// Compute: draws edge pixels with RenderSettings::kEdgeSamples samples, into those colours or into TileEdges::colors.
void drawEdgesByTiles(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas);

/// Composites edge pixels over the picture. @param clear  the picture's clear value
void drawEdgeColors(gpu::PassContext& context, const SceneView& view, const graph::Clear& clear);

}  // namespace nacre::passes
