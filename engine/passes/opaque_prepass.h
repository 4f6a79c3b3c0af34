#pragma once

#include "engine/passes/primitives.h"

namespace nacre::passes {

/// The opaque prepass (paper section 5): depth of flat plates that lie wholly inside their spheres.
void drawPlates(gpu::PassContext& context, const SceneView& view);
/// The same without those of triangles, which cost a bake more than what they hide.
void drawSpherePlates(gpu::PassContext& context, const SceneView& view);

}  // namespace nacre::passes
