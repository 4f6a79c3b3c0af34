#pragma once

#include "engine/gpu/execute.h"
#include "engine/passes/primitives.h"

namespace nacre::passes {

/// Compute: finds the pixels through which an edge runs and draws them from RenderSettings::kEdgeSamples samples, into
/// TileEdges::colors. Reads the numbers that findNearestByTiles() wrote.
void drawEdgesByTiles(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas);

/// Lays them over the picture. @param clear  what that is cleared to
void drawEdgeColors(gpu::PassContext& context, const SceneView& view, const graph::Clear& clear);

}  // namespace nacre::passes
