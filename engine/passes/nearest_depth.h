#pragma once

#include "engine/passes/primitives.h"

namespace nacre::passes {

/// The nearest depth of every pixel in the depth buffer, by gl_FragDepth: depth maps of the bake.
void drawNearestDepth(gpu::PassContext& context, const SceneView& view);

}  // namespace nacre::passes
