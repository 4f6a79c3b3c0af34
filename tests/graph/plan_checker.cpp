#include "tests/graph/plan_checker.h"

#include <algorithm>
#include <set>

#include "tests/graph/hazards.h"

namespace nacre::test {
namespace {

/// What an image or buffer holds, as a number: equal numbers, equal contents. 0: nothing in particular.
using Content = std::uint64_t;
Content mix(Content a, Content b) {
    a ^= b + 0x9e3779b97f4a7c15ull + (a << 6) + (a >> 2);
    return a * 0xbf58476d1ce4e5b9ull + 1;
}

class Checker {
public:
    Checker(const graph::Graph& g, const graph::Plan& plan, const graph::PlanCaps& caps)
        : g_(g), plan_(plan), caps_(caps) {
        for (const auto& image : g.images()) {
            images_.push_back({image.name, image.imported ? image.imported->layout : VK_IMAGE_LAYOUT_UNDEFINED, {}});
            if (image.imported) enter(images_.back(), *image.imported);
            if (image.undefined) images_.back().layout = VK_IMAGE_LAYOUT_UNDEFINED;
            memory_.push_back(image.imported && !image.undefined ? mix(7, memory_.size()) : 0);
        }
        for (const auto& buffer : g.buffers()) {
            buffers_.push_back({buffer.name, {}, {}});
            enter(buffers_.back(), buffer.imported);
            bufferContents_.push_back(mix(11, bufferContents_.size()));
        }
        expected();
    }

    std::vector<std::string> run() {
        // Twice: a graph follows itself, and its own images keep what the frame before did to them.
        for (int frame = 0; frame < 2; ++frame) {
            frame_ = frame;
            for (std::size_t i = 0; i < images_.size(); ++i)
                if (!g_.images()[i].imported) images_[i].layout = VK_IMAGE_LAYOUT_UNDEFINED;
            for (const graph::Step& step : plan_.steps) {
                where_ = "step " + std::to_string(&step - plan_.steps.data());
                for (const graph::Barrier& b : step.before) barrier(b);
                if (step.kind == PassKind::graphics)
                    renderPass(step.renderPass);
                else
                    pass(step.pass, step.kind, kOutside);
            }
            where_ = "end";
            for (const graph::Barrier& b : plan_.after) barrier(b);
            leave();
        }
        return faults_;
    }

private:
    void fault(const std::string& what) {
        faults_.push_back("frame " + std::to_string(frame_) + ", " + where_ + ": " + what);
    }
    void note(const Resource& r, const std::string& what) {
        if (!what.empty()) fault(r.name + " " + what);
    }

    static void enter(Resource& r, const graph::State& state) {
        Event e;
        e.write = true;
        e.stages = state.stages;
        e.access = state.access;
        e.chain = state.stages;
        if (!(state.access & kWrites)) {  // someone wrote it, and made it visible to this state
            e.available = true;
            e.ordered[kOutside] = state.stages;
            e.visible[kOutside].emplace_back(state.stages, state.access);
        }
        r.events = {e};
    }

    /// Contents after every pass in declared order, none left out: what each pass must find.
    void expected() {
        std::vector<Content> images = memory_, buffers = bufferContents_;
        for (std::uint32_t p = 0; p < g_.passes().size(); ++p) {
            found_.push_back(joinInputs(p, images, buffers));
            write(p, images, buffers);
        }
        finalImages_ = images;
        finalBuffers_ = buffers;
    }
    Content joinInputs(std::uint32_t p, const std::vector<Content>& images, const std::vector<Content>& buffers) const {
        Content all = 3;
        for (const graph::Use& use : g_.passes()[p].uses) {
            const bool old = use.verb == Verb::color || use.verb == Verb::ordered || use.verb == Verb::depth;
            if ((old && use.clear) || use.verb == Verb::resolve) continue;
            all = mix(all, use.isImage ? images[use.resource] : buffers[use.resource]);
        }
        return all;
    }
    void write(std::uint32_t p, std::vector<Content>& images, std::vector<Content>& buffers) const {
        const Content all = mix(joinInputs(p, images, buffers), p + 100);
        for (const graph::Use& use : g_.passes()[p].uses)
            if (graph::isWrite(use.verb)) (use.isImage ? images : buffers)[use.resource] = mix(all, use.resource);
    }

    void barrier(const graph::Barrier& b) {
        const Sync sync{b.from.stages, b.to.stages, b.from.access, b.to.access, kOutside, kOutside, true};
        Resource& r = b.isImage ? images_[b.resource] : buffers_[b.resource];
        if (!b.isImage || b.from.layout == b.to.layout) {
            r.apply(sync);
            return;
        }
        if (b.from.layout != VK_IMAGE_LAYOUT_UNDEFINED && b.from.layout != r.layout)
            fault(r.name + " is in another layout");
        if (b.from.layout == VK_IMAGE_LAYOUT_UNDEFINED) memory_[b.resource] = 0;
        note(r, r.change(b.to.layout, sync));
    }

    bool isSampled(std::uint32_t p, const graph::Use& use) const {
        return use.verb == Verb::input && plan_.inputIsSampled[p];
    }

    /// What a pass does beside attachments, and whether it finds the contents that it was declared to find.
    void pass(std::uint32_t p, PassKind kind, int scope) {
        for (const graph::Use& use : g_.passes()[p].uses) {
            if (use.isImage && (cleared_.erase(use.resource) != 0) != use.clear.has_value())
                fault(g_.images()[use.resource].name + " is cleared wrongly for pass " + std::to_string(p));
            const Verb verb = isSampled(p, use) ? Verb::samples : use.verb;
            if (use.isImage && verb <= Verb::input) continue;
            const Access a = verbAccess(verb, kind);
            Resource& r = use.isImage ? images_[use.resource] : buffers_[use.resource];
            if (use.isImage && r.layout != a.layout)
                fault(r.name + " is in the wrong layout for pass " + std::to_string(p));
            note(r, r.touch(a, scope, false));
        }
        if (frame_ == 0 && joinInputs(p, memory_, bufferContents_) != found_[p])
            fault("pass " + std::to_string(p) + " finds other contents than declared");
        if (plan_.culled[p]) fault("pass " + std::to_string(p) + " was culled, but runs");
        write(p, memory_, bufferContents_);
    }

    void renderPass(const graph::RenderPassPlan& rp) {
        checkShape(rp);
        std::vector<int> first(rp.attachments.size(), -1), last(rp.attachments.size(), -1);
        for (std::size_t s = 0; s < rp.subpasses.size(); ++s)
            for (std::uint32_t a = 0; a < rp.attachments.size(); ++a)
                if (Verb v{}; findVerb(rp.subpasses[s], a, v)) {
                    if (first[a] < 0) first[a] = static_cast<int>(s);
                    last[a] = static_cast<int>(s);
                }
        for (std::size_t s = 0; s < rp.subpasses.size(); ++s) {
            const int scope = static_cast<int>(s);
            enterSubpass(rp, s, first);
            for (const std::uint32_t p : rp.subpasses[s].passes) pass(p, PassKind::graphics, scope);
            for (std::uint32_t a = 0; a < rp.attachments.size(); ++a) {
                Verb verb{};
                if (!findVerb(rp.subpasses[s], a, verb)) {
                    checkPreserved(rp, s, a, first[a], last[a]);
                    continue;
                }
                Resource& r = images_[rp.attachments[a].image];
                note(r, r.touch(verbAccess(verb, PassKind::graphics), scope, true));
                if (last[a] == scope) store(rp.attachments[a], r, scope);
            }
        }
        for (Resource& r : images_) r.leaveRenderPass();
        for (Resource& r : buffers_) r.leaveRenderPass();
    }

    static bool findVerb(const graph::Subpass& subpass, std::uint32_t a, Verb& verb) {
        const auto has = [a](const std::vector<std::uint32_t>& list) {
            return std::find(list.begin(), list.end(), a) != list.end();
        };
        if (has(subpass.colors)) return verb = has(subpass.inputs) ? Verb::ordered : Verb::color, true;
        if (has(subpass.inputs)) return verb = Verb::input, true;
        if (subpass.resolve == static_cast<std::int32_t>(a)) return verb = Verb::resolve, true;
        if (subpass.depth == static_cast<std::int32_t>(a))
            return verb = subpass.depthWrite ? Verb::depth : Verb::depthTest, true;
        return false;
    }

    void enterSubpass(const graph::RenderPassPlan& rp, std::size_t s, const std::vector<int>& first) {
        const int scope = static_cast<int>(s);
        for (std::uint32_t a = 0; a < rp.attachments.size(); ++a) {
            Verb verb{};
            if (!findVerb(rp.subpasses[s], a, verb)) continue;
            const graph::Attachment& at = rp.attachments[a];
            Resource& r = images_[at.image];
            const VkImageLayout wanted = verbAccess(verb, PassKind::graphics).layout;
            if (first[a] == scope) {
                if (at.initialLayout != VK_IMAGE_LAYOUT_UNDEFINED && at.initialLayout != r.layout)
                    fault(r.name + " enters the render pass in another layout");
                if (at.initialLayout == VK_IMAGE_LAYOUT_UNDEFINED) memory_[at.image] = 0;
                if (at.initialLayout != wanted)
                    transition(rp, r, wanted, scope);
                else
                    applyDependencies(rp, r, scope);
                load(at, r, scope);
                continue;
            }
            if (r.layout != wanted)
                transition(rp, r, wanted, scope);
            else
                applyDependencies(rp, r, scope);
        }
    }

    static Sync makeSync(const graph::Dependency& d) {
        const bool outside = d.from == VK_SUBPASS_EXTERNAL;
        return {
            d.fromStages,           d.toStages, d.fromAccess, d.toAccess, outside ? kOutside : static_cast<int>(d.from),
            static_cast<int>(d.to), false};
    }

    void applyDependencies(const graph::RenderPassPlan& rp, Resource& r, int scope) {
        for (const graph::Dependency& d : rp.dependencies)
            if (static_cast<int>(d.to) == scope) r.apply(makeSync(d));
    }

    /// All dependencies into the subpass act together.
    void transition(const graph::RenderPassPlan& rp, Resource& r, VkImageLayout to, int scope) {
        applyDependencies(rp, r, scope);
        Sync all{0, 0, ~0u, 0, kOutside, scope, false};
        for (const graph::Dependency& d : rp.dependencies)
            if (static_cast<int>(d.to) == scope) all.toStages |= d.toStages, all.toAccess |= d.toAccess;
        for (const Event& e : r.events) {
            const auto it = e.ordered.find(scope);
            if (it == e.ordered.end())
                fault(r.name + " changes layout in the render pass while in use");
            else if (e.write && !e.available)
                fault(r.name + " changes layout before a write is available");
        }
        r.events.clear();
        r.change(to, all);
    }

    void load(const graph::Attachment& at, Resource& r, int scope) {
        const bool depth = graph::isDepthFormat(at.format);
        Access a = verbAccess(depth ? Verb::depth : Verb::color, PassKind::graphics);
        a.writes = at.load != graph::Load::load;
        if (depth) a.stages = VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT;
        a.access &= a.writes ? kWrites : ~kWrites;
        note(r, r.touch(a, scope, true));
        if (a.writes) memory_[at.image] = 0;
        if (at.load == graph::Load::clear) cleared_.insert(at.image);
        if (at.load == graph::Load::load && at.transient) fault(r.name + " is transient, but loaded");
    }

    void store(const graph::Attachment& at, Resource& r, int scope) {
        if (at.store == graph::Store::none) return;
        const bool depth = graph::isDepthFormat(at.format);
        Access a = verbAccess(depth ? Verb::depth : Verb::color, PassKind::graphics);
        if (depth) a.stages = VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT;
        a.access &= kWrites;
        note(r, r.touch(a, scope, true));
        if (at.store == graph::Store::store && at.transient) fault(r.name + " is transient, but stored");
        if (at.finalLayout != r.layout) fault(r.name + " leaves the render pass in another layout");
        if (at.store == graph::Store::dontCare) memory_[at.image] = 0;
    }

    void checkPreserved(const graph::RenderPassPlan& rp, std::size_t s, std::uint32_t a, int first, int last) {
        const auto& preserve = rp.subpasses[s].preserve;
        const bool kept = std::find(preserve.begin(), preserve.end(), a) != preserve.end();
        const int scope = static_cast<int>(s);
        const bool stored = rp.attachments[a].store != graph::Store::dontCare;
        const bool needed = first < scope && (last > scope || stored);
        if (needed && !kept) fault(images_[rp.attachments[a].image].name + " is not preserved");
    }

    void checkShape(const graph::RenderPassPlan& rp) {
        std::uint32_t bytes = 0;
        for (const graph::Attachment& a : rp.attachments) {
            const graph::ImageDesc& desc = g_.images()[a.image].desc;
            const bool resolved = std::any_of(rp.subpasses.begin(), rp.subpasses.end(), [&](const graph::Subpass& s) {
                return s.resolve == static_cast<std::int32_t>(&a - rp.attachments.data());
            });
            if (desc.extent != rp.extent || desc.samples != a.samples || a.samples != (resolved ? 1 : rp.samples))
                fault("extents or samples differ");
            if (!graph::isDepthFormat(a.format) && !resolved) bytes += graph::bytesPerTexel(a.format) * a.samples;
            if (a.transient && !plan_.images[a.image].transient) fault("transient in one place alone");
        }
        const bool alone = !caps_.transient && rp.subpasses.size() == 1 && rp.subpasses[0].passes.size() == 1;
        if (bytes > caps_.tileBytesPerPixel && !alone) fault("the tile budget is exceeded");
        if (bytes != rp.tileBytesPerPixel) fault("the tile's bytes are miscounted");
        std::size_t passes = 0;
        for (const graph::Subpass& s : rp.subpasses) {
            passes += s.passes.size();
            if (s.colors.size() > caps_.maxColorAttachments) fault("too many colour attachments");
            if (s.inputs.size() > caps_.maxInputAttachments) fault("too many input attachments");
        }
        if (!caps_.merge && passes > 1) fault("merged against its will");
        if (!caps_.tileSubpasses && rp.subpasses.size() > 1) fault("more than one subpass");
    }

    void leave() {
        if (frame_ > 0) return;  // contents of the second frame are the same again
        for (std::size_t i = 0; i < images_.size(); ++i) {
            const auto& decl = g_.images()[i];
            if ((decl.output || decl.imported) && memory_[i] != finalImages_[i])
                fault(decl.name + " ends with other contents");
            if (!decl.imported || !plan_.images[i].used) continue;
            if (images_[i].layout != decl.imported->layout) fault(decl.name + " is left in another layout");
        }
        if (bufferContents_ != finalBuffers_) fault("a buffer ends with other contents");
        for (std::size_t i = 0; i < images_.size(); ++i)
            if (g_.images()[i].imported) leaveAs(images_[i], *g_.images()[i].imported);
        for (std::size_t i = 0; i < buffers_.size(); ++i) leaveAs(buffers_[i], g_.buffers()[i].imported);
    }

    /// The next graph knows of the imported state alone: everything must be ordered before, or be part of, that.
    void leaveAs(Resource& r, const graph::State& state) {
        for (const Event& e : r.events) {
            const bool known = (e.stages & ~state.stages) == 0 && (!(e.access & kWrites) || (state.access & kWrites));
            if (!known && !(e.chain & state.stages)) note(r, "does more than its imported state tells");
        }
        enter(r, state);
    }

    const graph::Graph& g_;
    const graph::Plan& plan_;
    const graph::PlanCaps& caps_;
    std::vector<Resource> images_, buffers_;
    std::vector<Content> memory_, bufferContents_, found_, finalImages_, finalBuffers_;
    std::set<std::uint32_t> cleared_;  // and not used since
    std::vector<std::string> faults_;
    std::string where_;
    int frame_ = 0;
};

}  // namespace

std::vector<std::string> checkPlan(const graph::Graph& graph, const graph::Plan& plan, const graph::PlanCaps& caps) {
    return Checker(graph, plan, caps).run();
}

}  // namespace nacre::test
