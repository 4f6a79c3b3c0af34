#pragma once

#include "engine/gpu/caps.h"
#include "engine/results.h"

namespace nacre::gpu {

/// What people are told of a device.
DeviceInfo infoOf(const Caps& caps);

}  // namespace nacre::gpu
