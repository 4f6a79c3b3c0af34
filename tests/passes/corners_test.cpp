// Polygons of spheres, against what a circle and a sphere are.

#include "engine/passes/corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

namespace nacre::passes {
namespace {

/// The corners of a range once around.
std::vector<glm::vec3> around(CornerRange range) {
    const auto all = cornerStream();
    std::vector<glm::vec3> corners(all.begin() + range.first, all.begin() + range.first + range.count);
    std::ranges::sort(corners, {}, [](const glm::vec3& c) { return std::atan2(c.y, c.x); });
    return corners;
}

/// Distance of a polygon's nearest side from the middle.
float inradius(const std::vector<glm::vec3>& corners) {
    float least = 1e9f;
    for (std::size_t i = 0; i < corners.size(); ++i)
        least = std::min(least, glm::length(glm::vec2(corners[i] + corners[(i + 1) % corners.size()])) / 2);
    return least;
}

TEST(Corners, OfImpostorsLieAroundTheCircleAndThoseOfPlatesOnIt) {
    for (const CornerRange impostor : {kImpostorSquare, kImpostorOctagon}) {
        EXPECT_NEAR(inradius(around(impostor)), 1, 1e-6);
        for (const glm::vec3& c : around(impostor)) EXPECT_GT(c.z, 1);
    }
    for (const CornerRange plate : {kPlateSquare, kPlateOctagon})
        for (const glm::vec3& c : around(plate)) EXPECT_NEAR(glm::length(glm::vec2(c)), 1, 1e-6);
}

TEST(Corners, OfStripsGoFromSideToSide) {
    const auto all = cornerStream();
    for (const CornerRange range : {kImpostorSquare, kImpostorOctagon, kPlateSquare, kPlateOctagon})
        for (std::uint32_t i = range.first; i + 1 < range.first + range.count; i += 2) {
            EXPECT_EQ(all[i].x, all[i + 1].x);
            EXPECT_EQ(all[i].y, -all[i + 1].y);
            EXPECT_LT(all[i].y, 0);
        }
}

TEST(Corners, OfThePyramidHoldTheSphereUnderThem) {
    const auto all = cornerStream();
    const auto indices = pyramidIndices();
    constexpr int kSteps = 40;
    for (std::size_t facet = 0; facet < indices.size(); facet += 3) {
        const glm::vec3 a = all[kPyramid.first + indices[facet]], b = all[kPyramid.first + indices[facet + 1]],
                        c = all[kPyramid.first + indices[facet + 2]];
        EXPECT_EQ(glm::length(glm::vec2(a)), 0);
        EXPECT_NEAR(glm::length(glm::vec2(b + c)) / 2, 1, 1e-6);
        for (int i = 0; i <= kSteps; ++i)
            for (int k = 0; i + k <= kSteps; ++k) {
                const float u = static_cast<float>(i) / kSteps, v = static_cast<float>(k) / kSteps;
                const glm::vec3 p = a + (b - a) * u + (c - a) * v;
                const float h = 1 - p.x * p.x - p.y * p.y;
                if (h > 0) {
                    EXPECT_GT(p.z, std::sqrt(h)) << u << ", " << v;
                }
            }
    }
}

}  // namespace
}  // namespace nacre::passes
