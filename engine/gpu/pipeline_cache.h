#pragma once
// The driver's compiled pipelines, kept between runs.

#include <cstddef>
#include <span>
#include <vulkan/vulkan_raii.hpp>

namespace nacre::gpu {

/// Whether a cache's data was written by this device and driver. Reads the header only
/// (VkPipelineCacheHeaderVersionOne: vendor, device and the driver's UUID).
bool isOwnPipelineCache(const vk::PhysicalDeviceProperties& properties, std::span<const std::byte> data);

/// A cache that starts from `data`, or empty if `data` belongs to another device.
vk::raii::PipelineCache makePipelineCache(const vk::raii::Device& device, const vk::raii::PhysicalDevice& physical,
                                          std::span<const std::byte> data);

}  // namespace nacre::gpu
