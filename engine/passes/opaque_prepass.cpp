#include "engine/passes/opaque_prepass.h"

#include "engine/passes/plates.h"
#include "shaders.h"

namespace nacre::passes {

void drawPlates(gpu::PassContext& context, const SceneView& view) {
    PrimitivePass pass;
    pass.depth = gpu::DepthUse::write;
    pass.colorsWritten = 0;
    if (view.plates != PlateShape::none)
        drawPrimitives(context, view, Primitive::triangle,
                       {shaders::plateTriangleVertex, {shaders::plateFragment, shaders::plateFragmentCounting}}, pass);
    drawSpherePlates(context, view);
}

void drawSpherePlates(gpu::PassContext& context, const SceneView& view) {
    const Shaders shaders{shaders::plateVertex, {shaders::plateFragment, shaders::plateFragmentCounting}};
    PrimitivePass pass;
    pass.depth = gpu::DepthUse::write;
    pass.colorsWritten = 0;
    const graph::GeometryCaps& caps = context.device.caps().plan.geometry;
    for (const Plate& plate : platesOf(choosePlates(view.plates, caps, view.radiusPixels))) {
        pass.plate = &plate;
        drawPrimitives(context, view, Primitive::sphere, shaders, pass);
    }
}

}  // namespace nacre::passes
