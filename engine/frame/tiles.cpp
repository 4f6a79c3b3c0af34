#include "engine/frame/screen.h"
#include "engine/software/tile_lists.h"

namespace nacre {
namespace {

constexpr std::uint64_t kWord = sizeof(std::uint32_t);

/// The buffers of pixels go by the tiles of bins.
graph::Buffer addPixels(ScreenFrame& f, const ScreenOptions& options, const char* name, std::uint64_t bytes) {
    return f.graph.importBuffer(name, bytes * TileLists::pixelsOfBins(options.extent.width, options.extent.height));
}

/// Colours are in a buffer row by row, where the host reads them: no image is made.
void declareShadedTiles(ScreenFrame& f, const ScreenOptions& options, const Recorder& draw) {
    f.numbers = addPixels(f, options, "colours of tiles", kWord);
    if (options.edges) f.edges = addPixels(f, options, "primitive numbers", kWord);
    if (options.edgesAlone) {
        f.graph.compute("nearest primitive").writes(*f.edges).record(draw.nearestByTiles());
    } else {
        graph::PassBuilder nearest =
            f.graph.compute(options.rims ? "nearest primitive, lines and halos, shaded" : "nearest primitive, shaded");
        f.lit(nearest).writes(f.numbers);
        if (options.edges) nearest.writes(*f.edges);
        nearest.record(draw.colorsByTiles(f.atlas));
    }
    if (options.edges) {
        f.edgePixels = addPixels(f, options, "edge pixels", kWord);
        if (!options.edgesPlaced)
            f.graph.compute("edge pixels")
                .reads(*f.edges)
                .reads(f.numbers)
                .writes(f.edgePixels)
                .record(draw.edgePixels());
        f.lit(f.graph.compute("edge samples").reads(*f.edges).reads(f.edgePixels))
            .writes(f.numbers)
            .record(draw.edgesByTiles(f.atlas));
    }
}

}  // namespace

void declareTiles(ScreenFrame& f, const ScreenOptions& options, const Recorder& draw) {
    if (options.shadedByTiles) return declareShadedTiles(f, options, draw);
    f.numbers = addPixels(f, options, "primitive numbers", kWord);
    f.graph.compute("nearest primitive").writes(f.numbers).record(draw.nearestByTiles());

    if (options.edges) {
        f.edges = addPixels(f, options, "edge colours", 2 * kWord);
        f.edgePixels = addPixels(f, options, "edge pixels", kWord);
        f.graph.compute("edge pixels").reads(f.numbers).writes(f.edgePixels).writes(*f.edges).record(draw.edgePixels());
        f.lit(f.graph.compute("edge samples").reads(f.numbers).reads(f.edgePixels))
            .writes(*f.edges)
            .record(draw.edgesByTiles(f.atlas));
    }
    const bool depth = options.translucentLayers > 0;
    for (const ScreenTarget& target : options.targets) {
        graph::PassBuilder shading = f.graph.graphics(target.pass);
        if (depth) shading.depth(f.depth, graph::Clear{1.0f});
        f.lit(shading.reads(f.numbers))
            .color(f.add(target, options.extent), target.clear)
            .record(draw.shadedTiles(target.output, f.atlas, depth));
    }
    if (options.edges)
        f.graph.graphics("edge colour")
            .reads(*f.edges)
            .color(f.targets[0])
            .record(draw.edgeColors(options.targets[0].clear));
}

}  // namespace nacre
