#pragma once
// The Vulkan devices of this machine.

#include <vector>

#include "engine/results.h"

namespace nacre {

/// All devices, in the order in which DeviceOptions::device counts them. @throws Error
std::vector<DeviceInfo> listDevices();

/// "depth encoding + impostor colour: 2 subpasses as 1" and "screen: depth: 0 of 4.0 MB committed", one line each.
std::string describe(const DriverFeedback& feedback);

/// Whether this program was built with support for captures.
bool capturesBuilt();

}  // namespace nacre
