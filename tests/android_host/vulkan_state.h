#pragma once
// Between the two files of the Vulkan stand-in.

#define VK_USE_PLATFORM_ANDROID_KHR
#include <vulkan/vulkan.h>

#include <vector>

#include "tests/android_host/window.h"

namespace nacre::test {

struct DeviceRecord {
    VkInstance instance;
    VkPhysicalDevice physical;
    std::uint32_t queueFamily;
    PFN_vkGetDeviceProcAddr procedure;  ///< the loader's
    bool lost = false;
};

struct SwapchainRecord {
    VkDevice device;
    ANativeWindow* window;
    VkFormat format;
    VkExtent2D extent;
    int quarterTurns;
    std::vector<VkImage> images;
};

/// Told by the waits that vulkan.h lets a test watch.
void imageIsAwaited();
void deviceIsMade();
void fenceIsAwaited();
void commandsAreSubmitted();

/// The loader's function of an instance, or of none.
PFN_vkVoidFunction loaderFunction(VkInstance instance, const char* name);

/// Copies a presented image out, after `wait`, and leaves it as it was.
/// @returns its texels, 4 bytes each, in the image's own rows
std::vector<std::uint8_t> readBack(const DeviceRecord& device, VkDevice handle, VkQueue queue, VkImage image,
                                   VkExtent2D extent, const VkPresentInfoKHR& wait);

/// Texels as they are stored, turned back.
WindowPicture upright(const std::vector<std::uint8_t>& texels, const SwapchainRecord& swapchain);

}  // namespace nacre::test
