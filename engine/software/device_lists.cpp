#include "engine/software/device_lists.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "engine/software/software.h"
#include "engine/software/tile_bindings.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

// Shapes, rows of copies, calls; work.
constexpr std::array kBinTypes{kStorage, kStorage, kStorage, kStorage};
// Work, lists.
constexpr std::array kSortTypes{kStorage, kStorage};

/// Push constants of tile_offsets.comp and tile_sort.comp.
struct SortConstants {
    std::uint32_t bins = 0, offsets = 0;
};

std::uint32_t countBins(const ListedFrame& f) { return f.lists.across() * f.lists.down(); }

const gpu::Layout& binLayout(gpu::PipelineContext& context) {
    return context.pipelines.layout({"primitives of bins", kBinTypes, kCompute, sizeof(layout::TileConstants)});
}
const gpu::Layout& sortLayout(gpu::PipelineContext& context) {
    return context.pipelines.layout({"lists of bins", kSortTypes, kCompute, sizeof(SortConstants)});
}

gpu::ComputePipeline binPipeline(gpu::PipelineContext& context, const SceneView& view, bool writes) {
    const TileScene scene = tileScene(*view.buffers);
    gpu::ComputePipeline d{context.pass,
                           writes ? NACRE_TILE_SCENE(tileBinsWrite, ) : NACRE_TILE_SCENE(tileBinsCount, ),
                           {},
                           *binLayout(context).pipeline};
    setTileView(d.constants, view, view.rims.widest());
    return d;
}

gpu::ComputePipeline sortPipeline(gpu::PipelineContext& context, gpu::ShaderWords code) {
    gpu::ComputePipeline d{context.pass, code, {}, *sortLayout(context).pipeline};
    d.constants.set(layout::kTilesInBinId, TileLists::kTilesInBin);
    return d;
}

void drawBins(gpu::PassContext& context, const SceneView& view, bool writes) {
    constexpr std::uint32_t kItemsOfGroup = 64 / 16;  // shaders/tile_bins.comp
    const ListedFrame& f = listedFrame(view);
    if (!f.byDevice) return;
    layout::TileConstants constants = f.constants;
    constants.contourWidth = std::max(constants.contourWidth, view.rims.widest());
    bindTiles(context, binLayout(context), binPipeline(context, view, writes), constants, [&](TileBindings& to) {
        to.store(view.buffers->shapes);
        to.store(f.rows.buffer);
        to.store(f.byDevice->calls.buffer);
        to.store(f.byDevice->work.buffer);
    });
    dispatchTiles(context, (std::uint64_t{f.byDevice->items} + kItemsOfGroup - 1) / kItemsOfGroup);
}

void sortBins(gpu::PassContext& context, const SceneView& view, gpu::ShaderWords code, std::size_t groups) {
    const ListedFrame& f = listedFrame(view);
    if (!f.byDevice) return;
    const SortConstants constants{countBins(f), f.constants.offsets};
    bindTiles(context, sortLayout(context), sortPipeline(context, code), constants, [&](TileBindings& to) {
        to.store(f.byDevice->work.buffer);
        to.store(f.words.buffer);
    });
    dispatchTiles(context, groups);
}

}  // namespace

LargestPrimitives measureLargest(const Representation& r) {
    LargestPrimitives largest;
    for (const Sphere& s : r.spheres) largest.sphere = std::max(largest.sphere, s.radius);
    const auto add = [&](const Cylinder& c) {
        // Its box is wider than the axis by a radius at each side.
        largest.cylinder =
            std::max(largest.cylinder, glm::distance(c.a, c.b) + 2 * std::sqrt(2.0f) * std::max(c.radius, 0.0f));
        largest.wire = std::max(largest.wire, -c.radius);
    };
    for (const Cylinder& c : r.cylinders) add(c);
    for (const Cylinder& c : r.wires) add(c);
    const auto addTriangles = [&](std::span<const Triangle> triangles) {
        for (const Triangle& t : triangles) {
            const float step = t.step();
            const glm::vec3 a = decodePosition(r.meshVertices[t.a], step),
                            b = decodePosition(r.meshVertices[t.b], step),
                            c = decodePosition(r.meshVertices[t.c], step);
            const glm::vec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
            largest.triangle = std::max(largest.triangle, glm::distance(low, high));
        }
    };
    addTriangles(r.triangles);
    addTriangles(r.coarseTriangles);
    return largest;
}

std::uint64_t mostEntries(const SceneView& view, const LargestPrimitives& largest, std::uint64_t bins) {
    const layout::ViewConstants& c = view.constants;
    // Perspective enlarges near parts, most at the front of the scene.
    const double nearest = std::max<double>(c.depthStart, 1e-3 * c.origin);
    const double scale = (view.perspective ? 1.25 * c.origin / nearest : 1.0) / c.pixel;
    const double outline = 2.0 * std::max(c.contourWidth, view.rims.widest()) / c.pixel + 1;
    // A box with this diagonal covers the most bins if it is square.
    const auto binsIn = [&](double diagonal) {
        const double side = (diagonal * scale / std::sqrt(2.0) + outline) / TileBins::kPixels + 2;
        return std::min(std::ceil(side * side), static_cast<double>(bins));
    };
    const double wire = 2 * std::sqrt(2.0) * largest.wire * view.wireScale * c.pixel;
    return static_cast<std::uint64_t>(
        static_cast<double>(view.copies.sphereCount()) * binsIn(2 * std::sqrt(2.0) * largest.sphere * 1.005) +
        static_cast<double>(view.copies.cylinderCount()) * binsIn(1.005 * largest.cylinder + wire) +
        static_cast<double>(view.copies.triangleCount()) *
            binsIn(std::sqrt(2.0) * largest.triangle));  // each side of the box may be as long as an edge
}

void countPrimitivesOfBins(gpu::PassContext& context, const SceneView& view) { drawBins(context, view, false); }
void placeListsOfBins(gpu::PassContext& context, const SceneView& view) {
    constexpr std::uint32_t kBinsOfGroup = 256;
    sortBins(context, view, shaders::tileOffsets, (countBins(listedFrame(view)) + kBinsOfGroup - 1) / kBinsOfGroup);
}
void writeListsOfBins(gpu::PassContext& context, const SceneView& view) { drawBins(context, view, true); }
void sortListsOfBins(gpu::PassContext& context, const SceneView& view) {
    sortBins(context, view, shaders::tileSort, countBins(listedFrame(view)));
}

}  // namespace nacre::passes
