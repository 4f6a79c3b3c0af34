#include "engine/frame/effects/outlines/outlines.h"
#include "engine/frame/paths/paths.h"
#include "engine/frame/record.h"
#include "engine/passes/deferred_shading.h"
#include "engine/passes/geometry_passes.h"
#include "shaders.h"

namespace nacre {

using graph::Clear;
using passes::SceneView;

namespace {

/// The number of every pixel's nearest primitive, counted from 1 over all copies, and its depth by gl_FragDepth.
/// @param distance  also store its Z next to the number
passes::GeometryPass nearestPrimitive(bool distance) {
    static const passes::PrimitiveShaders kNumbers = NACRE_SHADERS(number, , identify, );
    passes::GeometryPass pass{kNumbers};
    pass.depth = gpu::DepthUse::write;
    pass.distances = distance;
    return pass;
}

}  // namespace

void declareDeferred(Frame& f, const FrameShape& shape) {
    const bool rims = shape.choice.rims();
    const VertexOutputs& vertices = shape.choice.vertices;
    if (shape.choice.prepass) declarePrepass(f, f.depth, vertices.plating);
    f.nearest = rims ? f.graph.image("primitive number, distance", {VK_FORMAT_R32G32_UINT, shape.extent})
                     : f.graph.image("primitive number", {VK_FORMAT_R32_UINT, shape.extent});
    const auto describe = [=](const auto&, const SceneView&) { return nearestPrimitive(rims); };
    for (const graph::Share& share : vertices.nearest.shares()) {
        std::optional<Clear> clear = clearFirst(share, 1.0f);
        if (shape.choice.prepass) clear.reset();
        f.graphics("nearest primitive")
            .share(share)
            .depth(f.depth, clear)
            .color(f.nearest, clearFirst(share, 0.0f))
            .record(clear ? drawsFirst(f, describe) : draws(f, describe));
    }

    // The nearest primitives are known here, and nothing has left the tile.
    std::optional<graph::Image> drawnRims;
    if (rims) drawnRims = declareRims(f, shape);

    for (const ScreenTarget& target : shape.targets) {
        graph::PassBuilder shading = f.graphics(target.pass).input(f.nearest);
        if (drawnRims) shading.input(*drawnRims);
        f.lit(shading)
            .color(f.add(target, shape), target.clear)
            .record(draws(f, [=, atlas = f.atlas, numbers = f.nearest, output = target.output, clear = target.clear](
                                 const auto& c, const SceneView&) {
                passes::DeferredPass pass{output, makeReads(c, fromEarlierPass(c), atlas, numbers)};
                if (drawnRims) pass.rims = passes::DeferredRims{viewIn(c, *drawnRims), clear};
                return pass;
            }));
    }
}

}  // namespace nacre
