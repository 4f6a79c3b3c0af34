#pragma once
// Declares the frame of a debug view: the passes of the path that the view needs, and one that turns their results into
// a picture.

#include "engine/frame/frame.h"

namespace nacre {

/// Tile width of DebugView::tiles, pixels: that of Mali GPUs.
constexpr std::uint32_t kDebugTile = 16;

/// Declares the passes of FrameChoice::debug. The shape has one target, the picture.
void declareDebugView(Frame& frame, const FrameShape& shape);

}  // namespace nacre
