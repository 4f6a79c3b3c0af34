#pragma once

namespace nacre::gpu {

/// Whether a package put a software driver beside the program, for machines without a Vulkan device.
bool hasBundledDriver();
/// From now on the loader knows the bundled driver alone. By the environment: loaders before 1.3.240 ignore
/// VK_LUNARG_direct_driver_loading.
void takeBundledDriver();
/// Whether takeBundledDriver() was called.
bool bundledDriverTaken();

}  // namespace nacre::gpu
