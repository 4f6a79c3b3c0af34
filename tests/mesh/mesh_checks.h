#pragma once
// What every mesh must be, whoever made it.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/mesh/mesh.h"

namespace nacre::test {

/// Index of the first vertex at each one's place.
inline std::vector<std::uint32_t> weldedVertices(const Mesh& mesh) {
    std::map<std::tuple<float, float, float>, std::uint32_t> first;
    std::vector<std::uint32_t> welded;
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 p = mesh.positions[i] + 0.0f;  // no -0
        welded.push_back(first.try_emplace({p.x, p.y, p.z}, i).first->second);
    }
    return welded;
}

/// Edges that no triangle of the opposite sense shares, counted over all triangles that are more than a line.
inline std::size_t openEdges(const Mesh& mesh) {
    const std::vector<std::uint32_t> welded = weldedVertices(mesh);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const glm::uvec3& t : mesh.triangles) {
        const std::uint32_t corners[] = {welded[t.x], welded[t.y], welded[t.z]};
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = corners[i], b = corners[(i + 1) % 3];
            if (a < b) ++edges[{a, b}];
            if (b < a) --edges[{b, a}];
        }
    }
    std::size_t open = 0;
    for (const auto& [edge, balance] : edges) open += balance != 0;
    return open;
}

/// Å^3; that of overlapping pieces counts twice.
inline double enclosedVolume(const Mesh& mesh) {
    double volume = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        volume += glm::dot(a, glm::cross(b, c)) / 6;
    }
    return volume;
}

/// Lengths agree, indices and numbers exist, normals are unit vectors on the outer side, each triangle is one atom's,
/// and nothing is open.
/// @param atoms  of the molecule
inline void expectSound(const Mesh& mesh, std::size_t atoms) {
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.atoms.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 &p = mesh.positions[i], &n = mesh.normals[i];
        ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        ASSERT_NEAR(glm::length(n), 1, 1e-4);
        ASSERT_LT(mesh.atoms[i], atoms);
    }
    std::size_t inward = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        ASSERT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
        const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
        const glm::vec3 area = glm::cross(b - a, c - a);
        inward += glm::dot(area, mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z]) < 0;
    }
    // Where a curve is tighter than a section is wide it folds, and a triangle there looks inwards.
    EXPECT_LE(inward, mesh.triangles.size() / 200);
    EXPECT_EQ(openEdges(mesh), 0u);
    EXPECT_TRUE(mesh.triangles.empty() || enclosedVolume(mesh) > 0);
}

}  // namespace nacre::test
