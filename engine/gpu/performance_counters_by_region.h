#pragma once
// VK_ARM_performance_counters_by_region, for older headers (the extension is in 1.4.331; bookworm has 1.3.239). Names,
// numbers and members are the specification's. A render pass writes the counters of each region of its area to memory.

#include <vulkan/vulkan_core.h>

#include <cstdint>

#ifndef VK_ARM_performance_counters_by_region
#define VK_ARM_PERFORMANCE_COUNTERS_BY_REGION_EXTENSION_NAME "VK_ARM_performance_counters_by_region"
constexpr auto VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PERFORMANCE_COUNTERS_BY_REGION_FEATURES_ARM =
    static_cast<VkStructureType>(1000605000);
constexpr auto VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PERFORMANCE_COUNTERS_BY_REGION_PROPERTIES_ARM =
    static_cast<VkStructureType>(1000605001);
constexpr auto VK_STRUCTURE_TYPE_PERFORMANCE_COUNTER_ARM = static_cast<VkStructureType>(1000605002);
constexpr auto VK_STRUCTURE_TYPE_PERFORMANCE_COUNTER_DESCRIPTION_ARM = static_cast<VkStructureType>(1000605003);
constexpr auto VK_STRUCTURE_TYPE_RENDER_PASS_PERFORMANCE_COUNTERS_BY_REGION_BEGIN_INFO_ARM =
    static_cast<VkStructureType>(1000605004);

struct VkPhysicalDevicePerformanceCountersByRegionFeaturesARM {
    VkStructureType sType;
    void* pNext;
    VkBool32 performanceCountersByRegion;
};
struct VkPhysicalDevicePerformanceCountersByRegionPropertiesARM {
    VkStructureType sType;
    void* pNext;
    std::uint32_t maxPerRegionPerformanceCounters;
    VkExtent2D performanceCounterRegionSize;
    std::uint32_t rowStrideAlignment;
    std::uint32_t regionAlignment;
    VkBool32 identityTransformOrder;
};
struct VkPerformanceCounterARM {
    VkStructureType sType;
    void* pNext;
    std::uint32_t counterID;
};
struct VkPerformanceCounterDescriptionARM {
    VkStructureType sType;
    void* pNext;
    VkFlags flags;
    char name[VK_MAX_DESCRIPTION_SIZE];
};
struct VkRenderPassPerformanceCountersByRegionBeginInfoARM {
    VkStructureType sType;
    void* pNext;
    std::uint32_t counterAddressCount;
    const VkDeviceAddress* pCounterAddresses;
    VkBool32 serializeRegions;
    std::uint32_t counterIndexCount;
    std::uint32_t* pCounterIndices;
};
using PFN_vkEnumeratePhysicalDeviceQueueFamilyPerformanceCountersByRegionARM = VkResult(VKAPI_PTR*)(
    VkPhysicalDevice, std::uint32_t, std::uint32_t*, VkPerformanceCounterARM*, VkPerformanceCounterDescriptionARM*);
#endif
