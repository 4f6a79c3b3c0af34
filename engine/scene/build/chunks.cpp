#include "engine/scene/build/chunks.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/scene/build/translucency.h"

namespace nacre {
namespace {

constexpr float kLargestFloat = std::numeric_limits<float>::max();

/// A ball about a primitive.
Chunk boundingBall(const Sphere& s) { return {s.center, s.radius}; }
Chunk boundingBall(const Cylinder& c) {
    const glm::vec3 half = (c.b - c.a) * 0.5f;
    return {c.a + half, std::sqrt(glm::dot(half, half) + c.radius * c.radius)};
}

/// A ball about a triangle.
class BallOfTriangle {
public:
    explicit BallOfTriangle(const Representation& r) : vertices_(r.meshVertices) {}
    Chunk operator()(const Triangle& t) const {
        const glm::vec3 a = decodePosition(vertices_[t.a], t.step()), b = decodePosition(vertices_[t.b], t.step()),
                        c = decodePosition(vertices_[t.c], t.step());
        const glm::vec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
        return {(low + high) * 0.5f, glm::length(high - low) * 0.5f};
    }

private:
    const std::vector<MeshVertex>& vertices_;
};

/// @param boundingBall  returns the ball of a primitive by index
template <typename BoundingBall>
std::vector<Chunk> chunksOfStream(std::size_t count, const BoundingBall& boundingBall) {
    std::vector<Chunk> chunks;
    chunks.reserve(count / Chunk::kPrimitives + 1);
    for (std::size_t first = 0; first < count; first += Chunk::kPrimitives) {
        const std::size_t end = std::min<std::size_t>(first + Chunk::kPrimitives, count);
        glm::vec3 low(kLargestFloat), high(-kLargestFloat);
        for (std::size_t i = first; i < end; ++i) {
            const glm::vec3 center = boundingBall(i).center;
            low = glm::min(low, center);
            high = glm::max(high, center);
        }
        Chunk chunk{low * 0.5f + high * 0.5f, 0};
        for (std::size_t i = first; i < end; ++i) {
            const Chunk ball = boundingBall(i);
            const float reach = glm::length(ball.center - chunk.center) + ball.radius;
            chunk.radius = std::isfinite(reach) ? std::max(chunk.radius, reach * 1.00001f) : kLargestFloat;
        }
        if (!std::isfinite(chunk.center.x + chunk.center.y + chunk.center.z)) chunk = {{}, kLargestFloat};
        chunks.push_back(chunk);
    }
    return chunks;
}

/// Spreads the lower ten bits, with two zeros between them.
std::uint32_t spread(std::uint32_t bits) {
    bits = (bits | bits << 16) & 0x030000ffu;
    bits = (bits | bits << 8) & 0x0300f00fu;
    bits = (bits | bits << 4) & 0x030c30c3u;
    return (bits | bits << 2) & 0x09249249u;
}

/// Indices of a stream's primitives in their new order; runs stay separate.
template <typename Primitive, typename Look>
std::vector<std::uint32_t> mortonOrder(const std::vector<Primitive>& stream, const std::vector<Look>& looks,
                                       const std::vector<std::uint32_t>& starts) {
    glm::vec3 low(kLargestFloat), high(-kLargestFloat);
    for (const Primitive& p : stream) {
        const glm::vec3 center = boundingBall(p).center;
        low = glm::min(low, center);
        high = glm::max(high, center);
    }
    const float side = std::max({high.x - low.x, high.y - low.y, high.z - low.z, 1e-3f});
    std::vector<std::uint64_t> keys(stream.size());  // code, number
    for (std::uint32_t i = 0; i < stream.size(); ++i) {
        const glm::vec3 at = (boundingBall(stream[i]).center - low) / side * 1023.0f;
        // Translucent ones last, so that each class is one run.
        std::uint32_t code = static_cast<std::uint32_t>(classifyTranslucency(looks[i])) << 30;
        for (int axis = 0; axis < 3; ++axis)
            code |= spread(at[axis] > 0 ? static_cast<std::uint32_t>(std::min(at[axis], 1023.0f)) : 0) << axis;
        keys[i] = std::uint64_t{code} << 32 | i;
    }
    for (std::size_t run = 0; run + 1 < starts.size(); ++run)
        std::sort(keys.begin() + starts[run], keys.begin() + starts[run + 1]);
    std::vector<std::uint32_t> order(stream.size());
    std::transform(keys.begin(), keys.end(), order.begin(),
                   [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
    return order;
}

template <typename T>
void reorder(std::vector<T>& stream, const std::vector<std::uint32_t>& order) {
    std::vector<T> sorted(stream.size());
    for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = stream[order[i]];
    stream = std::move(sorted);
}

}  // namespace

bool Chunks::finiteSpheres() const {
    return std::ranges::all_of(spheres, [](const Chunk& c) { return c.radius < kLargestFloat; });
}

Chunks makeChunks(const Representation& r) {
    const BallOfTriangle ballOfTriangle(r);
    return {
        chunksOfStream(r.spheres.size(), [&](std::size_t i) { return boundingBall(r.spheres[i]); }),
        chunksOfStream(r.cylinders.size() + r.wires.size(),
                       [&](std::size_t i) {
                           return boundingBall(i < r.cylinders.size() ? r.cylinders[i]
                                                                      : r.wires[i - r.cylinders.size()]);
                       }),
        chunksOfStream(r.triangles.size() + r.coarseTriangles.size(),
                       [&](std::size_t i) { return ballOfTriangle(drawnTriangle(r, i)); }),
    };
}

std::vector<std::uint32_t> runStarts(const std::vector<PrimitiveRun>& copies, const std::vector<ModelRun>& models,
                                     std::size_t count) {
    std::vector<std::uint32_t> starts{0, static_cast<std::uint32_t>(count)};
    for (const PrimitiveRun& run : copies) starts.push_back(run.first);
    for (const ModelRun& run : models) starts.push_back(run.first);
    std::sort(starts.begin(), starts.end());
    starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
    return starts;
}

StreamOrder orderInSpace(Representation& r) {
    StreamOrder order{
        mortonOrder(r.spheres, r.sphereLooks, runStarts(r.copies.spheres, r.sphereModels, r.spheres.size())),
        mortonOrder(r.cylinders, r.cylinderLooks, runStarts(r.copies.cylinders, r.cylinderModels, r.cylinders.size()))};
    putInOrder(r, order);
    return order;
}

void putInOrder(Representation& r, const StreamOrder& order) {
    reorder(r.spheres, order.spheres);
    reorder(r.sphereLooks, order.spheres);
    if (!r.ellipsoids.empty()) {
        r.ellipsoids.resize(order.spheres.size());
        reorder(r.ellipsoids, order.spheres);
    }
    reorder(r.cylinders, order.cylinders);
    reorder(r.cylinderLooks, order.cylinders);
}

}  // namespace nacre
