#include "engine/gpu/execute.h"

#include <algorithm>

#include "engine/gpu/region_counters.h"

namespace nacre::gpu {
namespace {

/// The part of a plan that a VkRenderPass depends on: no sizes, clear values, or numbers of images and passes.
graph::RenderPassPlan essence(graph::RenderPassPlan plan) {
    plan.extent = {};
    for (graph::Attachment& a : plan.attachments) {
        a.image = 0;
        a.clear = graph::Clear{0.0f};
    }
    for (graph::Subpass& s : plan.subpasses) s.passes.clear();
    return plan;
}

/// The part that its pipelines depend on: not load and store operations or layouts ("Render Pass Compatibility" of the
/// Vulkan specification).
graph::RenderPassPlan compatibility(graph::RenderPassPlan essence) {
    for (graph::Attachment& a : essence.attachments) {
        a.load = {};
        a.store = {};
        a.initialLayout = a.finalLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    }
    return essence;
}

const vk::SubpassBeginInfo kInline(vk::SubpassContents::eInline);

}  // namespace

Executor::Executor(const Device& device) : device_(device), pipelines_(device), descriptors_(device) {}

const Image& Executor::own(const std::string& key, const graph::ImageDesc& desc, const graph::PlannedImage& planned,
                           Retired* retired) {
    const auto it = images_.find(key);
    if (it != images_.end() && it->second.image.desc == desc && it->second.usage == planned.usage)
        return it->second.image;
    if (it != images_.end()) {
        if (retired) {
            retireFramebuffers(*retired);
            retired->images.push_back(std::move(it->second.image));
        } else {
            forgetFramebuffers();
        }
        images_.erase(it);
    }
    Image image = makeImage(device_, desc, vk::ImageUsageFlags(planned.usage), planned.transient, key);
    return images_.emplace(key, OwnedImage{planned.usage, planned.transient, std::move(image)}).first->second.image;
}

OwnedRenderPass& Executor::renderPass(const graph::RenderPassPlan& plan, const std::string& name) {
    const graph::RenderPassPlan key = essence(plan);
    for (OwnedRenderPass& pass : renderPasses_)
        if (pass.plan == key) return pass;
    MergedSubpasses merged;
    vk::raii::RenderPass made = makeRenderPass(device_, plan, name, merged);
    const auto compatible = std::ranges::find_if(
        renderPasses_, [&](const OwnedRenderPass& p) { return compatibility(p.plan) == compatibility(key); });
    const vk::RenderPass ofPipelines = compatible == renderPasses_.end() ? *made : compatible->ofPipelines;
    renderPasses_.push_back({key, std::move(made), ofPipelines, std::move(merged), {}});
    return renderPasses_.back();
}

vk::Framebuffer Executor::framebuffer(OwnedRenderPass& pass, const graph::RenderPassPlan& plan, Recording& recording,
                                      const std::string& name) {
    std::vector<VkImageView>& views = recording.views_;
    views.clear();
    for (const graph::Attachment& a : plan.attachments) views.push_back(recording.images_[a.image].view);
    for (const Framebuffer& f : pass.framebuffers)
        if (f.views == views && f.extent == plan.extent) return *f.handle;
    std::vector<vk::ImageView> handles(views.begin(), views.end());
    vk::raii::Framebuffer handle(
        *device_, vk::FramebufferCreateInfo({}, *pass.handle, handles, plan.extent.width, plan.extent.height,
                                            plan.viewMask ? 1 : plan.layers));
    device_.name(*handle, name);
    pass.framebuffers.push_back({views, plan.extent, std::move(handle), recording.graph_.name()});
    return *pass.framebuffers.back().handle;
}

void Executor::barriers(const vk::raii::CommandBuffer& commands, const std::vector<graph::Barrier>& list,
                        Recording& recording) const {
    if (list.empty()) return;
    vk::PipelineStageFlags from, to;
    auto& images = recording.imageBarriers_;
    auto& buffers = recording.bufferBarriers_;
    images.clear(), buffers.clear();
    for (const graph::Barrier& b : list) {
        from |= vk::PipelineStageFlags(b.from.stages);
        to |= vk::PipelineStageFlags(b.to.stages);
        const vk::AccessFlags fromAccess(b.from.access), toAccess(b.to.access);
        if (!b.isImage) {
            buffers.emplace_back(fromAccess, toAccess, VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED,
                                 recording.buffers_[b.resource], 0, VK_WHOLE_SIZE);
            continue;
        }
        const graph::ImageDesc& desc = recording.graph_.images()[b.resource].desc;
        const auto aspect =
            graph::isDepthFormat(desc.format) ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
        images.emplace_back(
            fromAccess, toAccess, static_cast<vk::ImageLayout>(b.from.layout),
            static_cast<vk::ImageLayout>(b.to.layout), VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED,
            recording.images_[b.resource].handle,
            vk::ImageSubresourceRange(aspect, 0, 1, recording.images_[b.resource].firstLayer, desc.layers));
    }
    commands.pipelineBarrier(from, to, {}, {}, buffers, images);
}

void Executor::beginRenderPass(Recording& recording, std::size_t step, PassContext& context) {
    const graph::RenderPassPlan& pass = recording.plan_.steps[step].renderPass;
    Recording::RenderPass& own = recording.renderPasses_[step];
    if (!own.made) own.made = &renderPass(pass, own.name);
    const vk::Rect2D area({0, 0}, {pass.extent.width, pass.extent.height});
    vk::RenderPassBeginInfo info(*own.made->handle, framebuffer(*own.made, pass, recording, own.name), area,
                                 own.clears);
    if (regions_) info.pNext = regions_->begin(pass, pass.subpasses.size());
    context.commands.beginRenderPass2KHR(info, kInline);
    context.renderPass = own.made->ofPipelines;
}

void Executor::recordRenderPass(Recording& recording, std::size_t step, PassContext& context) {
    const graph::RenderPassPlan& pass = recording.plan_.steps[step].renderPass;
    std::optional<DynamicRendering> dynamic;
    context.extent = pass.extent;
    context.samples = pass.samples;
    context.views = pass.layers;
    context.renderPass = nullptr;
    context.rendering = {};
    context.inputLayout = vk::ImageLayout::eShaderReadOnlyOptimal;
    if (DynamicRendering::takes(device_, pass)) {
        dynamic.emplace(device_, pass, context.images, context.commands);
        dynamic->begin(regions_ ? regions_->begin(pass, 1) : nullptr);
    } else {
        beginRenderPass(recording, step, context);
    }
    const vk::Rect2D area({0, 0}, {pass.extent.width, pass.extent.height});
    for (std::uint32_t s = 0; s < pass.subpasses.size(); ++s) {
        if (dynamic)
            context.rendering = dynamic->beginSubpass(s), context.inputLayout = dynamic->inputLayout(s);
        else if (s > 0)
            context.commands.nextSubpass2KHR(kInline, vk::SubpassEndInfo());
        context.subpass = dynamic ? 0 : s;
        context.colorCount = static_cast<std::uint32_t>(pass.subpasses[s].colors.size());
        for (const std::uint32_t p : pass.subpasses[s].passes) {
            const graph::PassDecl& declared = recording.graph_.passes()[p];
            device_.beginLabel(context.commands, declared.name);
            context.inputIsSampled = recording.plan_.inputIsSampled[p];
            context.commands.setViewport(0, vk::Viewport(0, 0, static_cast<float>(pass.extent.width),
                                                         static_cast<float>(pass.extent.height), 0, 1));
            context.commands.setScissor(0, area);
            context.pass = declared.name;
            context.share = declared.share;
            if (declared.work.record) declared.work.record(context);
            device_.endLabel(context.commands);
        }
    }
    if (dynamic)
        dynamic->end();
    else
        context.commands.endRenderPass2KHR(vk::SubpassEndInfo());
}

/// Finds the images and buffers that the graph names.
void Executor::bind(Recording& recording, const Imports& imports, Retired* retired) {
    const graph::Graph& graph = recording.graph_;
    const std::vector<graph::PlannedImage>& planned = recording.plan_.images;
    recording.images_.clear(), recording.buffers_.clear();
    for (std::uint32_t i = 0; i < graph.images().size(); ++i) {
        const graph::ImageDecl& decl = graph.images()[i];
        ImageRef image;
        if (decl.imported) {
            if (const ImageRef* bound = imports.image(i)) image = *bound;
            if (!image.handle && planned[i].used)
                throw graph::GraphError("graph '" + graph.name() + "', image '" + decl.name +
                                        "': imported, but not bound");
        } else if (planned[i].used) {
            image = own(recording.owned_[i], decl.desc, planned[i], retired);
        }
        recording.images_.push_back(image);
    }
    for (std::uint32_t i = 0; i < graph.buffers().size(); ++i) {
        const vk::Buffer* bound = imports.buffer(i);
        if (!bound)
            throw graph::GraphError("graph '" + graph.name() + "', buffer '" + graph.buffers()[i].name +
                                    "': not bound");
        recording.buffers_.push_back(*bound);
    }
}

void Executor::record(CommandBuffer& commands, Recording& recording, const Imports& imports,
                      DescriptorPool& descriptors, Timer* timer, Retired* retired) {
    const graph::Graph& graph = recording.graph_;
    const graph::Plan& plan = recording.plan_;
    bind(recording, imports, retired);
    device_.name(**commands, graph.name());  // here, because RenderDoc keeps names given while recording
    device_.log().record(recording.work_);
    device_.beginLabel(*commands, graph.name());
    if (timer) timer->begin(*commands);
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
        const graph::Step& step = plan.steps[i];
        if (step.kind == graph::PassKind::compute && commands.draws &&
            device_.caps().has(graph::Quirk::dispatchesApart)) {
            device_.endLabel(*commands);
            commands.split();
            device_.beginLabel(*commands, graph.name());
        }
        PassContext context{{device_, pipelines_}, *commands, descriptors};
        context.images = recording.images_;
        context.buffers = recording.buffers_;
        barriers(*commands, step.before, recording);
        if (step.kind == graph::PassKind::graphics) {
            commands.draws = true;
            recordRenderPass(recording, i, context);
            if (timer) timer->lap(*commands, recording.renderPasses_[i].name);
            continue;
        }
        const graph::PassDecl& pass = graph.passes()[step.pass];
        device_.beginLabel(*commands, pass.name);
        context.pass = pass.name;
        if (pass.work.record) pass.work.record(context);
        device_.endLabel(*commands);
        if (timer) timer->lap(*commands, pass.name);
    }
    barriers(*commands, plan.after, recording);
    device_.endLabel(*commands);
}

void Executor::prepare(const graph::Graph& graph, const graph::Plan& plan) {
    const vk::raii::CommandBuffer none{nullptr};
    const std::vector<ImageRef> images(graph.images().size());
    Recording recording(graph, plan);
    PipelineContext context{device_, pipelines_};
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
        const graph::RenderPassPlan& pass = plan.steps[i].renderPass;
        const auto ask = [&](std::uint32_t p) {
            context.pass = graph.passes()[p].name;
            context.inputIsSampled = plan.inputIsSampled[p];
            if (graph.passes()[p].work.want) graph.passes()[p].work.want(context);
        };
        if (plan.steps[i].kind == graph::PassKind::compute) ask(plan.steps[i].pass);
        const bool dynamic = DynamicRendering::takes(device_, pass);
        context.extent = pass.extent;
        context.samples = pass.samples;
        context.views = pass.layers;
        for (std::uint32_t s = 0; s < pass.subpasses.size(); ++s) {
            context.renderPass = dynamic ? nullptr : renderPass(pass, recording.renderPasses_[i].name).ofPipelines;
            if (dynamic) context.rendering = DynamicRendering(device_, pass, images, none).findFormats(s);
            context.subpass = dynamic ? 0 : s;
            context.colorCount = static_cast<std::uint32_t>(pass.subpasses[s].colors.size());
            for (const std::uint32_t p : pass.subpasses[s].passes) ask(p);
        }
    }
}

void Executor::run(const graph::Graph& graph, const graph::Plan& plan, const Imports& imports) {
    device_.submitAndWait([&](CommandBuffer& c) { record(c, graph, plan, imports); });
    reset();
}

void Executor::run(const graph::Graph& graph, const Imports& imports) {
    run(graph, graph::compile(graph, device_.caps().plan), imports);
}

DriverFeedback Executor::feedback() const {
    DriverFeedback feedback;
    for (const OwnedRenderPass& pass : renderPasses_)
        if (pass.merged.planned > 1 && pass.merged.carried > 0) feedback.merges.push_back(pass.merged);
    for (const auto& [name, owned] : images_)
        if (owned.image.lazy)
            feedback.transients.push_back({name, owned.image.memory.bytes(), (*owned.image.memory).getCommitment()});
    return feedback;
}

void Executor::forgetFramebuffers() {
    device_.waitIdle();
    for (OwnedRenderPass& pass : renderPasses_) pass.framebuffers.clear();
}

void Executor::retireFramebuffers(Retired& retired) {
    for (OwnedRenderPass& pass : renderPasses_) {
        for (Framebuffer& f : pass.framebuffers) retired.framebuffers.push_back(std::move(f.handle));
        pass.framebuffers.clear();
    }
}

void Executor::forget(const std::string& graph) {
    for (OwnedRenderPass& pass : renderPasses_)
        pass.framebuffers.remove_if([&](const Framebuffer& f) { return f.graph == graph; });
    std::erase_if(images_, [&](const auto& entry) { return entry.first.starts_with(graph + ": "); });
}

}  // namespace nacre::gpu
