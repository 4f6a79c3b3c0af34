#pragma once
// Translucent primitives. The nearest layers of a pixel are found before opaque visibility, and composited over the
// path's opaque picture, which they do not change; hidden ones are dropped there. Further layers are added up without
// order, and composited first.

#include "engine/frame/frame.h"
#include "engine/passes/scene_view.h"
#include "engine/scene/build/translucency.h"

namespace nacre {

/// Names of passes that draw translucent primitives: layers, numbered from the nearest, and the rest behind them.
constexpr const char* kTranslucentLayer = "translucent layer ";
constexpr const char* kTranslucentRest = "translucent rest";
constexpr const char* kTranslucentColor = "translucent colour ";
constexpr const char* kRestColor = "translucent colour of the rest";
/// Name of the pass that brings the nearest opaque depth into the depth buffer, where they test it.
constexpr const char* kOpaqueDepth = "opaque depth";

/// Declares passes that find the numbers of each pixel's nearest translucent primitives, one pass per layer from the
/// nearest on.
void declareTranslucentLayers(Frame& frame, const FrameShape& shape);

/// Declares the sums over further layers in front of opaque shapes. Where compute draws translucent primitives, it
/// finds and shades all layers now. Call once the path is declared.
void declareTranslucentRest(Frame& frame, const FrameShape& shape);

/// Composites the rest over the picture so far.
void declareRestColor(Frame& frame, const FrameChoice& choice);

/// Composites a layer over the picture so far. Call for the farthest first. @param layer  0 is the nearest
void declareTranslucentColor(Frame& frame, std::uint32_t layer);

/// A view of a scene's translucent primitives only, without outlines.
/// @param all  a view of the whole scene's copies
void viewTranslucent(passes::SceneView& view, const passes::SceneView& all, const TranslucentParts& parts);

}  // namespace nacre
