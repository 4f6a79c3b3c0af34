#pragma once

#include <array>
#include <optional>
#include <string>

namespace nacre::gpu {

/// Whether a package put a software driver beside the program, for machines without a Vulkan device.
bool hasBundledDriver();

/// While it lives, the loader knows the bundled driver alone: instances of this time have its devices. By the
/// environment, which is afterwards as before: loaders before 1.3.240 ignore VK_LUNARG_direct_driver_loading.
class BundledDriver {
public:
    BundledDriver();
    ~BundledDriver();
    BundledDriver(const BundledDriver&) = delete;
    BundledDriver& operator=(const BundledDriver&) = delete;

    /// Whether there was one.
    static bool taken();

private:
    std::array<std::optional<std::string>, 2> before_;
};

}  // namespace nacre::gpu
