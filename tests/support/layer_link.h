#pragma once
// How a Vulkan layer of the tests finds what lies below it.

#include <vulkan/vk_layer.h>

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

}  // namespace nacre::test
