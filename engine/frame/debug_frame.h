#pragma once
// The frame of a debug view, declared: the screen frame's own passes as far as the view looks at them, and one pass
// that turns what they made into a picture. Nothing here calls Vulkan.

#include "engine/debug_view.h"
#include "engine/frame/screen_frame.h"

namespace nacre {

/// Pixels across a tile of DebugView::tiles: that of Mali GPUs.
constexpr std::uint32_t kDebugTile = 16;

/// The path that a view's frame takes on a device that takes `usual`.
passes::Nearest debugNearest(DebugView view, passes::Nearest usual);

/// What a pass of the debug view reads. `tileMean`: it sums tiles up rather than showing something.
struct DebugInputs {
    graph::Image source, under;
    bool hasUnder = false, tileMean = false;
};
using DebugRecord = std::function<graph::Record(const DebugInputs&)>;

/// Declares the frame. `options.nearest` is debugNearest(), and options.targets holds the one target of the picture.
ScreenFrame debugFrame(DebugView view, const ScreenFrameOptions& options, const ScreenRecord& record,
                       const DebugRecord& show);

}  // namespace nacre
