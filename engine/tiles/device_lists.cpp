#include "engine/tiles/device_lists.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "engine/tiles/tile_bindings.h"
#include "engine/tiles/tiles.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

// Shapes, rows of copies, calls; work.
constexpr std::array kBinTypes{kStorage, kStorage, kStorage, kStorage};
// Work, lists.
constexpr std::array kSortTypes{kStorage, kStorage};

/// Push constants of tile_offsets.comp.
struct PlaceConstants {
    std::uint32_t bins, offsets, earlier, share;
};
/// Push constants of tile_sort.comp.
struct SortConstants {
    std::uint32_t bins, offsets, last;
};

std::uint32_t countBins(const ListedFrame& f) { return f.covered.across() * f.covered.down(); }

const gpu::Layout& binLayout(gpu::PipelineContext& context) {
    return context.pipelines.layout({"primitives of bins", kBinTypes, kCompute, sizeof(layout::TileConstants)});
}
const gpu::Layout& sortLayout(gpu::PipelineContext& context) {
    return context.pipelines.layout({"lists of bins", kSortTypes, kCompute, sizeof(PlaceConstants)});
}

gpu::ComputePipeline binPipeline(gpu::PipelineContext& context, const SceneView& view, bool writes) {
    const TileScene scene = tileScene(*view.buffers);
    gpu::ComputePipeline d{context.pass, NACRE_TILE_SCENE(tileBins), {}, *binLayout(context).pipeline};
    d.constants.set(layout::kWritesId, writes);
    setTileView(d.constants, view, view.rims.widest());
    return d;
}

gpu::ComputePipeline sortPipeline(gpu::PipelineContext& context, gpu::ShaderWords code) {
    gpu::ComputePipeline d{context.pass, code, {}, *sortLayout(context).pipeline};
    d.constants.set(layout::kTilesInBinId, TileSet::kTilesInBin);
    return d;
}

void drawBins(gpu::PassContext& context, const SceneView& view, bool writes) {
    constexpr std::uint32_t kGroup = 64;  // shaders/tile_bins.comp
    const ListedFrame& f = listedFrame(view);
    if (!f.byDevice || f.byDevice->items == 0) return;
    layout::TileConstants constants = f.constants;
    constants.contourWidth = std::max(constants.contourWidth, view.rims.widest());
    bindTiles(context, binLayout(context), binPipeline(context, view, writes), constants, [&](TileBindings& to) {
        to.store(view.buffers->shapes);
        to.store(f.rows.buffer);
        to.store(f.byDevice->calls.buffer);
        to.store(f.byDevice->work.buffer);
    });
    dispatchTiles(context, (std::uint64_t{f.byDevice->items} * f.byDevice->share + kGroup - 1) / kGroup);
}

template <typename Constants>
void sortBins(gpu::PassContext& context, const SceneView& view, gpu::ShaderWords code, std::size_t groups,
              const Constants& constants) {
    const ListedFrame& f = listedFrame(view);
    bindTiles(context, sortLayout(context), sortPipeline(context, code), constants, [&](TileBindings& to) {
        to.store(f.byDevice->work.buffer);
        to.store(f.words.buffer);
    });
    dispatchTiles(context, groups);
}

}  // namespace

MeasuredPrimitives measurePrimitives(const Representation& r) {
    MeasuredPrimitives sizes;
    const auto measure = [](float PrimitiveSizes::*kind, MeasuredPrimitives& to, auto size, const auto&... all) {
        double sum = 0;
        std::size_t count = 0;
        const auto add = [&](const auto& primitives) {
            for (const auto& p : primitives) {
                const float s = size(p);
                to.largest.*kind = std::max(to.largest.*kind, s);
                sum += static_cast<double>(s);
            }
            count += primitives.size();
        };
        (add(all), ...);
        to.mean.*kind = static_cast<float>(sum / static_cast<double>(std::max<std::size_t>(count, 1)));
    };
    measure(
        &PrimitiveSizes::sphere, sizes, [](const Sphere& s) { return s.radius; }, r.spheres);
    // The box of a cylinder is wider than its axis by a radius at each side.
    measure(
        &PrimitiveSizes::cylinder, sizes,
        [](const Cylinder& c) { return glm::distance(c.a, c.b) + 2 * std::sqrt(2.0f) * std::max(c.radius, 0.0f); },
        r.cylinders, r.wires);
    measure(
        &PrimitiveSizes::wire, sizes, [](const Cylinder& c) { return -c.radius; }, r.wires);
    measure(
        &PrimitiveSizes::triangle, sizes,
        [&](const Triangle& t) {
            const float step = t.step();
            const glm::vec3 a = decodePosition(r.meshVertices[t.a], step),
                            b = decodePosition(r.meshVertices[t.b], step),
                            c = decodePosition(r.meshVertices[t.c], step);
            return glm::distance(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)));
        },
        r.triangles, r.coarseTriangles);
    return sizes;
}

std::uint64_t boundEntries(const SceneView& view, const PrimitiveSizes& sizes, std::uint64_t bins) {
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
    const double wire = 2 * std::sqrt(2.0) * sizes.wire * view.wireScale * c.pixel;
    return static_cast<std::uint64_t>(
        static_cast<double>(view.copies.sphereCount()) * binsIn(2 * std::sqrt(2.0) * sizes.sphere * 1.005) +
        static_cast<double>(view.copies.cylinderCount()) * binsIn(1.005 * sizes.cylinder + wire) +
        static_cast<double>(view.copies.triangleCount()) *
            binsIn(std::sqrt(2.0) * sizes.triangle));  // each side of the box may be as long as an edge
}

std::uint32_t chooseShare(std::uint64_t entries, std::uint64_t primitives) {
    const std::uint64_t bins = entries / std::max<std::uint64_t>(primitives, 1);
    return bins >= 40 ? 16 : bins >= 12 ? 4 : 1;  // a bound counts two bins per side too many
}

ListRounds planRounds(std::uint64_t most, std::uint64_t longest, std::uint32_t room) {
    constexpr std::uint64_t kMostRounds = 32;
    if (most <= room) return {1, std::numeric_limits<std::uint32_t>::max()};
    if (2 * longest > room) return {};
    // The last list may be empty, and begin where all entries end.
    const std::uint64_t share = room - longest, count = most / share + 1;
    if (count > kMostRounds) return {};
    return {static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(share)};
}

void draw(gpu::PassContext& context, const SceneView& view, const BinLists& lists) {
    constexpr std::uint32_t kBinsOfGroup = 128;  // shaders/tile_offsets.comp
    const ListedFrame& f = listedFrame(view);
    if (!f.byDevice) return;
    const std::uint32_t bins = countBins(f), share = f.byDevice->rounds.share, offsets = f.constants.offsets;
    switch (lists.step) {
        case BinLists::Step::count:
            return drawBins(context, view, false);
        case BinLists::Step::place:
            return sortBins(context, view, shaders::tileOffsets, (bins + kBinsOfGroup - 1) / kBinsOfGroup,
                            PlaceConstants{bins, offsets, lists.round * share, share});
        case BinLists::Step::write:
            return drawBins(context, view, true);
        case BinLists::Step::sort:
            return sortBins(context, view, shaders::tileSort, bins,
                            SortConstants{bins, offsets, lists.round + 1 == f.byDevice->rounds.count ? 1u : 0u});
    }
}

void want(gpu::PipelineContext& context, const SceneView& view, const BinLists& lists) {
    if (!listedFrame(view).byDevice) return;
    switch (lists.step) {
        case BinLists::Step::count:
        case BinLists::Step::write:
            return context.pipelines.want(binPipeline(context, view, lists.step == BinLists::Step::write));
        case BinLists::Step::place:
            return context.pipelines.want(sortPipeline(context, shaders::tileOffsets));
        case BinLists::Step::sort:
            return context.pipelines.want(sortPipeline(context, shaders::tileSort));
    }
}

}  // namespace nacre::passes
