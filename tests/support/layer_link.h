#pragma once
// Shared by the Vulkan layers of the tests: finding the functions below a layer, and listing extensions.

#include <vulkan/vk_layer.h>

#include <algorithm>
#include <vector>

namespace nacre::test {

/// The loader's link in a chain of creation structures, moved on to the layer below: what calls go to from here.
template <typename Link>
auto* nextLayer(const void* chain, VkStructureType type) {
    auto* info = static_cast<Link*>(const_cast<void*>(chain));
    while (info && !(info->sType == type && info->function == VK_LAYER_LINK_INFO))
        info = static_cast<Link*>(const_cast<void*>(info->pNext));
    auto* next = info->u.pLayerInfo;
    info->u.pLayerInfo = next->pNext;
    return next;
}

/// The extensions of a device, as the layer below has them.
inline std::vector<VkExtensionProperties> listExtensions(PFN_vkEnumerateDeviceExtensionProperties below,
                                                         VkPhysicalDevice device) {
    std::uint32_t count = 0;
    below(device, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> all(count);
    below(device, nullptr, &count, all.data());
    return all;
}

/// Answers with as many extensions as the program has room for, or with their number.
inline VkResult tellExtensions(const std::vector<VkExtensionProperties>& all, std::uint32_t* count,
                               VkExtensionProperties* list) {
    const auto most = static_cast<std::uint32_t>(all.size()), room = list ? *count : most;
    *count = std::min(room, most);
    if (list) std::copy_n(all.begin(), *count, list);
    return room < most ? VK_INCOMPLETE : VK_SUCCESS;
}

}  // namespace nacre::test
