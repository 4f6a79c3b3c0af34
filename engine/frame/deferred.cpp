#include <optional>

#include "engine/frame/screen.h"

namespace nacre {

void declareDeferred(ScreenFrame& f, const ScreenOptions& options, const Recorder& draw) {
    if (options.prepass) f.graph.graphics("opaque prepass").depth(f.depth, graph::Clear{1.0f}).record(draw.plates());

    std::optional<graph::Clear> clear;
    if (!options.prepass) clear = graph::Clear{1.0f};
    f.nearest = f.graph.image("primitive number", {VK_FORMAT_R32_UINT, options.extent});
    f.graph.graphics("nearest primitive")
        .depth(f.depth, clear)
        .color(f.nearest, graph::Clear{0.0f})
        .record(draw.nearestPrimitive());

    for (const ScreenTarget& target : options.targets)
        f.lit(f.graph.graphics(target.pass).input(f.nearest))
            .color(f.add(target, options.extent), target.clear)
            .record(draw.shadedPrimitives(target.output, f.atlas, f.nearest));
}

}  // namespace nacre
