#pragma once
// A window that nobody sees: VK_EXT_headless_surface, which SwiftShader has.

#include <vulkan/vulkan.h>

#include <string>

#include "engine/device_options.h"
#include "engine/error.h"

namespace nacre::test {

inline SurfaceSource headlessSurface() {
    SurfaceSource source;
    source.instanceExtensions = {VK_KHR_SURFACE_EXTENSION_NAME, VK_EXT_HEADLESS_SURFACE_EXTENSION_NAME};
    source.create = [](VkInstance instance) {
        const auto make = reinterpret_cast<PFN_vkCreateHeadlessSurfaceEXT>(
            vkGetInstanceProcAddr(instance, "vkCreateHeadlessSurfaceEXT"));
        const VkHeadlessSurfaceCreateInfoEXT info{VK_STRUCTURE_TYPE_HEADLESS_SURFACE_CREATE_INFO_EXT, nullptr, 0};
        VkSurfaceKHR surface = VK_NULL_HANDLE;
        const VkResult result = make(instance, &info, nullptr, &surface);
        if (result != VK_SUCCESS) throw Error("cannot make a surface", "", std::to_string(result));
        return surface;
    };
    return source;
}

}  // namespace nacre::test
