#include "engine/frame/scene.h"

#include <algorithm>

#include "engine/passes/view_constants.h"

namespace nacre {
namespace {

void addAtlas(layout::ViewConstants& c, const passes::Atlas& atlas) {
    c.atlasTexel = glm::vec2(1.0 / atlas.image->desc.extent.width, 1.0 / atlas.image->desc.extent.height);
    c.patchTexels = atlas.sphereEdge | atlas.around << 8 | atlas.along << 16;
    c.spherePatches = atlas.spherePatches;
    c.cylinderPatches = atlas.cylinderPatches;
    c.occlusion = 1;
}

}  // namespace

Scene makeScene(const gpu::Device& device, Representation representation) {
    Scene scene{std::move(representation), {}, 0};
    scene.buffers = passes::makeSceneBuffers(device, scene.representation);
    double sum = 0;
    for (const Sphere& s : scene.representation.spheres) sum += s.radius;
    scene.meanRadius = sum / static_cast<double>(std::max<std::size_t>(scene.representation.spheres.size(), 1));
    return scene;
}

graph::Extent imageExtent(const View& view) {
    return view.quarterTurns % 2 ? graph::Extent{view.height, view.width} : graph::Extent{view.width, view.height};
}

std::shared_ptr<passes::SceneView> viewScene(const gpu::Device& device, const Scene& scene,
                                             const RenderSettings& settings, const View& view,
                                             const passes::Atlas& atlas, Visibility path) {
    auto seen = std::make_shared<passes::SceneView>();
    const graph::Extent image = imageExtent(view);
    layout::ViewConstants& c = seen->constants;
    c = passes::viewConstants(view, device.caps().snapPixels, image.width / 2.0, image.height / 2.0);
    c.lighting = settings.lighting ? 1 : 0;
    c.spheres = scene.buffers.sphereCount;
    c.primitives = scene.buffers.sphereCount + scene.buffers.cylinderCount;
    c.wholeImage = 1;
    if (atlas.image) addAtlas(c, atlas);
    seen->buffers = &scene.buffers;
    seen->copies = passes::placeCopies(scene.representation, view);
    if (path == Visibility::deferred)
        seen->copyRows = gpu::makeBuffer(device, std::span(std::as_const(seen->copies.rows)),
                                         vk::BufferUsageFlagBits::eStorageBuffer, "copies");
    seen->perspective = view.projection == Projection::perspective;
    seen->quarterTurns = view.quarterTurns;
    seen->plates = settings.tuning.plates;
    seen->impostor = settings.tuning.impostor;
    seen->radiusPixels = scene.meanRadius * view.pixelsPerAngstrom;
    return seen;
}

}  // namespace nacre
