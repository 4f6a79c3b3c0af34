#include "app/cli/plan_command.h"
#include "app/cli/stats.h"
#include "app/files/json_text.h"

namespace nacre::app {
namespace {

using Json = nlohmann::ordered_json;

const char* loadName(graph::Load load) {
    return load == graph::Load::clear ? "clear" : load == graph::Load::load ? "load" : "dont_care";
}
const char* storeName(graph::Store store) {
    return store == graph::Store::store ? "store" : store == graph::Store::none ? "none" : "dont_care";
}

Json subpassJson(const PlanReport& report, const graph::RenderPassPlan& pass, const graph::Subpass& subpass) {
    Json json{{"name", joinNames(report.frame.graph, subpass)}, {"reads", Json::array()}, {"writes", Json::array()}};
    for (const NamedUse& use : listUses(report, pass, subpass))
        json[use.writes ? "writes" : "reads"].push_back(use.image);
    Json inputs = Json::array();
    for (const NamedUse& use : listUses(report, pass, subpass))
        if (use.how == "input attachment") inputs.push_back(use.image);
    json["input_attachments"] = inputs;
    return json;
}

Json renderPassJson(const PlanReport& report, const graph::RenderPassPlan& pass) {
    const graph::Graph& g = report.frame.graph;
    const graph::Share& share = g.passes()[pass.subpasses.back().passes.back()].share;
    Json json{{"name", joinNames(g, pass)},
              {"subpasses", Json::array()},
              {"attachments", Json::array()},
              {"dependencies", Json::array()},
              {"share", share.index + 1},
              {"shares", share.count},
              {"tile_bytes_per_pixel", pass.tileBytesPerPixel}};
    if (pass.density >= 0)
        json["density_map"] = g.images()[pass.attachments[static_cast<std::size_t>(pass.density)].image].name;
    for (const graph::Subpass& subpass : pass.subpasses)
        json["subpasses"].push_back(subpassJson(report, pass, subpass));
    for (const graph::Attachment& a : pass.attachments)
        json["attachments"].push_back({{"name", g.images()[a.image].name},
                                       {"format", graph::formatName(a.format)},
                                       {"load", loadName(a.load)},
                                       {"store", storeName(a.store)},
                                       {"samples", a.samples},
                                       {"views", pass.layers},
                                       {"transient", a.transient},
                                       {"bytes", countBytes(g.images()[a.image])}});
    for (const graph::Dependency& d : pass.dependencies)
        json["dependencies"].push_back({{"from", d.from == VK_SUBPASS_EXTERNAL ? Json("external") : Json(d.from)},
                                        {"to", d.to},
                                        {"from_stages", stageNames(d.fromStages)},
                                        {"to_stages", stageNames(d.toStages)},
                                        {"by_region", d.byRegion}});
    return json;
}

Json fetchJson(const Fetch& fetch) {
    return {{"sphere", fetch.sphere},
            {"cylinder", fetch.cylinder},
            {"triangle", fetch.triangle},
            {"per", fetch.perPixel ? "covered pixel" : "primitive"}};
}

Json passesJson(const PlanReport& report) {
    Json list = Json::array();
    for (const graph::PassDecl& pass : report.frame.graph.passes()) {
        const PassNotes notes = describePass(pass, report.plannedWith.conservativeDepth);
        list.push_back({{"name", pass.name},
                        {"depth_test", depthTimingName(notes.depth)},
                        {"depth_test_why", notes.why},
                        {"binning_bytes", fetchJson(notes.binning)},
                        {"shading_bytes", fetchJson(notes.shading)},
                        {"precision", notes.precision}});
    }
    return list;
}

Json computeJson(const graph::Graph& graph, const graph::PassDecl& pass) {
    Json json{{"name", pass.name}, {"reads", Json::array()}, {"writes", Json::array()}};
    for (const graph::Use& use : pass.uses)
        json[graph::isWrite(use.verb) ? "writes" : "reads"].push_back(resourceName(graph, use));
    return json;
}

Json buffersJson(const graph::Graph& graph, const graph::Plan& plan) {
    Json list = Json::array();
    for (std::size_t i = 0; i < graph.buffers().size(); ++i)
        list.push_back({{"name", graph.buffers()[i].name},
                        {"loaded", plan.bufferTraffic[i].loaded},
                        {"stored", plan.bufferTraffic[i].stored}});
    return list;
}

Json imagesJson(const graph::Graph& graph, const graph::Plan& plan) {
    Json list = Json::array();
    for (std::size_t i = 0; i < graph.images().size(); ++i)
        if (!graph.images()[i].imported)
            list.push_back({{"name", graph.images()[i].name},
                            {"loaded", plan.traffic[i].loaded},
                            {"stored", plan.traffic[i].stored}});
    return list;
}

Json costsJson(const PlanReport& report) {
    Json list = Json::array();
    for (const EffectCost& cost : report.costs)
        list.push_back({{"option", cost.option},
                        {"visibility", cost.visibility},
                        {"passes", cost.passes},
                        {"samples", cost.samples},
                        {"loaded", cost.loaded},
                        {"stored", cost.stored},
                        {"tile_bytes_per_pixel", cost.tileBytes}});
    return list;
}

Json restJson(const RestPlan& rest) {
    const auto bytes = [](const graph::Traffic& t) { return Json{{"loaded", t.loaded}, {"stored", t.stored}}; };
    return {{"render_passes", rest.renderPasses},
            {"tile_bytes_per_pixel", rest.tileBytesPerPixel},
            {"memory_bytes", bytes(rest.traffic)},
            {"unmerged_memory_bytes", bytes(rest.unmerged)}};
}

}  // namespace

std::string planJson(const PlanReport& report) {
    Json json{{"caps", report.caps},
              {"visibility", visibilityName(report.choice.path)},
              {"why", report.why()},
              {"choice", choiceJson(report.decisions)},
              {"size", {report.extent.width, report.extent.height}},
              {"samples", report.samples},
              {"motion", {{"samples", report.motion.count}, {"why", report.motion.why}}},
              {"rest", report.rest ? restJson(*report.rest) : Json()},
              {"merge", report.plannedWith.merge},
              {"compute_passes", Json::array()},
              {"render_passes", Json::array()},
              {"passes", passesJson(report)},
              {"tile_bytes_per_pixel", graph::tileBytesPerPixel(report.plan)},
              {"tile_bytes_per_pixel_budget", report.plannedWith.tileBytesPerPixel}};
    for (const graph::Step& step : report.plan.steps)
        if (step.kind == graph::PassKind::graphics)
            json["render_passes"].push_back(renderPassJson(report, step.renderPass));
        else
            json["compute_passes"].push_back(computeJson(report.frame.graph, report.frame.graph.passes()[step.pass]));
    // `unmerged` and `paper` are the sums of loads and stores in those arrangements.
    json["memory_bytes"] = {{"loaded", report.plan.total.loaded},
                            {"stored", report.plan.total.stored},
                            {"unmerged", report.unmerged.total.loaded + report.unmerged.total.stored},
                            {"paper", report.paper.total.loaded + report.paper.total.stored},
                            {"images", imagesJson(report.frame.graph, report.plan)},
                            {"buffers", buffersJson(report.frame.graph, report.plan)},
                            {"unmerged_images", imagesJson(report.frame.graph, report.unmerged)},
                            {"paper_images", imagesJson(report.paperGraph, report.paper)}};
    json["costs"] = costsJson(report);
    json["geometry"] =
        report.geometry.empty() ? Json() : geometryJson(report.geometry, report.plannedWith.geometry.storesVaryings);
    const std::uint64_t most = report.plannedWith.geometry.mostVertexBytes;
    json["vertex_bytes"] = {{"most", most > 0 ? Json(most) : Json()},
                            {"render_passes", report.vertexBytes},
                            {"loaded_for_limit", report.forLimit.loaded},
                            {"stored_for_limit", report.forLimit.stored}};
    json["mesh_levels"] = meshLevelsJson(report.meshLevels);
    json["copy_levels"] = copyLevelsJson(report.copyLevels);
    json["facts"] = Json::array();
    for (const graph::Fact& fact : report.facts)
        json["facts"].push_back({{"what", fact.what}, {"source", fact.source}});
    return jsonText(json);
}

}  // namespace nacre::app
