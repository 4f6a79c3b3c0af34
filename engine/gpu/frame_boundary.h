#pragma once
// VK_EXT_frame_boundary, for older headers (the extension is in 1.3.259; bookworm has 1.3.239). Names, numbers and
// members are the specification's. It marks the end of a frame that is not presented, for capture tools.

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <cstdint>

#ifndef VK_EXT_frame_boundary
#define VK_EXT_FRAME_BOUNDARY_EXTENSION_NAME "VK_EXT_frame_boundary"
constexpr auto VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAME_BOUNDARY_FEATURES_EXT = static_cast<VkStructureType>(1000375000);
constexpr auto VK_STRUCTURE_TYPE_FRAME_BOUNDARY_EXT = static_cast<VkStructureType>(1000375001);
constexpr VkFlags VK_FRAME_BOUNDARY_FRAME_END_BIT_EXT = 1;

struct VkPhysicalDeviceFrameBoundaryFeaturesEXT {
    VkStructureType sType;
    void* pNext;
    VkBool32 frameBoundary;
};
struct VkFrameBoundaryEXT {
    VkStructureType sType;
    const void* pNext;
    VkFlags flags;
    std::uint64_t frameID;
    std::uint32_t imageCount;
    const VkImage* pImages;
    std::uint32_t bufferCount;
    const VkBuffer* pBuffers;
    std::uint64_t tagName;
    std::size_t tagSize;
    const void* pTag;
};
#endif
