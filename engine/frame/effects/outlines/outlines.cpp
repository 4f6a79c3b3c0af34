#include "engine/frame/effects/outlines/outlines.h"

#include "engine/frame/effects/halos/halos.h"
#include "engine/frame/picture.h"
#include "engine/frame/record.h"
#include "engine/passes/geometry_passes.h"
#include "shaders.h"

namespace nacre {
namespace {

/// Draws outline, its freedom from fog, and halo density per pixel; both depend on the surface behind. @param reads
/// `nearest` holds numbers and distances, as an input attachment or a texture
passes::GeometryPass rims(const passes::SceneView& view, const passes::Reads& reads) {
    static const passes::PrimitiveShaders kInput = NACRE_SHADERS(number, Reads, rims, Input),
                                          kTexture = NACRE_SHADERS(number, Reads, rims, Sampled);
    passes::GeometryPass pass{reads.from == passes::NearestFrom::texture ? kTexture : kInput};
    pass.reads = reads;
    pass.streams = true;
    pass.rim = view.rims.widest();
    pass.blend = gpu::Blend::maximum;
    return pass;
}

}  // namespace

graph::Image declareRims(Frame& f, const FrameShape& shape) {
    graph::Image drawn = f.graph.image(kRimPass, {VK_FORMAT_R8G8B8A8_UNORM, shape.extent});
    for (const graph::Share& share : shape.choice.vertices.shading.shares())
        f.graph.graphics(kRimPass)
            .share(share)
            .depthTest(f.depth)
            .input(f.nearest)
            .color(drawn, clearFirst(share, 0.0f))
            .record(draws(f, [atlas = f.atlas, numbers = f.nearest](const auto& c, const passes::SceneView& scene) {
                return rims(scene, makeReads(c, fromEarlierPass(c), atlas, numbers));
            }));
    return drawn;
}

passes::Rims makeRims(const RenderSettings& settings) {
    const Effects& e = settings.effects;
    const double perPixel = 1.0 / settings.view.pixelsPerAngstrom;
    return {static_cast<float>(e.linesByGroups() ? e.contours.width * perPixel : 0),
            static_cast<float>(e.halos.width * perPixel)};
}

void addOutlines(layout::ViewConstants& c, const RenderSettings& settings) {
    const Contours& outlines = settings.effects.contours;
    c.contourWidth = static_cast<float>(outlines.width / settings.view.pixelsPerAngstrom);
    c.contourDepth = static_cast<float>(outlines.depth);
}

void addOutlines(layout::EffectConstants& c, const RenderSettings& settings) {
    const Contours& outlines = settings.effects.contours;
    c.contour = linearColor(outlines.color, 1);
    c.lineWidth = makeRims(settings).line;
    c.lineDepth = static_cast<float>(outlines.depth);
}

}  // namespace nacre
