#pragma once
// What the renderer asks of every device: one table, checked when a device is opened, and held in tests against the
// least phone that it is to run on (tests/phone_layer/floor.h). What only some paths use is a cap (caps.h).

#include <cstdint>
#include <span>
#include <vulkan/vulkan_raii.hpp>

namespace nacre::gpu {

struct RequiredLimit {
    std::uint32_t VkPhysicalDeviceLimits::*limit;
    std::uint32_t least;
    const char* name;
    const char* why;
};

struct RequiredFormat {
    VkFormat format;
    VkFormatFeatureFlags features;  ///< of optimal tiling
    const char* why;
};

constexpr std::uint32_t kRequiredVulkan = VK_API_VERSION_1_1;
std::span<const RequiredLimit> requiredLimits();
std::span<const RequiredFormat> requiredFormats();
/// Beside VK_KHR_swapchain, for a window.
std::span<const char* const> requiredExtensions();

/// @throws Error that names the first thing the device lacks
void checkRequirements(const vk::raii::PhysicalDevice& device, bool window);

}  // namespace nacre::gpu
