#include "engine/scene/view/visible_depths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace nacre {
namespace {

/// Balls evenly over a sphere, or its back half.
std::vector<glm::dvec4> shell(double radius, bool back) {
    std::vector<glm::dvec4> balls;
    constexpr int kCount = 4000;
    for (int i = 0; i < kCount; ++i) {
        const double z = 1 - (2 * i + 1.0) / kCount, turn = 2 * std::numbers::pi * i / std::numbers::phi;
        const double r = std::sqrt(1 - z * z);
        if (!back || z < 0)
            balls.emplace_back(radius * r * std::cos(turn), radius * r * std::sin(turn), radius * z, 4.0);
    }
    return balls;
}

TEST(VisibleDepths, OfAClosedShellAreItsFront) {
    const View view;
    const std::vector<double> depths = visibleDepths(shell(100, false), view);
    ASSERT_FALSE(depths.empty());
    EXPECT_NEAR(depths.front(), -104, 1);
    // Half of a disc's area is within 71 % of its radius, where the front is at sqrt(1 - 0.5) of it.
    EXPECT_NEAR(depths[depths.size() / 2], -71 - 4, 6);
    const auto range = frontRange(depths, 104);
    ASSERT_TRUE(range);
    EXPECT_LT(range->near, -90);
    EXPECT_GT(range->far, -60);
    EXPECT_LT(range->far, 10);
}

TEST(VisibleDepths, OfAnOpenBowlGoOnBehindItsCentre) {
    const View view;
    EXPECT_FALSE(frontRange(visibleDepths(shell(100, true), view), 104));
    EXPECT_FALSE(frontRange({}, 10));
}

}  // namespace
}  // namespace nacre
