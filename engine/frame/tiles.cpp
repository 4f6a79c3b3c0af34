#include "engine/frame/screen.h"
#include "engine/scene/tile_lists.h"

namespace nacre {

void declareTiles(ScreenFrame& f, const ScreenOptions& options, const Recorder& draw) {
    const std::uint64_t bytes =
        sizeof(std::uint32_t) * TileLists::pixelsOfBins(options.extent.width, options.extent.height);
    if (options.shadedByTiles) {
        const ScreenTarget& target = options.targets[0];
        f.numbers = f.graph.importBuffer("colours of tiles", bytes);
        f.graph.compute("nearest primitive, shaded")
            .samples(f.atlas)
            .writes(f.numbers)
            .record(draw.colorsByTiles(f.atlas));
        const graph::Image picture = f.add(target, options.extent);
        f.graph.transfer(target.pass)
            .copiesFrom(f.numbers)
            .copiesTo(picture)
            .record(draw.copiedColors(f.numbers, picture, options.extent));
        return;
    }
    f.numbers = f.graph.importBuffer("primitive numbers", bytes);
    f.graph.compute("nearest primitive").writes(f.numbers).record(draw.nearestByTiles());

    for (const ScreenTarget& target : options.targets)
        f.graph.graphics(target.pass)
            .reads(f.numbers)
            .samples(f.atlas)
            .color(f.add(target, options.extent), target.clear)
            .record(draw.shadedTiles(target.output, f.atlas));
}

}  // namespace nacre
