#include "engine/passes/nearest_primitive.h"

#include "shaders.h"

namespace nacre::passes {

void drawNearestPrimitive(gpu::PassContext& context, const SceneView& view) {
    PrimitivePass pass;
    pass.depth = gpu::DepthUse::write;
    drawImpostors(context, view, pass,
                  {shaders::numberSphereVertex, {shaders::identifySphere, shaders::identifySphereCounting}},
                  {shaders::numberCylinderVertex, {shaders::identifyCylinder, shaders::identifyCylinderCounting}});
}

}  // namespace nacre::passes
