#pragma once

#include "engine/gpu/caps.h"
#include "engine/results.h"

namespace nacre::gpu {

/// What people are told of a device.
DeviceInfo infoOf(const Caps& caps);
/// The same, and what the device says of itself.
DeviceInfo infoOf(const Caps& caps, const vk::raii::PhysicalDevice& device);

}  // namespace nacre::gpu
