#pragma once
// A density map drawn as a volume: rays through it end at opaque surfaces, and translucent layers divide them.

#include "engine/frame/frame.h"

namespace nacre {

/// Draws a part of the volume over the picture so far; nothing for a choice without one. Draw the parts from back to
/// front.
/// @param layer  0 is the nearest: the part between it and the layer before it; the number of layers: the part from the
/// farthest one to what is opaque
void declareVolume(Frame& frame, const FrameChoice& choice, std::uint32_t layer);

}  // namespace nacre
