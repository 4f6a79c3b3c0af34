#pragma once
// The visibility paths: each file declares and records its passes in the order in which they run. All draw the same
// picture. The frame has its depth, atlas, shadow map and translucent layers when a path is declared.

#include "engine/frame/frame.h"

namespace nacre {

/// The paper's path: opaque prepass, encoded depth, impostor colour; three subpasses, and only colour leaves the tile.
void declareEncoded(Frame& frame, const FrameShape& shape);

/// Opaque prepass and impostor colour in one subpass; gl_FragDepth settles depth.
void declareFragdepth(Frame& frame, const FrameShape& shape);

/// Numbers of the nearest primitives by gl_FragDepth, then shading once per covered pixel.
void declareDeferred(Frame& frame, const FrameShape& shape);

/// The nearest depth is read and written as an attachment in raster order: no blending, no second pass over impostors.
void declareRasterOrder(Frame& frame, const FrameShape& shape);

/// Compute finds the nearest primitives per tile, from lists in depth order; then every covered pixel is shaded once.
/// Draws no triangles except those that bound covered areas. Edge samples come from the same lists. Without subgroup
/// operations compute writes numbers to an image, which is shaded as in `deferred`.
void declareTiles(Frame& frame, const FrameShape& shape);

/// The pass that shades such an image and keeps the depth of what it shows, for translucent layers.
constexpr const char* kDepthByNumbers = "colour and depth by numbers";

/// Declares the path of the choice.
void declarePath(Frame& frame, const FrameShape& shape);

/// The opaque prepass, shared by the paths that draw impostors.
void declarePrepass(Frame& frame, graph::Image& depth, const Rounds& rounds);

}  // namespace nacre
