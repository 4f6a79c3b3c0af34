#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <random>

#include "engine/occlusion/directions.h"

namespace nacre {
namespace {

glm::dvec3 viewDirection(const glm::dmat3& frame) { return {frame[0][2], frame[1][2], frame[2][2]}; }

/// Largest angle from any point of the sphere to the nearest of the first `count` directions, from random points.
double coveringAngle(const std::vector<glm::dmat3>& frames, std::size_t count) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 p = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        double nearest = -1;
        for (std::size_t k = 0; k < count; ++k) nearest = std::max(nearest, glm::dot(p, viewDirection(frames[k])));
        worst = std::max(worst, std::acos(std::min(nearest, 1.0)));
    }
    return worst;
}

TEST(OcclusionDirections, AreRightHandedFramesOfEqualArea) {
    for (const int count : {1, 16, 128, 500}) {
        const auto frames = occlusionDirections(count);
        ASSERT_EQ(frames.size(), static_cast<std::size_t>(count));
        glm::dvec3 sum(0);
        for (const glm::dmat3& f : frames) {
            EXPECT_NEAR(glm::determinant(f), 1.0, 1e-12);
            const glm::dmat3 product = f * glm::transpose(f);
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) EXPECT_NEAR(product[i][j], i == j ? 1.0 : 0.0, 1e-12);
            sum += viewDirection(f);
        }
        if (count > 1) {
            EXPECT_LT(glm::length(sum) / count, 1.5 / count) << count;
        }
    }
}

TEST(OcclusionDirections, ComeInPairsOfOpposites) {
    for (const int count : {2, 15, 128}) {
        const auto frames = occlusionDirections(count);
        for (std::size_t i = 0; i + 1 < frames.size(); i += 2)
            EXPECT_EQ(viewDirection(frames[i + 1]), -viewDirection(frames[i])) << i << " of " << count;
    }
}

TEST(OcclusionDirections, EveryPrefixIsWellSpread) {
    for (const int count : {128, 512}) {
        const auto frames = occlusionDirections(count);
        for (std::size_t prefix = 8; prefix <= frames.size(); prefix += prefix < 32 ? 4 : prefix / 4) {
            // Caps of equal area that cover the sphere once have this angle; a random set of 128 needs 2.8 times that.
            const double ideal = std::acos(1.0 - 2.0 / static_cast<double>(prefix));
            EXPECT_LT(coveringAngle(frames, prefix), 2.1 * ideal) << prefix << " of " << count;
            glm::dvec3 sum(0);
            for (std::size_t k = 0; k < prefix; ++k) sum += viewDirection(frames[k]);
            EXPECT_LT(glm::length(sum) / static_cast<double>(prefix), 0.16) << prefix << " of " << count;
        }
    }
}

}  // namespace
}  // namespace nacre
