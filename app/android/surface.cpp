#include "app/android/surface.h"

#define VK_USE_PLATFORM_ANDROID_KHR
#include <vulkan/vulkan.h>

#include "engine/error.h"

namespace nacre::app {

SurfaceSource surfaceOf(std::function<ANativeWindow*()> window) {
    SurfaceSource source;
    source.instanceExtensions = {VK_KHR_SURFACE_EXTENSION_NAME, VK_KHR_ANDROID_SURFACE_EXTENSION_NAME};
    source.create = [window = std::move(window)](VkInstance instance) {
        VkAndroidSurfaceCreateInfoKHR info{};
        info.sType = VK_STRUCTURE_TYPE_ANDROID_SURFACE_CREATE_INFO_KHR;
        info.window = window();
        if (!info.window) throw Error("cannot open a window", "", "the system took it away");
        VkSurfaceKHR surface = VK_NULL_HANDLE;
        if (const VkResult result = vkCreateAndroidSurfaceKHR(instance, &info, nullptr, &surface); result != VK_SUCCESS)
            throw Error("cannot open a window", "", "vkCreateAndroidSurfaceKHR says " + std::to_string(result));
        return surface;
    };
    return source;
}

}  // namespace nacre::app
