#pragma once

#include "engine/passes/primitives.h"

namespace nacre::passes {

/// Lines by groups and halos about every primitive, as what stands behind decides: for each pixel whether there is a
/// line, how clear of fog it is, and the density of a halo.
/// @param reads  `nearest` holds numbers and distances, as an input attachment or a texture
void drawRims(gpu::PassContext& context, const SceneView& view, const Reads& reads);

}  // namespace nacre::passes
