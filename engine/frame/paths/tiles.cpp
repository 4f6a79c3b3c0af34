#include "engine/tiles/tiles.h"

#include "engine/frame/paths/paths.h"
#include "engine/frame/record.h"
#include "engine/passes/deferred_shading.h"
#include "engine/tiles/lanes/lane_passes.h"

namespace nacre {
namespace {

using passes::SceneView;

constexpr std::uint64_t kWord = sizeof(std::uint32_t);

/// A buffer with a value for each pixel of all bins. @param bytes  of a value
graph::Buffer addPixels(Frame& f, const FrameShape& shape, const char* name, std::uint64_t bytes) {
    return f.graph.importBuffer(name, bytes * TileBins::pixels(shape.extent.width, shape.extent.height));
}

graph::Work nearestByTiles(const Frame& f) {
    return draws(f, [](const auto&, const SceneView&) { return passes::NearestByTiles(); });
}
graph::Work edgeSamples(const Frame& f) {
    return records(f, [atlas = f.atlas](gpu::PassContext& c, const SceneView& scene) {
        passes::drawEdgesByTiles(c, scene, c.view(atlas));
    });
}

/// Calls `nearest`, which declares the pass that draws tiles. Where the device lists the primitives of each bin, it
/// first counts them; then each round places, writes and sorts the lists of its bins, and draws their tiles.
template <typename Nearest>
void declareNearest(Frame& f, const FrameShape& shape, const Nearest& nearest) {
    if (shape.choice.geometry != Geometry::deviceLists) return nearest();
    const std::uint64_t bins = TileBins::count(shape.extent.width, shape.extent.height);
    f.entries = f.graph.importBuffer("primitives of bins", kWord * bins);
    f.lists = f.graph.importBuffer("lists of tiles", kWord * bins);
    using Step = passes::BinLists::Step;
    const auto make = [&](Step step, std::uint32_t round) {
        return draws(f, [=](const auto&, const SceneView&) { return passes::BinLists{step, round}; });
    };
    f.graph.compute("lists: count").writes(*f.entries).record(make(Step::count, 0));
    for (std::uint32_t round = 0; round < shape.listRounds; ++round) {
        f.graph.compute("lists: place").writes(*f.entries).writes(*f.lists).record(make(Step::place, round));
        f.graph.compute("lists: write").writes(*f.entries).record(make(Step::write, round));
        f.graph.compute("lists: sort").writes(*f.entries).writes(*f.lists).record(make(Step::sort, round));
        nearest();
    }
}

/// A compute pass that draws from the lists.
graph::PassBuilder fromLists(Frame& f, const char* name) {
    graph::PassBuilder pass = f.graph.compute(name);
    if (f.lists) pass.reads(*f.lists);
    return pass;
}

/// Compute finds and shades in one pass. Colours go to a buffer, row by row, which the host reads: no image is made.
void declareShadedByCompute(Frame& f, const FrameShape& shape) {
    const FrameChoice& choice = shape.choice;
    f.numbers = addPixels(f, shape, "colours of tiles", kWord);
    if (choice.drawsEdges()) f.edges = addPixels(f, shape, "primitive numbers", kWord);
    declareNearest(f, shape, [&] {
        if (choice.edgePixels == EdgePixels::alone)
            return void(fromLists(f, "nearest primitive").writes(*f.edges).record(nearestByTiles(f)));
        graph::PassBuilder nearest =
            fromLists(f, choice.rims() ? "nearest primitive, lines and halos, shaded" : "nearest primitive, shaded");
        f.lit(nearest).writes(f.numbers);
        if (f.edges) nearest.writes(*f.edges);
        nearest.record(draws(f, [atlas = f.atlas](const auto& c, const SceneView&) {
            return passes::NearestByTiles{viewIn(c, atlas)};
        }));
    });
    if (!f.edges) return;
    f.edgePixels = addPixels(f, shape, "edge pixels", kWord);
    if (choice.edgePixels == EdgePixels::found)
        f.graph.compute("edge pixels")
            .reads(*f.edges)
            .reads(f.numbers)
            .writes(f.edgePixels)
            .record(records(f, passes::findEdgesByTiles));
    graph::PassBuilder samples = fromLists(f, "edge samples");
    f.lit(samples.reads(*f.edges).reads(f.edgePixels)).writes(f.numbers).record(edgeSamples(f));
}

/// Compute finds numbers without subgroup operations, and writes them to an image. Fragments shade as in `deferred`.
void declareShadedByImage(Frame& f, const FrameShape& shape) {
    const FrameChoice& choice = shape.choice;
    f.nearest = f.graph.image("primitive number", {VK_FORMAT_R32_UINT, shape.extent});
    declareNearest(f, shape, [&] {
        fromLists(f, "nearest primitive")
            .stores(f.nearest)
            .record(draws(f, [numbers = f.nearest](const auto& c, const SceneView&) {
                return passes::TileNumbers{viewIn(c, numbers)};
            }));
    });
    const bool depth = choice.layers() > 0 || choice.has(Effect::Kind::volume);
    for (const ScreenTarget& target : shape.targets) {
        graph::PassBuilder shading = f.graph.graphics(depth ? kDepthByNumbers : target.pass).samples(f.nearest);
        if (depth) shading.depth(f.depth, graph::Clear{1.0f});
        f.lit(shading)
            .color(f.add(target, shape), target.clear)
            .record(draws(
                f, [=, atlas = f.atlas, numbers = f.nearest, output = target.output](const auto& c, const SceneView&) {
                    passes::DeferredPass pass{output, makeReads(c, passes::NearestFrom::texture, atlas, numbers)};
                    pass.depth = depth;
                    return pass;
                }));
    }
}

}  // namespace

void declareTiles(Frame& f, const FrameShape& shape) {
    const FrameChoice& choice = shape.choice;
    if (choice.shadedByCompute()) return declareShadedByCompute(f, shape);
    if (choice.shadedByImage()) return declareShadedByImage(f, shape);
    f.numbers = addPixels(f, shape, "primitive numbers", kWord);
    if (choice.shadedInPicture()) return;  // the host found all spheres
    declareNearest(f, shape, [&] { fromLists(f, "nearest primitive").writes(f.numbers).record(nearestByTiles(f)); });

    if (choice.drawsEdges()) {
        f.edges = addPixels(f, shape, "edge colours", 2 * kWord);
        f.edgePixels = addPixels(f, shape, "edge pixels", kWord);
        f.graph.compute("edge pixels")
            .reads(f.numbers)
            .writes(f.edgePixels)
            .writes(*f.edges)
            .record(records(f, passes::findEdgesByTiles));
        graph::PassBuilder samples = fromLists(f, "edge samples");
        f.lit(samples.reads(f.numbers).reads(f.edgePixels)).writes(*f.edges).record(edgeSamples(f));
    }
    const bool depth = choice.layers() > 0 || choice.has(Effect::Kind::volume);
    for (const ScreenTarget& target : shape.targets) {
        graph::PassBuilder shading = f.graph.graphics(target.pass);
        if (depth) shading.depth(f.depth, graph::Clear{1.0f});
        f.lit(shading.reads(f.numbers))
            .color(f.add(target, shape), target.clear)
            .record(draws(f, [=, atlas = f.atlas, output = target.output](const auto& c, const SceneView&) {
                return passes::TileShading{viewIn(c, atlas), output, depth};
            }));
    }
    if (f.edges)
        f.graph.graphics("edge colour")
            .reads(*f.edges)
            .color(f.targets[0])
            .record(records(f, [clear = shape.targets[0].clear](gpu::PassContext& c, const SceneView& scene) {
                passes::drawEdgeColors(c, scene, clear);
            }));
}

}  // namespace nacre
