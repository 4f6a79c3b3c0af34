#include "engine/passes/scene_buffers.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <glm/geometric.hpp>

#include "engine/error.h"
#include "engine/passes/corners.h"
#include "engine/scene/color/colors.h"
#include "engine/scene/instances/mesh_levels.h"

namespace nacre::passes {

namespace {

constexpr auto kUsage = vk::BufferUsageFlagBits::eVertexBuffer | vk::BufferUsageFlagBits::eStorageBuffer |
                        vk::BufferUsageFlagBits::eUniformTexelBuffer;

/// Writes streams back to back.
template <typename... Streams>
void put(const gpu::Buffer& buffer, const Streams&... streams) {
    std::byte* at = buffer.mapped;
    const auto one = [&](const auto& stream) {
        const std::size_t bytes = stream.size() * sizeof(stream[0]);
        if (bytes > 0) std::memcpy(at, stream.data(), bytes);
        at += bytes;
    };
    (one(streams), ...);
}

/// A buffer of streams, back to back.
template <typename... Streams>
gpu::Buffer joined(const gpu::Device& device, const std::string& name, const Streams&... streams) {
    const auto countBytes = [](const auto& stream) { return stream.size() * sizeof(stream[0]); };
    gpu::Buffer buffer = gpu::makeBuffer(device, (countBytes(streams) + ...), kUsage, gpu::Access::upload, name);
    put(buffer, streams...);
    return buffer;
}

void checkFits(const gpu::Device& device, const Representation& r) {
    const std::uint64_t most = mostShapeBytes(device.caps()), bytes = shapeBytes(r);
    if (bytes <= most) return;
    throw Error("too much for this device", device.caps().deviceName,
                "the shapes take " + std::to_string((bytes >> 20) + 1) + " MB, and its shaders read " +
                    std::to_string(most >> 20) +
                    " MB at most (draw fewer atoms, or a surface with a coarser --surface-resolution)");
}

std::size_t countCylinders(const Representation& r) { return r.cylinders.size() + r.wires.size(); }

/// Cylinders in device form, followed by wires. Adds 1 / length, Å, to save each pixel a division.
std::vector<Cylinder> placedCylinders(const Representation& r) {
    std::vector<Cylinder> cylinders = r.cylinders;
    cylinders.insert(cylinders.end(), r.wires.begin(), r.wires.end());
    for (Cylinder& c : cylinders) c.perLength = 1.0f / std::max(glm::distance(c.a, c.b), 1e-12f);
    return cylinders;
}

/// Triangles and vertices in device form: their indices are places in the joined streams.
std::vector<Triangle> placedTriangles(const Representation& r) {
    std::vector<Triangle> triangles = r.triangles;
    triangles.insert(triangles.end(), r.coarseTriangles.begin(), r.coarseTriangles.end());
    const auto first = static_cast<std::uint32_t>(r.spheres.size() + 2 * countCylinders(r) + triangles.size());
    for (Triangle& t : triangles) t.a += first, t.b += first, t.c += first;
    return triangles;
}
std::vector<MeshVertex> placedVertices(const Representation& r) {
    const auto first = static_cast<std::uint32_t>(2 * r.spheres.size() + 4 * countCylinders(r));
    std::vector<MeshVertex> vertices = r.meshVertices;
    for (MeshVertex& v : vertices) v.look = first + 2 * v.look;
    return vertices;
}

/// Rows of all spheres, where some are ellipsoids.
std::vector<EllipsoidRows> placedEllipsoids(const Representation& r) {
    std::vector<EllipsoidRows> rows = r.ellipsoids;
    if (rows.empty()) return rows;
    rows.resize(r.spheres.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!rows[i].any()) rows[i] = sphereRows(r.spheres[i].radius);
    return rows;
}

/// Linear values of sRGB bytes: linearFromSrgb() of shaders/common/srgb.glsl in lavapipe's steps, for equal bits. GPUs
/// that fuse products and sums may differ in the last bit.
std::array<float, 256> linearBytes() {
    std::array<float, 256> linear;
    for (std::size_t i = 0; i < linear.size(); ++i) {
        const float c = static_cast<float>(i) * (1.0f / 255.0f);
        float curve = -0.116626214f;
        for (const float next :
             {0.401858704f, -0.618510216f, 0.805984839f, 0.491395899f, 0.0350388936f, 0.000858094134f}) {
            const float product = curve * c;
            curve = product + next;
        }
        linear[i] = c > 0.04045f ? curve : c * static_cast<float>(1.0 / 12.92);
    }
    return linear;
}

std::vector<glm::vec4> makeBalls(const Representation& r) {
    static const std::array<float, 256> linear = linearBytes();
    std::vector<glm::vec4> balls;
    balls.reserve(r.spheres.size());
    for (std::size_t i = 0; i < r.spheres.size(); ++i) {
        const std::uint32_t color = r.sphereLooks[i].color;
        const float radius = r.spheres[i].radius;
        const bool tint = isCopyTint(color);
        const float own = r.ownMaterials && color >> 25 < kMaterials ? 2 * static_cast<float>((color >> 25) + 1) : 0;
        balls.emplace_back(linear[color & 0xffu] + own, linear[color >> 8 & 0xffu], linear[color >> 16 & 0xffu],
                           tint ? -radius : radius);
    }
    return balls;
}

/// Groups of the atoms of looks, in the order of the looks.
std::vector<std::uint32_t> listGroups(const Representation& r) {
    std::vector<std::uint32_t> groups;
    groups.reserve(r.spheres.size() + 2 * countCylinders(r) + r.meshLooks.size());
    const auto add = [&](std::uint32_t atom) {
        groups.push_back(atom > 0 && atom <= r.atomGroups.size() ? r.atomGroups[atom - 1] : 0);
    };
    for (const SphereLook& look : r.sphereLooks) add(look.atom);
    for (const auto* looks : {&r.cylinderLooks, &r.wireLooks})
        for (const CylinderLook& look : *looks) add(look.atomA), add(look.atomB);
    for (const SphereLook& look : r.meshLooks) add(look.atom);
    return groups;
}

}  // namespace

std::uint64_t mostShapeBytes(const gpu::Caps& caps) {
    return std::min(caps.maxBufferBytes,
                    caps.maxStorageBufferBytes * (caps.tiles.texels ? sizeof(glm::uvec4) / sizeof(std::uint32_t) : 1));
}

void putLooks(SceneBuffers& scene, const Representation& r) {
    put(scene.looks, r.sphereLooks, r.cylinderLooks, r.wireLooks, r.meshLooks, listGroups(r));
    if (scene.balls.mapped) put(scene.balls, makeBalls(r));
}

SceneBuffers makeSceneBuffers(const gpu::Device& device, const Representation& r) {
    SceneBuffers scene;
    scene.sphereCount = static_cast<std::uint32_t>(r.spheres.size());
    scene.cylinderCount = static_cast<std::uint32_t>(countCylinders(r));
    scene.triangleCount = static_cast<std::uint32_t>(r.triangles.size() + r.coarseTriangles.size());
    if (scene.empty()) return scene;
    checkFits(device, r);
    scene.cylinderOffset = r.spheres.size() * sizeof(Sphere);
    scene.cylinderLookOffset = r.spheres.size() * sizeof(SphereLook);
    const std::vector<EllipsoidRows> ellipsoids = placedEllipsoids(r);
    if (!ellipsoids.empty()) scene.ellipsoidOffset = shapeBytes(r) - ellipsoids.size() * sizeof(EllipsoidRows);
    scene.cutsOctants = r.cutsOctants;
    scene.shapes = joined(device, "stream A: shapes", r.spheres, placedCylinders(r), placedTriangles(r),
                          placedVertices(r), ellipsoids);
    scene.looks =
        joined(device, "stream B: looks", r.sphereLooks, r.cylinderLooks, r.wireLooks, r.meshLooks, listGroups(r));
    if (device.caps().plan.geometry.storesVaryings && !r.spheres.empty())
        scene.balls = joined(device, "stream C: spheres' linear colours", makeBalls(r));
    scene.firstGroup =
        static_cast<std::uint32_t>(2 * r.spheres.size() + 4 * countCylinders(r) + 2 * r.meshLooks.size());
    const auto corners = cornerStream();
    scene.corners =
        gpu::makeBuffer(device, std::span<const glm::vec3>(corners), vk::BufferUsageFlagBits::eVertexBuffer, "corners");
    const auto indices = pyramidIndices();
    scene.pyramid = gpu::makeBuffer(device, std::span<const std::uint16_t>(indices),
                                    vk::BufferUsageFlagBits::eIndexBuffer, "pyramid indices");
    if (device.caps().tiles.texels) {
        constexpr auto kShape = vk::Format::eR32G32B32A32Uint, kLook = vk::Format::eR32Uint;
        scene.shapeTexels = gpu::makeTexelView(device, scene.shapes, kShape, "stream A: shapes");
        scene.lookTexels = gpu::makeTexelView(device, scene.looks, kLook, "stream B: looks");
    }
    return scene;
}

}  // namespace nacre::passes
