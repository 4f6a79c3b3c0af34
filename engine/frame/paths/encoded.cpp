#include "engine/frame/paths/paths.h"
#include "engine/frame/record.h"
#include "engine/passes/geometry_passes.h"
#include "shaders.h"

namespace nacre {

using graph::Clear;
using passes::NearestFrom;
using passes::Output;
using passes::SceneView;

namespace {

/// Impostors shown where they have the pixel's nearest depth.
/// @param settles  the encoding is coarse: the depth buffer resolves ties
passes::GeometryPass shadedImpostors(Output output, const passes::Reads& reads, const passes::Encoding& encoding,
                                     bool settles) {
    static const passes::PrimitiveShaders kInput[] = NACRE_OUTPUTS(Input), kTexture[] = NACRE_OUTPUTS(Sampled),
                                          kInputSettles[] = NACRE_OUTPUTS(InputSettle),
                                          kTextureSettles[] = NACRE_OUTPUTS(SampledSettle);
    const bool texture = reads.from == NearestFrom::texture;
    const auto& shaders = texture ? (settles ? kTextureSettles : kTexture) : (settles ? kInputSettles : kInput);
    passes::GeometryPass pass = passes::shadingPass(shaders[static_cast<std::size_t>(output)], reads);
    if (output == Output::color)
        pass.fetched = texture ? (settles ? NACRE_FETCHED(SampledSettle) : NACRE_FETCHED(Sampled))
                               : (settles ? NACRE_FETCHED(InputSettle) : NACRE_FETCHED(Input));
    pass.encoding = encoding;
    if (settles) pass.depth = gpu::DepthUse::write;
    return pass;
}

}  // namespace

void declareEncoded(Frame& f, const FrameShape& shape) {
    const graph::EncodedFormat& format = shape.choice.encoded;
    const VertexOutputs& vertices = shape.choice.vertices;
    declarePrepass(f, f.depth, vertices.plating);

    f.encoding = format;
    f.nearest = f.graph.image("encoded depth", {format.format, shape.extent});
    const graph::Image atlas = f.atlas, nearest = f.nearest;
    for (const graph::Share& share : vertices.nearest.shares()) {
        graph::PassBuilder encoding = f.graphics("depth encoding").share(share).depthTest(f.depth);
        const std::optional<Clear> clear = clearFirst(share, format.farthest);
        if (format.ordered)
            encoding.ordered(f.nearest, clear).record(draws(f, [=](const auto& c, const SceneView&) {
                return passes::orderedDepth(makeReads(c, NearestFrom::ownAttachment, atlas, nearest));
            }));
        else
            encoding.color(f.nearest, clear)
                .record(draws(f, [encoding = passes::Encoding(format)](const auto&, const SceneView&) {
                    return passes::depthEncoding(encoding);
                }));
    }

    const bool settles = format.settles();
    for (const ScreenTarget& target : shape.targets)
        for (const graph::Share& share : vertices.shading.shares()) {
            graph::PassBuilder shading = f.graphics(target.pass).share(share);
            settles ? shading.depth(f.depth) : shading.depthTest(f.depth);
            f.draw(f.lit(shading.input(f.nearest)), target, shape, share);
            shading.record(draws(
                f, [=, output = target.output, encoding = passes::Encoding(format)](const auto& c, const SceneView&) {
                    return shadedImpostors(output, makeReads(c, fromEarlierPass(c), atlas, nearest), encoding, settles);
                }));
        }
}

}  // namespace nacre
