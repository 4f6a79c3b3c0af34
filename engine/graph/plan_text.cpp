#include <algorithm>
#include <sstream>

#include "engine/graph/plan.h"

namespace nacre::graph {
namespace {

const char* loadName(Load load) { return load == Load::clear ? "clear" : load == Load::load ? "load" : "-"; }
const char* storeName(Store store) { return store == Store::store ? "store" : store == Store::none ? "none" : "-"; }

void attachmentLine(std::ostream& out, const Graph& graph, const Attachment& a, bool isMap) {
    out << "  " << graph.images()[a.image].name << "  " << formatName(a.format) << "  " << loadName(a.load) << "  "
        << storeName(a.store) << (a.transient ? "  transient" : "");
    if (a.samples > 1) out << "  " << a.samples << " samples";
    if (isMap) {
        const ImageDesc& map = graph.images()[a.image].desc;
        out << "  " << map.extent.width << "x" << map.extent.height;
        if (map.layers > 1) out << ", " << map.layers << " layers";
        out << ", of fragments";
    }
    out << "\n";
}

std::string subpassUses(const Graph& graph, const RenderPassPlan& pass, const Subpass& subpass) {
    std::string text;
    auto add = [&](std::uint32_t attachment, const char* use) {
        text += (text.empty() ? "" : ", ") + graph.images()[pass.attachments[attachment].image].name + " " + use;
    };
    if (subpass.depth >= 0) add(static_cast<std::uint32_t>(subpass.depth), subpass.depthWrite ? "write" : "test");
    const auto both = [&](std::uint32_t a) { return std::ranges::find(subpass.inputs, a) != subpass.inputs.end(); };
    for (const std::uint32_t a : subpass.inputs)
        if (std::find(subpass.colors.begin(), subpass.colors.end(), a) == subpass.colors.end()) add(a, "input");
    for (const std::uint32_t a : subpass.colors) add(a, both(a) ? "ordered" : "write");
    if (subpass.resolve >= 0) add(static_cast<std::uint32_t>(subpass.resolve), "resolve");
    return text;
}

void renderPassText(std::ostream& out, const Graph& graph, const Plan& plan, const RenderPassPlan& pass) {
    out << "render pass " << pass.extent.width << "x" << pass.extent.height;
    if (pass.viewMask != 0) out << ", " << pass.layers << " views";
    out << "\n";
    for (std::size_t a = 0; a < pass.attachments.size(); ++a)
        attachmentLine(out, graph, pass.attachments[a], static_cast<std::int32_t>(a) == pass.density);
    for (std::size_t s = 0; s < pass.subpasses.size(); ++s) {
        out << "  subpass " << s;
        const char* separator = " ";
        for (const std::uint32_t p : pass.subpasses[s].passes) {
            out << separator << graph.passes()[p].name;
            separator = " + ";
        }
        out << ": " << subpassUses(graph, pass, pass.subpasses[s]);
        for (const std::uint32_t p : pass.subpasses[s].passes)
            for (const Use& use : graph.passes()[p].uses)
                if (use.isImage && (use.verb == Verb::samples || (use.verb == Verb::input && plan.inputIsSampled[p])))
                    out << ", " << graph.images()[use.resource].name << " sample";
                else if (!use.isImage)
                    out << ", " << graph.buffers()[use.resource].name << " " << verbName(use.verb);
        out << "\n";
    }
    for (const Dependency& d : pass.dependencies)
        if (d.from != VK_SUBPASS_EXTERNAL)
            out << "  dependency " << d.from << " -> " << d.to << (d.byRegion ? " by region" : "") << "\n";
    out << "  tile " << pass.tileBytesPerPixel << " B/px";
    for (const Attachment& a : pass.attachments)
        if (isDepthFormat(a.format)) out << " + depth";
    out << "\n";
}

}  // namespace

std::string describe(const Graph& graph, const Plan& plan) {
    std::ostringstream out;
    for (const Step& step : plan.steps) {
        if (step.kind == PassKind::graphics)
            renderPassText(out, graph, plan, step.renderPass);
        else
            out << (step.kind == PassKind::compute ? "compute " : "transfer ") << graph.passes()[step.pass].name
                << "\n";
    }
    for (std::size_t p = 0; p < plan.culled.size(); ++p)
        if (plan.culled[p]) out << "culled " << graph.passes()[p].name << "\n";
    out << "memory: loaded " << plan.total.loaded << " B, stored " << plan.total.stored << " B\n";
    return out.str();
}

}  // namespace nacre::graph
