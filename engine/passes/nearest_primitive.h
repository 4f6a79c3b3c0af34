#pragma once

#include "engine/passes/primitives.h"

namespace nacre::passes {

/// The number of every pixel's nearest primitive, counted from 1 over all copies, and its depth by gl_FragDepth.
/// @param distance  its Z stands beside the number
void drawNearestPrimitive(gpu::PassContext& context, const SceneView& view, bool distance);

}  // namespace nacre::passes
