#pragma once
// Translucent primitives: layers of the nearest ones, composited over the path's opaque picture, which is identical
// with and without them, in one piece. Layers are found before opaque visibility; hidden ones are dropped when they are
// composited.

#include "engine/frame/frame.h"
#include "engine/passes/scene_view.h"
#include "engine/scene/build/translucency.h"

namespace nacre {

/// Draw translucent primitives; numbered from the nearest layer.
constexpr const char* kTranslucentLayer = "translucent layer ";
constexpr const char* kTranslucentColor = "translucent colour ";

/// Declares the passes that find the numbers of the nearest translucent primitives of each pixel, and of the next ones
/// behind; none for a choice without layers.
void declareTranslucentLayers(Frame& frame, const FrameShape& shape);

/// Composites the layers over the path's result, farthest first.
void declareTranslucentColors(Frame& frame, const FrameShape& shape);

/// A view of a scene's translucent primitives only, without outlines.
/// @param all  a view of the whole scene's copies
void viewTranslucent(passes::SceneView& view, const passes::SceneView& all, const TranslucentParts& parts);

}  // namespace nacre
