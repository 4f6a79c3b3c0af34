#pragma once

#include <array>
#include <optional>
#include <string>

namespace nacre::gpu {

/// Whether a package put a software driver beside the program, for machines without a Vulkan device.
bool hasBundledDriver();

/// While it exists, the loader knows only the bundled driver, and new instances have its devices. Sets the environment,
/// and restores it afterwards: loaders before 1.3.240 ignore VK_LUNARG_direct_driver_loading.
class BundledDriver {
public:
    BundledDriver();
    ~BundledDriver();
    BundledDriver(const BundledDriver&) = delete;
    BundledDriver& operator=(const BundledDriver&) = delete;

    /// Whether a bundled driver was used.
    static bool taken();

private:
    std::array<std::optional<std::string>, 2> before_;
};

}  // namespace nacre::gpu
