#include "app/cli/plan_command.h"

#include <algorithm>
#include <ostream>

#include "app/cli/commands.h"
#include "app/cli/progress.h"
#include "app/download/load_map.h"
#include "app/download/load_molecule.h"
#include "app/drawing/drawing.h"
#include "engine/device_plan.h"
#include "engine/error.h"
#include "engine/frame/lens.h"

namespace nacre::app {
namespace {

const graph::EncodedFormat& formatOf(EncodedDepth rung) {
    for (const graph::EncodedFormat& format : graph::encodedFormats())
        if (format.rung == rung) return format;
    return graph::encodedFormats().front();
}

void chooseBySet(const PlanOptions& options, PlanReport& report) {
    const graph::CapabilitySet& set = graph::capabilitySet(options.caps);
    report.caps = set.plan.name;
    report.plannedWith = set.plan;
    report.facts = set.facts;
    const bool automatic = options.picture.device.visibility == Visibility::automatic;
    const graph::VisibilityChoice choice = graph::chooseVisibility(set.kind, set.plan);
    report.visibility = automatic ? choice.visibility : options.picture.device.visibility;
    if (report.visibility == Visibility::rasterOrder && !set.plan.rasterOrder)
        throw Error("cannot draw by raster-order", set.plan.name, "it does not read its own attachments in order");
    if (report.visibility == Visibility::tiles && !set.plan.tiles)
        throw Error("cannot draw by tiles", set.plan.name, "it is unknown whether its subgroups exchange values");
    report.why = automatic ? choice.why : "asked for";
    report.encoded = set.encoded;
    report.motion = graph::chooseSamples(set.kind, report.visibility, set.plan);
    if (options.picture.device.encoded == EncodedDepth::automatic) return;
    // Formats are sorted finest first: a device blends its own and all coarser ones.
    const graph::EncodedFormat& wanted = formatOf(options.picture.device.encoded);
    if (wanted.rung < set.encoded.rung)
        throw Error("cannot encode depth", std::string(wanted.name), set.plan.name + " does not blend that format");
    if (wanted.rung != set.encoded.rung) report.encoded = wanted;
}

void chooseByDevice(const PlanOptions& options, PlanReport& report) {
    const DevicePlan device = planOf(options.picture.device);
    report.caps = device.name;
    report.plannedWith = device.caps;
    report.visibility = device.visibility;
    report.why = device.why;
    report.encoded = device.encoded;
    report.motion = device.motion;
    report.shadesByTiles = device.shadesByTiles;
}

/// Takes the number of samples that the options ask for instead of the device's.
void askSamples(const PlanOptions& options, PlanReport& report, const SceneCounts& counts) {
    const Multisampling wanted = options.picture.device.multisampling;
    const std::string alone = lacksSamples(options.picture.effects, counts.translucent > 0);
    if (wanted == Multisampling::off) report.motion = {1, "asked for"};
    if (wanted == Multisampling::automatic && report.motion.samples > 1 && !alone.empty()) report.motion = {1, alone};
    if (wanted != Multisampling::four) return;
    std::string lacks = graph::lacksMultisampling(report.visibility, report.plannedWith);
    if (lacks.empty()) lacks = alone;
    if (lacks.empty() && options.edges) lacks = "--supersample auto takes 16: leave it out";
    if (!lacks.empty()) throw Error("cannot draw 4 samples per pixel", report.caps, lacks);
    report.motion = {graph::kMultisamples, "asked for"};
}

/// Submitted primitives of the given scene.
SceneCounts countsOfInput(const PlanOptions& options) {
    const Molecule molecule = loadMolecule(options.picture.input);
    loadMaps(options.picture);
    Drawing drawing(CameraBy::hand);
    drawing.build(molecule, options.picture);
    Representation scene = drawing.joinedScene();
    const View view =
        viewOf(options.picture.camera, scene.radius, options.picture.size.width, options.picture.size.height);
    const double pixels = options.picture.meshError * (options.edges ? 0.25 : 1.0);
    return countsOf(std::move(scene), view, pixels);
}

struct PlannedFrame {
    Visibility visibility;
    std::uint32_t samples;  ///< of it that a pixel of a picture has
    ScreenFrame frame;
    graph::Plan plan;
};

/// The frame as some effects have it, by what the report says of device and path.
/// @param multisamples  of a pixel, resolved on the tile
PlannedFrame framePlanned(const PlanOptions& options, const PlanReport& report, const SceneCounts& counts,
                          const Effects& effects, std::uint32_t multisamples = 1) {
    const bool rims = effects.rims();
    const bool shades = report.shadesByTiles && report.visibility == Visibility::tiles && counts.translucent == 0;
    const Visibility visibility = rims && !shades ? Visibility::deferred : report.visibility;
    ScreenOptions screen{report.extent, visibility, report.encoded, {VK_FORMAT_R8_UNORM, {1024, 1024}}, {}};
    screen.targets = kScreenTargets;
    screen.rims = rims;
    screen.prepass = graph::platesReject(visibility, report.plannedWith);
    if (counts.translucent > 0) screen.translucentLayers = kTranslucentLayers;
    screen.layersByTiles = counts.translucent > 0 && visibility == Visibility::tiles;
    screen.edges = options.edges && visibility == Visibility::tiles && counts.translucent == 0 && !rims;
    screen.shadedByTiles = shades;
    constexpr std::uint32_t kShadowPixels = 1024;  // of all but the largest scenes
    screen.shadowPixels = effects.shadow.strength > 0 ? kShadowPixels : 0;
    screen.samples = multisamples;
    const std::uint32_t samples = options.edges && !screen.edges ? RenderSettings::kEdgeSamples : multisamples;
    PlannedFrame planned{visibility, samples, screenFrame(screen), {}};
    for (const graph::Image target : planned.frame.targets) planned.frame.graph.output(target);
    if (shades) planned.frame.graph.output(planned.frame.numbers);
    planned.plan = graph::compile(planned.frame.graph, report.plannedWith);
    return planned;
}

/// The second frame of a picture with depth of field, as drawn behind the first.
PlannedFrame lensPlanned(const PlanReport& report) {
    ScreenOptions screen{report.extent, report.visibility, report.encoded, {VK_FORMAT_R8_UNORM, {1, 1}}, {}};
    screen.targets = kLensTargets;
    screen.prepass = graph::platesReject(report.visibility, report.plannedWith);
    PlannedFrame planned{report.visibility, 1, screenFrame(screen), {}};
    declareLens(planned.frame, report.extent, VK_FORMAT_R8G8B8A8_SRGB, nullptr);
    planned.frame.graph.output(planned.frame.targets[0]);
    planned.plan = graph::compile(planned.frame.graph, report.plannedWith);
    return planned;
}

/// A lens costs a frame of its own.
EffectCost costOfLens(const PlanReport& report, std::uint32_t samples) {
    const PlannedFrame lens = lensPlanned(report);
    EffectCost cost{"depth-of-field", visibilityName(lens.visibility), {}, samples, 0, 0, 0};
    for (const graph::PassDecl& pass : lens.frame.graph.passes()) cost.passes.push_back(pass.name);
    cost.loaded = static_cast<std::int64_t>(lens.plan.total.loaded);
    cost.stored = static_cast<std::int64_t>(lens.plan.total.stored);
    cost.tileBytes = graph::tileBytesPerPixel(lens.plan);
    return cost;
}

/// The option that makes a mesh translucent.
const char* opacityOption(const RepresentationOptions& look) {
    return look.surfaceOpacity < 1 ? "surface-opacity" : look.cartoonOpacity < 1 ? "cartoon-opacity" : "show";
}

/// Cost of each active effect alone: the frame with it compared with the frame without any, with opaque meshes.
std::vector<EffectCost> costsOf(const PlanOptions& options, const PlanReport& report, const SceneCounts& counts) {
    struct Alone {
        const char* name;
        Effects effects;
        std::uint64_t translucent;
        std::uint32_t multisamples = 1;
    };
    const Effects& asked = options.picture.effects;
    std::vector<Alone> alone;
    const auto add = [&](const char* name, auto change) {
        alone.push_back({name, {}, 0, 1});
        change(alone.back().effects);
    };
    if (asked.contours.width > 0) add("contours", [&](Effects& e) { e.contours.width = asked.contours.width; });
    if (asked.linesByGroups()) add("contour-weights 3", [&](Effects& e) { e.contours = asked.contours; });
    if (asked.halos.width > 0) add("halos", [&](Effects& e) { e.halos = asked.halos; });
    if (asked.fog.range != Fog::Range::off) add("fog", [&](Effects& e) { e.fog = asked.fog; });
    if (asked.shadow.strength > 0 && options.picture.lighting)
        add("shadow", [&](Effects& e) { e.shadow = asked.shadow; });
    if (asked.clip.on()) add("clip", [&](Effects& e) { e.clip = asked.clip; });
    if (counts.translucent > 0) alone.push_back({opacityOption(options.picture.look), {}, counts.translucent, 1});
    if (report.motion.samples > 1) alone.push_back({"msaa 4", {}, 0, report.motion.samples});
    SceneCounts opaque = counts;
    opaque.translucent = 0;
    const PlannedFrame none = framePlanned(options, report, opaque, {});
    const auto has = [&](const std::string& pass) {
        const auto& passes = none.frame.graph.passes();
        return std::any_of(passes.begin(), passes.end(), [&](const graph::PassDecl& p) { return p.name == pass; });
    };
    std::vector<EffectCost> costs;
    for (const auto& [name, effects, translucent, multisamples] : alone) {
        SceneCounts scene = opaque;
        scene.translucent = translucent;
        const PlannedFrame with = framePlanned(options, report, scene, effects, multisamples);
        const auto more = [](std::uint64_t a, std::uint64_t b) {
            return static_cast<std::int64_t>(a) - static_cast<std::int64_t>(b);
        };
        EffectCost cost{name, visibilityName(with.visibility), {}, with.samples, 0, 0, 0};
        for (const graph::PassDecl& pass : with.frame.graph.passes())
            if (!has(pass.name)) cost.passes.push_back(pass.name);
        cost.loaded = more(with.plan.total.loaded, none.plan.total.loaded);
        cost.stored = more(with.plan.total.stored, none.plan.total.stored);
        cost.tileBytes = more(graph::tileBytesPerPixel(with.plan), graph::tileBytesPerPixel(none.plan));
        costs.push_back(std::move(cost));
    }
    if (asked.depthOfField.strength > 0) costs.push_back(costOfLens(report, none.samples));
    return costs;
}

std::string joined(const graph::Graph& graph, const std::vector<std::uint32_t>& passes) {
    std::string text;
    for (const std::uint32_t p : passes) text += (text.empty() ? "" : " + ") + graph.passes()[p].name;
    return text;
}

}  // namespace

PlanReport planReport(const PlanOptions& options) {
    const Size& size = options.picture.size;
    PlanReport report{{}, {}, {}, {}, {}, {}, {}, {size.width, size.height}, {}, {}, {}, graph::Graph(""), {}};
    if (options.caps.empty())
        chooseByDevice(options, report);
    else
        chooseBySet(options, report);
    graph::PlanCaps& caps = report.plannedWith;
    caps.merge = caps.merge && options.merge;
    const bool scene = !options.picture.input.path.empty();
    SceneCounts counts = scene ? countsOfInput(options) : SceneCounts();
    askSamples(options, report, counts);
    report.costs = costsOf(options, report, counts);
    Effects effects = options.picture.effects;
    if (!options.picture.lighting) effects.shadow = {};
    const bool sampled = options.picture.device.multisampling == Multisampling::four;
    counts.flat = counts.flat || sampled;
    PlannedFrame planned = framePlanned(options, report, counts, effects, sampled ? report.motion.samples : 1);
    if (planned.visibility != report.visibility) report.why = "lines and halos ask which primitive a pixel shows";
    report.visibility = planned.visibility;
    report.samples = planned.samples;
    report.frame = std::move(planned.frame);
    report.plan = std::move(planned.plan);
    graph::PlanCaps alone = caps;
    alone.merge = false;
    report.unmerged = graph::compile(report.frame.graph, alone);
    graph::PlanCaps gles;
    gles.name = "OpenGL ES 2";
    gles.tileSubpasses = false;
    report.paperGraph = paperFrame(report.extent);
    report.paper = graph::compile(report.paperGraph, gles);
    report.meshLevels = counts.meshLevels;
    report.copyLevels = counts.copyLevels;
    if (scene)
        report.geometry = geometryOf(report.frame.graph, counts, report.plannedWith.geometry, PlateShape::automatic,
                                     ImpostorShape::automatic);
    return report;
}

std::vector<NamedUse> usesOf(const PlanReport& report, const graph::RenderPassPlan& pass,
                             const graph::Subpass& subpass) {
    const graph::Graph& g = report.frame.graph;
    std::vector<NamedUse> uses;
    const auto nameAt = [&](std::uint32_t attachment) { return g.images()[pass.attachments[attachment].image].name; };
    if (subpass.depth >= 0)
        uses.push_back({nameAt(static_cast<std::uint32_t>(subpass.depth)), subpass.depthWrite ? "test, write" : "test",
                        subpass.depthWrite});
    for (const std::uint32_t a : subpass.inputs) uses.push_back({nameAt(a), "input attachment", false});
    for (const std::uint32_t p : subpass.passes)
        for (const graph::Use& use : g.passes()[p].uses)
            if (use.verb == graph::Verb::samples || (use.verb == graph::Verb::input && report.plan.inputIsSampled[p]))
                uses.push_back({g.images()[use.resource].name, "texture", false});
            else if (use.verb == graph::Verb::reads)
                uses.push_back({g.buffers()[use.resource].name, "buffer", false});
    for (const std::uint32_t a : subpass.colors) uses.push_back({nameAt(a), "write", true});
    if (subpass.resolve >= 0) uses.push_back({nameAt(static_cast<std::uint32_t>(subpass.resolve)), "resolve", true});
    return uses;
}

const std::string& resourceName(const graph::Graph& graph, const graph::Use& use) {
    return use.isImage ? graph.images()[use.resource].name : graph.buffers()[use.resource].name;
}

std::string nameOf(const graph::Graph& graph, const graph::Subpass& subpass) { return joined(graph, subpass.passes); }

std::string nameOf(const graph::Graph& graph, const graph::RenderPassPlan& pass) {
    std::vector<std::uint32_t> all;
    for (const graph::Subpass& subpass : pass.subpasses)
        all.insert(all.end(), subpass.passes.begin(), subpass.passes.end());
    return joined(graph, all);
}

std::vector<std::string> stageNames(VkPipelineStageFlags stages) {
    constexpr std::pair<VkPipelineStageFlags, const char*> kNames[] = {
        {VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, "top"},
        {VK_PIPELINE_STAGE_VERTEX_INPUT_BIT, "vertex input"},
        {VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT, "early tests"},
        {VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, "fragment shader"},
        {VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT, "late tests"},
        {VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT, "colour output"},
        {VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, "compute shader"},
        {VK_PIPELINE_STAGE_TRANSFER_BIT, "transfer"},
        {VK_PIPELINE_STAGE_HOST_BIT, "host"},
    };
    std::vector<std::string> names;
    for (const auto& [flag, name] : kNames)
        if (stages & flag) names.emplace_back(name);
    return names;
}

std::uint64_t bytesOf(const graph::ImageDecl& image) {
    return std::uint64_t{graph::bytesPerTexel(image.desc.format)} * image.desc.extent.width * image.desc.extent.height *
           image.desc.layers * image.desc.samples;
}

void planCommand(const PlanOptions& options, std::ostream& out) {
    Progress progress;
    progress.begin("planning");
    const PlanReport report = planReport(options);
    out << (options.json ? planJson(report) : planText(report));
}

}  // namespace nacre::app
