#include <algorithm>

#include "engine/graph/plan_internal.h"

namespace nacre::graph {
namespace {

/// History of a resource since its last write, and the stages that already see that write.
struct Track {
    VkPipelineStageFlags writeStages = 0, readStages = 0, visibleStages = 0;
    VkAccessFlags writeAccess = 0, visibleAccess = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;

    bool touched() const { return (writeStages | readStages) != 0; }
    State before() const {
        const VkPipelineStageFlags stages = writeStages | readStages;
        return {stages ? stages : static_cast<VkPipelineStageFlags>(VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT), writeAccess,
                layout};
    }
};

Track makeTrack(const State& state) {
    Track track{.layout = state.layout};
    if (state.access & kWriteAccess) {
        track.writeStages = state.stages;
        track.writeAccess = state.access & kWriteAccess;
    } else if (state.access) {
        // The imported state is visible to these stages alone; others wait for them.
        track.writeStages = track.visibleStages = state.stages;
        track.visibleAccess = state.access;
    } else {
        track.readStages = state.stages;
    }
    return track;
}

/// One use of a resource by a step: the state on entry, and all of the step's stages and accesses.
struct StepUse {
    bool isImage = true;
    std::uint32_t resource = 0;
    State entry, whole;  // whole.layout: its final layout
    Attachment* attachment = nullptr;
    std::uint32_t firstSubpass = 0;  // of an attachment
};

class Synchronizer {
public:
    Synchronizer(const Graph& graph, Plan& plan) : graph_(graph), plan_(plan) {}

    void run() {
        for (Step& step : plan_.steps)
            if (step.kind == PassKind::graphics) subpassDependencies(step.renderPass);
        // Walks once to find the final states, and again from these: a graph may follow itself.
        reset();
        for (Step& step : plan_.steps) walk(step, false);
        const std::vector<Track> images = images_;
        reset();
        for (std::size_t i = 0; i < images_.size(); ++i)
            if (!graph_.images()[i].imported) {
                images_[i] = images[i];
                images_[i].layout = VK_IMAGE_LAYOUT_UNDEFINED;
            }
        for (Step& step : plan_.steps) walk(step, true);
        finish();
    }

private:
    void reset() {
        images_.assign(graph_.images().size(), {});
        buffers_.assign(graph_.buffers().size(), {});
        for (std::size_t i = 0; i < images_.size(); ++i)
            if (const ImageDecl& decl = graph_.images()[i]; decl.imported) {
                images_[i] = makeTrack(*decl.imported);
                if (decl.undefined) images_[i].layout = VK_IMAGE_LAYOUT_UNDEFINED;
            }
        for (std::size_t i = 0; i < buffers_.size(); ++i) buffers_[i] = makeTrack(graph_.buffers()[i].imported);
    }

    std::vector<StepUse> listUses(Step& step) const {
        std::vector<StepUse> uses;
        auto add = [&](std::uint32_t p) {
            for (const Use& use : graph_.passes()[p].uses) {
                const Verb verb = effectiveVerb(plan_, p, use);
                if (use.isImage && isAttachment(verb)) continue;
                merge(uses,
                      {use.isImage, use.resource, verbState(verb, step.kind), verbState(verb, step.kind), nullptr});
            }
        };
        if (step.kind != PassKind::graphics) add(step.pass);
        for (const Subpass& subpass : step.renderPass.subpasses)
            for (const std::uint32_t p : subpass.passes) add(p);
        for (std::size_t a = 0; a < step.renderPass.attachments.size(); ++a)
            if (static_cast<std::int32_t>(a) == step.renderPass.density)
                keepLayout(step.renderPass.attachments[a]);  // its barriers are those of a texture
            else
                uses.push_back(attachmentUse(step.renderPass, static_cast<std::uint32_t>(a)));
        return uses;
    }

    static void keepLayout(Attachment& map) {
        map.initialLayout = map.finalLayout = verbState(Verb::density, PassKind::graphics).layout;
    }

    static void merge(std::vector<StepUse>& uses, const StepUse& use) {
        for (StepUse& other : uses)
            if (other.isImage == use.isImage && other.resource == use.resource) {
                other.entry.stages |= use.entry.stages;
                other.entry.access |= use.entry.access;
                other.whole = other.entry;
                return;
            }
        uses.push_back(use);
    }

    static StepUse attachmentUse(RenderPassPlan& pass, std::uint32_t a) {
        StepUse use;
        use.resource = pass.attachments[a].image;
        use.attachment = &pass.attachments[a];
        use.whole.stages = 0;
        for (std::uint32_t s = 0; s < pass.subpasses.size(); ++s) {
            Verb verb{};
            if (!attachmentVerb(pass.subpasses[s], a, verb)) continue;
            const State state = verbState(verb, PassKind::graphics);
            if (use.whole.stages == 0) use.entry = state, use.firstSubpass = s;
            use.whole.stages |= state.stages;
            use.whole.access |= state.access;
            use.whole.layout = state.layout;
        }
        // Load and store operations write too: clears on entry, don't-care and store on exit.
        const State writing = attachmentState(*use.attachment);
        const bool storeWrites = use.attachment->store != Store::none;
        for (State* state : {&use.entry, &use.whole})
            if (storeWrites || (state == &use.entry && use.attachment->load != Load::load)) {
                state->stages |= writing.stages;
                state->access |= writing.access;
            }
        use.attachment->finalLayout = use.whole.layout;
        return use;
    }

    void walk(Step& step, bool emit) {
        for (StepUse& use : listUses(step)) {
            Track& track = use.isImage ? images_[use.resource] : buffers_[use.resource];
            const bool discards = use.attachment && use.attachment->load != Load::load;
            // A cleared attachment that has contents takes a barrier, as if it were loaded: both render passes are
            // compatible.
            const bool depends = discards && !hasContents(use.resource);
            const VkImageLayout wanted = use.isImage ? use.entry.layout : VK_IMAGE_LAYOUT_UNDEFINED;
            State from{track.before().stages, track.before().access,
                       discards ? VK_IMAGE_LAYOUT_UNDEFINED : track.layout};
            // Waits for all earlier drawing and sampling of a colour, in any fragment stage. So passes that differ only
            // in that are compatible: one pipeline draws the window and a picture that is sampled.
            if (depends && !isDepthFormat(use.attachment->format))
                from.stages |= VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT | VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;
            const State to{use.entry.stages, use.entry.access, wanted};
            if (use.attachment) {
                use.attachment->initialLayout = depends ? VK_IMAGE_LAYOUT_UNDEFINED : wanted;
                if (depends && emit) depend(step.renderPass, VK_SUBPASS_EXTERNAL, use.firstSubpass, from, to, false);
            }
            const bool needed = needsBarrier(track, to, use.isImage);
            if (emit && needed && !depends) step.before.push_back({use.isImage, use.resource, from, to});
            advance(track, use, needed || discards);
        }
        if (emit) sortDependencies(step.renderPass);
    }

    bool hasContents(std::uint32_t image) const {
        const ImageDecl& decl = graph_.images()[image];
        return decl.imported && !decl.undefined;
    }

    static bool needsBarrier(const Track& track, const State& to, bool isImage) {
        if (isImage && track.layout != to.layout) return true;
        if (to.access & kWriteAccess) return track.touched();
        if (!track.writeStages) return false;
        return (to.stages & ~track.visibleStages) != 0 || (to.access & ~track.visibleAccess) != 0;
    }

    static void advance(Track& track, const StepUse& use, bool synchronized) {
        const bool writes = (use.whole.access & kWriteAccess) != 0;
        if (writes || synchronized) {
            track = {};
            track.writeStages = use.whole.stages;
            track.writeAccess = use.whole.access & kWriteAccess;
            if (!writes) track.visibleStages = use.whole.stages, track.visibleAccess = use.whole.access;
        } else {
            track.readStages |= use.whole.stages;
        }
        track.layout = use.isImage ? use.whole.layout : VK_IMAGE_LAYOUT_UNDEFINED;
    }

    /// Stage and access of an attachment's load and store operations.
    static State attachmentState(const Attachment& attachment) {
        return verbState(isDepthFormat(attachment.format) ? Verb::depth : Verb::color, PassKind::graphics);
    }

    /// How a subpass uses an attachment. The last one that uses it also stores it, which is a write.
    static State stateIn(const RenderPassPlan& pass, std::uint32_t subpass, std::uint32_t a, Verb verb) {
        State state = verbState(verb, PassKind::graphics);
        Verb later{};
        for (std::uint32_t s = subpass + 1; s < pass.subpasses.size(); ++s)
            if (attachmentVerb(pass.subpasses[s], a, later)) return state;
        if (pass.attachments[a].store == Store::none) return state;
        const State storing = attachmentState(pass.attachments[a]);
        return {state.stages | storing.stages, state.access | storing.access, state.layout};
    }

    static void subpassDependencies(RenderPassPlan& pass) {
        for (std::uint32_t a = 0; a < pass.attachments.size(); ++a)
            for (std::uint32_t to = 1; to < pass.subpasses.size(); ++to) {
                Verb later{};
                if (!attachmentVerb(pass.subpasses[to], a, later)) continue;
                const State target = stateIn(pass, to, a, later);
                for (std::uint32_t from = 0; from < to; ++from) {
                    Verb earlier{};
                    if (!attachmentVerb(pass.subpasses[from], a, earlier)) continue;
                    if (isWrite(earlier) || (target.access & kWriteAccess) || earlier != later)
                        depend(pass, from, to, verbState(earlier, PassKind::graphics), target, true);
                }
            }
        for (std::uint32_t a = 0; a < pass.attachments.size(); ++a) preserve(pass, a);
    }

    static void preserve(RenderPassPlan& pass, std::uint32_t a) {
        std::vector<bool> used;
        Verb verb{};
        for (const Subpass& subpass : pass.subpasses) used.push_back(attachmentVerb(subpass, a, verb));
        const auto first = std::find(used.begin(), used.end(), true);
        const auto last = std::find(used.rbegin(), used.rend(), true).base();
        const bool stored = pass.attachments[a].store != Store::dontCare;
        for (auto it = first; it < (stored ? used.end() : last); ++it)
            if (!*it) pass.subpasses[static_cast<std::size_t>(it - used.begin())].preserve.push_back(a);
    }

    static void depend(RenderPassPlan& pass, std::uint32_t from, std::uint32_t to, const State& source,
                       const State& target, bool byRegion) {
        auto at = std::find_if(pass.dependencies.begin(), pass.dependencies.end(),
                               [&](const Dependency& d) { return d.from == from && d.to == to; });
        if (at == pass.dependencies.end()) at = pass.dependencies.insert(at, {from, to, 0, 0, 0, 0, byRegion});
        at->fromStages |= source.stages;
        at->toStages |= target.stages;
        at->fromAccess |= source.access & kWriteAccess;
        at->toAccess |= target.access;
    }

    static void sortDependencies(RenderPassPlan& pass) {
        std::sort(pass.dependencies.begin(), pass.dependencies.end(), [](const Dependency& x, const Dependency& y) {
            const std::int64_t fx = x.from == VK_SUBPASS_EXTERNAL ? -1 : std::int64_t{x.from};
            const std::int64_t fy = y.from == VK_SUBPASS_EXTERNAL ? -1 : std::int64_t{y.from};
            return fx != fy ? fx < fy : x.to < y.to;
        });
    }

    /// Whether the next graph, which trusts the imported state, would miss work of this one.
    static bool leftOtherwise(const Track& track, const State& imported) {
        if (track.writeAccess) return true;
        return imported.access && ((track.writeStages | track.readStages) & ~imported.stages);
    }

    /// A window image drawn by the last step: its render pass transitions it for presentation, which saves tilers a
    /// pass over memory. The semaphore of the presentation orders the rest.
    bool endsOnDisplay(std::uint32_t image) {
        if (graph_.images()[image].imported->layout != VK_IMAGE_LAYOUT_PRESENT_SRC_KHR || plan_.steps.empty())
            return false;
        for (Attachment& a : plan_.steps.back().renderPass.attachments)
            if (a.image == image) return a.finalLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, true;
        return false;
    }

    void finish() {
        for (std::uint32_t i = 0; i < images_.size(); ++i) {
            const auto& imported = graph_.images()[i].imported;
            if (!imported || !plan_.images[i].used || endsOnDisplay(i)) continue;
            if (images_[i].layout != imported->layout || leftOtherwise(images_[i], *imported))
                plan_.after.push_back({true, i, images_[i].before(), *imported});
        }
        for (std::uint32_t i = 0; i < buffers_.size(); ++i) {
            const BufferDecl& decl = graph_.buffers()[i];
            if (!decl.output && leftOtherwise(buffers_[i], decl.imported))
                plan_.after.push_back({false, i, buffers_[i].before(), decl.imported});
            if (!decl.output) continue;
            State to{VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT, {}};
            if (leftOtherwise(buffers_[i], decl.imported)) {  // also for the next graph, if imported so
                to.access |= decl.imported.access;
                if (decl.imported.access) to.stages |= decl.imported.stages;
            }
            plan_.after.push_back({false, i, buffers_[i].before(), to});
        }
    }

    const Graph& graph_;
    Plan& plan_;
    std::vector<Track> images_, buffers_;
};

}  // namespace

void deriveSynchronization(const Graph& graph, Plan& plan) { Synchronizer(graph, plan).run(); }

}  // namespace nacre::graph
