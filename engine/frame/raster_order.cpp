#include "engine/frame/screen.h"
#include "engine/graph/plan.h"

namespace nacre {

using passes::NearestFrom;

void declareRasterOrder(ScreenFrame& f, const ScreenOptions& options, const Recorder& draw) {
    f.graph.graphics("opaque prepass").depth(f.depth, graph::Clear{1.0f}).record(draw.plates());

    f.nearest = f.graph.image("nearest depth", {VK_FORMAT_R32_SFLOAT, options.extent});
    constexpr std::uint32_t kNarrow = 8;  // bytes of colour: the depth beside it fits every tile
    if (options.targets.size() == 1 && graph::bytesPerTexel(options.targets[0].format) <= kNarrow) {
        // It keeps the nearest depth itself.
        const ScreenTarget& target = options.targets[0];
        const graph::Image image = f.add(target, options.extent);
        f.lit(f.graph.graphics(target.pass).depthTest(f.depth))
            .color(image, target.clear)
            .ordered(f.nearest, graph::Clear{1.0f})
            .record(draw.impostors(target.output, NearestFrom::ownAttachment, f.atlas, f.nearest));
        return;
    }
    f.graph.graphics("depth encoding")
        .depthTest(f.depth)
        .ordered(f.nearest, graph::Clear{1.0f})
        .record(draw.encodedDepthInOrder(f.atlas, f.nearest));
    for (const ScreenTarget& target : options.targets)  // share what the pass before them kept
        f.lit(f.graph.graphics(target.pass).depthTest(f.depth))
            .color(f.add(target, options.extent), target.clear)
            .samples(f.nearest)
            .record(draw.impostors(target.output, NearestFrom::texture, f.atlas, f.nearest));
}

}  // namespace nacre
