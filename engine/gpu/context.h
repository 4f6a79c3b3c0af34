#pragma once

#include <vulkan/vulkan_raii.hpp>

namespace nacre::gpu {

/// Where Vulkan's functions come from: a library that is looked for at run time; or, with NACRE_LINKED_VULKAN (CMake),
/// the one that the program is linked with. An iPhone has none to be found.
inline vk::raii::Context makeContext() {
#if VULKAN_HPP_ENABLE_DYNAMIC_LOADER_TOOL
    return {};
#else
    return vk::raii::Context(vkGetInstanceProcAddr);
#endif
}

}  // namespace nacre::gpu
