#include "engine/frame/screen.h"

namespace nacre {

void declareFragdepth(ScreenFrame& f, const ScreenOptions& options, const Recorder& draw) {
    f.graph.graphics("opaque prepass").depth(f.depth, graph::Clear{1.0f}).record(draw.plates());

    for (const ScreenTarget& target : options.targets)
        f.graph.graphics(target.pass)
            .depth(f.depth)
            .samples(f.atlas)
            .color(f.add(target, options.extent), target.clear)
            .record(draw.impostorsByDepthBuffer(target.output, f.atlas));
}

}  // namespace nacre
