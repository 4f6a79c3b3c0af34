#include "engine/passes/nearest_depth.h"

#include "shaders.h"

namespace nacre::passes {

void drawNearestDepth(gpu::PassContext& context, const SceneView& view) {
    PrimitivePass pass;
    pass.depth = gpu::DepthUse::write;
    pass.colorsWritten = 0;
    drawPrimitives(context, view, Primitive::sphere,
                   {shaders::geometrySphereVertex, {shaders::nearestSphere, shaders::nearestSphereCounting}}, pass);
    drawPrimitives(context, view, Primitive::cylinder,
                   {shaders::geometryCylinderVertex, {shaders::nearestCylinder, shaders::nearestCylinderCounting}},
                   pass);
    drawPrimitives(context, view, Primitive::triangle,
                   {shaders::geometryTriangleVertex, {shaders::nearestTriangle, shaders::nearestTriangleCounting}},
                   pass);
}

}  // namespace nacre::passes
