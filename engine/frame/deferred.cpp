#include <optional>

#include "engine/frame/screen.h"

namespace nacre {

void declareDeferred(ScreenFrame& f, const ScreenOptions& options, const Recorder& draw) {
    if (options.prepass) f.graph.graphics("opaque prepass").depth(f.depth, graph::Clear{1.0f}).record(draw.plates());

    std::optional<graph::Clear> clear;
    if (!options.prepass) clear = graph::Clear{1.0f};
    f.nearest = options.rims ? f.graph.image("primitive number, distance", {VK_FORMAT_R32G32_UINT, options.extent})
                             : f.graph.image("primitive number", {VK_FORMAT_R32_UINT, options.extent});
    f.graph.graphics("nearest primitive")
        .depth(f.depth, clear)
        .color(f.nearest, graph::Clear{0.0f})
        .record(draw.nearestPrimitive(options.rims));

    if (options.rims) {
        const graph::Image rims = f.graph.image(kRimPass, {VK_FORMAT_R8G8B8A8_UNORM, options.extent});
        f.graph.graphics(kRimPass)
            .depthTest(f.depth)
            .input(f.nearest)
            .color(rims, graph::Clear{0.0f})
            .record(draw.rims(f.atlas, f.nearest));
        const ScreenTarget& target = options.targets[0];
        f.lit(f.graph.graphics(target.pass).input(f.nearest).input(rims))
            .color(f.add(target, options.extent), target.clear)
            .record(draw.rimmedPrimitives(f.atlas, f.nearest, rims, target.clear));
        return;
    }
    for (const ScreenTarget& target : options.targets)
        f.lit(f.graph.graphics(target.pass).input(f.nearest))
            .color(f.add(target, options.extent), target.clear)
            .record(draw.shadedPrimitives(target.output, f.atlas, f.nearest));
}

}  // namespace nacre
