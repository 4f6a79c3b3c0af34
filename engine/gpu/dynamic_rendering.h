#pragma once
// The second way to carry out a render pass of a plan: dynamic rendering whose subpasses read what earlier ones wrote
// at the same pixel (VK_KHR_dynamic_rendering_local_read, core in Vulkan 1.4). All colour attachments of the render
// pass are there from its beginning to its end; each subpass says which of them it draws to, and which it reads.

#include <array>
#include <span>
#include <vector>

#include "engine/gpu/local_read.h"
#include "engine/gpu/resources.h"
#include "engine/graph/plan.h"

namespace nacre::gpu {

/// What a pipeline must know of the attachments, where there is no VkRenderPass to tell it. No colours and no depth:
/// there is one.
struct RenderingFormats {
    static constexpr std::uint32_t kMost = 8;
    std::uint32_t colorCount = 0;  ///< of the whole render pass
    std::array<VkFormat, kMost> colors{};
    VkFormat depth = VK_FORMAT_UNDEFINED;
    std::array<std::uint32_t, kMost> locations{};  ///< a colour attachment's output in this subpass, or none
    std::array<std::uint32_t, kMost> inputs{};     ///< its number as an input attachment in this subpass, or none
    bool any() const { return colorCount > 0 || depth != VK_FORMAT_UNDEFINED; }
    friend bool operator==(const RenderingFormats&, const RenderingFormats&) = default;
};

/// Whether a driver can render dynamically with local reads, and is trusted to (engine/graph/known_drivers.cpp).
/// NACRE_NO_DYNAMIC_RENDERING=1 says no for all: as if the driver had never heard of it.
/// @param validate  the validation layer is there: one that is older than the extension calls every use of it an error
bool readsLocally(const vk::raii::PhysicalDevice& device, bool validate);
/// @param device  made with what readsLocally() asks for
LocalReadCalls localReadCallsOf(const vk::raii::Device& device);

/// One render pass of a plan while it is recorded.
class DynamicRendering {
public:
    /// @param images  by graph index; all outlive this
    DynamicRendering(const Device& device, const graph::RenderPassPlan& plan, std::span<const ImageRef> images,
                     const vk::raii::CommandBuffer& commands);
    /// Whether the device carries out such a render pass in this way: one of several subpasses, or with inputs.
    static bool takes(const Device& device, const graph::RenderPassPlan& plan);

    RenderingFormats formatsOf(std::uint32_t subpass) const;
    void begin() const;
    /// What it draws to and reads from here on; orders it behind earlier ones.
    RenderingFormats beginSubpass(std::uint32_t subpass) const;
    void end() const;
    /// Of what a subpass reads as input attachment.
    vk::ImageLayout inputLayout(std::uint32_t subpass) const;

private:
    vk::ImageLayout layoutOf(std::uint32_t attachment) const;
    void transition(bool entering) const;

    const Device& device_;
    const graph::RenderPassPlan& plan_;
    std::span<const ImageRef> images_;
    const vk::raii::CommandBuffer& commands_;
    std::vector<std::uint32_t> colors_;  // attachments
    std::int32_t depth_ = -1;
};

/// What tells a pipeline of them. Points into the formats, and into itself.
class RenderingChain {
public:
    explicit RenderingChain(const RenderingFormats& formats);
    RenderingChain(const RenderingChain&) = delete;
    const void* first() const { return formats_.any() ? &info_ : nullptr; }
    const VkRenderingAttachmentLocationInfoKHR& locations() const { return locations_; }
    const VkRenderingInputAttachmentIndexInfoKHR& inputs() const { return inputs_; }

private:
    const RenderingFormats& formats_;
    VkRenderingInputAttachmentIndexInfoKHR inputs_;
    VkRenderingAttachmentLocationInfoKHR locations_;
    VkPipelineRenderingCreateInfo info_;
};

}  // namespace nacre::gpu
