#include "engine/gpu/dynamic_rendering.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "engine/gpu/attachment_ops.h"
#include "engine/gpu/caps.h"
#include "engine/graph/plan_internal.h"

namespace nacre::gpu {
namespace {

constexpr std::uint32_t kNone = VK_ATTACHMENT_UNUSED;
constexpr auto kInputLayout = static_cast<vk::ImageLayout>(VK_IMAGE_LAYOUT_RENDERING_LOCAL_READ_KHR);

/// All uses of an attachment between begin and end, including load and store.
graph::State workOn(VkFormat format) {
    graph::State state = graph::verbState(graph::isDepthFormat(format) ? graph::Verb::depth : graph::Verb::color,
                                          graph::PassKind::graphics);
    if (!graph::isDepthFormat(format)) {
        const graph::State read = graph::verbState(graph::Verb::input, graph::PassKind::graphics);
        state.stages |= read.stages;
        state.access |= read.access;
    }
    return state;
}

/// The state that the plan's barriers expect at a render pass.
graph::State before(const graph::RenderPassPlan& plan) {
    graph::State state{0, 0, {}};
    for (const graph::Dependency& d : plan.dependencies) {
        if (d.from != VK_SUBPASS_EXTERNAL) continue;
        state.stages |= d.fromStages;
        state.access |= d.fromAccess;
    }
    return state;
}

bool trusted(const vk::raii::PhysicalDevice& device) {
    const graph::DriverIdentity identity = driverIdentity(device);
    return identity.driver != VkDriverId{} && !graph::has(graph::Quirk::noLocalRead, identity);
}

}  // namespace

bool readsLocally(const vk::raii::PhysicalDevice& device, bool validate) {
    const char* off = std::getenv("NACRE_NO_DYNAMIC_RENDERING");
    if (off && *off && std::string_view(off) != "0") return false;
    if (validate && !validationKnows(VK_MAKE_API_VERSION(0, 1, 3, 272))) return false;
    // Drivers of Vulkan 1.4 still list it, although it is core there.
    for (const char* name : {VK_KHR_DYNAMIC_RENDERING_LOCAL_READ_EXTENSION_NAME,
                             VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME, VK_KHR_DEPTH_STENCIL_RESOLVE_EXTENSION_NAME})
        if (!hasExtension(device, name)) return false;
    // Each colour attachment has its own blend state.
    if (!trusted(device) || !device.getFeatures().independentBlend) return false;
    VkPhysicalDeviceDynamicRenderingLocalReadFeaturesKHR read{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_LOCAL_READ_FEATURES_KHR, nullptr, false};
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &read, {}};
    device.getDispatcher()->vkGetPhysicalDeviceFeatures2(*device, &features);
    return read.dynamicRenderingLocalRead;
}

LocalReadCalls loadLocalReadCalls(const vk::raii::Device& device) {
    const auto call = [&](const char* name) { return device.getProcAddr(name); };
    return {
        reinterpret_cast<PFN_vkCmdSetRenderingAttachmentLocationsKHR>(call("vkCmdSetRenderingAttachmentLocationsKHR")),
        reinterpret_cast<PFN_vkCmdSetRenderingInputAttachmentIndicesKHR>(
            call("vkCmdSetRenderingInputAttachmentIndicesKHR"))};
}

DynamicRendering::DynamicRendering(const Device& device, const graph::RenderPassPlan& plan,
                                   std::span<const ImageRef> images, const vk::raii::CommandBuffer& commands)
    : device_(device), plan_(plan), images_(images), commands_(commands) {
    for (std::uint32_t a = 0; a < plan.attachments.size(); ++a)
        if (graph::isDepthFormat(plan.attachments[a].format))
            depth_ = static_cast<std::int32_t>(a);
        else
            colors_.at(colorCount_++) = a;
}

bool DynamicRendering::takes(const Device& device, const graph::RenderPassPlan& plan) {
    if (!device.caps().localRead || plan.samples > 1 || plan.density >= 0) return false;
    // Without inputs, a VkRenderPass works as well.
    const bool reads = plan.subpasses.size() > 1 ||
                       std::ranges::any_of(plan.subpasses, [](const graph::Subpass& s) { return !s.inputs.empty(); });
    if (!reads) return false;
    const auto depths = std::count_if(plan.attachments.begin(), plan.attachments.end(),
                                      [](const graph::Attachment& a) { return graph::isDepthFormat(a.format); });
    const std::size_t most =
        std::min<std::size_t>(device.caps().plan.maxColorAttachments, std::size_t{RenderingFormats::kMost});
    return depths <= 1 && plan.attachments.size() - static_cast<std::size_t>(depths) <= most;
}

/// One layout from beginning to end, unlike in the plan.
vk::ImageLayout DynamicRendering::findLayout(std::uint32_t a) const {
    bool read = false;
    for (const graph::Subpass& subpass : plan_.subpasses) {
        graph::Verb verb{};
        if (!graph::attachmentVerb(subpass, a, verb)) continue;
        if (verb == graph::Verb::ordered) return vk::ImageLayout::eGeneral;
        read = read || verb == graph::Verb::input;
    }
    if (read) return kInputLayout;
    return static_cast<std::int32_t>(a) == depth_ ? vk::ImageLayout::eDepthStencilAttachmentOptimal
                                                  : vk::ImageLayout::eColorAttachmentOptimal;
}

vk::ImageLayout DynamicRendering::inputLayout(std::uint32_t s) const {
    const std::vector<std::uint32_t>& inputs = plan_.subpasses[s].inputs;
    return inputs.empty() ? kInputLayout : findLayout(inputs.front());
}

/// Does what a VkRenderPass does implicitly: transitions into its layouts, after earlier work, and out of them. The
/// plan's own barriers continue from the attachments' stages.
void DynamicRendering::transition(bool entering) const {
    std::array<vk::ImageMemoryBarrier, RenderingFormats::kMost + 1> barriers;  // and depth
    std::uint32_t count = 0;
    vk::PipelineStageFlags own, earlier;
    if (entering) earlier = vk::PipelineStageFlags(before(plan_).stages);
    for (std::uint32_t a = 0; a < plan_.attachments.size(); ++a) {
        const graph::Attachment& attachment = plan_.attachments[a];
        const auto planned = static_cast<vk::ImageLayout>(entering ? attachment.initialLayout : attachment.finalLayout);
        const vk::ImageLayout inside = findLayout(a);
        if (planned == inside) continue;
        const graph::State work = workOn(attachment.format);
        own |= vk::PipelineStageFlags(work.stages);
        // The plan's barrier has already made existing contents available.
        vk::AccessFlags from;
        if (!entering) from = vk::AccessFlags(work.access);
        if (entering && planned == vk::ImageLayout::eUndefined) from = vk::AccessFlags(before(plan_).access);
        const auto aspect =
            static_cast<std::int32_t>(a) == depth_ ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
        barriers.at(count++) = vk::ImageMemoryBarrier(
            from, vk::AccessFlags(work.access), entering ? planned : inside, entering ? inside : planned,
            VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, images_[attachment.image].handle,
            vk::ImageSubresourceRange(aspect, 0, 1, images_[attachment.image].firstLayer, plan_.layers));
    }
    const vk::ArrayProxy<const vk::ImageMemoryBarrier> some(count, barriers.data());
    if (count > 0) commands_.pipelineBarrier(own | earlier, own, {}, {}, {}, some);
}

void DynamicRendering::begin(const void* chain) const {
    transition(true);
    const auto attachmentInfo = [&](std::uint32_t a) {
        const graph::Attachment& attachment = plan_.attachments[a];
        VkRenderingAttachmentInfo info{};
        info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
        info.imageView = images_[attachment.image].view;
        info.imageLayout = static_cast<VkImageLayout>(findLayout(a));
        info.loadOp = static_cast<VkAttachmentLoadOp>(loadOp(attachment.load));
        info.storeOp = static_cast<VkAttachmentStoreOp>(storeOp(attachment.store));
        if (graph::isDepthFormat(attachment.format))
            info.clearValue.depthStencil = {attachment.clear.value[0], 0};
        else
            std::copy(attachment.clear.value.begin(), attachment.clear.value.end(), info.clearValue.color.float32);
        return info;
    };
    std::array<VkRenderingAttachmentInfo, RenderingFormats::kMost> infos{};
    std::ranges::transform(colors(), infos.begin(), attachmentInfo);
    VkRenderingInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    info.pNext = chain;
    info.renderArea.extent = {plan_.extent.width, plan_.extent.height};
    info.layerCount = plan_.viewMask ? 1 : plan_.layers;
    info.viewMask = plan_.viewMask;
    info.colorAttachmentCount = colorCount_;
    info.pColorAttachments = infos.data();
    VkRenderingAttachmentInfo depth{};
    if (depth_ >= 0) depth = attachmentInfo(static_cast<std::uint32_t>(depth_)), info.pDepthAttachment = &depth;
    commands_.getDispatcher()->vkCmdBeginRenderingKHR(*commands_, &info);
}

RenderingFormats DynamicRendering::findFormats(std::uint32_t s) const {
    const graph::Subpass& subpass = plan_.subpasses[s];
    const auto findIndex = [](const std::vector<std::uint32_t>& list, std::uint32_t a) {
        const auto it = std::find(list.begin(), list.end(), a);
        return it == list.end() ? kNone : static_cast<std::uint32_t>(it - list.begin());
    };
    RenderingFormats formats{.colorCount = colorCount_, .viewMask = plan_.viewMask};
    for (std::size_t i = 0; i < colorCount_; ++i) {
        formats.colors[i] = plan_.attachments[colors_[i]].format;
        formats.locations[i] = findIndex(subpass.colors, colors_[i]);
        formats.inputs[i] = findIndex(subpass.inputs, colors_[i]);
    }
    if (depth_ >= 0) formats.depth = plan_.attachments[static_cast<std::size_t>(depth_)].format;
    return formats;
}

RenderingFormats DynamicRendering::beginSubpass(std::uint32_t s) const {
    for (const graph::Dependency& d : plan_.dependencies) {
        if (d.to != s || d.from == VK_SUBPASS_EXTERNAL || d.from == s) continue;
        vk::DependencyFlags flags = vk::DependencyFlagBits::eByRegion;
        if (plan_.viewMask != 0) flags |= vk::DependencyFlagBits::eViewLocal;
        commands_.pipelineBarrier(vk::PipelineStageFlags(d.fromStages), vk::PipelineStageFlags(d.toStages), flags,
                                  vk::MemoryBarrier(vk::AccessFlags(d.fromAccess), vk::AccessFlags(d.toAccess)), {},
                                  {});
    }
    const RenderingFormats formats = findFormats(s);
    const RenderingChain chain(formats);
    device_.localReadCalls().setLocations(*commands_, &chain.locations());
    device_.localReadCalls().setInputs(*commands_, &chain.inputs());
    return formats;
}

void DynamicRendering::end() const {
    commands_.getDispatcher()->vkCmdEndRenderingKHR(*commands_);
    transition(false);
}

RenderingChain::RenderingChain(const RenderingFormats& formats)
    : formats_(formats),
      inputs_{VK_STRUCTURE_TYPE_RENDERING_INPUT_ATTACHMENT_INDEX_INFO_KHR,
              nullptr,
              formats.colorCount,
              formats_.inputs.data(),
              nullptr,
              nullptr},
      locations_{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_LOCATION_INFO_KHR, &inputs_, formats.colorCount,
                 formats_.locations.data()},
      info_{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
            &locations_,
            formats.viewMask,
            formats.colorCount,
            formats_.colors.data(),
            formats.depth,
            VK_FORMAT_UNDEFINED} {}

}  // namespace nacre::gpu
