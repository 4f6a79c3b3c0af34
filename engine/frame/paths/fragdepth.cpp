#include <utility>

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

/// Impostors that write their depth. @param multisampled  fragments state which samples they cover
passes::GeometryPass shadedImpostors(Output output, const passes::Reads& reads, bool multisampled) {
    static const passes::PrimitiveShaders kShaders[] = NACRE_OUTPUTS(Fragdepth),
                                          kMultisampled = NACRE_SHADERS(look, , color, FragdepthMultisampled);
    passes::GeometryPass pass =
        passes::shadingPass(multisampled ? kMultisampled : kShaders[static_cast<std::size_t>(output)], reads);
    if (output == Output::color && !multisampled) pass.fetched = NACRE_FETCHED(Fragdepth);
    pass.depth = gpu::DepthUse::write;
    return pass;
}

}  // namespace

void declareFragdepth(Frame& f, const FrameShape& shape) {
    const VertexOutputs& vertices = shape.choice.vertices;
    if (shape.choice.prepass) declarePrepass(f, f.depth, vertices.plating);
    bool begins = !shape.choice.prepass;
    for (const ScreenTarget& target : shape.targets) {
        const auto describe = [atlas = f.atlas, output = target.output](const auto& c, const SceneView& scene) {
            return shadedImpostors(output, makeReads(c, NearestFrom::depthBuffer, atlas), scene.samples > 1);
        };
        for (const graph::Share& share : vertices.shading.shares()) {
            std::optional<Clear> clear;
            if (std::exchange(begins, false)) clear = Clear{1.0f};
            f.draw(f.lit(f.graphics(target.pass).share(share).depth(f.depth, clear)), target, shape, share)
                .record(clear ? drawsFirst(f, describe) : draws(f, describe));
        }
    }
}

}  // namespace nacre
