#pragma once
// Translucent primitives: layers of the nearest ones, composited over the path's opaque picture, which they do not
// change. Layers are found before opaque visibility; hidden ones are dropped in compositing.

#include "engine/frame/frame.h"
#include "engine/passes/scene_view.h"
#include "engine/scene/build/translucency.h"

namespace nacre {

/// Name of passes that draw translucent primitives; numbered from the nearest layer.
constexpr const char* kTranslucentLayer = "translucent layer ";
constexpr const char* kTranslucentColor = "translucent colour ";

/// Declares passes that find the numbers of each pixel's nearest translucent primitives, one pass per layer from the
/// nearest on.
void declareTranslucentLayers(Frame& frame, const FrameShape& shape);

/// Composites a layer over the picture so far. Call for the farthest first. @param layer  0 is the nearest
void declareTranslucentColor(Frame& frame, std::uint32_t layer);

/// A view of a scene's translucent primitives only, without outlines.
/// @param all  a view of the whole scene's copies
void viewTranslucent(passes::SceneView& view, const passes::SceneView& all, const TranslucentParts& parts);

}  // namespace nacre
