#pragma once
// What a driver tells of its tile: it merges every render pass into one, and commits nothing of what stays there.
// NACRE_PHONE_TILE=small: it merges nothing, tells why, and commits every byte.

#include <vulkan/vulkan.h>

#include <cstdlib>
#include <cstring>
#include <string_view>

namespace nacre::phone {

inline bool smallTile() {
    const char* tile = std::getenv("NACRE_PHONE_TILE");
    return tile && std::string_view(tile) == "small";
}

template <typename Found>
const Found* chained(const void* next, VkStructureType type) {
    for (auto* s = static_cast<const VkBaseInStructure*>(next); s; s = s->pNext)
        if (s->sType == type) return reinterpret_cast<const Found*>(s);
    return nullptr;
}

/// Fills in what a program asked for when it made a render pass.
inline void tellOfMerges(const VkRenderPassCreateInfo2& info) {
    const auto* question = chained<VkRenderPassCreationFeedbackCreateInfoEXT>(
        info.pNext, VK_STRUCTURE_TYPE_RENDER_PASS_CREATION_FEEDBACK_CREATE_INFO_EXT);
    if (question) question->pRenderPassFeedback->postMergeSubpassCount = smallTile() ? info.subpassCount : 1;
    for (std::uint32_t i = 0; i < info.subpassCount; ++i) {
        const auto* subpass = chained<VkRenderPassSubpassFeedbackCreateInfoEXT>(
            info.pSubpasses[i].pNext, VK_STRUCTURE_TYPE_RENDER_PASS_SUBPASS_FEEDBACK_CREATE_INFO_EXT);
        if (!subpass) continue;
        VkRenderPassSubpassFeedbackInfoEXT& answer = *subpass->pSubpassFeedback;
        const bool apart = smallTile() && i > 0;
        answer.subpassMergeStatus =
            apart ? VK_SUBPASS_MERGE_STATUS_NOT_MERGED_INSUFFICIENT_STORAGE_EXT : VK_SUBPASS_MERGE_STATUS_MERGED_EXT;
        std::strcpy(answer.description, apart ? "the tile is full" : "");
        answer.postMergeIndex = smallTile() ? i : 0;
    }
}

/// What a driver has of lazily allocated memory.
inline VkDeviceSize committed(VkDeviceSize size) { return smallTile() ? size : 0; }

}  // namespace nacre::phone
