#pragma once
// The Vulkan devices of this machine.

#include <vector>

#include "engine/device_options.h"
#include "engine/results.h"

namespace nacre {

/// All devices, in the order in which DeviceOptions::device counts them. @throws Error
std::vector<DeviceInfo> listDevices();

/// Whether the device's capabilities choose the path.
constexpr bool isAutomatic(Visibility visibility) { return visibility == Visibility::automatic; }

/// The device that the options name, with the path and other choices for it. @throws Error like Renderer
DeviceInfo deviceInfo(const DeviceOptions& options);

/// "depth encoding + impostor colour: 2 subpasses as 1" and "screen: depth: 0 of 4.0 MB committed", one line each.
std::string describe(const DriverFeedback& feedback);

/// Allows devices, from now on, to tune the C library's heap for the whole process where that makes their drivers
/// faster. Meant for stand-alone programs: as a library, this would change the host program's memory.
void letDriversTuneHeap();

/// Whether this program was built with support for captures.
bool capturesBuilt();

}  // namespace nacre
