#pragma once

#include "engine/graph/graph.h"
#include "engine/passes/output.h"
#include "engine/passes/primitives.h"

namespace nacre::passes {

/// Shades every covered pixel once: the hit is rebuilt from the pixel and the record of the primitive whose number it
/// holds.
/// @param reads  `nearest` holds the numbers, as an input attachment or a texture
void shadeNearestPrimitive(gpu::PassContext& context, const SceneView& view, Output output, const Reads& reads);

/// The same, under lines and halos. @param rims  as drawRims() leaves them @param clear  of the picture
void shadeRimmedPrimitive(gpu::PassContext& context, const SceneView& view, const Reads& reads, vk::ImageView rims,
                          const graph::Clear& clear);

}  // namespace nacre::passes
