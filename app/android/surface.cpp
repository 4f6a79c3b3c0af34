#include "app/android/surface.h"

#define VK_USE_PLATFORM_ANDROID_KHR
#include <android/native_window.h>
#include <vulkan/vulkan.h>

#include <utility>

#include "engine/error.h"

namespace nacre::app {

bool NativeWindow::set(ANativeWindow* window) {
    const std::lock_guard lock(mutex_);
    if (window) ANativeWindow_acquire(window);
    if (window_) ANativeWindow_release(window_);
    window_ = window;
    return std::exchange(taken_, false);
}

SurfaceSource NativeWindow::makeSurface(std::shared_ptr<NativeWindow> window) {
    SurfaceSource source{.instanceExtensions = {VK_KHR_SURFACE_EXTENSION_NAME, VK_KHR_ANDROID_SURFACE_EXTENSION_NAME}};
    source.create = [window = std::move(window)](VkInstance instance) {
        const std::lock_guard lock(window->mutex_);
        VkAndroidSurfaceCreateInfoKHR info{};
        info.sType = VK_STRUCTURE_TYPE_ANDROID_SURFACE_CREATE_INFO_KHR;
        info.window = window->window_;
        if (!info.window) throw Error("cannot open a window", "", "the system took it away");
        VkSurfaceKHR surface = VK_NULL_HANDLE;
        if (const VkResult result = vkCreateAndroidSurfaceKHR(instance, &info, nullptr, &surface); result != VK_SUCCESS)
            throw Error("cannot open a window", "", "vkCreateAndroidSurfaceKHR says " + std::to_string(result));
        window->taken_ = true;
        return surface;
    };
    return source;
}

}  // namespace nacre::app
