#pragma once
// Load and store operations of an attachment, as Vulkan's enums.

#include <vulkan/vulkan_raii.hpp>

#include "engine/graph/plan.h"

namespace nacre::gpu {

inline vk::AttachmentLoadOp loadOp(graph::Load load) {
    return load == graph::Load::clear  ? vk::AttachmentLoadOp::eClear
           : load == graph::Load::load ? vk::AttachmentLoadOp::eLoad
                                       : vk::AttachmentLoadOp::eDontCare;
}

inline vk::AttachmentStoreOp storeOp(graph::Store store) {
    return store == graph::Store::store      ? vk::AttachmentStoreOp::eStore
           : store == graph::Store::dontCare ? vk::AttachmentStoreOp::eDontCare
                                             : vk::AttachmentStoreOp::eNone;
}

}  // namespace nacre::gpu
