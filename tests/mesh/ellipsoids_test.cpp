// Meshes of ellipsoids, beside the quadric's equation.

#include "engine/mesh/ellipsoids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <set>

#include "engine/error.h"
#include "tests/mesh/mesh_checks.h"

namespace nacre {
namespace {

Ellipsoid tilted(const glm::dvec3& lengths, std::uint32_t atom = 0) {
    const glm::dvec3 x = glm::normalize(glm::dvec3(1, 2, 2)), y = glm::normalize(glm::dvec3(2, 1, -2));
    return {{3, -4, 5}, {x * lengths.x, y * lengths.y, glm::cross(x, y) * lengths.z}, atom};
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
        const Mesh mesh = ellipsoidMesh({&e, 1}, {});
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

TEST(EllipsoidMesh, IsClosedInEachLevelWithinItsError) {
    const Ellipsoid e = tilted({0.4, 0.3, 0.2});
    Mesh mesh = ellipsoidMesh({&e, 1}, {1, 1, 1});
    EXPECT_EQ(test::openEdges(mesh), 0u);
    ASSERT_EQ(mesh.coarser.size(), 4u);
    std::size_t finer = mesh.triangles.size();
    for (const MeshLevel& level : mesh.coarser) {
        EXPECT_LT(level.triangles.size(), finer / 2);
        finer = level.triangles.size();
        mesh.triangles = level.triangles;
        EXPECT_EQ(test::openEdges(mesh), 0u);
        for (const glm::uvec3& t : level.triangles) {
            const glm::dvec3 middle =
                (glm::dvec3(mesh.positions[t.x]) + glm::dvec3(mesh.positions[t.y]) + glm::dvec3(mesh.positions[t.z])) /
                3.0;
            const double inside = 1 - glm::length(inAxes(e, middle + glm::dvec3(1, 1, 1)));
            EXPECT_LE(inside * 0.4, 1.2 * static_cast<double>(level.error));
        }
    }
}

TEST(EllipsoidMesh, BandsFollowThePrincipalEllipses) {
    const Ellipsoid e = tilted({0.4, 0.3, 0.2}, 7);
    const Mesh mesh = ellipsoidMesh({&e, 1}, {});
    std::set<std::uint32_t> atoms(mesh.atoms.begin(), mesh.atoms.end());
    EXPECT_EQ(atoms, (std::set<std::uint32_t>{7, 7 | kEllipsoidBand}));
    double nearest = 1, width = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 parts = glm::abs(inAxes(e, glm::dvec3(mesh.positions[i]))) * glm::dvec3(0.4, 0.3, 0.2);
        const double away = std::min({parts.x, parts.y, parts.z});  // from a principal plane, Å
        if (mesh.atoms[i] & kEllipsoidBand)
            width = std::max(width, away);
        else
            nearest = std::min(nearest, away);
    }
    EXPECT_NEAR(width, 0.045 * std::cbrt(0.4 * 0.3 * 0.2), 1e-5);
    EXPECT_NEAR(nearest, width, 1e-5);
    for (const glm::uvec3& t : mesh.triangles)
        EXPECT_TRUE(mesh.atoms[t.x] == mesh.atoms[t.y] && mesh.atoms[t.y] == mesh.atoms[t.z]);
}

/// The corners of a triangle in units of the half axes, positive in the octant that is cut out.
std::array<glm::dvec3, 3> towardsCut(const Ellipsoid& e, const Mesh& mesh, const glm::uvec3& t) {
    std::array<glm::dvec3, 3> corners;
    for (int i = 0; i < 3; ++i)
        corners[static_cast<std::size_t>(i)] = inAxes(e, glm::dvec3(mesh.positions[t[i]])) * *e.cut;
    return corners;
}

TEST(CutEllipsoid, IsClosedAndHasSevenEighthsInEachLevel) {
    for (const glm::dvec3& lengths : {glm::dvec3(0.4, 0.3, 0.2), glm::dvec3(1, 0.2, 0.05), glm::dvec3(0.5)})
        for (int octant = 0; octant < 8; ++octant) {
            SCOPED_TRACE(octant);
            Ellipsoid e = tilted(lengths);
            Mesh mesh = ellipsoidMesh({&e, 1}, e.center);
            const double whole = test::enclosedVolume(mesh),
                         exact = 4 * std::numbers::pi / 3 * lengths.x * lengths.y * lengths.z;
            std::vector<double> ofLevels;
            for (const MeshLevel& level : mesh.coarser) {
                mesh.triangles = level.triangles;
                ofLevels.push_back(test::enclosedVolume(mesh));
            }
            e.cut = glm::dvec3(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1);
            Mesh cut = ellipsoidMesh({&e, 1}, e.center);
            EXPECT_EQ(test::openEdges(cut), 0u);
            EXPECT_NEAR(test::enclosedVolume(cut), 7.0 / 8 * exact, 0.01 * exact);
            EXPECT_NEAR(test::enclosedVolume(cut), 7.0 / 8 * whole, 0.001 * exact);
            ASSERT_EQ(cut.coarser.size(), ofLevels.size());
            for (std::size_t i = 0; i < ofLevels.size(); ++i) {
                EXPECT_EQ(cut.coarser[i].error, mesh.coarser[i].error);
                EXPECT_LT(cut.coarser[i].triangles.size(),
                          (i == 0 ? cut.triangles : cut.coarser[i - 1].triangles).size());
            }
            for (std::size_t i = 0; i < ofLevels.size(); ++i) {
                cut.triangles = cut.coarser[i].triangles;
                EXPECT_EQ(test::openEdges(cut), 0u) << i;
                // The rim keeps the ends of the lines, which are on the quadric, in each level.
                EXPECT_NEAR(test::enclosedVolume(cut), 7.0 / 8 * ofLevels[i], 0.02 * exact) << i;
            }
        }
}

TEST(CutEllipsoid, OpensOneOctantWithFacesInThePrincipalPlanes) {
    constexpr std::uint32_t kFlags = kEllipsoidBand | kEllipsoidFace;
    Ellipsoid e = tilted({0.4, 0.3, 0.2}, 7);
    e.cut = glm::dvec3(-1, 1, -1);
    const Mesh mesh = ellipsoidMesh({&e, 1}, {});
    std::array<double, 3> faces{}, lines{};  // areas, in squares of the half axes
    for (const glm::uvec3& t : mesh.triangles) {
        const auto corners = towardsCut(e, mesh, t);
        const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        EXPECT_LT(std::min({middle.x, middle.y, middle.z}), 1e-5) << "nothing is in the cut";
        EXPECT_TRUE(mesh.atoms[t.x] == mesh.atoms[t.y] && mesh.atoms[t.y] == mesh.atoms[t.z]);
        EXPECT_EQ(mesh.atoms[t.x] & ~kFlags, 7u);
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        const glm::dvec3 normal(mesh.normals[t.x]);
        EXPECT_GE(glm::dot(glm::cross(b - a, c - a), normal), 0);
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dvec3 across = glm::normalize(e.axes[static_cast<std::size_t>(axis)]) * (*e.cut)[axis];
            const double off =
                std::max({std::abs(corners[0][axis]), std::abs(corners[1][axis]), std::abs(corners[2][axis])});
            const bool inward = std::min(middle[(axis + 1) % 3], middle[(axis + 2) % 3]) > 0;
            if (off > 1e-5 || !inward || glm::dot(normal, across) < 0.999) continue;
            EXPECT_NEAR(glm::dot(normal, across), 1, 1e-6) << "flat, and facing the cut";
            const glm::dvec3 area = glm::cross(corners[1] - corners[0], corners[2] - corners[0]) / 2.0;
            (mesh.atoms[t.x] & kEllipsoidFace ? faces : lines)[static_cast<std::size_t>(axis)] += std::abs(area[axis]);
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(faces[axis] + lines[axis], std::numbers::pi / 4, 2e-3) << "a quarter of the ellipse";
        EXPECT_GT(lines[axis], 0.1);
        EXPECT_GT(faces[axis], 0.3);
    }
}

/// Along an axis that bounds a face, the lines that begin there are evenly spaced and equally wide; they run along the
/// other axis to the rim.
TEST(CutEllipsoid, LinesOfAFaceAreParallelToAnAxis) {
    Ellipsoid e = tilted({0.4, 0.3, 0.2});
    e.cut = glm::dvec3(1);
    const Mesh mesh = ellipsoidMesh({&e, 1}, {});
    for (int axis = 0; axis < 3; ++axis) {
        const int along = (axis + 1) % 3, run = (axis + 2) % 3;
        std::map<std::pair<int, int>, double> lines;  // length by both borders, in thousandths of the axis
        for (const glm::uvec3& t : mesh.triangles) {
            if (!(mesh.atoms[t.x] & kEllipsoidBand)) continue;
            const auto corners = towardsCut(e, mesh, t);
            glm::dvec3 low(1), high(0);
            for (const glm::dvec3& p : corners) low = glm::min(low, p), high = glm::max(high, p);
            if (high[axis] > 1e-5 || low[axis] < -1e-5 ||
                glm::dot(glm::dvec3(mesh.normals[t.x]), e.axes[static_cast<std::size_t>(axis)]) < 0)
                continue;
            if (high[along] - low[along] < 1e-4) continue;
            const auto thousandths = [](double share) { return static_cast<int>(std::lround(share * 1000)); };
            // Triangles of one line begin at its outer border.
            double& length = lines[{thousandths(high[along]), 0}];
            length = std::max(length, high[run]);
        }
        ASSERT_EQ(lines.size(), 5u) << axis;
        const double half =
            std::min(0.03 * std::cbrt(0.4 * 0.3 * 0.2) / glm::length(e.axes[static_cast<std::size_t>(along)]), 0.04);
        int number = 0;
        for (const auto& [border, length] : lines) {
            const double outer = number == 0 ? 2 * half : 0.2 * number + half,
                         inner = number == 0 ? 0 : 0.2 * number - half;
            EXPECT_NEAR(border.first, 1000 * outer, 0.6) << axis;
            EXPECT_NEAR(length, std::sqrt(1 - inner * inner), 1e-4) << axis << ' ' << number;
            ++number;
        }
    }
}

TEST(EllipsoidMesh, SeveralOfASceneShareTheTriangles) {
    const Ellipsoid e = tilted({0.4, 0.3, 0.2});
    const std::size_t finest = ellipsoidMesh({&e, 1}, {}).triangles.size();
    EXPECT_EQ(ellipsoidMesh({&e, 1}, {}, 204).triangles.size(), finest);
    EXPECT_LT(ellipsoidMesh({&e, 1}, {}, 205).triangles.size(), finest / 2);
    EXPECT_THROW(ellipsoidMesh({&e, 1}, {}, kMostEllipsoids + 1), Error);
}

TEST(EllipsoidMesh, ManyTakeFewerTrianglesEachUpToALimit) {
    for (const auto& [count, pieces] :
         {std::pair<std::size_t, int>{204, 32}, {205, 16}, {698, 16}, {699, 8}, {2118, 8}, {2119, 4}, {200'000, 4}})
        EXPECT_EQ(ellipsoidPieces(count), pieces) << count;
    EXPECT_LT(ellipsoidMeshError(32), 1e-3);
    EXPECT_LT(ellipsoidMeshError(16), 4e-3);
    EXPECT_LT(ellipsoidMeshError(8), 0.016);
    EXPECT_LT(ellipsoidMeshError(4), 0.06);
    const std::vector<Ellipsoid> many(kMostEllipsoids + 1);
    EXPECT_THROW(ellipsoidMesh(many, {}), Error);
}

}  // namespace
}  // namespace nacre
