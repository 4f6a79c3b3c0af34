#pragma once
// Covers pixels of a frame that are not wanted, for paths that test depth.

#include <glm/vec4.hpp>
#include <vector>

#include "engine/passes/primitives.h"
#include "engine/passes/tile_mask.h"

namespace nacre::passes {

/// Rectangles over the quarters of tiles that a mask leaves out: left, top, right, bottom in NDC.
std::vector<glm::vec4> makeCovers(const TileMask& mask, graph::Extent image);

/// Fills the depth of the view's covers with 0, if it has any. Comes first in a pass that clears depth.
void drawCovers(gpu::PassContext& context, const SceneView& view);

}  // namespace nacre::passes
