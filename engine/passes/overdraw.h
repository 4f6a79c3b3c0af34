#pragma once

#include "engine/passes/primitives.h"

namespace nacre::passes {

/// How many fragments of impostors pass the depth test in every pixel: 1/255 each, added up.
void drawOverdraw(gpu::PassContext& context, const SceneView& view);

}  // namespace nacre::passes
