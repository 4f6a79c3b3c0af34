#include "engine/passes/nearest_depth.h"

#include "shaders.h"

namespace nacre::passes {

void drawNearestDepth(gpu::PassContext& context, const SceneView& view) {
    PrimitivePass pass;
    pass.depth = gpu::DepthUse::write;
    pass.colorsWritten = 0;
    drawImpostors(context, view, pass,
                  {shaders::geometrySphereVertex, {shaders::nearestSphere, shaders::nearestSphereCounting}},
                  {shaders::geometryCylinderVertex, {shaders::nearestCylinder, shaders::nearestCylinderCounting}});
}

}  // namespace nacre::passes
