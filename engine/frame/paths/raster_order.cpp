#include "engine/frame/paths/paths.h"
#include "engine/frame/record.h"
#include "engine/passes/geometry_passes.h"
#include "shaders.h"

namespace nacre {

using passes::NearestFrom;
using passes::Output;
using passes::SceneView;

namespace {

/// Impostors that keep the nearest depth themselves, in a second colour attachment.
passes::GeometryPass orderedImpostors(Output output, const passes::Reads& reads, bool multisampled) {
    static const passes::PrimitiveShaders kShaders[] = NACRE_OUTPUTS(Ordered),
                                          kMultisampled = NACRE_SHADERS(look, , color, OrderedMultisampled);
    passes::GeometryPass pass =
        passes::shadingPass(multisampled ? kMultisampled : kShaders[static_cast<std::size_t>(output)], reads);
    if (output == Output::color && !multisampled) pass.fetched = NACRE_FETCHED(Ordered);
    pass.colorsWritten = 2;
    return pass;
}

/// Impostors shown where an earlier pass left their depth.
passes::GeometryPass impostorsAtNearest(Output output, const passes::Reads& reads) {
    static const passes::PrimitiveShaders kShaders[] = NACRE_OUTPUTS(Sampled);
    passes::GeometryPass pass = passes::shadingPass(kShaders[static_cast<std::size_t>(output)], reads);
    if (output == Output::color) pass.fetched = NACRE_FETCHED(Sampled);
    return pass;
}

}  // namespace

void declareRasterOrder(Frame& f, const FrameShape& shape) {
    const VertexOutputs& vertices = shape.choice.vertices;
    declarePrepass(f, f.depth, vertices.plating);
    f.encoding = graph::EncodedFormat();
    f.nearest = f.graph.image("nearest depth", {VK_FORMAT_R32_SFLOAT, shape.extent, shape.choice.attachmentSamples()});
    const graph::Image atlas = f.atlas, nearest = f.nearest;
    if (settlesWhileShading(shape.targets)) {
        const ScreenTarget& target = shape.targets[0];
        for (const graph::Share& share : vertices.shading.shares())
            f.draw(f.lit(f.graphics(target.pass).share(share).depthTest(f.depth)), target, shape, share)
                .ordered(f.nearest, clearFirst(share, 1.0f))
                .record(draws(f, [=, output = target.output](const auto& c, const SceneView& scene) {
                    return orderedImpostors(output, makeReads(c, NearestFrom::ownAttachment, atlas, nearest),
                                            scene.samples > 1);
                }));
        return;
    }
    for (const graph::Share& share : vertices.nearest.shares())
        f.graphics("depth encoding")
            .share(share)
            .depthTest(f.depth)
            .ordered(f.nearest, clearFirst(share, 1.0f))
            .record(draws(f, [=](const auto& c, const SceneView&) {
                return passes::orderedDepth(makeReads(c, NearestFrom::ownAttachment, atlas, nearest));
            }));
    for (const ScreenTarget& target : shape.targets)  // share the previous pass's attachments
        for (const graph::Share& share : vertices.shading.shares())
            f.draw(f.lit(f.graphics(target.pass).share(share).depthTest(f.depth)), target, shape, share)
                .samples(f.nearest)
                .record(draws(f, [=, output = target.output](const auto& c, const SceneView&) {
                    return impostorsAtNearest(output, makeReads(c, NearestFrom::texture, atlas, nearest));
                }));
}

}  // namespace nacre
