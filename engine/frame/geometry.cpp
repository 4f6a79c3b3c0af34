#include "engine/frame/geometry.h"

#include <algorithm>

#include "engine/frame/effects/outlines/outlines.h"
#include "engine/frame/effects/shadow/choice.h"
#include "engine/frame/effects/translucency/translucency.h"
#include "engine/frame/level_scenes.h"
#include "engine/passes/placed_copies.h"
#include "engine/passes/plates.h"
#include "engine/passes/select_triangles.h"
#include "engine/scene/instances/mesh_levels.h"

namespace nacre {
namespace {

using graph::Verb;

constexpr std::uint32_t kPosition = 16, kVec4 = 16, kNumber = 4, kThree = 12;
constexpr std::uint32_t kTwo = 8;
constexpr std::uint32_t kSphereLook = kThree + kTwo, kCylinderLook = 3 * kThree + kTwo, kTriangleLook = 3 * kThree;

/// Positions and varyings of a vertex as shaders/*.vert write them.
struct VertexBytes {
    std::uint32_t sphere = kPosition + kVec4, cylinder = kPosition + 2 * kVec4;
    std::uint32_t triangle = kPosition + 3 * kThree + kNumber;
};

/// Corners of a polygon or pyramid, and the triangles that it is made of.
struct Shape {
    std::uint32_t vertices = 0, triangles = 0;
};

Shape operator+(const Shape& a, const Shape& b) { return {a.vertices + b.vertices, a.triangles + b.triangles}; }

Shape polygon(std::uint32_t corners) { return {corners, corners - 2}; }

Shape impostorOf(ImpostorShape shape) {
    switch (shape) {
        case ImpostorShape::square:
            return polygon(4);
        case ImpostorShape::octagon:
            return polygon(8);
        default:
            return {9, 8};  // indexed: each corner once
    }
}

/// Whether a colour of the pass holds integers: primitive numbers, which the vertex stage passes on.
bool numbers(const graph::Graph& graph, const graph::PassDecl& pass) {
    return std::any_of(pass.uses.begin(), pass.uses.end(), [&](const graph::Use& use) {
        const VkFormat format = graph.images()[use.resource].desc.format;
        return use.verb == Verb::color && (format == VK_FORMAT_R32_UINT || format == VK_FORMAT_R32G32_UINT);
    });
}

}  // namespace

SceneCounts countsOf(Representation r, const RenderSettings& settings, SceneFacts& facts) {
    RenderSettings unbaked = settings.ofFrame();
    unbaked.occlusion.directions = 0;
    if (LevelScenes::draws(r, unbaked)) {
        LevelScenes scenes;
        SceneCounts counts = countsOf(scenes.show(r, unbaked, settings.view), settings, facts);
        counts.copyLevels = scenes.counts();
        return counts;
    }
    orderInSpace(r);
    const Chunks chunks = chunksOf(r);
    const View& view = settings.view;
    passes::PlacedCopies placed = passes::placeCopies(r, view, &chunks, cullingMargin(settings, view, !r.wires.empty()),
                                                      meshErrorOf(settings, view), true);
    const SceneSizes sizes = sizesOf(r);
    const TranslucentRuns runs = translucentRuns(r);
    SceneCounts counts;
    counts.meshLevels = placed.triangleLevels(r);
    const std::uint64_t triangles = placed.triangleCount();
    passes::selectTriangles(placed.triangles, runs, passes::Triangles::translucent);
    counts.translucent = placed.triangleCount();
    counts.triangles = triangles - counts.translucent;
    counts.spheres = placed.sphereCount();
    counts.cylinders = placed.cylinderCount();
    counts.radiusPixels = sizes.meanRadius * view.pixelsPerAngstrom;
    counts.flat = view.projection == Projection::perspective;

    facts = factsOf(r, chunks, runs);
    facts.spheres = counts.spheres;
    facts.triangles = counts.triangles;
    facts.radiusPixels = counts.radiusPixels;
    facts.smallestPixels = smallestPixels(sizes, !r.wires.empty(), settings, view);
    return counts;
}

void tellGeometry(const graph::Graph& graph, const SceneCounts& counts, const graph::GeometryCaps& caps,
                  PlateShape plates, ImpostorShape impostor, std::vector<PassGeometry>& list) {
    const Shape sphere = impostorOf(passes::chooseImpostor(impostor, caps, counts.radiusPixels, counts.flat));
    const Shape cylinder = polygon(4), triangle = polygon(3);
    Shape plate;
    for (const passes::Plate& p : passes::platesOf(passes::choosePlates(plates, caps, counts.radiusPixels)))
        plate = plate + polygon(p.corners);
    std::size_t told = 0;
    const auto tell = [&](const graph::PassDecl& pass, std::uint64_t vertices, std::uint64_t triangles,
                          std::uint64_t varyingBytes) {
        if (told == list.size()) list.emplace_back();
        PassGeometry& geometry = list[told++];
        geometry.name = pass.name;
        geometry.vertices = vertices;
        geometry.triangles = triangles;
        geometry.varyingBytes = varyingBytes;
    };
    for (const graph::PassDecl& pass : graph.passes()) {
        const bool tests = pass.has(Verb::depth) || pass.has(Verb::depthTest) || pass.has(Verb::ordered);
        // None of the scene's primitives, but triangles over the screen.
        const bool screen = pass.has(Verb::reads) || pass.name.starts_with(kTranslucentColor);
        if (pass.kind != graph::PassKind::graphics || !tests || screen) continue;
        if (pass.name.starts_with(kTranslucentLayer)) {
            const std::uint64_t vertices = counts.translucent * triangle.vertices;
            tell(pass, vertices, counts.translucent, vertices * (VertexBytes().triangle + kNumber));
            continue;
        }
        if (!pass.has(Verb::color) && !pass.has(Verb::ordered) && pass.name != kShadowPass) {
            const std::uint64_t flat = plate.vertices ? counts.triangles : 0;
            const std::uint64_t vertices = counts.spheres * plate.vertices + flat * triangle.vertices;
            tell(pass, vertices, counts.spheres * plate.triangles + flat, vertices * kPosition);
            continue;
        }
        VertexBytes bytes;
        if (pass.has(Verb::samples))  // the occlusion atlas: it shades
            bytes = {caps.storesVaryings ? kPosition + kThree + kNumber : bytes.sphere + kSphereLook,
                     bytes.cylinder + kCylinderLook,
                     caps.storesVaryings ? kPosition + kNumber : bytes.triangle + kTriangleLook};
        else if (numbers(graph, pass) || pass.name == kRimPass)
            bytes = {bytes.sphere + kNumber, bytes.cylinder + kNumber, bytes.triangle + kNumber};
        else if (caps.storesVaryings)
            bytes.triangle = kPosition + kNumber;
        const std::uint64_t spheres = counts.spheres * sphere.vertices,
                            triangles = counts.triangles * triangle.vertices,
                            cylinders = counts.cylinders * cylinder.vertices;
        tell(pass, spheres + cylinders + triangles,
             counts.spheres * sphere.triangles + counts.cylinders * cylinder.triangles + counts.triangles,
             spheres * bytes.sphere + cylinders * bytes.cylinder + triangles * bytes.triangle);
    }
    list.resize(told);
}

std::vector<PassGeometry> geometryOf(const graph::Graph& graph, const SceneCounts& counts,
                                     const graph::GeometryCaps& caps, PlateShape plates, ImpostorShape impostor) {
    std::vector<PassGeometry> list;
    tellGeometry(graph, counts, caps, plates, impostor, list);
    return list;
}

PassGeometry sumOf(std::span<const PassGeometry> passes) {
    PassGeometry sum;
    for (const PassGeometry& pass : passes) {
        sum.vertices += pass.vertices;
        sum.triangles += pass.triangles;
        sum.varyingBytes += pass.varyingBytes;
    }
    return sum;
}

}  // namespace nacre
