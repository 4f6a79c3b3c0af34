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

/// The device that the options name, with its path and what else is chosen for it. @throws Error like Renderer
DeviceInfo deviceInfo(const DeviceOptions& options);

/// "depth encoding + impostor colour: 2 subpasses as 1" and "screen: depth: 0 of 4.0 MB committed", one line each.
std::string describe(const DriverFeedback& feedback);

/// From now on a device may set how the C library's heap works in the whole process, where its driver is faster then.
/// For programs of their own; within another program it changes that program's memory.
void letDriversTuneHeap();

/// Whether this program was built with support for captures.
bool capturesBuilt();

}  // namespace nacre
