#include "engine/frame/geometry.h"

#include <algorithm>

#include "engine/frame/effects/outlines/outlines.h"
#include "engine/frame/effects/shadow/shadow.h"
#include "engine/frame/effects/translucency/translucency.h"
#include "engine/frame/level_scenes.h"
#include "engine/frame/paths/paths.h"
#include "engine/passes/select_opacity.h"
#include "engine/scene/instances/mesh_levels.h"

namespace nacre {
namespace {

using graph::Verb;
using passes::chooseShapes;
using passes::computeCost;
using passes::Handed;
using passes::PassCost;
using passes::PrimitiveCounts;
using passes::SphereShapes;

/// Whether a colour of the pass holds integers: primitive numbers, which the vertex stage passes on.
bool numbers(const graph::Graph& graph, const graph::PassDecl& pass) {
    return std::any_of(pass.uses.begin(), pass.uses.end(), [&](const graph::Use& use) {
        const VkFormat format = graph.images()[use.resource].desc.format;
        return use.verb == Verb::color && (format == VK_FORMAT_R32_UINT || format == VK_FORMAT_R32G32_UINT);
    });
}

}  // namespace

SceneCounts countPrimitives(Representation r, const RenderSettings& settings, SceneFacts& facts) {
    RenderSettings unbaked = settings.ofFrame();
    unbaked.occlusion.directions = 0;
    if (LevelScenes::draws(r, unbaked)) {
        LevelScenes scenes;
        SceneCounts counts = countPrimitives(scenes.show(r, unbaked, settings.view), settings, facts);
        counts.copyLevels = scenes.counts();
        return counts;
    }
    orderInSpace(r);
    const Chunks chunks = makeChunks(r);
    const View& view = settings.view;
    passes::PlacedCopies placed = passes::placeCopies(r, view, &chunks, cullingMargin(settings, view, !r.wires.empty()),
                                                      computeMeshError(settings, view), true);
    const SceneSizes sizes = measureSizes(r);
    const TranslucentParts parts = translucentParts(r);
    SceneCounts counts;
    counts.meshLevels = placed.triangleLevels(r);
    const auto countSelected = [&](passes::PlacedCopies copies, passes::Opacity which) -> PrimitiveCounts {
        passes::select(copies, parts, which);
        return {copies.sphereCount(),
                copies.cylinderCount(),
                copies.triangleCount(),
                sizes.meanRadius * view.pixelsPerAngstrom,
                view.projection == Projection::perspective,
                !r.ellipsoids.empty()};
    };
    static_cast<PrimitiveCounts&>(counts) = countSelected(placed, passes::Opacity::opaque);
    counts.layers = countSelected(placed, passes::Opacity::translucent);

    if (shadowPixels(settings) > 0) counts.light = countsInLight(r, settings, parts);

    facts = collectFacts(r, chunks, parts);
    static_cast<PrimitiveCounts&>(facts) = counts;
    facts.light = counts.light;
    facts.layers = counts.layers;
    facts.smallestPixels = smallestPixels(sizes, !r.wires.empty(), settings, view);
    return counts;
}

void tellGeometry(const graph::Graph& graph, const SceneCounts& counts, const graph::GeometryCaps& caps,
                  PlateShape plates, ImpostorShape impostor, std::vector<PassGeometry>& list) {
    const SphereShapes shapes = chooseShapes(plates, impostor, caps, counts);
    std::size_t told = 0;
    const auto tell = [&](std::uint32_t p, const PassCost& cost, const PrimitiveCounts& of) {
        if (told == list.size()) list.emplace_back();
        PassGeometry& geometry = list[told++];
        const graph::PassDecl& pass = graph.passes()[p];
        geometry.name = pass.name;
        geometry.pass = p;
        geometry.vertices = geometry.triangles = geometry.varyingBytes = 0;
        for (std::size_t kind = 0; kind < cost.size(); ++kind) {
            const auto [first, end] = pass.share.range(kind, passes::countKinds(of));
            geometry.vertices += (end - first) * cost[kind].vertices;
            geometry.triangles += (end - first) * cost[kind].triangles;
            geometry.varyingBytes += (end - first) * cost[kind].bytes;
        }
    };
    for (std::uint32_t p = 0; p < graph.passes().size(); ++p) {
        const graph::PassDecl& pass = graph.passes()[p];
        const bool tests = pass.has(Verb::depth) || pass.has(Verb::depthTest) || pass.has(Verb::ordered);
        // Draws triangles over the screen instead of the scene's primitives.
        const bool screen = pass.has(Verb::reads) || pass.name == kDepthByNumbers || pass.name == kOpaqueDepth ||
                            pass.name.starts_with(kTranslucentColor);
        if (pass.kind != graph::PassKind::graphics || !tests) continue;
        if (pass.name.starts_with(kTranslucentLayer) || pass.name == kTranslucentRest) {
            tell(p, computeCost(Handed::number, false, chooseShapes(plates, impostor, caps, counts.layers)),
                 counts.layers);
        } else if (screen) {
            continue;
        } else if (pass.name == kShadowPass) {
            tell(p, computeCost(Handed::depth, caps.storesVaryings, chooseShapes(plates, impostor, caps, counts.light)),
                 counts.light);
        } else if (!pass.has(Verb::color) && !pass.has(Verb::ordered)) {
            tell(p, computeCost(Handed::plates, false, shapes), counts);
        } else {
            // Passes that sample the occlusion atlas shade.
            const bool numbered = numbers(graph, pass) || pass.name == kRimPass;
            const bool fetched = caps.storesVaryings && pass.name == "impostor colour";  // not of layers
            const Handed handed = !pass.has(Verb::samples) ? (numbered ? Handed::number : Handed::depth)
                                  : fetched                ? Handed::shadingFetched
                                                           : Handed::shading;
            tell(p, computeCost(handed, caps.storesVaryings, shapes), counts);
        }
    }
    list.resize(told);
}

std::vector<PassGeometry> describeGeometry(const graph::Graph& graph, const SceneCounts& counts,
                                           const graph::GeometryCaps& caps, PlateShape plates, ImpostorShape impostor) {
    std::vector<PassGeometry> list;
    tellGeometry(graph, counts, caps, plates, impostor, list);
    return list;
}

std::vector<std::uint64_t> countVertexBytes(const graph::Plan& plan, std::span<const PassGeometry> passes) {
    std::vector<std::uint64_t> bytes;
    for (const graph::Step& step : plan.steps) {
        std::uint64_t sum = 0;
        for (const graph::Subpass& subpass : step.renderPass.subpasses)
            for (const PassGeometry& pass : passes)
                if (std::ranges::find(subpass.passes, pass.pass) != subpass.passes.end()) sum += pass.varyingBytes;
        if (sum > 0) bytes.push_back(sum);
    }
    return bytes;
}

PassGeometry sumGeometry(std::span<const PassGeometry> passes) {
    PassGeometry sum;
    for (const PassGeometry& pass : passes) {
        sum.vertices += pass.vertices;
        sum.triangles += pass.triangles;
        sum.varyingBytes += pass.varyingBytes;
    }
    return sum;
}

}  // namespace nacre
