#include "engine/passes/opaque_prepass.h"

#include "engine/passes/plates.h"
#include "shaders.h"

namespace nacre::passes {

void drawPlates(gpu::PassContext& context, const SceneView& view) {
    PrimitivePass pass;
    pass.shaders = {shaders::plateVertex, {shaders::plateFragment, shaders::plateFragmentCounting}};
    pass.depth = gpu::DepthUse::write;
    pass.colorsWritten = 0;
    for (const Plate& plate : platesOf(choosePlates(view.plates, context.device.caps().software, view.radiusPixels))) {
        pass.corners = plate.corners;
        pass.rim = plate.rim;
        drawSpheres(context, view, pass);
    }
}

}  // namespace nacre::passes
