#pragma once
// The frame of a debug view, declared: the screen frame's own passes as far as the view looks at them, and one pass
// that turns what they made into a picture.

#include "engine/debug_view.h"
#include "engine/frame/screen.h"

namespace nacre {

/// Pixels across a tile of DebugView::tiles: that of Mali GPUs.
constexpr std::uint32_t kDebugTile = 16;

/// The path that a view's frame takes on a device that takes `usual`.
Visibility debugVisibility(DebugView view, Visibility usual);

/// Declares the frame. `options.visibility` is debugVisibility(), and options.targets holds the one target of the
/// picture.
ScreenFrame debugFrame(DebugView view, const ScreenOptions& options, const Recorder& recorder = {});

}  // namespace nacre
