#pragma once

#include "engine/passes/primitives.h"

namespace nacre::passes {

/// The number of every pixel's nearest primitive, counted from 1 over all copies, and its depth by gl_FragDepth.
void drawNearestPrimitive(gpu::PassContext& context, const SceneView& view);

}  // namespace nacre::passes
