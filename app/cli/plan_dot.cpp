// The plan as a Graphviz graph: a box for each render pass, inside it what stays on the tile; memory outside.

#include <iomanip>
#include <set>
#include <sstream>

#include "app/cli/plan_command.h"

namespace nacre::app {
namespace {

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + '"';
}

std::string megabytes(std::uint64_t bytes) {
    std::ostringstream out;
    out << std::fixed << std::setprecision(1) << static_cast<double>(bytes) / 1e6 << " MB";
    return out.str();
}

class Dot {
public:
    explicit Dot(const PlanReport& report) : report_(report), graph_(report.frame.graph) {}

    std::string text() {
        out_ << "digraph plan {\n"
             << "  graph [rankdir=LR, fontname=Helvetica, labelloc=t, fontsize=16, nodesep=0.35, ranksep=0.6, label="
             << quoted(title()) << "]\n"
             << "  node [fontname=Helvetica, fontsize=12]\n  edge [fontname=Helvetica, fontsize=10]\n";
        for (std::size_t s = 0; s < report_.plan.steps.size(); ++s)
            if (report_.plan.steps[s].kind == graph::PassKind::graphics)
                renderPass(s);
            else
                computePass(s);
        for (std::uint32_t b = 0; b < graph_.buffers().size(); ++b)
            out_ << "  buffer" << b
                 << " [shape=cylinder, style=filled, fillcolor=\"#f4c7b0\", label=" << quoted(graph_.buffers()[b].name)
                 << "]\n";
        for (const std::uint32_t image : inMemory_) memoryNode(image);
        out_ << edges_.str() << "}\n";
        return out_.str();
    }

private:
    std::string title() const {
        return report_.caps + ", " + visibilityName(report_.visibility) + ", " + std::to_string(report_.extent.width) +
               "x" + std::to_string(report_.extent.height) + ": loads " + megabytes(report_.plan.total.loaded) +
               ", stores " + megabytes(report_.plan.total.stored) + " a frame";
    }

    std::string onTile(std::size_t step, std::uint32_t attachment) const {
        return "tile" + std::to_string(step) + "_" + std::to_string(attachment);
    }
    static std::string subpassNode(std::size_t step, std::size_t subpass) {
        return "pass" + std::to_string(step) + "_" + std::to_string(subpass);
    }

    void edge(const std::string& from, const std::string& to, const std::string& label, const char* style) {
        edges_ << "  " << from << " -> " << to << " [label=" << quoted(label) << ", " << style << "]\n";
    }

    void memoryNode(std::uint32_t image) {
        const graph::ImageDecl& decl = graph_.images()[image];
        out_ << "  memory" << image
             << " [shape=cylinder, style=filled, fillcolor=\"#f4c7b0\", label=" << quoted(decl.name) << "]\n";
    }

    void computePass(std::size_t s) {
        const graph::PassDecl& pass = graph_.passes()[report_.plan.steps[s].pass];
        out_ << "  pass" << s
             << " [shape=box, style=\"rounded,filled\", fillcolor=white, label=" << quoted("compute: " + pass.name)
             << "]\n";
        for (const graph::Use& use : pass.uses)
            edge("pass" + std::to_string(s), "buffer" + std::to_string(use.resource),
                 "store " + megabytes(report_.plan.bufferTraffic[use.resource].stored), "style=bold");
    }

    void renderPass(std::size_t s) {
        const graph::RenderPassPlan& pass = report_.plan.steps[s].renderPass;
        out_ << "  subgraph cluster" << s << " {\n    label=\"render pass " << s << ": " << pass.tileBytesPerPixel
             << " B a pixel on the tile\"; style=\"rounded,filled\"; color=\"#8aa4b8\"; fillcolor=\"#eef4f8\"\n";
        for (std::size_t p = 0; p < pass.subpasses.size(); ++p) {
            out_ << "    " << subpassNode(s, p) << " [shape=box, style=\"rounded,filled\", fillcolor=white, label="
                 << quoted("subpass " + std::to_string(p) + ": " + nameOf(graph_, pass.subpasses[p])) << "]\n";
            if (p > 0)
                edges_ << "  " << subpassNode(s, p - 1) << " -> " << subpassNode(s, p) << " [style=invis, weight=4]\n";
        }
        for (std::uint32_t a = 0; a < pass.attachments.size(); ++a) attachment(s, pass, a);
        out_ << "  }\n";
        for (std::size_t p = 0; p < pass.subpasses.size(); ++p) uses(s, p, pass.subpasses[p]);
    }

    void attachment(std::size_t s, const graph::RenderPassPlan& pass, std::uint32_t a) {
        const graph::Attachment& at = pass.attachments[a];
        const graph::ImageDecl& decl = graph_.images()[at.image];
        const std::string kind = at.transient ? "\ntransient" : "";
        std::string label = decl.name + "\n" + graph::formatName(at.format) + kind;
        std::string escaped;
        for (const char c : label) escaped += c == '\n' ? std::string("\\n") : std::string(1, c);
        out_ << "    " << onTile(s, a) << " [shape=box, style=\"filled" << (at.transient ? ",dashed" : "")
             << "\", fillcolor=\"#cfe3c8\", label=\"" << escaped << "\"]\n";
        const std::string memory = "memory" + std::to_string(at.image);
        if (at.load == graph::Load::load) {
            inMemory_.insert(at.image);
            edge(memory, onTile(s, a), "load " + megabytes(bytesOf(decl)), "color=\"#c0392b\", penwidth=2");
        }
        if (at.store == graph::Store::store) {
            inMemory_.insert(at.image);
            edge(onTile(s, a), memory, "store " + megabytes(bytesOf(decl)), "color=\"#c0392b\", penwidth=2");
        }
    }

    void uses(std::size_t s, std::size_t p, const graph::Subpass& subpass) {
        const std::string node = subpassNode(s, p);
        if (subpass.depth >= 0) {
            const std::string depth = onTile(s, static_cast<std::uint32_t>(subpass.depth));
            if (subpass.depthWrite)
                edge(node, depth, "depth", "color=\"#2e7d32\"");
            else
                edge(depth, node, "test", "color=\"#2e7d32\", style=dashed");
        }
        for (const std::uint32_t a : subpass.inputs) edge(onTile(s, a), node, "input", "color=\"#2e7d32\"");
        for (const std::uint32_t a : subpass.colors) edge(node, onTile(s, a), "write", "color=\"#2e7d32\"");
        for (const std::uint32_t pass : subpass.passes)
            for (const graph::Use& use : graph_.passes()[pass].uses) {
                const bool sampledInput = use.verb == graph::Verb::input && report_.plan.inputIsSampled[pass];
                if (use.verb == graph::Verb::reads)
                    edge("buffer" + std::to_string(use.resource), node,
                         "load " + megabytes(report_.plan.bufferTraffic[use.resource].loaded), "color=\"#c0392b\"");
                if (use.verb != graph::Verb::samples && !sampledInput) continue;
                inMemory_.insert(use.resource);
                edge("memory" + std::to_string(use.resource), node, "texture", "color=\"#c0392b\", style=dashed");
            }
    }

    const PlanReport& report_;
    const graph::Graph& graph_;
    std::ostringstream out_, edges_;
    std::set<std::uint32_t> inMemory_;
};

}  // namespace

std::string planDot(const PlanReport& report) { return Dot(report).text(); }

}  // namespace nacre::app
