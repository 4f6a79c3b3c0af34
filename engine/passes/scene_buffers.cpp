#include "engine/passes/scene_buffers.h"

#include <cstring>

namespace nacre::passes {

SceneBuffers makeSceneBuffers(const gpu::Device& device, const Representation& r) {
    using Usage = vk::BufferUsageFlagBits;
    SceneBuffers scene;
    scene.sphereCount = static_cast<std::uint32_t>(r.spheres.size());
    scene.cylinderCount = static_cast<std::uint32_t>(r.cylinders.size());
    const std::size_t sphereBytes = r.spheres.size() * sizeof(Sphere);
    const std::size_t cylinderBytes = r.cylinders.size() * sizeof(Cylinder);
    scene.cylinderOffset = sphereBytes;
    scene.shapes = gpu::makeBuffer(device, sphereBytes + cylinderBytes, Usage::eVertexBuffer | Usage::eStorageBuffer,
                                   gpu::Access::upload, "stream A: shapes");
    if (sphereBytes) std::memcpy(scene.shapes.mapped, r.spheres.data(), sphereBytes);
    if (cylinderBytes) std::memcpy(scene.shapes.mapped + sphereBytes, r.cylinders.data(), cylinderBytes);
    scene.sphereLooks = gpu::makeBuffer(device, std::span(r.sphereLooks), Usage::eVertexBuffer | Usage::eStorageBuffer,
                                        "stream B: sphere looks");
    scene.cylinderLooks = gpu::makeBuffer(device, std::span(r.cylinderLooks),
                                          Usage::eVertexBuffer | Usage::eStorageBuffer, "stream B: cylinder looks");
    return scene;
}

}  // namespace nacre::passes
