#include "engine/scene/build/mesh_streams.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <unordered_map>

#include "engine/error.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/build/translucency.h"

namespace nacre {
namespace {

constexpr float kNormalSteps = 65535.0f;

bool finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// The least power of two that fits every coordinate into its bits.
float stepFor(double reach) {
    int exponent = 0;
    std::frexp(std::max(reach, 1e-6), &exponent);  // reach < 2^exponent
    return static_cast<float>(std::ldexp(1.0, exponent - static_cast<int>(kPositionBits) + 1));
}

std::uint32_t packNormal(glm::vec3 n) {
    const float length = glm::length(n);
    n = length > 1e-12f && std::isfinite(length) ? n / length : glm::vec3(0, 0, 1);
    glm::vec2 p = glm::vec2(n) / (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
    if (n.z < 0)
        p = (1.0f - glm::abs(glm::vec2(p.y, p.x))) * glm::vec2(p.x >= 0 ? 1.0f : -1.0f, p.y >= 0 ? 1.0f : -1.0f);
    const auto fraction = [](float v) { return static_cast<std::uint32_t>((v * 0.5f + 0.5f) * kNormalSteps + 0.5f); };
    return fraction(p.x) | fraction(p.y) << 16;
}

void checkMesh(const Mesh& mesh) {
    const std::size_t count = mesh.positions.size();
    if (mesh.normals.size() != count || mesh.atoms.size() != count ||
        (!mesh.margins.empty() && mesh.margins.size() != count))
        throw Error("cannot draw mesh", "", "it has as many normals, atoms and margins as positions");
    const auto check = [&](const std::vector<glm::uvec3>& triangles) {
        for (const glm::uvec3& t : triangles)
            if (t.x >= count || t.y >= count || t.z >= count)
                throw Error("cannot draw mesh", "", "a triangle names a vertex that it does not have");
    };
    check(mesh.triangles);
    for (const MeshLevel& level : mesh.coarser) check(level.triangles);
}

/// The vertices of a mesh, those of its coarsest level first: a view of a level reads no others.
struct VertexOrder {
    std::vector<std::uint32_t> vertices;  // of the mesh
    std::vector<std::uint32_t> places;    // position of each vertex in that order
    std::vector<std::uint32_t> ends;      // end of each coarser level's vertices

    explicit VertexOrder(const Mesh& mesh) : places(mesh.positions.size(), kNone), ends(mesh.coarser.size()) {
        vertices.reserve(places.size());
        std::vector<bool> used(places.size());
        for (std::size_t i = mesh.coarser.size(); i-- > 0;) {
            for (const glm::uvec3& t : mesh.coarser[i].triangles) used[t.x] = used[t.y] = used[t.z] = true;
            addThose(used);
            ends[i] = static_cast<std::uint32_t>(vertices.size());
        }
        used.assign(places.size(), true);
        addThose(used);
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffu;

    void addThose(const std::vector<bool>& used) {
        for (std::uint32_t v = 0; v < places.size(); ++v)
            if (used[v] && places[v] == kNone) {
                places[v] = static_cast<std::uint32_t>(vertices.size());
                vertices.push_back(v);
            }
    }
};

/// Whether each edge is shared by two triangles of opposite direction, with vertices compared by position: adds a
/// number for each directed edge, and subtracts it for the opposite direction.
class EdgeSum {
public:
    explicit EdgeSum(const Representation& r) : vertices_(r.meshVertices) {}
    void add(const Triangle& t) {
        const std::uint64_t a = hashVertex(t.a), b = hashVertex(t.b), c = hashVertex(t.c);
        add(a, b);
        add(b, c);
        add(c, a);
    }
    bool isZero() const { return sum_ == 0; }

private:
    static std::uint64_t mixed(std::uint64_t x) {
        x = (x ^ x >> 32) * 0x9e3779b97f4a7c15u;
        return x ^ x >> 29;
    }
    std::uint64_t hashVertex(std::uint32_t v) const {
        return mixed(std::uint64_t{vertices_[v].xz} << 32 | vertices_[v].yz);
    }
    void add(std::uint64_t from, std::uint64_t to) { sum_ += mixed(from + 3 * to) - mixed(to + 3 * from); }

    const std::vector<MeshVertex>& vertices_;
    std::uint64_t sum_ = 0;
};

}  // namespace

bool isClosed(const Representation& r, std::span<const Triangle> triangles) {
    EdgeSum edges(r);
    for (const Triangle& t : triangles) edges.add(t);
    return edges.isZero();
}

const Triangle& drawnTriangle(const Representation& r, std::size_t number) {
    return number < r.triangles.size() ? r.triangles[number] : r.coarseTriangles[number - r.triangles.size()];
}

bool isSolid(const Representation& r) {
    std::size_t closed = 0;
    for (const MeshRun& mesh : r.meshes) closed += mesh.closed ? mesh.count : 0;
    const auto mirrors = [](const glm::dmat4x3& m) { return glm::dot(glm::cross(m[0], m[1]), m[2]) < 0; };
    return closed > 0 && closed == r.triangles.size() && std::ranges::none_of(r.copies.transforms, mirrors);
}

glm::vec3 decodeNormal(const MeshVertex& v) {
    const glm::vec2 p = glm::vec2(v.normal & 0xffffu, v.normal >> 16) * (2.0f / kNormalSteps) - 1.0f;
    glm::vec3 n(p, 1.0f - std::abs(p.x) - std::abs(p.y));
    if (n.z < 0) {
        n.x = (1.0f - std::abs(p.y)) * (p.x >= 0 ? 1.0f : -1.0f);
        n.y = (1.0f - std::abs(p.x)) * (p.y >= 0 ? 1.0f : -1.0f);
    }
    return glm::normalize(n);
}

void appendMesh(const Mesh& mesh, const glm::dvec3& shift, const std::function<SphereLook(std::uint32_t)>& readLook,
                Representation& r) {
    checkMesh(mesh);
    double reach = 0;
    for (const glm::vec3& p : mesh.positions) {
        const glm::dvec3 at = glm::dvec3(p) + shift;
        if (finite(at)) reach = std::max({reach, std::abs(at.x), std::abs(at.y), std::abs(at.z)});
    }
    const float step = stepFor(reach);
    const auto coordinate = [&](double v) {
        const double steps = std::floor(v / static_cast<double>(step) + 0.5) + kMiddlePosition;
        return static_cast<std::uint32_t>(std::clamp(steps, 0.0, static_cast<double>(kPositionMask)));
    };
    const auto base = static_cast<std::uint32_t>(r.meshVertices.size());
    const VertexOrder order(mesh);
    std::unordered_map<std::uint32_t, std::uint32_t> looks;
    for (const std::uint32_t i : order.vertices) {
        const glm::dvec3 at = glm::dvec3(mesh.positions[i]) + shift;
        MeshVertex v;
        if (finite(at)) {
            const std::uint32_t z = coordinate(at.z);
            v.xz = coordinate(at.x) | z << kPositionBits;
            v.yz = coordinate(at.y) | z >> 11 << kPositionBits;
        }
        v.normal = packNormal(mesh.normals[i]);
        const auto [look, added] = looks.emplace(mesh.atoms[i], static_cast<std::uint32_t>(r.meshLooks.size()));
        if (added) r.meshLooks.push_back(readLook(mesh.atoms[i]));
        v.look = look->second;
        r.meshVertices.push_back(v);
    }
    const float widest = mesh.margins.empty() ? 0 : *std::max_element(mesh.margins.begin(), mesh.margins.end());
    const auto computeLack = [&](std::uint32_t i) -> Triangle::Weights {
        if (!(widest > 0)) return 0;
        const float lack = (1 - mesh.margins[i] / widest) * (Triangle::kWeightMask + 1);
        return static_cast<Triangle::Weights>(std::clamp(std::lround(lack), 0L, long{Triangle::kWeightMask}));
    };
    const auto packWeights = [&](const glm::uvec3& t) {
        return computeLack(t.x) | computeLack(t.y) << Triangle::kWeightBits |
               computeLack(t.z) << 2 * Triangle::kWeightBits;
    };
    const auto samePlace = [&](std::uint32_t i, std::uint32_t k) {
        const MeshVertex &a = r.meshVertices[base + order.places[i]], &b = r.meshVertices[base + order.places[k]];
        return a.xz == b.xz && a.yz == b.yz;
    };
    const auto isFinite = [&](std::uint32_t i) { return finite(glm::dvec3(mesh.positions[i]) + shift); };
    /// @returns where they begin
    const auto add = [&](const std::vector<glm::uvec3>& triangles, std::vector<Triangle>& stream) {
        const std::size_t first = stream.size();
        for (const glm::uvec3& t : triangles)
            if (isFinite(t.x) && isFinite(t.y) && isFinite(t.z) && !samePlace(t.x, t.y) && !samePlace(t.y, t.z) &&
                !samePlace(t.z, t.x))
                stream.push_back({base + order.places[t.x], base + order.places[t.y], base + order.places[t.z], step,
                                  packWeights(t)});
        orderByTranslucency(r, stream.begin() + static_cast<std::ptrdiff_t>(first), stream.end());
        return static_cast<std::uint32_t>(first);
    };
    const auto countFrom = [](std::uint32_t first, const std::vector<Triangle>& stream) {
        return static_cast<std::uint32_t>(stream.size()) - first;
    };
    MeshRun run;
    run.firstVertex = base;
    run.endVertex = static_cast<std::uint32_t>(r.meshVertices.size());
    run.first = add(mesh.triangles, r.triangles);
    run.count = countFrom(run.first, r.triangles);
    run.closed = isClosed(r, std::span(r.triangles).subspan(run.first));
    for (std::size_t i = 0; i < mesh.coarser.size(); ++i) {
        const MeshLevel& level = mesh.coarser[i];
        const std::uint32_t first = add(level.triangles, r.coarseTriangles);
        run.levels.push_back({level.error, first, countFrom(first, r.coarseTriangles), base + order.ends[i]});
        run.closed = run.closed && isClosed(r, std::span(r.coarseTriangles).subspan(first));
    }
    r.meshes.push_back(std::move(run));
}

}  // namespace nacre
