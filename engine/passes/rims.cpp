#include "engine/passes/rims.h"

#include <algorithm>

#include "shaders.h"

namespace nacre::passes {

void drawRims(gpu::PassContext& context, const SceneView& view, const Reads& reads) {
    const bool texture = reads.from == NearestFrom::texture;
    PrimitivePass pass;
    pass.reads = &reads;
    pass.streams = true;
    pass.rim = std::max(view.rims.line, view.rims.halo);
    pass.blend = gpu::Blend::maximum;
    drawPrimitives(
        context, view, Primitive::sphere,
        {shaders::numberSphereVertex, texture ? Stage{shaders::rimsSphereSampled, shaders::rimsSphereSampledCounting}
                                              : Stage{shaders::rimsSphereInput, shaders::rimsSphereInputCounting}},
        pass);
    drawPrimitives(context, view, Primitive::cylinder,
                   {shaders::numberCylinderVertex,
                    texture ? Stage{shaders::rimsCylinderSampled, shaders::rimsCylinderSampledCounting}
                            : Stage{shaders::rimsCylinderInput, shaders::rimsCylinderInputCounting}},
                   pass);
    drawPrimitives(context, view, Primitive::triangle,
                   {shaders::numberTriangleReadsVertex,
                    texture ? Stage{shaders::rimsTriangleSampled, shaders::rimsTriangleSampledCounting}
                            : Stage{shaders::rimsTriangleInput, shaders::rimsTriangleInputCounting}},
                   pass);
}

}  // namespace nacre::passes
