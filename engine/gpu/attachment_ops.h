#pragma once
// What happens to an attachment where a render pass begins and ends, in Vulkan's words.

#include <vulkan/vulkan_raii.hpp>

#include "engine/graph/plan.h"

namespace nacre::gpu {

inline vk::AttachmentLoadOp loadOp(graph::Load load) {
    switch (load) {
        case graph::Load::clear:
            return vk::AttachmentLoadOp::eClear;
        case graph::Load::load:
            return vk::AttachmentLoadOp::eLoad;
        case graph::Load::dontCare:
            return vk::AttachmentLoadOp::eDontCare;
    }
    return {};
}

inline vk::AttachmentStoreOp storeOp(graph::Store store) {
    switch (store) {
        case graph::Store::store:
            return vk::AttachmentStoreOp::eStore;
        case graph::Store::dontCare:
            return vk::AttachmentStoreOp::eDontCare;
        case graph::Store::none:
            return vk::AttachmentStoreOp::eNone;
    }
    return {};
}

}  // namespace nacre::gpu
