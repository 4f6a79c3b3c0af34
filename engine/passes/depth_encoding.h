#pragma once

#include "engine/passes/primitives.h"

namespace nacre::passes {

/// Depth encoding (paper section 3): the nearest depth of every pixel as a colour, kept by a MIN blend.
void encodeDepth(gpu::PassContext& context, const SceneView& view, const Encoding& encoding);

/// The same without blending: each fragment reads what the pixel holds, in raster order.
void encodeDepthInOrder(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas, vk::ImageView nearest);

}  // namespace nacre::passes
