#pragma once
// Requirements on every device: one table, checked when a device is opened, and tested against the weakest supported
// phone (tests/phone_layer/floor.h). Requirements of single paths are caps (caps.h).

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
    VkFormatFeatureFlags features;  ///< for optimal tiling
    const char* why;
};

constexpr std::uint32_t kRequiredVulkan = VK_API_VERSION_1_1;
std::span<const RequiredLimit> requiredLimits();
std::span<const RequiredFormat> requiredFormats();
/// For a window, besides VK_KHR_swapchain.
std::span<const char* const> requiredExtensions();

/// @throws Error that names the first missing feature
void checkRequirements(const vk::raii::PhysicalDevice& device, bool window);

}  // namespace nacre::gpu
