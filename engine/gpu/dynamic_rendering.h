#pragma once
// Executes a plan's render pass by dynamic rendering whose subpasses read what earlier ones wrote at the same pixel
// (VK_KHR_dynamic_rendering_local_read, core in Vulkan 1.4). All colour attachments are bound for the whole render
// pass; each subpass selects the ones that it draws to and reads.

#include <array>
#include <span>

#include "engine/gpu/local_read.h"
#include "engine/gpu/resources.h"
#include "engine/graph/plan.h"

namespace nacre::gpu {

/// Attachment formats that a pipeline needs without a VkRenderPass. Empty if there is a VkRenderPass.
struct RenderingFormats {
    static constexpr std::uint32_t kMost = 8;
    std::uint32_t colorCount = 0;  ///< in the whole render pass
    std::array<VkFormat, kMost> colors{};
    VkFormat depth = VK_FORMAT_UNDEFINED;
    std::uint32_t viewMask = 0;                    ///< that of the graph::RenderPassPlan
    std::array<std::uint32_t, kMost> locations{};  ///< output location of each colour attachment in this subpass, or
                                                   ///< none
    std::array<std::uint32_t, kMost> inputs{};     ///< input attachment index of each in this subpass, or none
    bool any() const { return colorCount > 0 || depth != VK_FORMAT_UNDEFINED; }
    friend bool operator==(const RenderingFormats&, const RenderingFormats&) = default;
};

/// Whether a driver supports dynamic rendering with local reads and is trusted with it
/// (engine/graph/known_drivers.cpp). NACRE_NO_DYNAMIC_RENDERING=1 turns it off. @param validate  under validation: a
/// layer older than the extension reports every use as an error
bool readsLocally(const vk::raii::PhysicalDevice& device, bool validate);
/// @param device  created with the features that readsLocally() checks
LocalReadCalls loadLocalReadCalls(const vk::raii::Device& device);

/// One render pass of a plan while it is recorded. Does not allocate.
class DynamicRendering {
public:
    /// @param images  by graph index; all outlive this
    DynamicRendering(const Device& device, const graph::RenderPassPlan& plan, std::span<const ImageRef> images,
                     const vk::raii::CommandBuffer& commands);
    /// Whether the device executes a render pass this way: one with several subpasses, or inputs.
    static bool takes(const Device& device, const graph::RenderPassPlan& plan);

    RenderingFormats findFormats(std::uint32_t subpass) const;
    /// @param chain  continues the structure that begins it
    void begin(const void* chain) const;
    /// Selects the attachments that the subpass draws to and reads, with a barrier after earlier subpasses.
    RenderingFormats beginSubpass(std::uint32_t subpass) const;
    void end() const;
    /// Layout in which a subpass reads input attachments.
    vk::ImageLayout inputLayout(std::uint32_t subpass) const;

private:
    std::span<const std::uint32_t> colors() const { return {colors_.data(), colorCount_}; }
    vk::ImageLayout findLayout(std::uint32_t attachment) const;
    void transition(bool entering) const;

    const Device& device_;
    const graph::RenderPassPlan& plan_;
    std::span<const ImageRef> images_;
    const vk::raii::CommandBuffer& commands_;
    std::array<std::uint32_t, RenderingFormats::kMost> colors_{};  // attachments
    std::uint32_t colorCount_ = 0;
    std::int32_t depth_ = -1;
};

/// The structures that pass the formats to a pipeline. Points into the formats, and into itself.
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
