#include <algorithm>

#include "engine/graph/plan_internal.h"

namespace nacre::graph {
namespace {

/// The density map of a pass; null: none.
const Use* findDensityUse(const PassDecl& pass) {
    const auto found = std::ranges::find(pass.uses, Verb::density, &Use::verb);
    return found == pass.uses.end() ? nullptr : &*found;
}

bool contains(const std::vector<std::uint32_t>& list, std::uint32_t value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

/// Builds one render pass from neighbouring passes.
class Merger {
public:
    Merger(const Graph& graph, const PlanCaps& caps, Plan& plan) : graph_(graph), caps_(caps), plan_(plan) {}

    void add(std::uint32_t p) {
        const PassDecl& pass = graph_.passes()[p];
        if (pass.kind != PassKind::graphics) {
            Step step;
            step.kind = pass.kind;
            step.pass = p;
            plan_.steps.push_back(std::move(step));
            return;
        }
        if (!joins(pass)) open(pass);
        place(p);
    }

private:
    RenderPassPlan& current() { return plan_.steps.back().renderPass; }

    std::int32_t find(std::uint32_t image) {
        for (std::size_t i = 0; i < current().attachments.size(); ++i)
            if (current().attachments[i].image == image) return static_cast<std::int32_t>(i);
        return -1;
    }

    void open(const PassDecl& pass) {
        Step step;
        step.kind = PassKind::graphics;
        for (const Use& use : pass.uses)
            if (use.isImage && isAttachment(use.verb) && use.verb != Verb::resolve) {
                const ImageDesc& desc = graph_.images()[use.resource].desc;
                step.renderPass.extent = desc.extent;
                step.renderPass.samples = desc.samples;
                step.renderPass.layers = desc.layers;
                step.renderPass.viewMask = desc.layers > 1 ? (1u << desc.layers) - 1 : 0;
            }
        plan_.steps.push_back(std::move(step));
    }

    bool joins(const PassDecl& pass) {
        if (!caps_.merge || pass.share.apart || plan_.steps.empty() || plan_.steps.back().kind != PassKind::graphics)
            return false;
        if (!sharesDensityMap(pass)) return false;
        bool shares = false, inputOnTile = false, inputInMemory = false;
        std::uint32_t bytes = current().tileBytesPerPixel;
        for (const Use& use : pass.uses) {
            if (crossesPixels(use)) return false;
            if (!use.isImage || !isAttachment(use.verb)) continue;
            const ImageDesc& desc = graph_.images()[use.resource].desc;
            const std::uint32_t samples = use.verb == Verb::resolve ? 1 : current().samples;
            if (desc.extent != current().extent || desc.samples != samples || desc.layers != current().layers)
                return false;
            const std::int32_t at = find(use.resource);
            if (at >= 0) {
                shares = true;
                if (use.clear) return false;  // an attachment is cleared only on entry
                inputOnTile = inputOnTile || use.verb == Verb::input;
            } else if (use.verb == Verb::input) {
                inputInMemory = true;
            } else if (isDepthFormat(desc.format)) {
                if (hasDepth()) return false;  // another depth image
            } else {
                bytes += tileBytes(use);
            }
        }
        // A pass reads all its inputs in one way.
        if (!shares || bytes > caps_.tileBytesPerPixel || (inputOnTile && inputInMemory)) return false;
        return caps_.tileSubpasses || sharesSubpass(pass);
    }

    /// A render pass has one map.
    bool sharesDensityMap(const PassDecl& pass) {
        const Use* map = findDensityUse(pass);
        if (!map) return current().density < 0;
        return current().density >= 0 && current().density == find(map->resource);
    }

    /// Bytes of an image on the tile. A resolve target leaves the tile at once.
    std::uint32_t tileBytes(const Use& use) const {
        const ImageDesc& desc = graph_.images()[use.resource].desc;
        const bool none = use.verb == Verb::resolve || use.verb == Verb::density || isDepthFormat(desc.format);
        return none ? 0 : bytesPerTexel(desc.format) * desc.samples;
    }

    bool hasDepth() {
        return std::any_of(current().subpasses.begin(), current().subpasses.end(),
                           [](const Subpass& s) { return s.depth >= 0; });
    }

    /// Whether a use conflicts with an earlier pass of the current render pass in a way that only the end of the
    /// render pass orders: textures and buffers are visible to every pixel, and an attachment has another layout than a
    /// texture.
    bool crossesPixels(const Use& use) {
        const bool onTile = isAttachment(use.verb) && (use.verb != Verb::input || find(use.resource) >= 0);
        for (const Subpass& subpass : current().subpasses)
            for (const std::uint32_t earlier : subpass.passes)
                for (const Use& other : graph_.passes()[earlier].uses) {
                    if (other.isImage != use.isImage || other.resource != use.resource) continue;
                    const bool otherOnTile = isAttachment(effectiveVerb(plan_, earlier, other));
                    if (onTile != otherOnTile) return true;
                    if (!onTile && (isWrite(use.verb) || isWrite(other.verb))) return true;
                }
        return false;
    }

    /// Whether a pass can share the last subpass: it reads no input on the tile, and uses shared attachments in the
    /// same way. Where a new subpass would leave the tile, a depth image may be written by one and tested by another.
    bool sharesSubpass(const PassDecl& pass) {
        if (current().subpasses.empty()) return false;
        const Subpass& last = current().subpasses.back();
        std::vector<std::int32_t> colors;
        for (const Use& use : pass.uses)
            if (use.verb == Verb::color) colors.push_back(find(use.resource));
        // Shaders number their outputs, and differing masks are an optional feature: the same colours, or none.
        const bool sameColors = std::equal(colors.begin(), colors.end(), last.colors.begin(), last.colors.end(),
                                           [](auto x, auto y) { return x == static_cast<std::int32_t>(y); });
        if (!sameColors && !colors.empty() && !last.colors.empty()) return false;
        if (!colors.empty() && !last.colors.empty() && !resolvesAlike(pass, last)) return false;
        for (const Use& use : pass.uses) {
            if (!use.isImage || !isAttachment(use.verb)) continue;
            // Raster order is a property of the whole subpass: such a pass gets its own.
            if (use.verb == Verb::ordered || last.ordered) return false;
            const std::int32_t at = find(use.resource);
            if (at < 0) continue;  // new here, or a texture
            if (use.verb == Verb::input || contains(last.inputs, static_cast<std::uint32_t>(at))) return false;
            if (last.depth != at || !caps_.tileSubpasses) continue;
            if (use.verb == Verb::depth && !last.depthWrite) return false;
            if (use.verb == Verb::depthTest && last.depthWrite && !sameColors) return false;
        }
        return true;
    }

    /// A subpass resolves once, after all of its passes.
    bool resolvesAlike(const PassDecl& pass, const Subpass& last) {
        std::int32_t to = -1;
        for (const Use& use : pass.uses)
            if (use.verb == Verb::resolve) {
                to = find(use.resource);
                if (to < 0) return false;
            }
        return to == last.resolve;
    }

    std::uint32_t attach(const Use& use) {
        std::int32_t at = find(use.resource);
        if (at < 0) {
            Attachment attachment;
            attachment.image = use.resource;
            attachment.format = graph_.images()[use.resource].desc.format;
            attachment.samples = graph_.images()[use.resource].desc.samples;
            attachment.load = use.clear ? Load::clear : Load::dontCare;
            if (use.clear) attachment.clear = *use.clear;
            current().tileBytesPerPixel += tileBytes(use);
            at = static_cast<std::int32_t>(current().attachments.size());
            current().attachments.push_back(attachment);
        }
        return static_cast<std::uint32_t>(at);
    }

    void place(std::uint32_t p) {
        const PassDecl& pass = graph_.passes()[p];
        for (const Use& use : pass.uses)
            if (use.verb == Verb::input && find(use.resource) < 0) {
                if (graph_.images()[use.resource].desc.samples > 1)
                    throw GraphError(
                        naming(graph_, pass, use) +
                        ": input of several samples per pixel, read outside the render pass that writes it");
                plan_.inputIsSampled[p] = true;
            }
        if (!sharesSubpass(pass)) current().subpasses.emplace_back();
        if (const Use* map = findDensityUse(pass)) current().density = static_cast<std::int32_t>(attach(*map));
        // attach() may grow the attachments, never the subpasses.
        Subpass& subpass = current().subpasses.back();
        subpass.passes.push_back(p);
        for (const Use& use : pass.uses) {
            const Verb verb = effectiveVerb(plan_, p, use);
            if (!use.isImage || !isAttachment(verb)) continue;
            const std::uint32_t at = attach(use);
            const bool ordered = verb == Verb::ordered;
            if ((verb == Verb::color || ordered) && !contains(subpass.colors, at)) subpass.colors.push_back(at);
            if (verb == Verb::input || ordered) subpass.inputs.push_back(at);
            subpass.ordered = subpass.ordered || ordered;
            if (verb == Verb::resolve) subpass.resolve = static_cast<std::int32_t>(at);
            if (verb == Verb::depth || verb == Verb::depthTest) {
                subpass.depth = static_cast<std::int32_t>(at);
                subpass.depthWrite = subpass.depthWrite || verb == Verb::depth;
            }
        }
    }

    const Graph& graph_;
    const PlanCaps& caps_;
    Plan& plan_;
};

}  // namespace

bool attachmentVerb(const Subpass& subpass, std::uint32_t attachment, Verb& verb) {
    if (contains(subpass.colors, attachment))
        return verb = contains(subpass.inputs, attachment) ? Verb::ordered : Verb::color, true;
    if (contains(subpass.inputs, attachment)) return verb = Verb::input, true;
    if (subpass.resolve == static_cast<std::int32_t>(attachment)) return verb = Verb::resolve, true;
    if (subpass.depth == static_cast<std::int32_t>(attachment))
        return verb = subpass.depthWrite ? Verb::depth : Verb::depthTest, true;
    return false;
}

void mergePasses(const Graph& graph, const PlanCaps& caps, Plan& plan) {
    Merger merger(graph, caps, plan);
    for (std::uint32_t p = 0; p < graph.passes().size(); ++p)
        if (!plan.culled[p]) merger.add(p);
}

}  // namespace nacre::graph
