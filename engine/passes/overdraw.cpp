#include "engine/passes/overdraw.h"

#include "shaders.h"

namespace nacre::passes {

void drawOverdraw(gpu::PassContext& context, const SceneView& view) {
    PrimitivePass pass;
    pass.blend = gpu::Blend::add;
    drawPrimitives(context, view, Primitive::sphere,
                   {shaders::geometrySphereVertex, {shaders::overdrawSphere, shaders::overdrawSphereCounting}}, pass);
    drawPrimitives(context, view, Primitive::cylinder,
                   {shaders::geometryCylinderVertex, {shaders::overdrawCylinder, shaders::overdrawCylinderCounting}},
                   pass);
    drawPrimitives(context, view, Primitive::triangle,
                   {shaders::geometryTriangleVertex, {shaders::overdrawTriangle, shaders::overdrawTriangleCounting}},
                   pass);
}

}  // namespace nacre::passes
