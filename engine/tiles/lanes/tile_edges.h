#pragma once

#include "engine/gpu/execute.h"
#include "engine/passes/primitives.h"

namespace nacre::passes {

/// Requests the pipelines of edges while the one of the nearest primitives is compiled.
void wantEdgesByTiles(gpu::PipelineContext& context, const SceneView& view);

}  // namespace nacre::passes
