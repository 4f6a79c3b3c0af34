#pragma once

#include "engine/passes/output.h"
#include "engine/passes/primitives.h"

namespace nacre::passes {

/// Impostor colour (paper sections 2 to 4), or a layer: each hit that is its pixel's nearest is written.
/// @param settles  encoded depth is coarse (graph::EncodedFormat::settles): the depth buffer settles what it leaves
/// open
void drawImpostorColor(gpu::PassContext& context, const SceneView& view, Output output, const Reads& reads,
                       const Encoding& encoding, bool settles);

}  // namespace nacre::passes
