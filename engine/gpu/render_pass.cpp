#include "engine/gpu/attachment_ops.h"
#include "engine/gpu/execute.h"
#include "engine/graph/plan_internal.h"

namespace nacre::gpu {
namespace {

vk::AttachmentReference2 reference(std::uint32_t attachment, graph::Verb verb, VkFormat format) {
    const auto aspect =
        graph::isDepthFormat(format) ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
    return {attachment, static_cast<vk::ImageLayout>(graph::verbState(verb, graph::PassKind::graphics).layout), aspect};
}

/// A view reads only what it wrote itself.
vk::DependencyFlags dependencyFlags(const graph::Dependency& d, const graph::RenderPassPlan& plan) {
    vk::DependencyFlags flags;
    if (d.byRegion) flags |= vk::DependencyFlagBits::eByRegion;
    if (plan.viewMask != 0 && d.byRegion && d.from != VK_SUBPASS_EXTERNAL && d.to != VK_SUBPASS_EXTERNAL)
        flags |= vk::DependencyFlagBits::eViewLocal;
    return flags;
}

/// Lets a subpass read what it writes. The order of its primitives is the driver's affair.
vk::SubpassDependency2 readOfOwn(std::uint32_t subpass, bool views) {
    vk::DependencyFlags flags = vk::DependencyFlagBits::eByRegion;
    if (views) flags |= vk::DependencyFlagBits::eViewLocal;
    return {subpass,
            subpass,
            vk::PipelineStageFlagBits::eColorAttachmentOutput,
            vk::PipelineStageFlagBits::eFragmentShader,
            vk::AccessFlagBits::eColorAttachmentWrite,
            vk::AccessFlagBits::eInputAttachmentRead,
            flags};
}

struct References {
    std::vector<vk::AttachmentReference2> colors, inputs, resolves;
    vk::AttachmentReference2 depth;
};

/// Asks the driver how it merges the subpasses of a render pass that is being made.
class MergeQuestion {
public:
    MergeQuestion(vk::RenderPassCreateInfo2& pass, std::vector<vk::SubpassDescription2>& subpasses)
        : answers_(subpasses.size()), questions_(subpasses.size()) {
        for (std::size_t s = 0; s < subpasses.size(); ++s) {
            questions_[s].pSubpassFeedback = &answers_[s];
            subpasses[s].pNext = &questions_[s];
        }
        question_.pRenderPassFeedback = &answer_;
        question_.pNext = pass.pNext;
        pass.pNext = &question_;
    }

    std::uint32_t subpassesCarried() const { return answer_.postMergeSubpassCount; }
    /// "not merged: aliasing attachments, ..."
    std::string why() const {
        std::string text;
        for (const auto& a : answers_) {
            const auto status = static_cast<vk::SubpassMergeStatusEXT>(a.subpassMergeStatus);
            if (status == vk::SubpassMergeStatusEXT::eMerged || status == vk::SubpassMergeStatusEXT::eDisallowed)
                continue;  // there is nothing to merge the first subpass with
            const std::string words(a.description.data());
            text += (text.empty() ? "" : "; ") + vk::to_string(status) + (words.empty() ? "" : ": ") + words;
        }
        return inOneLine(text);
    }

private:
    std::vector<vk::RenderPassSubpassFeedbackInfoEXT> answers_;
    std::vector<vk::RenderPassSubpassFeedbackCreateInfoEXT> questions_;
    vk::RenderPassCreationFeedbackInfoEXT answer_;
    vk::RenderPassCreationFeedbackCreateInfoEXT question_;
};

}  // namespace

vk::raii::RenderPass makeRenderPass(const Device& device, const graph::RenderPassPlan& plan, const std::string& name,
                                    MergedSubpasses& merged) {
    std::vector<vk::AttachmentDescription2> attachments;
    for (const graph::Attachment& a : plan.attachments)
        attachments.emplace_back(vk::AttachmentDescriptionFlags{}, static_cast<vk::Format>(a.format),
                                 static_cast<vk::SampleCountFlagBits>(a.samples), loadOp(a.load), storeOp(a.store),
                                 vk::AttachmentLoadOp::eDontCare, vk::AttachmentStoreOp::eDontCare,
                                 static_cast<vk::ImageLayout>(a.initialLayout),
                                 static_cast<vk::ImageLayout>(a.finalLayout));
    const bool promised = device.caps().plan.rasterOrder == graph::RasterOrder::promised;
    std::vector<References> references(plan.subpasses.size());
    std::vector<vk::SubpassDescription2> subpasses;
    for (std::size_t s = 0; s < plan.subpasses.size(); ++s) {
        const graph::Subpass& subpass = plan.subpasses[s];
        References& r = references[s];
        const auto findVerb = [&](std::uint32_t attachment) {
            graph::Verb verb{};
            graph::attachmentVerb(subpass, attachment, verb);
            return verb;
        };
        for (const std::uint32_t a : subpass.colors)
            r.colors.push_back(reference(a, findVerb(a), plan.attachments[a].format));
        for (const std::uint32_t a : subpass.inputs)
            r.inputs.push_back(reference(a, findVerb(a), plan.attachments[a].format));
        if (subpass.depth >= 0)
            r.depth = reference(static_cast<std::uint32_t>(subpass.depth),
                                subpass.depthWrite ? graph::Verb::depth : graph::Verb::depthTest, VK_FORMAT_D32_SFLOAT);
        vk::SubpassDescriptionFlags flags;
        if (subpass.ordered && promised)
            flags = vk::SubpassDescriptionFlagBits::eRasterizationOrderAttachmentColorAccessEXT;
        vk::SubpassDescription2 description(flags, vk::PipelineBindPoint::eGraphics, plan.viewMask, r.inputs, r.colors);
        if (subpass.depth >= 0) description.pDepthStencilAttachment = &r.depth;
        if (subpass.resolve >= 0) {
            const auto to = static_cast<std::uint32_t>(subpass.resolve);
            r.resolves.assign(r.colors.size(), vk::AttachmentReference2(VK_ATTACHMENT_UNUSED));
            r.resolves[0] = reference(to, graph::Verb::resolve, plan.attachments[to].format);
            description.pResolveAttachments = r.resolves.data();
        }
        description.preserveAttachmentCount = static_cast<std::uint32_t>(subpass.preserve.size());
        description.pPreserveAttachments = subpass.preserve.data();
        subpasses.push_back(description);
    }
    std::vector<vk::SubpassDependency2> dependencies;
    for (const graph::Dependency& d : plan.dependencies)
        dependencies.emplace_back(d.from, d.to, vk::PipelineStageFlags(d.fromStages),
                                  vk::PipelineStageFlags(d.toStages), vk::AccessFlags(d.fromAccess),
                                  vk::AccessFlags(d.toAccess), dependencyFlags(d, plan));
    for (std::uint32_t s = 0; s < subpasses.size() && !promised; ++s)
        if (plan.subpasses[s].ordered) dependencies.push_back(readOfOwn(s, plan.viewMask != 0));
    vk::RenderPassCreateInfo2 info({}, attachments, subpasses, dependencies);
    if (plan.viewMask != 0) info.setCorrelatedViewMasks(plan.viewMask);
    const auto density = static_cast<std::uint32_t>(plan.density);
    const vk::RenderPassFragmentDensityMapCreateInfoEXT map(
        vk::AttachmentReference(density, vk::ImageLayout::eFragmentDensityMapOptimalEXT));
    if (plan.density >= 0) info.pNext = &map;
    std::optional<MergeQuestion> question;
    if (device.caps().mergeFeedback && subpasses.size() > 1) question.emplace(info, subpasses);
    vk::raii::RenderPass pass = device->createRenderPass2KHR(info);
    merged = {name, static_cast<std::uint32_t>(subpasses.size()), 0, ""};
    if (question) merged.carried = question->subpassesCarried(), merged.why = question->why();
    device.name(*pass, name);
    return pass;
}

}  // namespace nacre::gpu
