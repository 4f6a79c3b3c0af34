#include "engine/frame/scene.h"

#include <algorithm>
#include <cstring>
#include <glm/geometric.hpp>

#include "engine/frame/effects/halos/halos.h"
#include "engine/frame/effects/outlines/outlines.h"
#include "engine/frame/effects/shadow/shadow.h"
#include "engine/frame/picture.h"
#include "engine/passes/view_constants.h"
#include "engine/scene/build/atom_groups.h"
#include "engine/scene/build/mesh_caps.h"
#include "engine/scene/instances/mesh_levels.h"

namespace nacre {
namespace {

void addAtlas(layout::ViewConstants& c, const passes::Atlas& atlas) {
    c.atlasTexel = glm::vec2(1.0 / atlas.image->desc.extent.width, 1.0 / atlas.image->desc.extent.height);
    c.patchTexels = atlas.sphereEdge | atlas.around << 8 | atlas.along << 16 | atlas.least << 24;
    c.patchesInRow = atlas.spherePatches | atlas.cylinderPatches << 16;
}

/// Clipping planes and outlines, in the units of the passes.
void addEffects(layout::ViewConstants& c, const RenderSettings& settings, const View& view) {
    const Effects& e = settings.effects;
    const double center = view.projection == Projection::perspective ? view.eyeDistance : view.radius;  // its Z
    c.clipNear = static_cast<float>(std::max<double>(center + e.clip.near, -layout::kNoPlane));
    c.clipFar = static_cast<float>(std::min<double>(center + e.clip.far, layout::kNoPlane));
    addOutlines(c, settings);
}

template <typename T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Whether `ordered` is the stream in this order.
template <typename T>
bool isOrdered(const std::vector<T>& ordered, const std::vector<T>& stream, const std::vector<std::uint32_t>& order) {
    if (ordered.size() != stream.size() || order.size() != stream.size()) return false;
    for (std::size_t i = 0; i < order.size(); ++i)
        if (std::memcmp(&ordered[i], &stream[order[i]], sizeof(T)) != 0) return false;
    return true;
}

/// @param now  in order
bool hasSameEllipsoids(const Representation& now, const Representation& r, const std::vector<std::uint32_t>& order) {
    std::vector<EllipsoidRows> rows = r.ellipsoids;
    if (!rows.empty()) rows.resize(r.spheres.size());
    if (rows.empty()) return now.ellipsoids.empty();
    return now.cutsOctants == r.cutsOctants && isOrdered(now.ellipsoids, rows, order);
}

/// Whether a representation has the scene's shapes in its order. Not for assemblies, whose copies may differ.
bool hasSameShapes(const Scene& scene, const Representation& r) {
    const Representation& now = scene.representation;
    return r.copies.transforms.empty() && now.copies.transforms.empty() && r.radius == now.radius &&
           r.meshLooks.size() == now.meshLooks.size() && r.sphereLooks.size() == now.sphereLooks.size() &&
           r.cylinderLooks.size() == now.cylinderLooks.size() && r.wireLooks.size() == now.wireLooks.size() &&
           isOrdered(now.spheres, r.spheres, scene.order.spheres) && hasSameEllipsoids(now, r, scene.order.spheres) &&
           isOrdered(now.cylinders, r.cylinders, scene.order.cylinders) && sameBytes(r.wires, now.wires) &&
           sameBytes(r.triangles, now.triangles) && sameBytes(r.coarseTriangles, now.coarseTriangles) &&
           sameBytes(r.meshVertices, now.meshVertices) && sameBytes(r.sphereModels, now.sphereModels) &&
           sameBytes(r.cylinderModels, now.cylinderModels) && sameBytes(r.triangleModels, now.triangleModels);
}

/// Whether the same primitives are opaque in the scene and in a representation with its shapes.
bool hasSameOpacities(const Scene& scene, const Representation& r) {
    const Representation& now = scene.representation;
    const auto same = [](const auto& looks, const auto& others, const std::vector<std::uint32_t>& order) {
        for (std::size_t i = 0; i < order.size(); ++i)
            if (classifyTranslucency(looks[i]) != classifyTranslucency(others[order[i]])) return false;
        return true;
    };
    return same(now.sphereLooks, r.sphereLooks, scene.order.spheres) &&
           same(now.cylinderLooks, r.cylinderLooks, scene.order.cylinders) &&
           translucentParts(r).triangles == scene.translucent.triangles;
}

/// @param scene  with its representation, in order
void completeScene(const gpu::Device& device, Scene& scene) {
    fitBuffer(scene.representation, passes::mostShapeBytes(device.caps()));
    scene.translucent = translucentParts(scene.representation);
    scene.solid = isSolid(scene.representation) && scene.translucent.empty();
    scene.layersPerLength = layersPerLength(scene.representation, scene.translucent);
    scene.chunks = makeChunks(scene.representation);
    scene.buffers = passes::makeSceneBuffers(device, scene.representation);
    scene.sizes = measureSizes(scene.representation);
}

}  // namespace

SceneSizes measureSizes(const Representation& r) {
    SceneSizes sizes;
    double sum = 0;
    const auto smallest = [&](float radius) {
        sizes.smallestRadius = std::min(sizes.smallestRadius, static_cast<double>(radius));
    };
    for (std::size_t i = 0; i < r.spheres.size(); ++i) {
        sum += r.spheres[i].radius;
        const EllipsoidRows* rows = r.ellipsoid(i);
        smallest(rows ? rows->inner() : r.spheres[i].radius);
    }
    for (const Cylinder& c : r.cylinders) smallest(c.radius);
    for (const Cylinder& wire : r.wires)
        sizes.thinnestWire = std::min(sizes.thinnestWire, -static_cast<double>(wire.radius));
    sizes.meanRadius = sum / static_cast<double>(std::max<std::size_t>(r.spheres.size(), 1));
    return sizes;
}

SceneFacts collectFacts(const Representation& r, const Chunks& chunks, const TranslucentParts& translucent) {
    SceneFacts facts;
    facts.hasCylinders = !r.cylinders.empty();
    facts.hasWires = !r.wires.empty();
    facts.hasTranslucent = !translucent.empty();
    facts.hasTranslucentAtoms = translucent.hasAtoms();
    facts.meshTriangles = r.triangles.size();
    facts.boxed = chunks.finiteSpheres();
    facts.hasVolume = r.volume != nullptr;
    facts.hasEllipsoids = !r.ellipsoids.empty();
    return facts;
}

double cullingMargin(const RenderSettings& settings, const View& view, bool wires) {
    constexpr double kWidestWire = 10;  // pixels
    return (wires ? kWidestWire : 0) + std::max(settings.effects.contours.width, settings.effects.halos.width) *
                                           view.pixelsPerAngstrom / settings.view.pixelsPerAngstrom;
}

double smallestPixels(const SceneSizes& sizes, bool wires, const RenderSettings& settings, const View& view) {
    const double farthest =
        view.projection == Projection::perspective ? view.eyeDistance / (view.eyeDistance + view.radius) : 1;
    double smallest = sizes.smallestRadius * view.pixelsPerAngstrom * farthest;
    if (wires)
        smallest =
            std::min(smallest, sizes.thinnestWire * static_cast<double>(static_cast<float>(
                                                        view.pixelsPerAngstrom / settings.view.pixelsPerAngstrom)));
    const Contours& outlines = settings.effects.contours;
    return outlines.width > 0 ? std::min(smallest, 0.75 * outlines.width) : smallest;
}

double computeMeshError(const RenderSettings& settings, const View& view) {
    static_assert(RenderSettings::kEdgeSamples == 16);
    return errorInSpace(view, settings.meshError * (wantsEdges(settings) ? 0.25 : 1.0));
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
    c.fog = alpha > 0 ? linearColor({r, g, b}, e.fog.strength) : linearColor({1, 1, 1}, e.fog.strength);
    c.fogStart = static_cast<float>(center + start);
    c.perFog = static_cast<float>(1.0 / std::max(end - start, 1e-6));
    constexpr double kHatchPixels = 7;
    c.hatch = static_cast<float>(kHatchPixels / view.pixelsPerAngstrom);
    static_assert(kMostCopyColors == layout::kMostCopyColors);
    static_assert(kResidueBits == layout::kResidueBits && kGroupResidues == layout::kGroupResidues);
    for (std::size_t i = 0; i < copyColors.size(); ++i) {
        const auto channel = [&](int shift) { return static_cast<float>(copyColors[i] >> shift & 0xff) / 255.0f; };
        c.copyColors[i] = linearColor({channel(0), channel(8), channel(16)}, 1);
    }
    c.capColor = packedCapColor(e.clip);
    c.layersPerLength = static_cast<float>(scene.layersPerLength);
    addShadow(c, settings);
    addOutlines(c, settings);
    addHalos(c, settings);
    c.firstGroup = scene.buffers.firstGroup;
    c.bakedCylinders = static_cast<std::uint32_t>(scene.representation.cylinders.size());
    return c;
}

Scene makeScene(const gpu::Device& device, Representation representation) {
    Scene scene{std::move(representation), {}, {}, {}, {}, {}, false, 0};
    scene.order = orderInSpace(scene.representation);
    completeScene(device, scene);
    return scene;
}

Scene makeOrderedScene(const gpu::Device& device, Representation representation) {
    Scene scene{std::move(representation), {}, {}, {}, {}, {}, false, 0};
    completeScene(device, scene);
    return scene;
}

bool recolor(Scene& scene, Representation& r) {
    Representation& now = scene.representation;
    if (scene.buffers.empty() || !hasSameShapes(scene, r)) return false;
    // Translucent primitives do not occlude: if others become translucent, the bake is outdated.
    if (!hasSameOpacities(scene, r)) return false;
    putInOrder(r, scene.order);
    // The shapes stay where they are: a running bake may read them. The meshes keep the levels that fit a buffer.
    r.ellipsoids = std::move(now.ellipsoids);
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
    Scene scene{std::move(representation), {}, {}, {}, {}, before.order, false, 0};
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
    if (view.other) {
        const glm::vec2 axis = passes::viewConstants(otherView(view), image.width / 2.0, image.height / 2.0).axisPixel;
        seen->otherAxis = view.quarterTurns % 2 ? axis.y : axis.x;
    }
    c.spheres = scene.buffers.sphereCount;
    c.cylinders = scene.buffers.cylinderCount;
    c.primitives = scene.buffers.primitives();
    if (atlas.image) addAtlas(c, atlas);
    seen->occlusionCells = atlas.cells;
    seen->atlasOwner = atlas.owner;
    seen->bounced = atlas.bounced;
    seen->interpolates = atlas.interpolates;
    addEffects(c, settings, view);
    seen->lighting = settings.lighting;
    seen->occlusion = settings.occlusion.directions > 0;
    seen->effects = settings.effects;
    seen->rims = makeRims(settings);
    seen->copyColors = static_cast<int>(scene.representation.copies.colors.size());
    seen->blendsColors = scene.representation.blendsColors;
    seen->ownMaterials = scene.representation.ownMaterials;
    if (shadowPixels(settings) > 0) seen->light = lightScene(scene, settings, view, views);
    seen->buffers = &scene.buffers;
    seen->octants = 2;
    const glm::dvec3 shift = view.seen(glm::dvec3(0));
    for (int i = 0; i < 3; ++i)
        seen->still[static_cast<std::size_t>(i)] =
            glm::vec4(view.rotation[0][i], view.rotation[1][i], view.rotation[2][i], shift[i]);
    const bool wires = !scene.representation.wires.empty();
    passes::placeCopies(seen->copies, scene.representation, view, settings.tuning.cull ? &scene.chunks : nullptr,
                        cullingMargin(settings, view, wires), computeMeshError(settings, view), true);
    seen->perspective = view.projection == Projection::perspective;
    // The inside of a closed surface is visible only through a cut, an outline or from inside.
    seen->frontsOnly = scene.solid && !settings.effects.clip.on() && settings.effects.contours.width <= 0 &&
                       !seen->rims.any() && (!seen->perspective || view.eyeDistance > view.radius);
    seen->quarterTurns = view.quarterTurns;
    seen->plates = settings.tuning.plates;
    seen->impostor = settings.tuning.impostor;
    seen->radiusPixels = scene.sizes.meanRadius * view.pixelsPerAngstrom;
    seen->smallestPixels = smallestPixels(scene.sizes, wires, settings, view);
    seen->wireScale = 0;
    if (wires) {
        seen->wireScale = static_cast<float>(view.pixelsPerAngstrom / settings.view.pixelsPerAngstrom);
        c.wirePixel = static_cast<float>(1 / settings.view.pixelsPerAngstrom);
    }
    return seen;
}

}  // namespace nacre
