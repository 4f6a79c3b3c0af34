#include "engine/frame/screen.h"

namespace nacre {

void declareEncoded(ScreenFrame& f, const ScreenOptions& options, const Recorder& draw) {
    const graph::EncodedFormat& format = options.encoded;
    f.graph.graphics("opaque prepass").depth(f.depth, graph::Clear{1.0f}).record(draw.plates());

    f.nearest = f.graph.image("encoded depth", {format.format, options.extent});
    f.graph.graphics("depth encoding")
        .depthTest(f.depth)
        .color(f.nearest, graph::Clear{format.farthest})
        .record(draw.encodedDepth(format));

    for (const ScreenTarget& target : options.targets) {
        const graph::Image image = f.add(target, options.extent);
        graph::PassBuilder shading = f.graph.graphics(target.pass);
        // Coarse encodings leave ties, which the depth buffer settles.
        format.settles() ? shading.depth(f.depth) : shading.depthTest(f.depth);
        f.lit(shading.input(f.nearest)).color(image, target.clear);
        shading.record(draw.impostorsAtEncodedDepth(target.output, f.atlas, f.nearest, format));
    }
}

}  // namespace nacre
