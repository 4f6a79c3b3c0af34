#pragma once
// What a tool that records frames learns: NACRE_PHONE_FRAMES may name a file that gets a line for each submission which
// says what frame it belongs to: the frame's number, and whether it ends there.

#include <vulkan/vulkan.h>

#include <cstdlib>
#include <fstream>
#include <vector>

#include "engine/gpu/frame_boundary.h"
#include "tests/phone_layer/below.h"
#include "tests/phone_layer/clock.h"
#include "tests/phone_layer/density.h"
#include "tests/phone_layer/feedback.h"

namespace nacre::phone {

inline VKAPI_ATTR VkResult VKAPI_CALL QueueSubmit(VkQueue queue, std::uint32_t count, const VkSubmitInfo* infos,
                                                  VkFence fence) {
    const char* file = std::getenv("NACRE_PHONE_FRAMES");
    std::vector<VkSubmitInfo> below(infos, infos + count);
    for (VkSubmitInfo& info : below) {
        const auto* frame = chained<VkFrameBoundaryEXT>(info.pNext, VK_STRUCTURE_TYPE_FRAME_BOUNDARY_EXT);
        if (!frame) continue;
        if (file) std::ofstream(file, std::ios::app) << frame->frameID << (frame->flags ? " ends\n" : " goes on\n");
        if (info.pNext != frame) std::abort();  // nothing else is chained to a submission
        info.pNext = frame->pNext;              // the driver knows nothing of it
    }
    tellWork();
    submitMaps();
    return nextQueueSubmit(queue, count, below.data(), fence);
}

}  // namespace nacre::phone
