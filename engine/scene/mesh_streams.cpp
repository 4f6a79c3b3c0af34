#include "engine/scene/mesh_streams.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <stdexcept>
#include <unordered_map>

#include "engine/scene/representation.h"
#include "engine/scene/translucency.h"

namespace nacre {
namespace {

constexpr std::uint32_t kPositionBits = 21, kPositionMask = (1u << kPositionBits) - 1;
constexpr std::uint32_t kMiddle = 1u << (kPositionBits - 1);  // of the range of a coordinate
constexpr float kNormalSteps = 65535.0f;

bool finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// The least power of two in whose steps every coordinate has its bits.
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
    if (mesh.normals.size() != count || mesh.atoms.size() != count)
        throw std::invalid_argument("a mesh has as many normals and atoms as positions");
    const auto check = [&](const std::vector<glm::uvec3>& triangles) {
        for (const glm::uvec3& t : triangles)
            if (t.x >= count || t.y >= count || t.z >= count)
                throw std::invalid_argument("a triangle names a vertex that its mesh does not have");
    };
    check(mesh.triangles);
    for (const MeshLevel& level : mesh.coarser) check(level.triangles);
}

}  // namespace

const Triangle& drawnTriangle(const Representation& r, std::size_t number) {
    return number < r.triangles.size() ? r.triangles[number] : r.coarseTriangles[number - r.triangles.size()];
}

glm::vec3 positionOf(const MeshVertex& v, float step) {
    const std::uint32_t x = v.xz & kPositionMask, y = v.yz & kPositionMask;
    const std::uint32_t z = v.xz >> kPositionBits | v.yz >> kPositionBits << 11;
    return (glm::vec3(x, y, z) - static_cast<float>(kMiddle)) * step;
}

glm::vec3 normalOf(const MeshVertex& v) {
    const glm::vec2 p = glm::vec2(v.normal & 0xffffu, v.normal >> 16) * (2.0f / kNormalSteps) - 1.0f;
    glm::vec3 n(p, 1.0f - std::abs(p.x) - std::abs(p.y));
    if (n.z < 0) {
        n.x = (1.0f - std::abs(p.y)) * (p.x >= 0 ? 1.0f : -1.0f);
        n.y = (1.0f - std::abs(p.x)) * (p.y >= 0 ? 1.0f : -1.0f);
    }
    return glm::normalize(n);
}

void appendMesh(const Mesh& mesh, const glm::dvec3& shift, const std::function<SphereLook(std::uint32_t)>& lookOf,
                Representation& r) {
    checkMesh(mesh);
    double reach = 0;
    for (const glm::vec3& p : mesh.positions) {
        const glm::dvec3 at = glm::dvec3(p) + shift;
        if (finite(at)) reach = std::max({reach, std::abs(at.x), std::abs(at.y), std::abs(at.z)});
    }
    const float step = stepFor(reach);
    const auto coordinate = [&](double v) {
        const double steps = std::floor(v / static_cast<double>(step) + 0.5) + kMiddle;
        return static_cast<std::uint32_t>(std::clamp(steps, 0.0, static_cast<double>(kPositionMask)));
    };
    const auto base = static_cast<std::uint32_t>(r.meshVertices.size());
    std::unordered_map<std::uint32_t, std::uint32_t> looks;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 at = glm::dvec3(mesh.positions[i]) + shift;
        MeshVertex v;
        if (finite(at)) {
            const std::uint32_t z = coordinate(at.z);
            v.xz = coordinate(at.x) | z << kPositionBits;
            v.yz = coordinate(at.y) | z >> 11 << kPositionBits;
        }
        v.normal = packNormal(mesh.normals[i]);
        const auto [look, added] = looks.emplace(mesh.atoms[i], static_cast<std::uint32_t>(r.meshLooks.size()));
        if (added) r.meshLooks.push_back(lookOf(mesh.atoms[i]));
        v.look = look->second;
        r.meshVertices.push_back(v);
    }
    const auto samePlace = [&](std::uint32_t i, std::uint32_t k) {
        const MeshVertex &a = r.meshVertices[base + i], &b = r.meshVertices[base + k];
        return a.xz == b.xz && a.yz == b.yz;
    };
    const auto isFinite = [&](std::uint32_t i) { return finite(glm::dvec3(mesh.positions[i]) + shift); };
    /// @returns where they begin
    const auto add = [&](const std::vector<glm::uvec3>& triangles, std::vector<Triangle>& stream) {
        const std::size_t first = stream.size();
        for (const glm::uvec3& t : triangles)
            if (isFinite(t.x) && isFinite(t.y) && isFinite(t.z) && !samePlace(t.x, t.y) && !samePlace(t.y, t.z) &&
                !samePlace(t.z, t.x))
                stream.push_back({base + t.x, base + t.y, base + t.z, step});
        orderByTranslucency(r, stream.begin() + static_cast<std::ptrdiff_t>(first), stream.end());
        return static_cast<std::uint32_t>(first);
    };
    const auto countFrom = [](std::uint32_t first, const std::vector<Triangle>& stream) {
        return static_cast<std::uint32_t>(stream.size()) - first;
    };
    MeshRun run;
    run.first = add(mesh.triangles, r.triangles);
    run.count = countFrom(run.first, r.triangles);
    for (const MeshLevel& level : mesh.coarser) {
        const std::uint32_t first = add(level.triangles, r.coarseTriangles);
        run.levels.push_back({level.error, first, countFrom(first, r.coarseTriangles)});
    }
    r.meshes.push_back(std::move(run));
}

}  // namespace nacre
