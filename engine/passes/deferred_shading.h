#pragma once

#include "engine/passes/output.h"
#include "engine/passes/primitives.h"

namespace nacre::passes {

/// Shades every covered pixel once: the hit is rebuilt from the pixel and the record of the primitive whose number it
/// holds.
/// @param reads  `nearest` holds the numbers, as an input attachment or a texture
void shadeNearestPrimitive(gpu::PassContext& context, const SceneView& view, Output output, const Reads& reads);

}  // namespace nacre::passes
