#pragma once
// VK_KHR_present_id2 and VK_KHR_present_wait2, for older headers (the extensions are in 1.4.317; bookworm has 1.3.239).
// Names, numbers and members are the specification's. They number presents, and wait for their display.

#include <vulkan/vulkan_core.h>

#include <cstdint>

#ifndef VK_KHR_present_id2
#define VK_KHR_PRESENT_ID_2_EXTENSION_NAME "VK_KHR_present_id2"
constexpr auto VK_STRUCTURE_TYPE_SURFACE_CAPABILITIES_PRESENT_ID_2_KHR = static_cast<VkStructureType>(1000479000);
constexpr auto VK_STRUCTURE_TYPE_PRESENT_ID_2_KHR = static_cast<VkStructureType>(1000479001);
constexpr auto VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_ID_2_FEATURES_KHR = static_cast<VkStructureType>(1000479002);
constexpr auto VK_SWAPCHAIN_CREATE_PRESENT_ID_2_BIT_KHR = static_cast<VkSwapchainCreateFlagBitsKHR>(0x40);

struct VkSurfaceCapabilitiesPresentId2KHR {
    VkStructureType sType;
    void* pNext;
    VkBool32 presentId2Supported;
};
struct VkPresentId2KHR {
    VkStructureType sType;
    const void* pNext;
    std::uint32_t swapchainCount;
    const std::uint64_t* pPresentIds;
};
struct VkPhysicalDevicePresentId2FeaturesKHR {
    VkStructureType sType;
    void* pNext;
    VkBool32 presentId2;
};
#endif

#ifndef VK_KHR_present_wait2
#define VK_KHR_PRESENT_WAIT_2_EXTENSION_NAME "VK_KHR_present_wait2"
constexpr auto VK_STRUCTURE_TYPE_SURFACE_CAPABILITIES_PRESENT_WAIT_2_KHR = static_cast<VkStructureType>(1000480000);
constexpr auto VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_WAIT_2_FEATURES_KHR = static_cast<VkStructureType>(1000480001);
constexpr auto VK_STRUCTURE_TYPE_PRESENT_WAIT_2_INFO_KHR = static_cast<VkStructureType>(1000480002);
constexpr auto VK_SWAPCHAIN_CREATE_PRESENT_WAIT_2_BIT_KHR = static_cast<VkSwapchainCreateFlagBitsKHR>(0x80);

struct VkSurfaceCapabilitiesPresentWait2KHR {
    VkStructureType sType;
    void* pNext;
    VkBool32 presentWait2Supported;
};
struct VkPhysicalDevicePresentWait2FeaturesKHR {
    VkStructureType sType;
    void* pNext;
    VkBool32 presentWait2;
};
struct VkPresentWait2InfoKHR {
    VkStructureType sType;
    const void* pNext;
    std::uint64_t presentId;
    std::uint64_t timeout;
};
using PFN_vkWaitForPresent2KHR = VkResult(VKAPI_PTR*)(VkDevice, VkSwapchainKHR, const VkPresentWait2InfoKHR*);
#endif
