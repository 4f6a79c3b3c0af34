#include "engine/frame/effects/shadow/shadow.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "engine/passes/geometry_passes.h"
#include "engine/passes/select_opacity.h"
#include "engine/passes/view_constants.h"

namespace nacre {
namespace {

/// The light's view: +z points to the light.
View lightView(const RenderSettings& settings, const View& view) {
    const glm::dvec3 w = glm::normalize(glm::dvec3(layout::kLightX, layout::kLightY, layout::kLightZ));
    const glm::dvec3 u = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), w)), v = glm::cross(w, u);
    View light;
    light.width = light.height = shadowPixels(settings);
    light.rotation = glm::transpose(glm::dmat3(u, v, w)) * view.rotation;
    light.radius = view.radius;
    constexpr double kRoom = 0.5;  // margin, Å: bonds may extend slightly beyond
    light.pixelsPerAngstrom = light.width / (2.0 * (view.radius + kRoom));
    return light;
}

void placeInLight(passes::PlacedCopies& copies, const Representation& r, const RenderSettings& settings,
                  const View& view, const View& light, const TranslucentParts& translucent) {
    // Same levels as in the view, so that nothing shades itself.
    passes::placeCopies(copies, r, light, nullptr, 0, computeMeshError(settings, view));
    // Translucent parts cast no shadow.
    passes::select(copies, translucent, passes::Opacity::opaque);
}

}  // namespace

passes::PrimitiveCounts countsInLight(const Representation& r, const RenderSettings& settings,
                                      const TranslucentParts& translucent) {
    const View light = lightView(settings, settings.view);
    passes::PlacedCopies copies;
    placeInLight(copies, r, settings, settings.view, light, translucent);
    return {.spheres = copies.sphereCount(),
            .cylinders = copies.cylinderCount(),
            .triangles = copies.triangleCount(),
            .radiusPixels = measureSizes(r).meanRadius * light.pixelsPerAngstrom,
            .hasEllipsoids = !r.ellipsoids.empty()};
}

void declareShadow(Frame& f, const FrameChoice& choice) {
    const std::uint32_t side = choice.effects.size(Effect::Kind::shadow);
    if (side == 0) return;
    f.shadow = f.graph.image("shadow map", {VK_FORMAT_D32_SFLOAT, {side, side}});
    graph::Work work;
    if (f.shown)
        work = {
            [shown = f.shown](gpu::PassContext& c) { passes::draw(c, *shown->scene->light, passes::nearestDepth()); },
            [shown = f.shown](gpu::PipelineContext& c) {
                passes::want(c, *shown->scene->light, passes::nearestDepth());
            }};
    for (const graph::Share& share : choice.vertices.light.shares())
        f.graph.graphics(kShadowPass).share(share).depth(*f.shadow, clearFirst(share, 1.0f)).record(work);
}

std::shared_ptr<passes::SceneView> lightScene(const Scene& scene, const RenderSettings& settings, const View& view,
                                              SceneViews& views) {
    const View light = lightView(settings, view);
    const auto seen = nextView(views);
    layout::ViewConstants& c = seen->constants;
    c = passes::viewConstants(light, light.width / 2.0, light.height / 2.0);
    const Clip& clip = settings.effects.clip;
    const glm::dmat3 turn = light.rotation * glm::transpose(view.rotation);
    seen->cut = clip.near > -Clip::kNone;
    if (!seen->cut && view.projection == Projection::perspective)
        layout::setCutPlane(c, glm::vec4(turn * (glm::dvec3(0, 0, view.eyeDistance) - view.shift), 1));
    else
        layout::setCutPlane(c, glm::vec4(turn[2], seen->cut ? -clip.near : 0));
    seen->octants = 3;
    seen->buffers = &scene.buffers;
    placeInLight(seen->copies, scene.representation, settings, view, light, scene.translucent);
    seen->impostor = settings.tuning.impostor;
    seen->radiusPixels = scene.sizes.meanRadius * light.pixelsPerAngstrom;
    return seen;
}

void addShadow(layout::EffectConstants& c, const RenderSettings& settings) {
    const View light = lightView(settings, settings.view);
    if (light.width == 0) return;
    const layout::ViewConstants seen = passes::viewConstants(light, light.width / 2.0, light.height / 2.0);
    const glm::dmat3 turn = light.rotation * glm::transpose(settings.view.rotation);  // from view space
    const glm::dvec3 aside = turn * settings.view.shift;                              // eyes share the map
    const double perMap = light.pixelsPerAngstrom / light.width;
    const auto row = [&](int i, double scale, double shift) {
        return glm::vec4(turn[0][i] * scale, turn[1][i] * scale, turn[2][i] * scale, shift - aside[i] * scale);
    };
    // u, v and depth in the map as dot products with (x, y, z, 1).
    c.shadowU = row(0, perMap, 0.5);
    c.shadowV = row(1, -perMap, 0.5);
    c.shadowW = row(2, -seen.perRange, (seen.origin - seen.depthStart) * seen.perRange);
    constexpr double kSoft = 0.45, kLift = 0.12;  // Å
    const double texel = 1.0 / light.pixelsPerAngstrom;
    c.shadowSpread = static_cast<float>(std::max(kSoft, 1.5 * texel) * perMap);
    c.shadowSlope = static_cast<float>(std::max(kSoft, 1.5 * texel)) * seen.perRange;
    c.shadowBias = static_cast<float>(kLift + 2.0 * texel);
    c.shadow = static_cast<float>(settings.effects.shadow.strength);
}

}  // namespace nacre
