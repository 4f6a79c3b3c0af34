#pragma once
// What the driver compiled, kept from one run to the next.

#include <cstddef>
#include <span>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

namespace nacre::gpu {

/// Whether a cache's data was written by this device and driver: VkPipelineCacheHeaderVersionOne names vendor, device
/// and the driver's UUID. Nothing but the header is looked at.
bool isPipelineCacheOf(const vk::PhysicalDeviceProperties& properties, std::span<const std::byte> data);

/// A cache that starts from `data`, or empty if that is another device's.
vk::raii::PipelineCache makePipelineCache(const vk::raii::Device& device, const vk::raii::PhysicalDevice& physical,
                                          std::span<const std::byte> data);

}  // namespace nacre::gpu
