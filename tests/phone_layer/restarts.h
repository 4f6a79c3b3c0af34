#pragma once
// The encoders of MoltenVK 1.4, which that phone is drawn by. Each subpass has one of its own, and so has what follows
// where the number of input attachments of dynamic rendering changes. What is transient, and nobody reads as an input
// attachment, lives as long as its encoder: it is filled with noise wherever another one begins.
// (MoltenVK, MVKRenderPass.mm, MVKCommandBuffer.mm, MVKImage.mm.)

#include <vulkan/vulkan.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <mutex>
#include <vector>

#include "engine/gpu/local_read.h"
#include "tests/phone_layer/below.h"
#include "tests/phone_layer/density.h"
#include "tests/phone_layer/vertices.h"

namespace nacre::phone {

/// An attachment as an encoder knows it.
struct Tiled {
    bool depth = false, lost = false;  ///< lost: with its encoder
};
struct PlannedPass {
    std::vector<VkAttachmentDescription2> attachments;
    struct Subpass {
        std::vector<std::uint32_t> colors;
        std::uint32_t depth = VK_ATTACHMENT_UNUSED, views = 0;
    };
    std::vector<Subpass> subpasses;
};
/// What a command buffer draws to.
struct Encoding {
    const PlannedPass* pass = nullptr;  ///< null: dynamic rendering
    std::vector<Tiled> attachments;     ///< of the pass, or colours and then depth
    std::vector<bool> begun;            ///< of the pass
    std::uint32_t subpass = 0, inputs = 0, layers = 1;
    VkRect2D area{};
};

inline std::recursive_mutex restartsMutex;  // of what follows: several threads may have a device each
inline std::map<VkImage, VkImageUsageFlags> imageUsage;
inline std::map<VkImageView, VkImageUsageFlags> viewUsage;
inline std::map<VkFramebuffer, std::vector<VkImageView>> framebufferViews;
inline std::map<VkRenderPass, PlannedPass> plannedPasses;
inline std::map<VkCommandBuffer, Encoding> encodings;

inline bool lostWithEncoder(VkImageView view) {
    const VkImageUsageFlags usage = viewUsage[view];
    return (usage & VK_IMAGE_USAGE_TRANSIENT_ATTACHMENT_BIT) && !(usage & VK_IMAGE_USAGE_INPUT_ATTACHMENT_BIT);
}

/// Clears stripes to values that no picture is made of.
inline void fillWithNoise(VkCommandBuffer commands, const Encoding& e, VkClearAttachment attachment) {
    constexpr std::int32_t kStripe = 5;
    if (const char* file = std::getenv("NACRE_PHONE_DRAWS")) std::ofstream(file, std::ios::app) << "noise\n";
    for (std::int32_t y = 0; y < static_cast<std::int32_t>(e.area.extent.height); y += kStripe) {
        const float value = static_cast<float>(y * 7 % 11) / 10;
        if (attachment.aspectMask == VK_IMAGE_ASPECT_DEPTH_BIT)
            attachment.clearValue.depthStencil = {value, 0};
        else
            attachment.clearValue.color = {{value, 1 - value, value, 1}};
        const auto rows = std::min<std::uint32_t>(kStripe, e.area.extent.height - static_cast<std::uint32_t>(y));
        const VkClearRect rect{{{e.area.offset.x, e.area.offset.y + y}, {e.area.extent.width, rows}}, 0, e.layers};
        nextCmdClearAttachments(commands, 1, &attachment, 1, &rect);
    }
}

inline VKAPI_ATTR VkResult VKAPI_CALL CreateImage(VkDevice of, const VkImageCreateInfo* info,
                                                  const VkAllocationCallbacks* allocator, VkImage* image) {
    const std::lock_guard lock(restartsMutex);
    const VkResult result = nextCreateImage(of, info, allocator, image);
    if (result == VK_SUCCESS) imageUsage[*image] = info->usage, noteMap(*image, *info);
    return result;
}

inline VKAPI_ATTR VkResult VKAPI_CALL CreateImageView(VkDevice of, const VkImageViewCreateInfo* info,
                                                      const VkAllocationCallbacks* allocator, VkImageView* view) {
    const std::lock_guard lock(restartsMutex);
    const VkResult result = nextCreateImageView(of, info, allocator, view);
    if (result == VK_SUCCESS) viewUsage[*view] = imageUsage[info->image], noteMap(*view, *info);
    return result;
}

inline VKAPI_ATTR VkResult VKAPI_CALL CreateFramebuffer(VkDevice of, const VkFramebufferCreateInfo* info,
                                                        const VkAllocationCallbacks* allocator, VkFramebuffer* made) {
    const std::lock_guard lock(restartsMutex);
    const VkResult result = nextCreateFramebuffer(of, info, allocator, made);
    if (result == VK_SUCCESS)
        framebufferViews[*made].assign(info->pAttachments, info->pAttachments + info->attachmentCount),
            noteMap(*made, *info);
    return result;
}

inline void planEncoders(const VkRenderPassCreateInfo2& info, VkRenderPass made) {
    const std::lock_guard lock(restartsMutex);
    PlannedPass& pass = plannedPasses[made] = {};
    pass.attachments.assign(info.pAttachments, info.pAttachments + info.attachmentCount);
    for (std::uint32_t s = 0; s < info.subpassCount; ++s) {
        const VkSubpassDescription2& subpass = info.pSubpasses[s];
        PlannedPass::Subpass& planned = pass.subpasses.emplace_back();
        for (std::uint32_t i = 0; i < subpass.colorAttachmentCount; ++i)
            planned.colors.push_back(subpass.pColorAttachments[i].attachment);
        planned.views = subpass.viewMask;
        if (subpass.pDepthStencilAttachment) planned.depth = subpass.pDepthStencilAttachment->attachment;
    }
}

/// The encoder of a subpass begins. @param noise  it is not the first
inline void beginEncoder(VkCommandBuffer commands, Encoding& e, bool noise) {
    if (e.subpass >= e.pass->subpasses.size()) return;  // of a device that is no phone
    const PlannedPass::Subpass& subpass = e.pass->subpasses[e.subpass];
    const auto take = [&](std::uint32_t a, VkImageAspectFlags aspect, std::uint32_t color) {
        if (a == VK_ATTACHMENT_UNUSED) return;
        if (noise && e.begun[a] && e.attachments[a].lost) fillWithNoise(commands, e, {aspect, color, {}});
        e.begun[a] = true;
    };
    for (std::uint32_t i = 0; i < subpass.colors.size(); ++i) take(subpass.colors[i], VK_IMAGE_ASPECT_COLOR_BIT, i);
    take(subpass.depth, VK_IMAGE_ASPECT_DEPTH_BIT, 0);
}

inline VKAPI_ATTR void VKAPI_CALL CmdBeginRenderPass2KHR(VkCommandBuffer commands, const VkRenderPassBeginInfo* info,
                                                         const VkSubpassBeginInfo* begin) {
    const std::lock_guard lock(restartsMutex);
    Encoding& e = encodings[commands] = {};
    e.pass = &plannedPasses[info->renderPass];
    writeRegions(commands, info->pNext, info->renderArea.extent, e.pass->subpasses.size(), 1);
    nextCmdBeginRenderPass2KHR(commands, info, begin);
    beginWithMap(*info);
    e.begun.resize(e.pass->attachments.size());
    e.area = info->renderArea;
    beginVertices(commands, e.pass->subpasses.empty() ? 0 : e.pass->subpasses[0].views);
    countAttachments(commands, e.pass->attachments, info->renderArea.extent);
    for (const VkImageView view : framebufferViews[info->framebuffer])
        e.attachments.push_back({false, lostWithEncoder(view)});
    beginEncoder(commands, e, false);
}

inline VKAPI_ATTR void VKAPI_CALL CmdNextSubpass2KHR(VkCommandBuffer commands, const VkSubpassBeginInfo* begin,
                                                     const VkSubpassEndInfo* end) {
    const std::lock_guard lock(restartsMutex);
    nextCmdNextSubpass2KHR(commands, begin, end);
    Encoding& e = encodings[commands];
    ++e.subpass;
    beginEncoder(commands, e, molten());
}

inline VKAPI_ATTR void VKAPI_CALL CmdBeginRenderingKHR(VkCommandBuffer commands, const VkRenderingInfo* info) {
    const std::lock_guard lock(restartsMutex);
    nextCmdBeginRenderingKHR(commands, info);
    Encoding& e = encodings[commands] = {};
    e.area = info->renderArea;
    e.layers = info->layerCount;
    beginVertices(commands, info->viewMask);
    for (std::uint32_t i = 0; i < info->colorAttachmentCount; ++i)
        e.attachments.push_back({false, lostWithEncoder(info->pColorAttachments[i].imageView)});
    if (info->pDepthAttachment) e.attachments.push_back({true, lostWithEncoder(info->pDepthAttachment->imageView)});
}

inline VKAPI_ATTR void VKAPI_CALL CmdSetRenderingAttachmentLocationsKHR(VkCommandBuffer,
                                                                        const VkRenderingAttachmentLocationInfoKHR*) {}

inline VKAPI_ATTR void VKAPI_CALL
CmdSetRenderingInputAttachmentIndicesKHR(VkCommandBuffer commands, const VkRenderingInputAttachmentIndexInfoKHR* info) {
    const std::lock_guard lock(restartsMutex);
    Encoding& e = encodings[commands];
    if (info->colorAttachmentCount == e.inputs) return;
    e.inputs = info->colorAttachmentCount;
    for (std::uint32_t i = 0; i < e.attachments.size(); ++i) {
        const VkImageAspectFlags aspect =
            e.attachments[i].depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
        if (e.attachments[i].lost) fillWithNoise(commands, e, {aspect, e.attachments[i].depth ? 0 : i, {}});
    }
}

}  // namespace nacre::phone
