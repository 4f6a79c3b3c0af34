#pragma once
// The Vulkan devices of this machine.

#include <vector>

#include "engine/results.h"

namespace nacre {

/// Every one, in the order that DeviceOptions::device counts them. @throws Error
std::vector<DeviceInfo> listDevices();

/// Whether this program was built to capture frames.
bool capturesBuilt();

}  // namespace nacre
