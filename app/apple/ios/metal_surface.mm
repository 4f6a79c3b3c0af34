#include "app/apple/ios/metal_surface.h"

#define VK_USE_PLATFORM_METAL_EXT
#include <vulkan/vulkan.h>

#include "engine/error.h"

namespace nacre::app {

SurfaceSource makeSurface(CAMetalLayer* layer) {
    SurfaceSource source;
    source.instanceExtensions = {VK_KHR_SURFACE_EXTENSION_NAME, VK_EXT_METAL_SURFACE_EXTENSION_NAME};
    source.create = [layer](VkInstance instance) {
        const auto make =
            reinterpret_cast<PFN_vkCreateMetalSurfaceEXT>(vkGetInstanceProcAddr(instance, "vkCreateMetalSurfaceEXT"));
        VkMetalSurfaceCreateInfoEXT info{};
        info.sType = VK_STRUCTURE_TYPE_METAL_SURFACE_CREATE_INFO_EXT;
        info.pLayer = layer;
        VkSurfaceKHR surface = VK_NULL_HANDLE;
        if (!make || make(instance, &info, nullptr, &surface) != VK_SUCCESS)
            throw Error("cannot draw into the view", "", "Vulkan makes no surface for its Metal layer");
        return surface;
    };
    return source;
}

}  // namespace nacre::app
