#include "app/cli/plan_command.h"

#include <algorithm>
#include <ostream>

#include "app/cli/commands.h"
#include "app/cli/progress.h"
#include "app/download/load_map.h"
#include "app/download/load_molecule.h"
#include "app/drawing/drawing.h"
#include "engine/device_caps.h"
#include "engine/error.h"
#include "engine/frame/effects/lens/lens.h"
#include "engine/frame/foveation.h"
#include "engine/frame/window_end.h"

namespace nacre::app {
namespace {

const graph::EncodedFormat& findFormat(EncodedDepth rung) {
    for (const graph::EncodedFormat& format : graph::encodedFormats())
        if (format.rung == rung) return format;
    return graph::encodedFormats().front();
}

/// The capability set or the real device, changed by the options.
graph::FrameCaps chooseCaps(const PlanOptions& options) {
    const DeviceOptions& device = options.picture.device;
    if (options.caps.empty()) return deviceCaps(device);
    graph::FrameCaps caps = graph::capabilitySet(options.caps);
    caps.visibility = device.visibility;
    caps.multisampling = device.multisampling;
    if (device.encoded == EncodedDepth::automatic) return caps;
    // Formats are sorted finest first: a device blends its own and all coarser ones.
    const graph::EncodedFormat& wanted = findFormat(device.encoded);
    if (wanted.rung < caps.encoded.rung)
        throw Error("cannot encode depth", std::string(wanted.name), caps.plan.name + " does not blend that format");
    if (wanted.rung != caps.encoded.rung) caps.encoded = wanted;
    return caps;
}

/// The scene of the input, if there is one.
std::optional<Representation> sceneOfInput(const PlanOptions& options) {
    if (options.picture.input.path.empty()) return {};
    const Molecule molecule = loadMolecule(options.picture.input);
    loadMaps(options.picture);
    Drawing drawing(CameraBy::hand);
    drawing.build(molecule, options.picture);
    return drawing.joinedScene();
}

RenderSettings planSettings(const PlanOptions& options, double radius) {
    PictureDescription picture = options.picture;
    if (options.headset) picture.stereo.mode = Stereo::Mode::sideBySide, picture.size.width *= 2;
    RenderSettings settings = settingsOfEyes(picture, picture.camera, radius);
    settings.supersample = options.edges ? RenderSettings::kEdges : 1;
    return settings;
}

/// A frame, planned without readers of its result.
struct PlannedFrame {
    FrameChoice choice;
    Frame frame;
    graph::Plan plan;
};

enum class FrameTarget { picture, headset };

FrameRequest makeRequest(const RenderSettings& settings, Part part, FrameTarget of) {
    return {settings, part, Ending::readBack, 0, false, settings.view.other.has_value(), of == FrameTarget::headset};
}

PlannedFrame framePlanned(const RenderSettings& settings, Part part, const SceneFacts& scene,
                          const graph::FrameCaps& caps, FrameTarget of = FrameTarget::picture) {
    PlannedFrame planned;
    planned.choice = choose(makeRequest(settings, part, of), scene, caps);
    FrameShape shape;
    shape.choice = planned.choice;
    shape.choice.ending = Ending::left;
    shape.extent = {settings.view.width, settings.view.height};
    shape.atlas = {VK_FORMAT_R8_UNORM, {1024, 1024}};
    shape.targets = screenTargets(planned.choice);
    if (planned.choice.foveated)
        shape.density = densityMapFor(shape.extent, planned.choice.views, caps.plan.densityTexel);
    planned.frame = declareFrame(shape);
    if (part == Part::distances) declareLens(planned.frame, shape.extent, VK_FORMAT_R8G8B8A8_SRGB, nullptr);
    if (planned.choice.shadedByCompute()) planned.frame.graph.output(planned.frame.numbers);
    for (const graph::Image target : planned.frame.targets) planned.frame.graph.output(target);
    planned.plan = graph::compile(planned.frame.graph, caps.plan);
    return planned;
}

/// A frame of a window at rest, behind the first.
RestPlan planRest(const RenderSettings& settings, const SceneFacts& scene, const graph::FrameCaps& caps) {
    static constexpr ScreenTarget kColor{"colour", VK_FORMAT_R8G8B8A8_SRGB, passes::Output::color, "impostor colour"};
    FrameShape shape;
    shape.choice = choose({settings.ofFrame(), Part::sample, Ending::nextSample}, scene, caps);
    shape.extent = shape.window = {settings.view.width, settings.view.height};
    shape.targets = {&kColor, 1};
    Frame frame = declareFrame(shape);
    WindowEnd{kColor.format}.declare(frame, shape);
    const graph::Plan plan = graph::compile(frame.graph, caps.plan);
    graph::PlanCaps alone = caps.plan;
    alone.merge = false;
    RestPlan rest{0, graph::tileBytesPerPixel(plan), plan.total, graph::compile(frame.graph, alone).total};
    for (const graph::Step& step : plan.steps) rest.renderPasses += step.kind == graph::PassKind::graphics;
    return rest;
}

/// Samples per pixel of a picture where colours change.
std::uint32_t countSamples(const FrameChoice& choice) {
    return choice.refinement != Refinement::none ? RenderSettings::kEdgeSamples : choice.attachmentSamples();
}

/// A lens needs a frame of its own.
EffectCost costOfLens(const RenderSettings& settings, const graph::FrameCaps& caps, std::uint32_t samples) {
    const PlannedFrame lens = framePlanned(settings, Part::distances, {}, caps);
    EffectCost cost{"depth-of-field", visibilityName(lens.choice.path), {}, samples, 0, 0, 0};
    for (const graph::PassDecl& pass : lens.frame.graph.passes()) cost.passes.push_back(pass.name);
    cost.loaded = static_cast<std::int64_t>(lens.plan.total.loaded);
    cost.stored = static_cast<std::int64_t>(lens.plan.total.stored);
    cost.tileBytes = graph::tileBytesPerPixel(lens.plan);
    return cost;
}

/// The option that makes part of the scene translucent.
const char* opacityOption(const RepresentationOptions& look) {
    return look.surfaceOpacity < 1   ? "surface-opacity"
           : look.cartoonOpacity < 1 ? "cartoon-opacity"
           : look.atomOpacity < 1    ? "atom-opacity"
                                     : "show";
}

/// Cost of each active effect alone: compares a frame with the effect to one without effects, with opaque meshes.
std::vector<EffectCost> measureCosts(const PlanOptions& options, const RenderSettings& settings,
                                     const SceneFacts& scene, const graph::FrameCaps& caps,
                                     const MotionSamples& motion) {
    struct Alone {
        const char* name;
        Effects effects;
        Part part = Part::whole;
        bool translucent = false;
    };
    const Effects& asked = settings.effects;
    std::vector<Alone> alone;
    const auto add = [&](const char* name, auto change) {
        alone.push_back({name, {}});
        change(alone.back().effects);
    };
    if (asked.contours.width > 0) add("contours", [&](Effects& e) { e.contours.width = asked.contours.width; });
    if (asked.linesByGroups()) add("contour-weights 3", [&](Effects& e) { e.contours = asked.contours; });
    if (asked.halos.width > 0) add("halos", [&](Effects& e) { e.halos = asked.halos; });
    if (asked.fog.range != Fog::Range::off) add("fog", [&](Effects& e) { e.fog = asked.fog; });
    if (asked.shadow.strength > 0 && settings.lighting) add("shadow", [&](Effects& e) { e.shadow = asked.shadow; });
    if (asked.clip.on()) add("clip", [&](Effects& e) { e.clip = asked.clip; });
    if (scene.hasTranslucent) alone.push_back({opacityOption(options.picture.look), {}, Part::whole, true});
    if (motion.count > 1) alone.push_back({"msaa 4", {}, Part::motion});
    const auto planned = [&](const Alone& with) {
        RenderSettings s = settings.ofFrame();
        s.effects = with.effects;
        SceneFacts facts = scene;
        facts.hasTranslucent = with.translucent;
        graph::FrameCaps device = caps;
        if (with.part == Part::whole) device.multisampling = Multisampling::off;
        return framePlanned(s, with.part, facts, device);
    };
    const PlannedFrame none = planned({"", {}});
    const auto has = [&](const std::string& pass) {
        return std::ranges::any_of(none.frame.graph.passes(), [&](const graph::PassDecl& p) { return p.name == pass; });
    };
    std::vector<EffectCost> costs;
    for (const Alone& one : alone) {
        const PlannedFrame with = planned(one);
        const auto more = [](std::uint64_t a, std::uint64_t b) {
            return static_cast<std::int64_t>(a) - static_cast<std::int64_t>(b);
        };
        EffectCost cost{one.name, visibilityName(with.choice.path), {}, countSamples(with.choice), 0, 0, 0};
        for (const graph::PassDecl& pass : with.frame.graph.passes())
            if (!has(pass.name)) cost.passes.push_back(pass.name);
        cost.loaded = more(with.plan.total.loaded, none.plan.total.loaded);
        cost.stored = more(with.plan.total.stored, none.plan.total.stored);
        cost.tileBytes = more(graph::tileBytesPerPixel(with.plan), graph::tileBytesPerPixel(none.plan));
        costs.push_back(std::move(cost));
    }
    if (asked.depthOfField.strength > 0) costs.push_back(costOfLens(settings, caps, countSamples(none.choice)));
    return costs;
}

std::string joined(const graph::Graph& graph, const std::vector<std::uint32_t>& passes) {
    std::string text;
    for (const std::uint32_t p : passes) text += (text.empty() ? "" : " + ") + graph.passes()[p].name;
    return text;
}

}  // namespace

PlanReport planReport(const PlanOptions& options) {
    graph::FrameCaps caps = chooseCaps(options);
    caps.plan.merge = caps.plan.merge && options.merge;
    choosePath(caps);  // throws for a path that the device lacks
    const bool sampled = caps.multisampling == Multisampling::four;
    MotionSamples motion = chooseMotionSamples(caps);
    if (sampled && options.edges)
        throw Error("cannot draw 4 samples per pixel", caps.plan.name, "--supersample auto takes 16: leave it out");

    std::optional<Representation> scene = sceneOfInput(options);
    constexpr double kSomeRadius = 10;  // Å
    const RenderSettings settings = planSettings(options, scene ? scene->radius : kSomeRadius);
    SceneFacts facts;
    SceneCounts counts;
    const bool given = scene.has_value();
    if (given) counts = countPrimitives(std::move(*scene), settings, facts);
    counts.flat = counts.flat || sampled;
    const std::string lacks = lacksSamples(settings, facts.blends());
    if (motion.count > 1 && !sampled && !lacks.empty()) motion = {1, lacks};

    const FrameTarget of = options.headset ? FrameTarget::headset : FrameTarget::picture;
    const Part part = options.headset ? Part::motion : Part::whole;
    PlannedFrame planned = framePlanned(settings, part, facts, caps, of);
    PlanReport report;
    report.caps = caps.plan.name;
    report.plannedWith = caps.plan;
    report.decisions = explain(makeRequest(settings, part, of), facts, caps);
    report.choice = planned.choice;
    if (!options.caps.empty()) report.facts = graph::capabilitySet(options.caps).facts;
    report.extent = {settings.view.width, settings.view.height};
    report.motion = motion;
    report.samples = countSamples(planned.choice);
    if (!settings.view.other && settings.debug == DebugView::none) report.rest = planRest(settings, facts, caps);
    report.costs = measureCosts(options, settings, facts, caps, motion);
    report.frame = std::move(planned.frame);
    report.plan = std::move(planned.plan);
    report.explained = options.explain;
    graph::PlanCaps alone = caps.plan;
    alone.merge = false;
    report.unmerged = graph::compile(report.frame.graph, alone);
    graph::PlanCaps gles;
    gles.name = "OpenGL ES 2";
    gles.tileSubpasses = false;
    report.paperGraph = paperFrame(report.extent);
    report.paper = graph::compile(report.paperGraph, gles);
    report.meshLevels = counts.meshLevels;
    report.copyLevels = counts.copyLevels;
    if (given) {
        const VertexOutputs& vertices = report.choice.vertices;
        report.geometry =
            describeGeometry(report.frame.graph, counts, caps.plan.geometry, vertices.plates, vertices.impostor);
        report.vertexBytes = countVertexBytes(report.plan, report.geometry);
        graph::FrameCaps unlimited = caps;
        unlimited.plan.geometry.mostVertexBytes = 0;
        const graph::Traffic without = framePlanned(settings, part, facts, unlimited, of).plan.total;
        report.forLimit = {report.plan.total.loaded - without.loaded, report.plan.total.stored - without.stored};
    }
    return report;
}

std::vector<NamedUse> listUses(const PlanReport& report, const graph::RenderPassPlan& pass,
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

std::string joinNames(const graph::Graph& graph, const graph::Subpass& subpass) {
    return joined(graph, subpass.passes);
}

std::string joinNames(const graph::Graph& graph, const graph::RenderPassPlan& pass) {
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
        {VK_PIPELINE_STAGE_FRAGMENT_DENSITY_PROCESS_BIT_EXT, "fragment density"},
    };
    std::vector<std::string> names;
    for (const auto& [flag, name] : kNames)
        if (stages & flag) names.emplace_back(name);
    return names;
}

std::uint64_t countBytes(const graph::ImageDecl& image) {
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
