#include "engine/frame/screen.h"
#include "engine/scene/tile_lists.h"

namespace nacre {

void declareTiles(ScreenFrame& f, const ScreenOptions& options, const Recorder& draw) {
    f.numbers = f.graph.importBuffer(
        "primitive numbers",
        sizeof(std::uint32_t) * TileLists::pixelsOfBins(options.extent.width, options.extent.height));
    f.graph.compute("nearest primitive").writes(f.numbers).record(draw.nearestByTiles());

    for (const ScreenTarget& target : options.targets)
        f.graph.graphics(target.pass)
            .reads(f.numbers)
            .samples(f.atlas)
            .color(f.add(target, options.extent), target.clear)
            .record(draw.shadedTiles(target.output, f.atlas));
}

}  // namespace nacre
