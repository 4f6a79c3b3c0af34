#include <optional>

#include "engine/frame/screen.h"

namespace nacre {

void declareFragdepth(ScreenFrame& f, const ScreenOptions& options, const Recorder& draw) {
    if (options.prepass) f.graph.graphics("opaque prepass").depth(f.depth, graph::Clear{1.0f}).record(draw.plates());

    std::optional<graph::Clear> clear;
    if (!options.prepass) clear = graph::Clear{1.0f};
    for (const ScreenTarget& target : options.targets) {
        f.lit(f.graph.graphics(target.pass).depth(f.depth, clear))
            .color(f.add(target, options.extent), target.clear)
            .record(draw.impostors(target.output, passes::NearestFrom::depthBuffer, f.atlas));
        clear.reset();
    }
}

}  // namespace nacre
