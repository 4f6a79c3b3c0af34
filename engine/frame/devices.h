#pragma once
// The choices that hold for all frames of a device, as text for people.

#include "engine/graph/frame_caps.h"
#include "engine/results.h"

namespace nacre {

/// Sets path and samples in motion. @throws Error if the device cannot do what its options ask for
void addChoices(DeviceInfo& info, const graph::FrameCaps& device);

}  // namespace nacre
