#pragma once
// VK_KHR_dynamic_rendering_local_read, for older headers (the extension is in 1.3.272; bookworm has 1.3.239). Names,
// numbers and members are the specification's.

#include <vulkan/vulkan_core.h>

#include <cstdint>

#ifndef VK_KHR_dynamic_rendering_local_read
#define VK_KHR_DYNAMIC_RENDERING_LOCAL_READ_EXTENSION_NAME "VK_KHR_dynamic_rendering_local_read"
constexpr auto VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_LOCAL_READ_FEATURES_KHR =
    static_cast<VkStructureType>(1000232000);
constexpr auto VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_LOCATION_INFO_KHR = static_cast<VkStructureType>(1000232001);
constexpr auto VK_STRUCTURE_TYPE_RENDERING_INPUT_ATTACHMENT_INDEX_INFO_KHR = static_cast<VkStructureType>(1000232002);
constexpr auto VK_IMAGE_LAYOUT_RENDERING_LOCAL_READ_KHR = static_cast<VkImageLayout>(1000232000);

struct VkPhysicalDeviceDynamicRenderingLocalReadFeaturesKHR {
    VkStructureType sType;
    void* pNext;
    VkBool32 dynamicRenderingLocalRead;
};
struct VkRenderingAttachmentLocationInfoKHR {
    VkStructureType sType;
    const void* pNext;
    std::uint32_t colorAttachmentCount;
    const std::uint32_t* pColorAttachmentLocations;
};
struct VkRenderingInputAttachmentIndexInfoKHR {
    VkStructureType sType;
    const void* pNext;
    std::uint32_t colorAttachmentCount;
    const std::uint32_t* pColorAttachmentInputIndices;
    const std::uint32_t* pDepthInputAttachmentIndex;
    const std::uint32_t* pStencilInputAttachmentIndex;
};
using PFN_vkCmdSetRenderingAttachmentLocationsKHR = void(VKAPI_PTR*)(VkCommandBuffer,
                                                                     const VkRenderingAttachmentLocationInfoKHR*);
using PFN_vkCmdSetRenderingInputAttachmentIndicesKHR = void(VKAPI_PTR*)(VkCommandBuffer,
                                                                        const VkRenderingInputAttachmentIndexInfoKHR*);
#endif

namespace nacre::gpu {

/// The extension's functions; null where the device lacks it.
struct LocalReadCalls {
    PFN_vkCmdSetRenderingAttachmentLocationsKHR setLocations = nullptr;
    PFN_vkCmdSetRenderingInputAttachmentIndicesKHR setInputs = nullptr;
};

}  // namespace nacre::gpu
