// Meshes of ellipsoids, beside the quadric's equation.

#include "engine/mesh/ellipsoids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>

#include "tests/mesh/mesh_checks.h"

namespace nacre {
namespace {

constexpr double kBand = 0.01;
constexpr std::uint32_t kOwn = 7, kOfBands = 9;

Ellipsoid tilted(const glm::dvec3& lengths) {
    const glm::dvec3 x = glm::normalize(glm::dvec3(1, 2, 2)), y = glm::normalize(glm::dvec3(2, 1, -2));
    return {{3, -4, 5}, {x * lengths.x, y * lengths.y, glm::cross(x, y) * lengths.z}, kBand};
}

Mesh meshOf(const Ellipsoid& e, int pieces = 32) {
    Mesh mesh;
    addEllipsoid(mesh, e, pieces, kOwn, kOfBands);
    return mesh;
}

/// A point in units of the half axes: on the ellipsoid its length is 1.
glm::dvec3 inAxes(const Ellipsoid& e, const glm::dvec3& p) {
    glm::dvec3 parts(0);
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3& axis = e.axes[static_cast<std::size_t>(i)];
        parts[i] = glm::dot(p - e.center, axis) / glm::dot(axis, axis);
    }
    return parts;
}

TEST(EllipsoidMesh, LiesOnTheQuadricWithItsNormals) {
    for (const glm::dvec3& lengths : {glm::dvec3(0.4, 0.3, 0.2), glm::dvec3(1, 0.2, 0.05), glm::dvec3(0.5)}) {
        const Ellipsoid e = tilted(lengths);
        const Mesh mesh = meshOf(e);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::dvec3 p(mesh.positions[i]), parts = inAxes(e, p);
            ASSERT_NEAR(glm::length(parts), 1, 2e-5);
            glm::dvec3 gradient(0);
            for (int k = 0; k < 3; ++k)
                gradient += glm::normalize(e.axes[static_cast<std::size_t>(k)]) * (parts[k] / lengths[k]);
            ASSERT_NEAR(glm::dot(glm::normalize(gradient), glm::dvec3(mesh.normals[i])), 1, 1e-5);
        }
        for (const glm::uvec3& t : mesh.triangles) {
            const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
            ASSERT_GT(glm::dot(glm::cross(b - a, c - a), glm::dvec3(mesh.normals[t.x])), 0);
        }
        const double volume = 4 * std::numbers::pi / 3 * lengths.x * lengths.y * lengths.z;
        EXPECT_NEAR(test::enclosedVolume(mesh), volume, 0.02 * volume);
        EXPECT_LT(test::enclosedVolume(mesh), volume);
    }
}

TEST(EllipsoidMesh, IsClosedAndNearTheQuadricWithAnyPieces) {
    const Ellipsoid e = tilted({0.4, 0.3, 0.2});
    for (const auto& [pieces, most] : {std::pair(32, 2e-3), {16, 5e-3}, {8, 0.017}, {4, 0.06}}) {
        const Mesh mesh = meshOf(e, pieces);
        EXPECT_EQ(test::openEdges(mesh), 0u);
        EXPECT_EQ(mesh.triangles.size(), trianglesPerEllipsoid(pieces));
        for (const glm::uvec3& t : mesh.triangles) {
            const glm::dvec3 middle =
                (glm::dvec3(mesh.positions[t.x]) + glm::dvec3(mesh.positions[t.y]) + glm::dvec3(mesh.positions[t.z])) /
                3.0;
            EXPECT_LE(1 - glm::length(inAxes(e, middle)), most) << pieces;
        }
    }
}

TEST(EllipsoidMesh, BandsFollowThePrincipalEllipses) {
    const Ellipsoid e = tilted({0.4, 0.3, 0.2});
    const Mesh mesh = meshOf(e);
    std::set<std::uint32_t> atoms(mesh.atoms.begin(), mesh.atoms.end());
    EXPECT_EQ(atoms, (std::set<std::uint32_t>{kOwn, kOfBands}));
    double nearest = 1, width = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 parts = glm::abs(inAxes(e, glm::dvec3(mesh.positions[i]))) * glm::dvec3(0.4, 0.3, 0.2);
        const double away = std::min({parts.x, parts.y, parts.z});  // from a principal plane, Å
        if (mesh.atoms[i] == kOfBands)
            width = std::max(width, away);
        else
            nearest = std::min(nearest, away);
    }
    EXPECT_NEAR(width, kBand, 1e-5);
    EXPECT_NEAR(nearest, width, 1e-5);
    for (const glm::uvec3& t : mesh.triangles)
        EXPECT_TRUE(mesh.atoms[t.x] == mesh.atoms[t.y] && mesh.atoms[t.y] == mesh.atoms[t.z]);
}

TEST(EllipsoidMesh, ManyTakeFewerTrianglesEach) {
    for (const auto& [count, pieces] :
         {std::pair<std::size_t, int>{222, 32}, {223, 16}, {818, 16}, {819, 8}, {2793, 8}, {2794, 4}, {200'000, 4}})
        EXPECT_EQ(ellipsoidPieces(count), pieces) << count;
}

}  // namespace
}  // namespace nacre
