#include "engine/mesh/mesh_measures.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "engine/molecule/disjoint_sets.h"

namespace nacre {
namespace {

/// Six times the volume between a triangle and the origin.
double wedgeVolume(const Mesh& mesh, const glm::uvec3& t) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    return glm::dot(a, glm::cross(b, c));
}

}  // namespace

MeshMeasures measure(const Mesh& mesh) {
    MeshMeasures measures;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        measures.area += glm::length(glm::cross(b - a, c - a)) / 2;
        measures.volume += wedgeVolume(mesh, t) / 6;
    }
    return measures;
}

std::vector<std::uint32_t> meshParts(const Mesh& mesh) {
    DisjointSets sets(mesh.positions.size());
    for (const glm::uvec3& t : mesh.triangles)
        for (const std::uint32_t other : {t.y, t.z}) sets.join(t.x, other);
    std::vector<std::uint32_t> parts(sets.count());
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        const std::uint32_t first =
            sets.findRoot(i);  // a root is the smallest index of its part, so it already has a number
        parts[i] = first == i ? count++ : parts[first];
    }
    return parts;
}

std::size_t dropCavities(Mesh& mesh) {
    const std::vector<std::uint32_t> parts = meshParts(mesh);
    if (parts.empty()) return 0;
    std::vector<double> volumes(*std::max_element(parts.begin(), parts.end()) + 1);
    for (const glm::uvec3& t : mesh.triangles) volumes[parts[t.x]] += wedgeVolume(mesh, t);
    const std::size_t cavities =
        static_cast<std::size_t>(std::count_if(volumes.begin(), volumes.end(), [](double v) { return v < 0; }));
    if (cavities == 0) return 0;
    Mesh kept;
    std::vector<std::uint32_t> places(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (volumes[parts[i]] < 0) continue;
        places[i] = static_cast<std::uint32_t>(kept.positions.size());
        kept.positions.push_back(mesh.positions[i]);
        kept.normals.push_back(mesh.normals[i]);
        kept.atoms.push_back(mesh.atoms[i]);
    }
    for (const glm::uvec3& t : mesh.triangles)
        if (volumes[parts[t.x]] >= 0) kept.triangles.emplace_back(places[t.x], places[t.y], places[t.z]);
    mesh = std::move(kept);
    return cavities;
}

}  // namespace nacre
