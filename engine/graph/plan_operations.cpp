#include "engine/graph/plan_internal.h"

namespace nacre::graph {
namespace {

/// How one step uses one image, in the order of its passes.
struct ImageUse {
    bool used = false, written = false, onlyAttachment = true, overwritten = false;
};

ImageUse findUse(const Graph& graph, const Plan& plan, const Step& step, std::uint32_t image) {
    ImageUse result;
    auto visit = [&](std::uint32_t p) {
        for (const Use& use : graph.passes()[p].uses) {
            if (!use.isImage || use.resource != image) continue;
            const Verb verb = effectiveVerb(plan, p, use);
            if (!result.used) result.overwritten = use.clear.has_value() || verb == Verb::resolve;
            result.used = true;
            result.written = result.written || isWrite(verb);
            result.onlyAttachment = result.onlyAttachment && isAttachment(verb);
        }
    };
    if (step.kind != PassKind::graphics) visit(step.pass);
    for (const Subpass& subpass : step.renderPass.subpasses)
        for (const std::uint32_t p : subpass.passes) visit(p);
    return result;
}

/// The density map among the attachments; null: none.
const Attachment* findDensityMap(const RenderPassPlan& pass) {
    return pass.density < 0 ? nullptr : &pass.attachments[static_cast<std::size_t>(pass.density)];
}

std::uint64_t countBytes(const ImageDecl& image) {
    return std::uint64_t{bytesPerTexel(image.desc.format)} * image.desc.extent.width * image.desc.extent.height *
           image.desc.layers * image.desc.samples;
}

class Operations {
public:
    Operations(const Graph& graph, const PlanCaps& caps, Plan& plan) : graph_(graph), caps_(caps), plan_(plan) {}

    void derive(std::uint32_t image) {
        const ImageDecl& decl = graph_.images()[image];
        std::vector<ImageUse> uses;
        std::uint32_t steps = 0;
        bool onlyAttachment = true, defined = decl.imported && !decl.undefined;
        for (const Step& step : plan_.steps) {
            uses.push_back(findUse(graph_, plan_, step, image));
            if (uses.back().used) ++steps;
            onlyAttachment = onlyAttachment && uses.back().onlyAttachment;
        }
        PlannedImage& planned = plan_.images[image];
        planned.used = steps > 0;
        bool loaded = false;
        for (std::size_t s = 0; s < plan_.steps.size(); ++s) {
            for (Attachment& a : plan_.steps[s].renderPass.attachments) {
                if (a.image != image) continue;
                if (a.load != Load::clear) a.load = defined && !uses[s].overwritten ? Load::load : Load::dontCare;
                a.store = chooseStore(decl, uses, s);
                if (findDensityMap(plan_.steps[s].renderPass) == &a)
                    a.store = Store::dontCare;  // Vulkan wants that of maps
                loaded = loaded || a.load == Load::load;
            }
            defined = defined || uses[s].written;
        }
        planned.transient = steps == 1 && onlyAttachment && !loaded && !decl.output && !decl.imported &&
                            caps_.transient && !caps_.storeAll;
        for (Step& step : plan_.steps)
            for (Attachment& a : step.renderPass.attachments)
                if (a.image == image) a.transient = planned.transient;
    }

    void deriveUsage() {
        for (std::uint32_t p = 0; p < graph_.passes().size(); ++p) {
            if (plan_.culled[p]) continue;
            for (const Use& use : graph_.passes()[p].uses)
                if (use.isImage) plan_.images[use.resource].usage |= usageFlag(effectiveVerb(plan_, p, use));
        }
        for (PlannedImage& image : plan_.images)
            if (image.transient) image.usage |= VK_IMAGE_USAGE_TRANSIENT_ATTACHMENT_BIT;
    }

    void deriveTraffic() {
        for (const Step& step : plan_.steps)
            for (const Attachment& a : step.renderPass.attachments) {
                const std::uint64_t bytes = countBytes(graph_.images()[a.image]);
                if (a.load == Load::load) plan_.traffic[a.image].loaded += bytes;
                if (a.store == Store::store) plan_.traffic[a.image].stored += bytes;
            }
        // An image that this graph writes is loaded once for each later pass that reads it as a texture.
        std::vector<bool> written(graph_.images().size());
        for (std::uint32_t p = 0; p < graph_.passes().size(); ++p)
            for (const Use& use : graph_.passes()[p].uses) {
                if (plan_.culled[p] || !use.isImage) continue;
                const Verb verb = effectiveVerb(plan_, p, use);
                if (verb == Verb::stores && !written[use.resource])
                    plan_.traffic[use.resource].stored += countBytes(graph_.images()[use.resource]);
                if (isWrite(verb)) written[use.resource] = true;
                if (verb == Verb::samples && written[use.resource])
                    plan_.traffic[use.resource].loaded += countBytes(graph_.images()[use.resource]);
            }
        deriveBufferTraffic();
        for (const std::vector<Traffic>* list : {&plan_.traffic, &plan_.bufferTraffic})
            for (const Traffic& t : *list) {
                plan_.total.loaded += t.loaded;
                plan_.total.stored += t.stored;
            }
    }

    /// A buffer between passes, or from compute to the host: written to memory once, and read by every consumer.
    void deriveBufferTraffic() {
        std::vector<bool> written(graph_.buffers().size());
        for (std::uint32_t p = 0; p < graph_.passes().size(); ++p)
            for (const Use& use : graph_.passes()[p].uses) {
                if (plan_.culled[p] || use.isImage) continue;
                Traffic& traffic = plan_.bufferTraffic[use.resource];
                const VkDeviceSize size = graph_.buffers()[use.resource].size;
                if (use.verb == Verb::writes) written[use.resource] = true;
                const bool left = graph_.passes()[p].kind == PassKind::compute && graph_.buffers()[use.resource].output;
                if (use.verb == Verb::writes && left) traffic.stored = size;
                if (use.verb != Verb::reads || !written[use.resource]) continue;
                traffic.loaded += size;
                traffic.stored = size;
            }
    }

private:
    Store chooseStore(const ImageDecl& decl, const std::vector<ImageUse>& uses, std::size_t s) const {
        std::size_t next = s + 1;
        while (next < uses.size() && !uses[next].used) ++next;
        const bool wanted = next < uses.size() ? !uses[next].overwritten : decl.output || decl.imported.has_value();
        if (!wanted && !caps_.storeAll) return Store::dontCare;
        return !uses[s].written && caps_.storeNone ? Store::none : Store::store;
    }

    const Graph& graph_;
    const PlanCaps& caps_;
    Plan& plan_;
};

}  // namespace

void deriveOperations(const Graph& graph, const PlanCaps& caps, Plan& plan) {
    Operations operations(graph, caps, plan);
    for (std::uint32_t i = 0; i < graph.images().size(); ++i) operations.derive(i);
    operations.deriveUsage();
    operations.deriveTraffic();
}

}  // namespace nacre::graph
