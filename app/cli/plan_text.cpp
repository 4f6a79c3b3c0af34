// The plan as text: tables with aligned columns.

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/cli/plan_command.h"
#include "app/picture/option_text.h"

namespace nacre::app {
namespace {

using Row = std::vector<std::string>;

/// Columns as wide as their longest cell. Those from `numbers` on are flushed right.
void table(std::ostream& out, const std::string& indent, const std::vector<Row>& rows, std::size_t numbers = SIZE_MAX) {
    std::vector<std::size_t> widths;
    for (const Row& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
    }
    for (const Row& row : rows) {
        std::string line = indent;
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string padding(widths[c] - row[c].size(), ' ');
            line += (c ? "  " : "") + (c >= numbers ? padding + row[c] : row[c] + padding);
        }
        out << line.substr(0, line.find_last_not_of(' ') + 1) << '\n';
    }
}

std::string list(const std::vector<std::string>& words, const char* none = "-") {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text.empty() ? none : text;
}

/// 11,849,760
std::string grouped(std::uint64_t value) {
    std::string text = std::to_string(value);
    for (std::size_t i = text.size(); i > 3;) text.insert(i -= 3, ",");
    return text;
}

void renderPassText(std::ostream& out, const PlanReport& report, const graph::RenderPassPlan& pass) {
    const graph::Graph& g = report.frame.graph;
    out << "render pass: " << joinNames(g, pass);
    const graph::Share& share = g.passes()[pass.subpasses.back().passes.back()].share;
    if (share.count > 1) out << ", share " << share.index + 1 << " of " << share.count << " of the primitives";
    out << '\n';
    std::vector<Row> rows{{"attachment", "format", "load", "store", "memory"}};
    bool depth = false;
    for (const graph::Attachment& a : pass.attachments) {
        depth = depth || graph::isDepthFormat(a.format);
        std::string samples = a.samples > 1 ? ", " + std::to_string(a.samples) + " samples" : std::string();
        if (pass.density >= 0 && &a == &pass.attachments[static_cast<std::size_t>(pass.density)]) {
            const graph::Extent map = g.images()[a.image].desc.extent;
            samples = ", " + std::to_string(map.width) + "x" + std::to_string(map.height);
        }
        if (pass.viewMask != 0) samples += ", " + std::to_string(pass.layers) + " views";
        rows.push_back({g.images()[a.image].name, graph::formatName(a.format) + samples,
                        a.load == graph::Load::clear  ? "clear"
                        : a.load == graph::Load::load ? "load"
                                                      : "-",
                        a.store == graph::Store::store  ? "store"
                        : a.store == graph::Store::none ? "none"
                                                        : "-",
                        a.transient ? "transient: none" : grouped(countBytes(g.images()[a.image])) + " B"});
    }
    table(out, "  ", rows);
    rows = {{"subpass", "passes", "reads", "writes"}};
    for (std::size_t s = 0; s < pass.subpasses.size(); ++s) {
        std::vector<std::string> reads, writes;
        for (const NamedUse& use : listUses(report, pass, pass.subpasses[s]))
            (use.writes ? writes : reads)
                .push_back(use.how == "write" || use.how == "test, write" ? use.image
                                                                          : use.image + " (" + use.how + ")");
        rows.push_back({std::to_string(s), joinNames(g, pass.subpasses[s]), list(reads), list(writes)});
    }
    table(out, "  ", rows);
    rows = {{"dependency", "waits for", "before", "reach"}};
    for (const graph::Dependency& d : pass.dependencies)
        rows.push_back(
            {(d.from == VK_SUBPASS_EXTERNAL ? "before" : std::to_string(d.from)) + " -> " + std::to_string(d.to),
             list(stageNames(d.fromStages)), list(stageNames(d.toStages)), d.byRegion ? "same pixel" : "whole image"});
    if (rows.size() > 1) table(out, "  ", rows);
    out << "  tile: " << pass.tileBytesPerPixel << " of " << report.plannedWith.tileBytesPerPixel
        << " B per pixel for colour and input" << (depth ? ", depth beside them" : "") << "\n\n";
}

void computeText(std::ostream& out, const PlanReport& report, const graph::PassDecl& pass) {
    out << "compute: " << pass.name << '\n';
    std::vector<std::string> reads, writes;
    for (const graph::Use& use : pass.uses)
        (graph::isWrite(use.verb) ? writes : reads).push_back(resourceName(report.frame.graph, use));
    table(out, "  ", {{"reads", "writes"}, {list(reads), list(writes)}});
    out << '\n';
}

void barriersText(std::ostream& out, const PlanReport& report, const std::vector<graph::Barrier>& barriers) {
    std::vector<Row> rows{{"barrier", "waits for", "before"}};
    for (const graph::Barrier& b : barriers)
        rows.push_back(
            {b.isImage ? report.frame.graph.images()[b.resource].name : report.frame.graph.buffers()[b.resource].name,
             list(stageNames(b.from.stages)), list(stageNames(b.to.stages))});
    if (rows.size() > 1) table(out, "  ", rows);
    if (rows.size() > 1) out << '\n';
}

std::string fetchText(const Fetch& fetch) {
    if (fetch.sphere == 0 && fetch.cylinder == 0) return "-";
    std::string text = std::to_string(fetch.sphere) + " B";
    if (fetch.cylinder || fetch.triangle) text += " / " + std::to_string(fetch.cylinder) + " B";
    if (fetch.triangle) text += " / " + std::to_string(fetch.triangle) + " B";
    return text + (fetch.perPixel ? " per covered pixel" : "");
}

void passesText(std::ostream& out, const PlanReport& report) {
    std::vector<Row> rows{{"pass", "depth test", "binning", "shading"}};
    for (const graph::PassDecl& pass : report.frame.graph.passes()) {
        const PassNotes notes = describePass(pass, report.plannedWith.conservativeDepth);
        rows.push_back({pass.name, depthTimingName(notes.depth), fetchText(notes.binning), fetchText(notes.shading)});
    }
    out << "bytes fetched per sphere / cylinder / triangle\n";
    table(out, "  ", rows);
    for (const graph::PassDecl& pass : report.frame.graph.passes()) {
        const PassNotes notes = describePass(pass, report.plannedWith.conservativeDepth);
        out << "  " << pass.name << '\n' << "    depth: " << notes.why << '\n' << "    " << notes.precision << '\n';
    }
    out << '\n';
}

void memoryText(std::ostream& out, const PlanReport& report) {
    out << "bytes to and from memory per frame: attachments, and textures and buffers that the frame makes\n";
    std::vector<Row> rows{{"image", "loaded", "stored", "unmerged: loaded", "stored", "paper: loaded", "stored"}};
    const auto cells = [](Row& row, const graph::Traffic& traffic) {
        row.push_back(grouped(traffic.loaded));
        row.push_back(grouped(traffic.stored));
    };
    const auto& images = report.frame.graph.images();
    const auto& paperImages = report.paperGraph.images();
    std::vector<bool> shown(paperImages.size());
    for (std::size_t i = 0; i < images.size(); ++i) {
        if (images[i].imported) continue;
        Row row{images[i].name};
        cells(row, report.plan.traffic[i]);
        cells(row, report.unmerged.traffic[i]);
        for (std::size_t p = 0; p < paperImages.size(); ++p)
            if (paperImages[p].name == images[i].name) {
                cells(row, report.paper.traffic[p]);
                shown[p] = true;
            }
        rows.push_back(row);
    }
    for (std::size_t i = 0; i < report.frame.graph.buffers().size(); ++i) {
        Row row{report.frame.graph.buffers()[i].name};
        cells(row, report.plan.bufferTraffic[i]);
        cells(row, report.unmerged.bufferTraffic[i]);
        rows.push_back(row);
    }
    for (std::size_t p = 0; p < paperImages.size(); ++p) {
        if (shown[p]) continue;
        Row row{paperImages[p].name, "", "", "", ""};
        cells(row, report.paper.traffic[p]);
        rows.push_back(row);
    }
    rows.push_back({"total"});
    for (const graph::Plan* plan : {&report.plan, &report.unmerged, &report.paper}) cells(rows.back(), plan->total);
    const std::uint32_t views = report.choice.views;
    rows.push_back({views > 1 ? "per pixel and eye" : "per pixel"});
    const std::uint64_t pixels = std::uint64_t{report.extent.width} * report.extent.height;
    for (const graph::Plan* plan : {&report.plan, &report.unmerged, &report.paper}) {
        const std::uint64_t each = pixels * (plan == &report.paper ? 1 : views);
        cells(rows.back(), {plan->total.loaded / each, plan->total.stored / each});
    }
    table(out, "  ", rows, 1);
}

/// Cost of each effect alone, compared with the frame without any.
void costsText(std::ostream& out, const PlanReport& report) {
    out << "\neach option by itself adds to a frame\n";
    std::vector<Row> rows{{"option", "passes", "B loaded", "stored", "on the tile, B per pixel", "samples"}};
    const auto more = [](std::int64_t bytes) {
        const std::string number = grouped(static_cast<std::uint64_t>(std::abs(bytes)));
        return bytes > 0 ? "+" + number : bytes < 0 ? "-" + number : "0";
    };
    for (const EffectCost& cost : report.costs)
        rows.push_back({"--" + cost.option, list(cost.passes, "none: a few instructions"), more(cost.loaded),
                        more(cost.stored), more(cost.tileBytes), std::to_string(cost.samples)});
    table(out, "  ", rows, 2);
}

void geometryText(std::ostream& out, const PlanReport& report) {
    const bool stored = report.plannedWith.geometry.storesVaryings;
    out << "\nvertices of the scene, and the bytes that they hand to fragments"
        << (stored ? ", through memory: written once, read once\n" : ", which stays on the chip\n");
    std::vector<Row> rows{{"pass", "vertices", "triangles", stored ? "B written" : "B", stored ? "B read" : ""}};
    const auto add = [&](const std::string& name, const PassGeometry& pass) {
        rows.push_back({name, grouped(pass.vertices), grouped(pass.triangles), grouped(pass.varyingBytes),
                        stored ? grouped(pass.varyingBytes) : ""});
    };
    for (const PassGeometry& pass : report.geometry) add(pass.name, pass);
    add("total", sumGeometry(report.geometry));
    table(out, "  ", rows, 1);
    const std::uint64_t most = report.plannedWith.geometry.mostVertexBytes;
    if (most == 0) return;
    out << "  at most " << grouped(most) << " B in a render pass:";
    for (const std::uint64_t bytes : report.vertexBytes) out << ' ' << grouped(bytes);
    out << '\n';
    if (report.forLimit.loaded + report.forLimit.stored > 0)
        out << "  the limit adds " << grouped(report.forLimit.loaded) << " B loaded, "
            << grouped(report.forLimit.stored) << " B stored\n";
}

void levelsText(std::ostream& out, const PlanReport& report) {
    out << "\nlevels of cartoons and surfaces\n";
    std::vector<Row> levels{{"error, angstrom", "triangles", "drawn"}};
    for (const MeshLevelCount& level : report.meshLevels)
        levels.push_back(
            {numberText(std::round(level.error * 1e4) / 1e4), grouped(level.triangles), grouped(level.drawn)});
    table(out, "  ", levels, 1);
}

void copyLevelsText(std::ostream& out, const PlanReport& report) {
    out << "\nlevels of copies\n";
    std::vector<Row> levels{{"error, angstrom", "copies", "spheres"}};
    for (const CopyLevelCount& level : report.copyLevels)
        levels.push_back(
            {numberText(std::round(level.error * 1e4) / 1e4), grouped(level.copies), grouped(level.spheres)});
    table(out, "  ", levels, 1);
}

}  // namespace

std::string planText(const PlanReport& report) {
    std::ostringstream out;
    out << report.caps << ", " << report.extent.width << "x" << report.extent.height << '\n'
        << "visibility " << visibilityName(report.choice.path) << ": " << report.why() << "\n";
    out << "frames in motion: " << report.motion.count << (report.motion.count == 1 ? " sample" : " samples")
        << " per pixel (" << report.motion.why << ")\n";
    if (report.rest) {
        const std::uint64_t pixels = std::uint64_t{report.extent.width} * report.extent.height;
        const RestPlan& rest = *report.rest;
        out << "frames at rest: " << rest.renderPasses << (rest.renderPasses == 1 ? " render pass" : " render passes")
            << ", " << rest.traffic.loaded / pixels << " B loaded and " << rest.traffic.stored / pixels
            << " B stored per pixel (unmerged: " << rest.unmerged.loaded / pixels << " and "
            << rest.unmerged.stored / pixels << ")\n";
    }
    for (const Decision& decision : report.decisions)
        if (decision.what == "views" || decision.what == "vertex outputs")
            out << (decision.what == "views" ? "stereo" : decision.what) << ": " << decision.how << " (" << decision.why
                << ")\n";
    if (report.samples > 1)
        out << "pixels of a picture where colours change are the mean of " << report.samples << " samples\n";
    if (report.explained) {
        out << "\nhow the frame is drawn\n";
        std::vector<Row> rows;
        for (const Decision& decision : report.decisions) rows.push_back({decision.what, decision.how, decision.why});
        table(out, "  ", rows);
    }
    out << '\n';
    for (const graph::Step& step : report.plan.steps) {
        barriersText(out, report, step.before);
        if (step.kind == graph::PassKind::graphics)
            renderPassText(out, report, step.renderPass);
        else
            computeText(out, report, report.frame.graph.passes()[step.pass]);
    }
    passesText(out, report);
    memoryText(out, report);
    if (!report.costs.empty()) costsText(out, report);
    if (!report.geometry.empty()) geometryText(out, report);
    if (!report.meshLevels.empty()) levelsText(out, report);
    if (!report.copyLevels.empty()) copyLevelsText(out, report);
    if (!report.facts.empty()) out << "\nknown facts about " << report.caps << '\n';
    for (const graph::Fact& fact : report.facts) out << "  " << fact.what << "\n    [" << fact.source << "]\n";
    return out.str();
}

}  // namespace nacre::app
