#include "tests/reference/solids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <random>

namespace nacre::reference {
namespace {

/// Signed distance to a solid: negative inside.
double distanceTo(const Ball& ball, const glm::dvec3& point) { return glm::length(point - ball.center) - ball.radius; }

/// In the half plane (distance from axis, height) a rod is a box.
double distanceTo(const Rod& rod, const glm::dvec3& point) {
    const glm::dvec3 axis = glm::normalize(rod.b - rod.a), middle = 0.5 * (rod.a + rod.b);
    const double height = glm::dot(point - middle, axis);
    const double outward = glm::length(point - middle - height * axis);
    const glm::dvec2 over(outward - rod.radius, std::abs(height) - 0.5 * glm::length(rod.b - rod.a));
    return std::min(std::max(over.x, over.y), 0.0) + glm::length(glm::max(over, glm::dvec2(0.0)));
}

template <typename Solid>
glm::dvec3 gradient(const Solid& solid, const glm::dvec3& point) {
    constexpr double kStep = 1e-6;
    glm::dvec3 slope;
    for (int k = 0; k < 3; ++k) {
        glm::dvec3 step(0.0);
        step[k] = kStep;
        slope[k] = distanceTo(solid, point + step) - distanceTo(solid, point - step);
    }
    return glm::normalize(slope);
}

bool isNearRim(const Ball&, const glm::dvec3&) { return false; }

bool isNearRim(const Rod& rod, const glm::dvec3& point) {
    const glm::dvec3 axis = glm::normalize(rod.b - rod.a);
    const double height = glm::dot(point - rod.a, axis);
    const bool onSide = std::abs(glm::length(point - rod.a - height * axis) - rod.radius) < 1e-5;
    const bool onCap = std::min(std::abs(height), std::abs(height - glm::length(rod.b - rod.a))) < 1e-5;
    return onSide && onCap;
}

enum class March { hit, miss, undecided };

/// Walks from `from` along the line by the distance that is certainly free; no formula in common with cross().
template <typename Solid>
March march(const Solid& solid, const Line& line, double from, double sign, double& t) {
    t = from;
    for (int step = 0; step < 20000; ++step) {
        const double free = distanceTo(solid, line.origin + t * line.direction);
        if (free < 1e-10) return March::hit;
        if (std::abs(t) > 50.0) return March::miss;
        t += sign * free;
    }
    return March::undecided;  // runs along the surface
}

class Lines {
public:
    glm::dvec3 point(double reach) {
        return {reach * spread_(engine_), reach * spread_(engine_), reach * spread_(engine_)};
    }
    double between(double low, double high) { return low + (high - low) * 0.5 * (spread_(engine_) + 1.0); }
    /// From a far point to somewhere near the origin.
    Line toward(double reach) {
        const glm::dvec3 start = 20.0 * glm::normalize(point(1.0));
        return {start, glm::normalize(point(reach) - start)};
    }

private:
    std::mt19937_64 engine_{7};
    std::uniform_real_distribution<double> spread_{-1.0, 1.0};
};

/// The most negative distance on a stretch behind t: near 0 if the line only grazes the solid.
template <typename Solid>
double deepest(const Solid& solid, const Line& line, double t) {
    double least = 0.0;
    for (double step = 0.0; step < 10.0; step += 1e-3)
        least = std::min(least, distanceTo(solid, line.origin + (t + step) * line.direction));
    return least;
}

struct Tally {
    int hits = 0, misses = 0, caps = 0, sides = 0;
};

template <typename Solid>
void holdAgainstMarching(const Solid& solid, const Line& line, Tally& tally) {
    double enter = 0.0, leave = 0.0;
    const March forth = march(solid, line, 0.0, 1.0, enter);
    if (forth == March::undecided) return;
    const auto crossing = cross(line, solid);
    if (!crossing || forth == March::miss) {
        // Both must say so, but for a graze that stays within the marcher's own tolerance.
        EXPECT_FALSE(crossing && crossing->leave - crossing->enter > 1e-3);
        if (forth == March::hit) {
            EXPECT_GT(deepest(solid, line, enter), -1e-7);
        }
        ++tally.misses;
        return;
    }
    ASSERT_EQ(march(solid, line, 45.0, -1.0, leave), March::hit);
    // A tolerance of 1e-10 across the surface is far more along a grazing line.
    const double slant = std::abs(glm::dot(crossing->normal, line.direction));
    if (slant < 0.01) return;
    ++tally.hits;
    EXPECT_NEAR(crossing->enter, enter, 1e-7);
    EXPECT_NEAR(crossing->leave, leave, 1e-5);
    const glm::dvec3 place = line.origin + crossing->enter * line.direction;
    EXPECT_NEAR(glm::length(crossing->normal), 1.0, 1e-12);
    EXPECT_LT(glm::dot(crossing->normal, line.direction), 0.0);
    // The rim has no gradient.
    if (isNearRim(solid, place)) return;
    EXPECT_GT(glm::dot(crossing->normal, gradient(solid, place)), 0.999999);
}

TEST(Solids, BallsAgreeWithMarchingTheDistance) {
    Lines lines;
    Tally tally;
    for (int i = 0; i < 3000; ++i)
        holdAgainstMarching(Ball{lines.point(2.0), lines.between(0.1, 3.0)}, lines.toward(2.5), tally);
    EXPECT_GT(tally.hits, 500);
    EXPECT_GT(tally.misses, 500);
}

TEST(Solids, RodsAgreeWithMarchingTheDistance) {
    Lines lines;
    Tally tally;
    for (int i = 0; i < 6000; ++i) {
        const Rod rod{lines.point(3.0), lines.point(3.0), lines.between(0.1, 2.0)};
        const Line line = lines.toward(3.0);
        holdAgainstMarching(rod, line, tally);
        const auto crossing = cross(line, rod);
        if (!crossing) continue;
        const double facing = std::abs(glm::dot(crossing->normal, glm::normalize(rod.b - rod.a)));
        ++(facing > 0.5 ? tally.caps : tally.sides);
        const glm::dvec3 place = line.origin + crossing->enter * line.direction;
        const glm::dvec3 axis = rod.b - rod.a;
        EXPECT_NEAR(crossing->along, glm::dot(place - rod.a, axis) / glm::dot(axis, axis), 1e-9);
    }
    EXPECT_GT(tally.hits, 1000);
    EXPECT_GT(tally.misses, 1000);
    EXPECT_GT(tally.caps, 200);
    EXPECT_GT(tally.sides, 1000);
}

TEST(Solids, RodHitAlongItsAxis) {
    const Rod rod{{0, 0, 1}, {0, 0, 4}, 0.5};
    const auto inside = cross(Line{{0.3, 0.0, 10.0}, {0, 0, -1}}, rod);
    ASSERT_TRUE(inside);
    EXPECT_DOUBLE_EQ(inside->enter, 6.0);
    EXPECT_DOUBLE_EQ(inside->leave, 9.0);
    EXPECT_EQ(inside->normal, glm::dvec3(0, 0, 1));
    EXPECT_DOUBLE_EQ(inside->along, 1.0);
    EXPECT_FALSE(cross(Line{{0.6, 0.0, 10.0}, {0, 0, -1}}, rod));
}

TEST(Solids, RodHitSquareToItsAxis) {
    const Rod rod{{0, 0, 1}, {0, 0, 4}, 0.5};
    const auto side = cross(Line{{10, 0.3, 2.0}, {-1, 0, 0}}, rod);
    ASSERT_TRUE(side);
    EXPECT_DOUBLE_EQ(side->enter, 9.6);
    EXPECT_NEAR(glm::length(side->normal - glm::dvec3(0.8, 0.6, 0)), 0.0, 1e-14);
    EXPECT_NEAR(side->along, 1.0 / 3.0, 1e-14);
    EXPECT_FALSE(cross(Line{{10, 0, 0.99}, {-1, 0, 0}}, rod));
    EXPECT_FALSE(cross(Line{{10, 0, 4.01}, {-1, 0, 0}}, rod));
}

TEST(Solids, WithoutVolumeNothingIsHit) {
    const Line line{{0, 0, 10}, {0, 0, -1}};
    EXPECT_FALSE(cross(line, Ball{{0, 0, 0}, 0.0}));
    EXPECT_FALSE(cross(line, Ball{{0, 0, 0}, -1.0}));
    EXPECT_FALSE(cross(line, Rod{{0, 0, 0}, {0, 0, 0}, 1.0}));
    EXPECT_FALSE(cross(line, Rod{{0, 0, 0}, {0, 0, 1}, 0.0}));
}

}  // namespace
}  // namespace nacre::reference
