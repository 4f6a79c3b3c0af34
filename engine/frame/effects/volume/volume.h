#pragma once
// A density map drawn as a volume: rays through it end at what is opaque, and are parted by translucent layers.

#include "engine/frame/frame.h"

namespace nacre {

/// Draws a part of the volume over the picture so far; nothing for a choice without one. The parts follow each other
/// from the back: behind all layers, then in front of each.
/// @param layer  0 is the nearest: the part between it and the layer before it; the number of layers: the part from the
/// farthest one to what is opaque
void declareVolume(Frame& frame, const FrameChoice& choice, std::uint32_t layer);

}  // namespace nacre
