#pragma once
// What Adreno 6xx drivers below 512.503 crash at: a dispatch behind dynamic viewport or scissor state of the same
// command buffer (github.com/godotengine/godot pull request 91514). This phone's aborts.

#include <vulkan/vulkan.h>

#include <cstdio>
#include <cstdlib>
#include <set>

#include "tests/phone_layer/below.h"

namespace nacre::phone {

inline std::set<VkCommandBuffer> dynamicStateSet;

inline VKAPI_ATTR VkResult VKAPI_CALL BeginCommandBuffer(VkCommandBuffer commands,
                                                         const VkCommandBufferBeginInfo* info) {
    dynamicStateSet.erase(commands);
    return nextBeginCommandBuffer(commands, info);
}

inline VKAPI_ATTR void VKAPI_CALL CmdSetViewport(VkCommandBuffer commands, std::uint32_t first, std::uint32_t count,
                                                 const VkViewport* viewports) {
    dynamicStateSet.insert(commands);
    nextCmdSetViewport(commands, first, count, viewports);
}

inline VKAPI_ATTR void VKAPI_CALL CmdSetScissor(VkCommandBuffer commands, std::uint32_t first, std::uint32_t count,
                                                const VkRect2D* scissors) {
    dynamicStateSet.insert(commands);
    nextCmdSetScissor(commands, first, count, scissors);
}

/// To be called at each dispatch.
inline void crashBehindDraws(VkCommandBuffer commands) {
    if (!adreno() || !dynamicStateSet.count(commands)) return;
    std::fprintf(stderr, "phone: a dispatch behind draws in one command buffer\n");
    std::abort();
}

}  // namespace nacre::phone
