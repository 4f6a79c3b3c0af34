#pragma once

#include <vulkan/vulkan_raii.hpp>

namespace nacre::gpu {

/// Vulkan's entry point: from a library loaded at run time, or, with NACRE_LINKED_VULKAN (CMake), from the one that the
/// program is linked with (iPhones have no loadable one).
inline vk::raii::Context makeContext() {
#if VULKAN_HPP_ENABLE_DYNAMIC_LOADER_TOOL
    return {};
#else
    return vk::raii::Context(vkGetInstanceProcAddr);
#endif
}

}  // namespace nacre::gpu
