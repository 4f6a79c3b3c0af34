#include "engine/frame/scene.h"

#include <algorithm>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "engine/frame/picture.h"
#include "engine/passes/translucent.h"
#include "engine/passes/view_constants.h"
#include "engine/scene/build/atom_groups.h"
#include "engine/scene/instances/mesh_levels.h"

namespace nacre {
namespace {

void addAtlas(layout::ViewConstants& c, const passes::Atlas& atlas) {
    c.atlasTexel = glm::vec2(1.0 / atlas.image->desc.extent.width, 1.0 / atlas.image->desc.extent.height);
    c.patchTexels = atlas.sphereEdge | atlas.around << 8 | atlas.along << 16 | atlas.least << 24;
    c.patchesInRow = atlas.spherePatches | atlas.cylinderPatches << 16;
}

/// Planes and lines, in the numbers of the passes.
void addEffects(layout::ViewConstants& c, const RenderSettings& settings, const View& view) {
    const Effects& e = settings.effects;
    const double center = view.projection == Projection::perspective ? view.eyeDistance : view.radius;  // its Z
    c.clipNear = static_cast<float>(std::max<double>(center + e.clip.near, -layout::kNoPlane));
    c.clipFar = static_cast<float>(std::min<double>(center + e.clip.far, layout::kNoPlane));
    // `view` may have more pixels than the picture: scales the outline accordingly.
    c.contourWidth = static_cast<float>(e.contours.width / settings.view.pixelsPerAngstrom);
    c.contourDepth = static_cast<float>(e.contours.depth);
}

/// `view` may have more pixels than the picture: scales rims accordingly.
passes::Rims rimsOf(const RenderSettings& settings) {
    const Effects& e = settings.effects;
    const double perPixel = 1.0 / settings.view.pixelsPerAngstrom;
    return {static_cast<float>(e.linesByGroups() ? e.contours.width * perPixel : 0),
            static_cast<float>(e.halos.width * perPixel)};
}

glm::vec4 linear(float r, float g, float b, double share) {
    return {linearFromSrgb(r), linearFromSrgb(g), linearFromSrgb(b), share};
}

/// The scene from the light: the frame in which +z points to it.
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

/// From view space to the light's map: u, v and depth as dot products with (x, y, z, 1).
void addShadow(layout::EffectConstants& c, const RenderSettings& settings) {
    const View light = lightView(settings, settings.view);
    if (light.width == 0) return;
    const layout::ViewConstants seen = passes::viewConstants(light, light.width / 2.0, light.height / 2.0);
    const glm::dmat3 turn = light.rotation * glm::transpose(settings.view.rotation);  // from view space
    const double perMap = light.pixelsPerAngstrom / light.width;
    const auto row = [&](int i, double scale, double shift) {
        return glm::vec4(turn[0][i] * scale, turn[1][i] * scale, turn[2][i] * scale, shift);
    };
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

/// The scene as the light sees it. With clipping, primitives whose centre is in front of the near plane are left out.
std::shared_ptr<passes::SceneView> lightScene(const Scene& scene, const RenderSettings& settings, const View& view,
                                              SceneViews& views) {
    const View light = lightView(settings, view);
    const auto seen = nextView(views);
    layout::ViewConstants& c = seen->constants;
    c = passes::viewConstants(light, light.width / 2.0, light.height / 2.0);
    const Clip& clip = settings.effects.clip;
    if (clip.near > -Clip::kNone) {
        const glm::dvec3 viewer = light.rotation * glm::transpose(view.rotation) * glm::dvec3(0, 0, 1);
        layout::setCutPlane(c, glm::vec4(viewer, -clip.near));
        seen->cut = true;
    }
    seen->buffers = &scene.buffers;
    // As the view does, so that nothing shades itself.
    passes::placeCopies(seen->copies, scene.representation, light, nullptr, 0, meshErrorOf(settings, view));
    // Translucent parts cast no shadow.
    passes::choose(seen->copies.triangles, scene.translucent, passes::Triangles::opaque);
    seen->impostor = settings.tuning.impostor;
    seen->radiusPixels = scene.meanRadius * light.pixelsPerAngstrom;
    return seen;
}

template <typename T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Whether a stream is another one in an order.
template <typename T>
bool isOrdered(const std::vector<T>& ordered, const std::vector<T>& stream, const std::vector<std::uint32_t>& order) {
    if (ordered.size() != stream.size() || order.size() != stream.size()) return false;
    for (std::size_t i = 0; i < order.size(); ++i)
        if (std::memcmp(&ordered[i], &stream[order[i]], sizeof(T)) != 0) return false;
    return true;
}

/// Whether a representation has the scene's shapes, each with its look. Not for assemblies, whose copies may differ.
bool hasShapesOf(const Scene& scene, const Representation& r) {
    const Representation& now = scene.representation;
    return r.copies.transforms.empty() && now.copies.transforms.empty() && r.radius == now.radius &&
           r.meshLooks.size() == now.meshLooks.size() && r.sphereLooks.size() == now.sphereLooks.size() &&
           r.cylinderLooks.size() == now.cylinderLooks.size() && r.wireLooks.size() == now.wireLooks.size() &&
           isOrdered(now.spheres, r.spheres, scene.order.spheres) &&
           isOrdered(now.cylinders, r.cylinders, scene.order.cylinders) && sameBytes(r.wires, now.wires) &&
           sameBytes(r.triangles, now.triangles) && sameBytes(r.coarseTriangles, now.coarseTriangles) &&
           sameBytes(r.meshVertices, now.meshVertices) && sameBytes(r.sphereModels, now.sphereModels) &&
           sameBytes(r.cylinderModels, now.cylinderModels) && sameBytes(r.triangleModels, now.triangleModels);
}

/// @param scene  with its representation, in order
void completeScene(const gpu::Device& device, Scene& scene) {
    fitBuffer(scene.representation, passes::mostShapeBytes(device.caps()));
    scene.translucent = translucentRuns(scene.representation);
    scene.solid = isSolid(scene.representation) && scene.translucent.empty();
    scene.chunks = chunksOf(scene.representation);
    scene.buffers = passes::makeSceneBuffers(device, scene.representation);
    double sum = 0;
    const auto smallest = [&](float radius) {
        scene.smallestRadius = std::min(scene.smallestRadius, static_cast<double>(radius));
    };
    for (const Sphere& s : scene.representation.spheres) {
        sum += s.radius;
        smallest(s.radius);
    }
    for (const Cylinder& c : scene.representation.cylinders) smallest(c.radius);
    for (const Cylinder& wire : scene.representation.wires)
        scene.thinnestWire = std::min(scene.thinnestWire, -static_cast<double>(wire.radius));
    scene.meanRadius = sum / static_cast<double>(std::max<std::size_t>(scene.representation.spheres.size(), 1));
}

}  // namespace

double meshErrorOf(const RenderSettings& settings, const View& view) {
    static_assert(RenderSettings::kEdgeSamples == 16);
    const bool edges = settings.supersample == RenderSettings::kEdges && settings.debug == DebugView::none;
    return errorInSpace(view, settings.meshError * (edges ? 0.25 : 1.0));
}

std::uint32_t shadowPixels(const RenderSettings& settings) {
    if (settings.effects.shadow.strength <= 0 || !settings.lighting) return 0;
    constexpr double kLarge = 80;  // Å
    return settings.view.radius > kLarge ? 2048 : 1024;
}

layout::EffectConstants effectConstants(const RenderSettings& settings, const Scene& scene) {
    const std::vector<std::uint32_t>& copyColors = scene.representation.copies.colors;
    const Effects& e = settings.effects;
    const View& view = settings.view;
    const double center = view.projection == Projection::perspective ? view.eyeDistance : view.radius;
    const bool automatic = e.fog.range == Fog::Range::automatic;
    // No fog in front of the centre.
    const double start = automatic ? 0.0 : e.fog.start, end = automatic ? view.radius : e.fog.end;
    const auto& [r, g, b, alpha] = settings.background;
    layout::EffectConstants c{};
    c.contour = linear(e.contours.color[0], e.contours.color[1], e.contours.color[2], 1);
    c.fog = alpha > 0 ? linear(r, g, b, e.fog.strength) : linear(1, 1, 1, e.fog.strength);
    c.fogStart = static_cast<float>(center + start);
    c.perFog = static_cast<float>(1.0 / std::max(end - start, 1e-6));
    constexpr double kHatchPixels = 7;
    c.hatch = static_cast<float>(kHatchPixels / view.pixelsPerAngstrom);
    static_assert(kMostCopyColors == layout::kMostCopyColors);
    static_assert(kResidueBits == layout::kResidueBits && kGroupResidues == layout::kGroupResidues);
    for (std::size_t i = 0; i < copyColors.size(); ++i) {
        const auto channel = [&](int shift) { return static_cast<float>(copyColors[i] >> shift & 0xff) / 255.0f; };
        c.copyColors[i] = linear(channel(0), channel(8), channel(16), 1);
    }
    addShadow(c, settings);
    const passes::Rims rims = rimsOf(settings);
    c.firstGroup = scene.buffers.firstGroup;
    c.halo = linear(e.halos.color[0], e.halos.color[1], e.halos.color[2], e.halos.strength);
    c.haloWidth = rims.halo;
    c.perHaloDepth = static_cast<float>(1.0 / e.halos.depth);
    c.lineWidth = rims.line;
    c.lineDepth = static_cast<float>(e.contours.depth);
    c.bakedCylinders = static_cast<std::uint32_t>(scene.representation.cylinders.size());
    return c;
}

Scene makeScene(const gpu::Device& device, Representation representation) {
    Scene scene{std::move(representation), {}, 0, 1e9, 1e9, {}, {}, {}, false};
    scene.order = orderInSpace(scene.representation);
    completeScene(device, scene);
    return scene;
}

Scene makeOrderedScene(const gpu::Device& device, Representation representation) {
    Scene scene{std::move(representation), {}, 0, 1e9, 1e9, {}, {}, {}, false};
    completeScene(device, scene);
    return scene;
}

bool recolor(Scene& scene, Representation& r) {
    Representation& now = scene.representation;
    if (scene.buffers.empty() || !hasShapesOf(scene, r)) return false;
    const TranslucentRuns translucent = translucentRuns(r);
    const auto asBefore = [](const TranslucentRun& a, const TranslucentRun& b) {
        return a.first == b.first && a.count == b.count && a.kind == b.kind;
    };
    // What is translucent hides no light.
    if (!std::equal(translucent.begin(), translucent.end(), scene.translucent.begin(), scene.translucent.end(),
                    asBefore))
        return false;
    putInOrder(r, scene.order);
    // The shapes stay where they are: a running bake may read them. The meshes have the levels that a buffer holds.
    r.spheres = std::move(now.spheres), r.cylinders = std::move(now.cylinders), r.wires = std::move(now.wires);
    r.triangles = std::move(now.triangles), r.coarseTriangles = std::move(now.coarseTriangles);
    r.meshVertices = std::move(now.meshVertices), r.meshes = std::move(now.meshes);
    now = std::move(r);
    passes::putLooks(scene.buffers, now);
    return true;
}

bool isMoved(const Scene& scene, const Representation& r) {
    const Representation& before = scene.representation;
    return r.copies.transforms.empty() && before.copies.transforms.empty() &&
           r.spheres.size() == before.spheres.size() && r.cylinders.size() == before.cylinders.size() &&
           r.wires.size() == before.wires.size() && r.triangles.size() == before.triangles.size() &&
           r.meshVertices.size() == before.meshVertices.size() && r.sphereModels.size() == before.sphereModels.size();
}

Scene makeMovedScene(const gpu::Device& device, Representation representation, const Scene& before) {
    Scene scene{std::move(representation), {}, 0, 1e9, 1e9, {}, {}, before.order, false};
    putInOrder(scene.representation, scene.order);
    completeScene(device, scene);
    return scene;
}

graph::Extent imageExtent(const View& view) {
    return view.quarterTurns % 2 ? graph::Extent{view.height, view.width} : graph::Extent{view.width, view.height};
}

std::shared_ptr<passes::SceneView> nextView(SceneViews& views) {
    const std::shared_ptr<passes::SceneView>& view = views.free();
    view->clear();
    return view;
}

std::shared_ptr<passes::SceneView> viewScene(const Scene& scene, const RenderSettings& settings, const View& view,
                                             const passes::Atlas& atlas, SceneViews& views) {
    const auto seen = nextView(views);
    const graph::Extent image = imageExtent(view);
    layout::ViewConstants& c = seen->constants;
    c = passes::viewConstants(view, image.width / 2.0, image.height / 2.0);
    c.spheres = scene.buffers.sphereCount;
    c.cylinders = scene.buffers.cylinderCount;
    c.primitives = scene.buffers.primitives();
    if (atlas.image) addAtlas(c, atlas);
    seen->occlusionCells = atlas.cells;
    seen->atlasOwner = atlas.owner;
    addEffects(c, settings, view);
    seen->lighting = settings.lighting;
    seen->occlusion = settings.occlusion.directions > 0;
    seen->effects = settings.effects;
    seen->rims = rimsOf(settings);
    seen->copyColors = static_cast<int>(scene.representation.copies.colors.size());
    seen->blendsColors = scene.representation.blendsColors;
    if (shadowPixels(settings) > 0) seen->light = lightScene(scene, settings, view, views);
    seen->buffers = &scene.buffers;
    constexpr double kWidestWire = 10;  // pixels
    const double wires = scene.representation.wires.empty() ? 0 : kWidestWire;
    passes::placeCopies(seen->copies, scene.representation, view, settings.tuning.cull ? &scene.chunks : nullptr,
                        wires + std::max(settings.effects.contours.width, settings.effects.halos.width) *
                                    view.pixelsPerAngstrom / settings.view.pixelsPerAngstrom,
                        meshErrorOf(settings, view), true);
    seen->perspective = view.projection == Projection::perspective;
    // Where a surface folds, its inner side may look out. Nothing else of it does.
    seen->frontsOnly = scene.solid && !settings.effects.clip.on() && settings.effects.contours.width <= 0 &&
                       !seen->rims.any() && (!seen->perspective || view.eyeDistance > view.radius);
    seen->quarterTurns = view.quarterTurns;
    seen->plates = settings.tuning.plates;
    seen->impostor = settings.tuning.impostor;
    seen->radiusPixels = scene.meanRadius * view.pixelsPerAngstrom;
    const double farthest = seen->perspective ? view.eyeDistance / (view.eyeDistance + view.radius) : 1;
    seen->smallestPixels = scene.smallestRadius * view.pixelsPerAngstrom * farthest;
    seen->wireScale = 0;
    if (!scene.representation.wires.empty()) {
        seen->wireScale = static_cast<float>(view.pixelsPerAngstrom / settings.view.pixelsPerAngstrom);
        c.wirePixel = static_cast<float>(1 / settings.view.pixelsPerAngstrom);
        seen->smallestPixels =
            std::min(seen->smallestPixels, scene.thinnestWire * static_cast<double>(seen->wireScale));
    }
    const Contours& contours = settings.effects.contours;
    if (contours.width > 0) seen->smallestPixels = std::min(seen->smallestPixels, 0.75 * contours.width);
    return seen;
}

}  // namespace nacre
