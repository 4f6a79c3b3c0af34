#include "engine/occlusion/occluder_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/scene/instances/mesh_levels.h"

namespace nacre::occlusion {
namespace {

// Cell width in map pixels; the depth test has a slack of one pixel. The RMS error of 4HHB's surface is 0.019 with 2
// pixels, 0.022 with 3, 0.041 with 4.
constexpr float kCell = 3;

std::uint64_t mixed(std::uint64_t x) {  // the finaliser of splitmix64
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return x ^ x >> 31;
}

std::span<const Triangle> spanTriangles(const Representation& r, std::uint32_t first, std::uint32_t count) {
    const std::size_t finest = r.triangles.size();
    return first < finest ? std::span(r.triangles).subspan(first, count)
                          : std::span(r.coarseTriangles).subspan(first - finest, count);
}

/// The triangles with their own copies of vertices. @param vertices  source of each
OccluderMesh plainMesh(const Representation& r, std::span<const Triangle> triangles,
                       std::vector<std::uint32_t>& vertices) {
    std::uint32_t first = UINT32_MAX, end = 0;
    for (const Triangle& t : triangles) {
        first = std::min({first, t.a, t.b, t.c});
        end = std::max({end, t.a + 1, t.b + 1, t.c + 1});
    }
    OccluderMesh mesh;
    mesh.triangles.reserve(triangles.size());
    constexpr std::uint32_t kNew = UINT32_MAX;
    std::vector<std::uint32_t> numbers(end - std::min(first, end), kNew);
    for (const Triangle& t : triangles) {
        const auto numbered = [&](std::uint32_t vertex) {
            std::uint32_t& number = numbers[vertex - first];
            if (number == kNew) {
                number = static_cast<std::uint32_t>(vertices.size());
                vertices.push_back(vertex);
                mesh.positions.push_back(decodePosition(r.meshVertices[vertex], t.step()));
            }
            return number;
        };
        const std::uint32_t a = numbered(t.a), b = numbered(t.b), c = numbered(t.c);
        mesh.triangles.emplace_back(a, b, c);
    }
    return mesh;
}

/// Numbers the clusters of vertices by cell and by the signs of their normals. The signs separate the two sides of thin
/// parts.
class Clusters {
public:
    explicit Clusters(std::size_t vertices) : slots_(std::bit_ceil(2 * vertices + 1)) {}

    std::uint32_t add(const glm::vec3& position, const glm::vec3& normal, float cell) {
        const auto along = [&](float x) {
            constexpr std::uint64_t kBits = (1u << 20) - 1;
            return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / cell))) & kBits;
        };
        const std::uint64_t side = (normal.x < 0 ? 1u : 0u) | (normal.y < 0 ? 2u : 0u) | (normal.z < 0 ? 4u : 0u);
        const std::uint64_t key =
            1 + (side << 60 | along(position.x) << 40 | along(position.y) << 20 | along(position.z));
        std::size_t at = mixed(key) & (slots_.size() - 1);
        while (slots_[at].key != 0 && slots_[at].key != key) at = (at + 1) & (slots_.size() - 1);
        if (slots_[at].key == 0) {
            slots_[at] = {key, static_cast<std::uint32_t>(sums_.size())};
            sums_.emplace_back(0);
            counts_.push_back(0);
        }
        const std::uint32_t cluster = slots_[at].cluster;
        sums_[cluster] += position;
        counts_[cluster] += 1;
        return cluster;
    }

    std::vector<glm::vec3> middles() {
        for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] /= counts_[i];
        return std::move(sums_);
    }

private:
    struct Slot {
        std::uint64_t key = 0;  ///< 0: free
        std::uint32_t cluster = 0;
    };
    std::vector<Slot> slots_;
    std::vector<glm::vec3> sums_;
    std::vector<float> counts_;
};

OccluderMesh clustered(const Representation& r, const OccluderMesh& fine, std::span<const std::uint32_t> vertices,
                       float cell) {
    Clusters clusters(vertices.size());
    std::vector<std::uint32_t> clusterIndex(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        clusterIndex[i] = clusters.add(fine.positions[i], decodeNormal(r.meshVertices[vertices[i]]), cell);
    OccluderMesh mesh;
    for (const glm::uvec3& t : fine.triangles) {
        const glm::uvec3 coarse(clusterIndex[t.x], clusterIndex[t.y], clusterIndex[t.z]);
        if (coarse.x != coarse.y && coarse.y != coarse.z && coarse.z != coarse.x) mesh.triangles.push_back(coarse);
    }
    mesh.positions = clusters.middles();
    return mesh;
}

}  // namespace

OccluderMesh occluderMesh(const Representation& r, std::uint32_t first, std::uint32_t count, float pixel) {
    std::vector<std::uint32_t> vertices;
    const std::span<const Triangle> triangles = spanTriangles(r, first, count);
    OccluderMesh mesh = plainMesh(r, triangles, vertices);
    if (OccluderMesh coarse = clustered(r, mesh, vertices, kCell * pixel);
        2 * coarse.triangles.size() <= mesh.triangles.size())
        mesh = std::move(coarse);
    mesh.closed = isClosed(r, triangles);  // merging keeps a closed mesh closed
    return mesh;
}

OccluderMeshes::OccluderMeshes(const Representation& representation, double error, float pixel) {
    if (representation.triangles.empty()) return;
    for (const PrimitiveRun& run : drawnRuns(representation, error)) of(representation, run.first, run.count, pixel);
}

const OccluderMesh& OccluderMeshes::of(const Representation& representation, std::uint32_t first, std::uint32_t count,
                                       float pixel) {
    const auto [mesh, isNew] = meshes_.try_emplace({first, count});
    if (isNew) mesh->second = occluderMesh(representation, first, count, pixel);
    return mesh->second;
}

}  // namespace nacre::occlusion
