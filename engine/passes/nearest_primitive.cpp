#include "engine/passes/nearest_primitive.h"

#include "shaders.h"

namespace nacre::passes {

void drawNearestPrimitive(gpu::PassContext& context, const SceneView& view) {
    PrimitivePass pass;
    pass.depth = gpu::DepthUse::write;
    drawPrimitives(context, view, Primitive::sphere,
                   {shaders::numberSphereVertex, {shaders::identifySphere, shaders::identifySphereCounting}}, pass);
    drawPrimitives(context, view, Primitive::cylinder,
                   {shaders::numberCylinderVertex, {shaders::identifyCylinder, shaders::identifyCylinderCounting}},
                   pass);
    drawPrimitives(context, view, Primitive::triangle,
                   {shaders::numberTriangleVertex, {shaders::identifyTriangle, shaders::identifyTriangleCounting}},
                   pass);
}

}  // namespace nacre::passes
