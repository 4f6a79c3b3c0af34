#include "engine/passes/scene_buffers.h"

#include <array>
#include <cstring>

namespace nacre::passes {

namespace {

constexpr auto kUsage = vk::BufferUsageFlagBits::eVertexBuffer | vk::BufferUsageFlagBits::eStorageBuffer |
                        vk::BufferUsageFlagBits::eUniformTexelBuffer;

/// A buffer of two streams, the second behind the first.
template <typename A, typename B>
gpu::Buffer joined(const gpu::Device& device, const std::vector<A>& first, const std::vector<B>& second,
                   const std::string& name) {
    const std::size_t bytes = first.size() * sizeof(A), more = second.size() * sizeof(B);
    gpu::Buffer buffer = gpu::makeBuffer(device, bytes + more, kUsage, gpu::Access::upload, name);
    if (bytes) std::memcpy(buffer.mapped, first.data(), bytes);
    if (more) std::memcpy(buffer.mapped + bytes, second.data(), more);
    return buffer;
}

std::array<std::uint16_t, kPyramidIndices> pyramidIndices() {
    std::array<std::uint16_t, kPyramidIndices> indices{};
    for (std::uint16_t facet = 0; facet < 8; ++facet) {
        indices[3 * facet + 1] = static_cast<std::uint16_t>(facet + 1);
        indices[3 * facet + 2] = static_cast<std::uint16_t>((facet + 1) % 8 + 1);
    }
    return indices;
}

}  // namespace

SceneBuffers makeSceneBuffers(const gpu::Device& device, const Representation& r) {
    SceneBuffers scene;
    scene.sphereCount = static_cast<std::uint32_t>(r.spheres.size());
    scene.cylinderCount = static_cast<std::uint32_t>(r.cylinders.size());
    if (scene.empty()) return scene;
    scene.cylinderOffset = r.spheres.size() * sizeof(Sphere);
    scene.cylinderLookOffset = r.spheres.size() * sizeof(SphereLook);
    scene.shapes = joined(device, r.spheres, r.cylinders, "stream A: shapes");
    scene.looks = joined(device, r.sphereLooks, r.cylinderLooks, "stream B: looks");
    const auto indices = pyramidIndices();
    scene.pyramid = gpu::makeBuffer(device, std::span<const std::uint16_t>(indices),
                                    vk::BufferUsageFlagBits::eIndexBuffer, "pyramid indices");
    if (device.caps().tiles.texels) {
        constexpr auto kShape = vk::Format::eR32G32B32A32Sfloat, kLook = vk::Format::eR32Uint;
        scene.shapeTexels = gpu::makeTexelView(device, scene.shapes, kShape, "stream A: shapes");
        scene.lookTexels = gpu::makeTexelView(device, scene.looks, kLook, "stream B: looks");
    }
    return scene;
}

}  // namespace nacre::passes
