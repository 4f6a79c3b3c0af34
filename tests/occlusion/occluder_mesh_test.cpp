// Meshes as depth maps by tiles show them.
#include "engine/occlusion/occluder_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "engine/occlusion/depth_maps.h"
#include "engine/occlusion/mesh_heights.h"
#include "tests/renderer/meshes.h"

namespace nacre::test {
namespace {

Representation makeScene(const Mesh& mesh) {
    Representation r;
    appendMesh(mesh, glm::dvec3(0), testLook, r);
    return r;
}

occlusion::OccluderMesh makeOccluder(const Mesh& mesh, float pixel) {
    const Representation r = makeScene(mesh);
    return occlusion::occluderMesh(r, 0, static_cast<std::uint32_t>(r.triangles.size()), pixel);
}

/// Whether each edge has a triangle on either side, counted.
bool hasNoBorder(const std::vector<glm::uvec3>& triangles) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> turns;
    for (const glm::uvec3& t : triangles)
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t from = t[i], to = t[(i + 1) % 3];
            turns[std::minmax(from, to)] += from < to ? 1 : -1;
        }
    return std::ranges::all_of(turns, [](const auto& edge) { return edge.second == 0; });
}

TEST(OccluderMesh, OfSmallTrianglesHasFewer) {
    constexpr float kRadius = 5, kPixel = 0.4f;
    const Mesh ball = icosphere({0, 0, 0}, kRadius, 5, 0);
    const occlusion::OccluderMesh coarse = makeOccluder(ball, kPixel);
    EXPECT_LT(coarse.triangles.size(), ball.triangles.size() / 4);
    EXPECT_TRUE(coarse.closed);
    EXPECT_TRUE(hasNoBorder(coarse.triangles));
    for (const glm::vec3& p : coarse.positions) EXPECT_NEAR(glm::length(p), kRadius, kPixel / 4);
    for (const glm::uvec3& t : coarse.triangles) {
        const glm::vec3 a = coarse.positions[t.x], b = coarse.positions[t.y], c = coarse.positions[t.z];
        EXPECT_NEAR(glm::length(a + b + c) / 3, kRadius, kPixel / 2);
    }
}

TEST(DepthMapSizes, FollowTheCurvatureOfMeshes) {
    const auto perAngstrom = [](float radius) {
        Representation r = makeScene(icosphere({0, 0, 0}, radius, 4, 0));
        r.radius = 100;
        return occlusion::DepthMapSizes::pixelsFor(r, 64u << 20, 32) / (2 * r.radius);
    };
    constexpr double kStep = 12 / 200.0;  // widths are multiples of 8 pixels
    EXPECT_NEAR(perAngstrom(0.2f), 2.5, kStep);
    EXPECT_NEAR(perAngstrom(1), 2.2, kStep);
    EXPECT_NEAR(perAngstrom(1.5f), 2.2 / 1.5, kStep);
    EXPECT_NEAR(perAngstrom(5), 1.25, kStep);
}

TEST(OccluderMesh, OfLargeTrianglesIsTheMesh) {
    const Mesh ball = icosphere({1, 2, 3}, 4, 2, 0);
    const Representation r = makeScene(ball);
    const auto count = static_cast<std::uint32_t>(r.triangles.size());
    const occlusion::OccluderMesh same = occlusion::occluderMesh(r, 0, count, 0.1f);
    ASSERT_EQ(same.triangles.size(), count);
    EXPECT_EQ(same.positions.size(), r.meshVertices.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        const Triangle& t = r.triangles[i];
        EXPECT_EQ(same.positions[same.triangles[i].x], decodePosition(r.meshVertices[t.a], t.step()));
        EXPECT_EQ(same.positions[same.triangles[i].y], decodePosition(r.meshVertices[t.b], t.step()));
        EXPECT_EQ(same.positions[same.triangles[i].z], decodePosition(r.meshVertices[t.c], t.step()));
    }
    // A part of it has edges without another side.
    EXPECT_TRUE(same.closed);
    EXPECT_FALSE(occlusion::occluderMesh(r, 3, count - 3, 0.1f).closed);
}

TEST(OccluderMesh, IsClosedWhereTheSidesOfACreaseMeet) {
    // Each triangle has vertices of its own, as at creases.
    const Mesh ball = icosphere({0, 0, 0}, 3, 2, 0);
    Mesh creased;
    for (const glm::uvec3& t : ball.triangles) {
        const auto first = static_cast<std::uint32_t>(creased.positions.size());
        for (int i = 0; i < 3; ++i) {
            creased.positions.push_back(ball.positions[t[i]]);
            creased.normals.push_back(glm::normalize(ball.positions[t.x] + ball.positions[t.y] + ball.positions[t.z]));
            creased.atoms.push_back(0);
        }
        creased.triangles.emplace_back(first, first + 1, first + 2);
    }
    EXPECT_TRUE(makeOccluder(creased, 0.01f).closed);
    creased.triangles.pop_back();
    EXPECT_FALSE(makeOccluder(creased, 0.01f).closed);
}

TEST(OccluderMesh, KeepsTheSidesOfASheetApart) {
    Mesh sheet;
    constexpr std::uint32_t kSide = 60;
    constexpr float kApart = 0.25f;
    for (const float side : {1.0f, -1.0f}) {
        const auto first = static_cast<std::uint32_t>(sheet.positions.size());
        for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
            const std::uint32_t x = i % kSide, y = i / kSide, a = first + i, b = a + kSide;
            sheet.positions.emplace_back(0.1f * static_cast<float>(x), 0.1f * static_cast<float>(y), kApart * side);
            sheet.normals.push_back(glm::normalize(glm::vec3(0.1f, 0.1f, side)));
            sheet.atoms.push_back(0);
            if (x + 1 == kSide || y + 1 == kSide) continue;
            sheet.triangles.emplace_back(a, side > 0 ? a + 1 : b, side > 0 ? b : a + 1);
            sheet.triangles.emplace_back(a + 1, side > 0 ? b + 1 : b, side > 0 ? b : b + 1);
        }
    }
    const occlusion::OccluderMesh coarse = makeOccluder(sheet, 1.0f);
    EXPECT_LT(coarse.triangles.size(), sheet.triangles.size() / 4);
    std::set<bool> sides;
    for (const glm::vec3& p : coarse.positions) {
        EXPECT_NEAR(std::abs(p.z), kApart, 1e-3f);
        sides.insert(p.z > 0);
    }
    EXPECT_EQ(sides.size(), 2u);
}

TEST(MeshHeights, DrawsOnItsMapAlone) {
    constexpr std::uint32_t kPixels = 10, kPitch = 12;
    constexpr float kNothing = -1e30f, kOther = 7;
    // Covers the map and more, and rises to the right.
    occlusion::OccluderMesh square;
    for (const float y : {-20.0f, 20.0f})
        for (const float x : {-20.0f, 20.0f}) square.positions.emplace_back(x, y, 0.5f * x);
    square.triangles = {{0, 1, 3}, {0, 3, 2}};
    std::vector<float> heights(std::size_t{kPitch} * kPixels, kOther);
    for (std::uint32_t y = 0; y < kPixels; ++y) std::fill_n(&heights[std::size_t{y} * kPitch], kPixels, kNothing);
    const glm::vec4 rows[] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    occlusion::MeshHeights drawn;
    drawn.draw(square, 0, square.triangles.size(), rows, {heights.data(), kPitch, kPixels, 1});
    for (std::uint32_t y = 0; y < kPixels; ++y)
        for (std::uint32_t x = 0; x < kPitch; ++x) {
            const float height = heights[std::size_t{y} * kPitch + x];
            if (x < kPixels)
                EXPECT_NEAR(height, 0.5f * (static_cast<float>(x) + 0.5f - 5), 1e-4f) << x << " " << y;
            else
                EXPECT_EQ(height, kOther);
        }
    // What lies behind changes nothing, nor what is turned away.
    const std::vector<float> before = heights;
    for (glm::vec3& p : square.positions) p.z -= 1;
    drawn.draw(square, 0, square.triangles.size(), rows, {heights.data(), kPitch, kPixels, 1});
    EXPECT_EQ(heights, before);
    for (glm::vec3& p : square.positions) p.z += 5;
    square.triangles = {{0, 3, 1}, {0, 2, 3}};
    square.closed = true;
    drawn.draw(square, 0, square.triangles.size(), rows, {heights.data(), kPitch, kPixels, 1});
    EXPECT_EQ(heights, before);
    // A mirror image of what is turned away faces the map.
    std::vector<float> mirrored = before;
    const glm::vec4 mirror[] = {{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    drawn.draw(square, 0, square.triangles.size(), mirror, {mirrored.data(), kPitch, kPixels, 1});
    EXPECT_NE(mirrored, before);
    square.closed = false;
    drawn.draw(square, 0, square.triangles.size(), rows, {heights.data(), kPitch, kPixels, 1});
    EXPECT_NE(heights, before);
}

TEST(MeshHeights, AreTheSameWithAnyLanes) {
    constexpr std::uint32_t kPixels = 50;
    std::mt19937 random(1);  // not a distribution of the library's, whose numbers vary
    const auto within = [&](float least, float most) {
        return least + (most - least) * static_cast<float>(random() % 65536) / 65536;
    };
    std::vector<glm::vec4> corners;
    std::vector<glm::uvec3> triangles;
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const float x = within(-3, kPixels + 3), y = within(-3, kPixels + 3), size = i % 100 == 0 ? 20 : 1.5f;
        for (int corner = 0; corner < 3; ++corner)
            corners.emplace_back(x + within(-size, size), y + within(-size, size), within(-20, 20), 0);
        triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    triangles.emplace_back(5, 5, 5);  // without an area
    std::vector<float> least;
    for (const occlusion::TriangleLanes& lanes : occlusion::triangleLanes())
        for (const bool fronts : {false, true}) {
            std::vector<float> heights(std::size_t{kPixels} * kPixels, -1e30f);
            lanes.draw(corners.data(), triangles.data(), triangles.size(), fronts,
                       {heights.data(), kPixels, kPixels, 1});
            least.insert(least.end(), heights.begin(), heights.end());
            const auto* same = &least[fronts ? heights.size() : 0];
            EXPECT_TRUE(std::equal(heights.begin(), heights.end(), same)) << lanes.lanes;
        }
}

}  // namespace
}  // namespace nacre::test
