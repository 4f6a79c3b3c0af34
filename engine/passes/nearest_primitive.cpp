#include "engine/passes/nearest_primitive.h"

#include "shaders.h"

namespace nacre::passes {

void drawNearestPrimitive(gpu::PassContext& context, const SceneView& view, bool distance) {
    PrimitivePass pass;
    pass.depth = gpu::DepthUse::write;
    drawPrimitives(context, view, Primitive::sphere,
                   {shaders::numberSphereVertex,
                    distance ? Stage{shaders::identifySphereDistance, shaders::identifySphereDistanceCounting}
                             : Stage{shaders::identifySphere, shaders::identifySphereCounting}},
                   pass);
    drawPrimitives(context, view, Primitive::cylinder,
                   {shaders::numberCylinderVertex,
                    distance ? Stage{shaders::identifyCylinderDistance, shaders::identifyCylinderDistanceCounting}
                             : Stage{shaders::identifyCylinder, shaders::identifyCylinderCounting}},
                   pass);
    drawPrimitives(context, view, Primitive::triangle,
                   {shaders::numberTriangleVertex,
                    distance ? Stage{shaders::identifyTriangleDistance, shaders::identifyTriangleDistanceCounting}
                             : Stage{shaders::identifyTriangle, shaders::identifyTriangleCounting}},
                   pass);
}

}  // namespace nacre::passes
