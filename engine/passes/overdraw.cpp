#include "engine/passes/overdraw.h"

#include "shaders.h"

namespace nacre::passes {

void drawOverdraw(gpu::PassContext& context, const SceneView& view) {
    PrimitivePass pass;
    pass.blend = gpu::Blend::add;
    drawImpostors(context, view, pass,
                  {shaders::geometrySphereVertex, {shaders::overdrawSphere, shaders::overdrawSphereCounting}},
                  {shaders::geometryCylinderVertex, {shaders::overdrawCylinder, shaders::overdrawCylinderCounting}});
}

}  // namespace nacre::passes
