#pragma once
// Declares the frame of a debug view: the passes of the screen frame that the view needs, and one pass that turns their
// results into a picture.

#include "engine/debug_view.h"
#include "engine/frame/screen.h"

namespace nacre {

/// Tile width of DebugView::tiles, pixels: that of Mali GPUs.
constexpr std::uint32_t kDebugTile = 16;

/// The path of a view's frame on a device whose path is `usual`.
Visibility debugVisibility(DebugView view, Visibility usual);

/// Declares the frame. `options.visibility` is debugVisibility(), and options.targets holds the picture's one target.
ScreenFrame debugFrame(DebugView view, const ScreenOptions& options, const Recorder& recorder = {});

}  // namespace nacre
