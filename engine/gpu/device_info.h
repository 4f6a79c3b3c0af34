#pragma once

#include "engine/gpu/caps.h"
#include "engine/results.h"

namespace nacre::gpu {

/// Device information for people.
DeviceInfo describeDevice(const Caps& caps);
/// Adds what the device reports about itself.
DeviceInfo describeDevice(const Caps& caps, const vk::raii::PhysicalDevice& device);

}  // namespace nacre::gpu
