// Truths are radiation view factors from a small flat element, since cosine-weighted occlusion is one minus those of
// all that blocks: J. R. Howell, "A Catalog of Radiation Heat Transfer Configuration Factors".

#include "tests/reference/ambient_occlusion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include "tests/reference/scenes.h"

namespace nacre::reference {
namespace {

constexpr std::size_t kRays = 16384;
/// Strata leave errors only in the cells that an outline crosses: about 4 * 128 of 16384 cells, each with a standard
/// deviation below 1/2, gives 0.5 * sqrt(512) / 16384 = 7e-4. Five of those.
constexpr double kTolerance = 3.5e-3;

glm::dvec3 randomDirection(std::mt19937_64& engine) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(engine), normal(engine), normal(engine)));
}

/// Factor of a sphere whose centre stands `angle` from the element's normal at `ratio` of its radii.
double sphereFactor(double ratio, double angle) {
    const double square = ratio * ratio, cosine = std::cos(angle);
    if (angle + std::asin(1.0 / ratio) <= std::numbers::pi / 2.0) return cosine / square;
    if (angle - std::asin(1.0 / ratio) >= std::numbers::pi / 2.0) return 0.0;
    const double tangent = std::sqrt(square - 1.0);  // of the complement of the cone's half angle
    return 0.5 - std::asin(tangent / (ratio * std::sin(angle))) / std::numbers::pi +
           (cosine * std::acos(-tangent * cosine / std::sin(angle)) -
            tangent * std::sqrt(1.0 - square * cosine * cosine)) /
               (square * std::numbers::pi);
}

TEST(AmbientOcclusion, LoneSphereIsOpenEverywhere) {
    std::mt19937_64 engine(1);
    for (const glm::vec3 center : {glm::vec3(0.0f), glm::vec3(60.0f, -70.0f, 40.0f)}) {
        Representation scene;
        addSphere(scene, center, 1.7f, 1);
        const OcclusionScene traced(scene);
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 normal = randomDirection(engine);
            EXPECT_EQ(traced.occlusionAt(glm::dvec3(center) + 1.7 * normal, normal), 1.0);
        }
    }
}

TEST(AmbientOcclusion, LoneRodIsOpenOnSideAndCaps) {
    std::mt19937_64 engine(2);
    for (const glm::vec3 shift : {glm::vec3(0.0f), glm::vec3(40.0f, 41.0f, 42.0f)}) {
        Representation scene;
        addRod(scene, shift, shift + glm::vec3(2.0f, -1.0f, 1.0f), 0.15f, 1, 2);
        const OcclusionScene traced(scene);
        const glm::dvec3 a = scene.cylinders[0].a, b = scene.cylinders[0].b, axis = glm::normalize(b - a);
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 outward = glm::normalize(glm::cross(axis, randomDirection(engine)));
            const double share = i / 99.0;
            EXPECT_EQ(traced.occlusionAt(glm::mix(a, b, share) + 0.15 * outward, outward), 1.0);
            EXPECT_EQ(traced.occlusionAt(a + 0.15 * share * outward, -axis), 1.0);
            EXPECT_EQ(traced.occlusionAt(b + 0.15 * share * outward, axis), 1.0);
        }
    }
}

TEST(AmbientOcclusion, SphereAboveTheHorizonBlocksItsViewFactor) {
    // A tiny sphere carries the element; the other stands `ratio` radii away.
    for (const double ratio : {1.2, 2.0, 4.0})
        for (double angle = 0.0; angle + std::asin(1.0 / ratio) < std::numbers::pi / 2.0; angle += 0.2) {
            Representation scene;
            addSphere(scene, glm::vec3(glm::dvec3(std::sin(angle), 0.0, std::cos(angle)) * ratio * 3.0), 3.0f, 1);
            const OcclusionScene traced(scene);
            EXPECT_NEAR(traced.occlusionAt({0, 0, 0}, {0, 0, 1}, kRays), 1.0 - std::cos(angle) / (ratio * ratio),
                        kTolerance)
                << ratio << ", " << angle;
        }
}

TEST(AmbientOcclusion, SphereAcrossTheHorizonBlocksItsViewFactor) {
    int across = 0;
    for (const double ratio : {1.2, 2.0, 4.0})
        for (double angle = 0.2; angle < 3.0; angle += 0.2) {
            if (angle + std::asin(1.0 / ratio) > std::numbers::pi / 2.0 &&
                angle - std::asin(1.0 / ratio) < std::numbers::pi / 2.0)
                ++across;
            Representation scene;
            addSphere(scene, glm::vec3(glm::dvec3(0.0, std::sin(angle), std::cos(angle)) * ratio * 3.0), 3.0f, 1);
            const OcclusionScene traced(scene);
            EXPECT_NEAR(traced.occlusionAt({0, 0, 0}, {0, 0, 1}, kRays), 1.0 - sphereFactor(ratio, angle), kTolerance)
                << ratio << ", " << angle;
        }
    EXPECT_GT(across, 5);
}

TEST(AmbientOcclusion, SphereThatTouchesAnother) {
    // Unit spheres that touch at z = 1: at polar angle a the other's centre stands sqrt(5 - 4 cos a) away.
    Representation scene;
    addSphere(scene, {0, 0, 0}, 1.0f, 1);
    addSphere(scene, {0, 0, 2}, 1.0f, 2);
    const OcclusionScene traced(scene);
    for (double polar = 0.3; polar < 3.1; polar += 0.2) {
        const glm::dvec3 normal(std::sin(polar), 0.0, std::cos(polar));
        const glm::dvec3 toOther = glm::dvec3(0, 0, 2) - normal;
        const double angle = std::acos(glm::dot(glm::normalize(toOther), normal));
        EXPECT_NEAR(traced.occlusionAt(normal, normal, kRays), 1.0 - sphereFactor(glm::length(toOther), angle),
                    kTolerance)
            << polar;
    }
}

TEST(AmbientOcclusion, GiantSphereActsAsAPlane) {
    // An element tilted by b from a floor's normal sees the floor by (1 - cos b) / 2. The sphere falls away from its
    // tangent plane at the horizon, an angle sqrt(2 h / R) = 0.01 that makes for a factor of at most 0.005.
    Representation scene;
    addSphere(scene, {0, 0, -20000}, 20000.0f, 1);
    const OcclusionScene traced(scene);
    for (double tilt = 0.0; tilt < 3.0; tilt += 0.25) {
        const glm::dvec3 normal(std::sin(tilt), 0.0, std::cos(tilt));
        EXPECT_NEAR(traced.occlusionAt({0, 0, 1}, normal, kRays), (1.0 + std::cos(tilt)) / 2.0, 0.005 + kTolerance);
    }
}

TEST(AmbientOcclusion, CapOfARodActsAsADisc) {
    // The element on the axis faces the cap: R^2 / (R^2 + h^2), and the side hides behind it.
    Representation scene;
    addRod(scene, {0, 0, 2}, {0, 0, 9}, 1.5f, 1, 2);
    const OcclusionScene traced(scene);
    for (const double height : {0.1, 0.5, 1.5, 4.0}) {
        const double factor = 2.25 / (2.25 + height * height);
        EXPECT_NEAR(traced.occlusionAt({0, 0, 2.0 - height}, {0, 0, 1}, kRays), 1.0 - factor, kTolerance);
    }
}

TEST(AmbientOcclusion, LongRodBlocksItsViewFactor) {
    // The element faces the axis of an endless rod at distance d: R / d.
    Representation scene;
    addRod(scene, {-2000, 0, 0}, {2000, 0, 0}, 1.0f, 1, 2);
    const OcclusionScene traced(scene);
    for (const double distance : {1.5, 2.0, 5.0})
        EXPECT_NEAR(traced.occlusionAt({0, 0, distance}, {0, 0, -1}, kRays), 1.0 - 1.0 / distance, kTolerance);
}

TEST(AmbientOcclusion, InsideEverythingIsClosed) {
    Representation scene;
    addSphere(scene, {0, 0, 0}, 2.0f, 1);
    addRod(scene, {10, 0, 0}, {20, 0, 0}, 2.0f, 1, 2);
    const OcclusionScene traced(scene);
    EXPECT_EQ(traced.occlusionAt({0.5, 0, 0}, {0, 0, 1}), 0.0);
    EXPECT_EQ(traced.occlusionAt({15, 0.5, 0}, {0, 0, 1}), 0.0);
}

TEST(AmbientOcclusion, SameSeedSameNumber) {
    Representation scene;
    addSphere(scene, {0, 0, 3}, 2.0f, 1);
    const OcclusionScene traced(scene);
    const double once = traced.occlusionAt({0, 0, 0}, {0.6, 0, 0.8}, 4096, 5);
    EXPECT_EQ(once, traced.occlusionAt({0, 0, 0}, {0.6, 0, 0.8}, 4096, 5));
    // Fewer rays than asked for are never cast: a share of 8 x 8 rays, not of 7 x 7.
    const double few = 64.0 * traced.occlusionAt({0, 0, 0}, {0.6, 0, 0.8}, 50);
    EXPECT_EQ(few, std::round(few));
}

Representation pileOfSpheres() {
    Representation scene;
    std::mt19937_64 engine(3);
    std::uniform_real_distribution<double> length(0.0, 9.0);
    for (std::uint32_t i = 0; i < 250; ++i)
        addSphere(scene, glm::vec3(length(engine) * randomDirection(engine)), 1.7f, i + 1);
    return scene;
}

TEST(AmbientOcclusion, RandomPointsAreOnTheOutsideAndRepeat) {
    const Representation scene = pileOfSpheres();
    const std::vector<SurfacePoint> points = randomVisiblePoints(scene, 500, 9);
    ASSERT_EQ(points.size(), 500u);
    for (const SurfacePoint& point : points) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Sphere& sphere : scene.spheres)
            nearest = std::min(nearest, glm::length(point.position - glm::dvec3(sphere.center)) - sphere.radius);
        EXPECT_NEAR(nearest, 0.0, 1e-12);
        const Sphere& own = scene.spheres.at(point.primitive);
        const glm::dvec3 outward = (point.position - glm::dvec3(own.center)) / double{own.radius};
        EXPECT_NEAR(glm::length(outward - point.normal), 0.0, 1e-12);
    }
    EXPECT_EQ(randomVisiblePoints(scene, 500, 9)[499].position, points[499].position);
    EXPECT_NE(randomVisiblePoints(scene, 500, 10)[499].position, points[499].position);
    EXPECT_TRUE(randomVisiblePoints(scene, 0).empty());
    EXPECT_EQ(randomVisiblePoints(scene, 1).size(), 1u);
}

TEST(AmbientOcclusion, RandomPointsOfALoneSphereLieEvenly) {
    Representation scene;
    addSphere(scene, {0, 0, 0}, 2.0f, 1);
    glm::dvec3 sum(0.0), squares(0.0);
    for (const SurfacePoint& point : randomVisiblePoints(scene, 4000)) {
        sum += point.normal;
        squares += point.normal * point.normal;
    }
    // 16 views, each with mean normal 2/3 toward its viewer: standard deviation of a component about 2/3 / sqrt(48).
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(sum[k] / 4000.0, 0.0, 0.4);
        EXPECT_NEAR(squares[k] / 4000.0, 1.0 / 3.0, 0.15);
    }
}

TEST(AmbientOcclusion, RandomPointsNeedSomethingToSee) {
    EXPECT_THROW(randomVisiblePoints(Representation{}, 10), std::invalid_argument);
}

TEST(AmbientOcclusion, AgreesWithRaysCastOneByOne) {
    // The same integral by the double-precision solids and plain random directions: shares no code with Embree.
    Representation scene = pileOfSpheres();
    for (std::size_t i = 1; i < 60; ++i)
        addRod(scene, scene.spheres[i - 1].center * 1.2f, scene.spheres[i].center * 1.2f, 0.4f, 1, 2);
    const OcclusionScene traced(scene);
    std::mt19937_64 engine(11);
    for (const SurfacePoint& point : randomVisiblePoints(scene, 40)) {
        constexpr int kCount = 2000;
        int open = 0;
        for (int i = 0; i < kCount; ++i) {
            // Normal plus an even direction is cosine-weighted.
            const Line line{point.position + 1e-9 * point.normal,
                            glm::normalize(point.normal + randomDirection(engine))};
            bool blocked = false;
            for (std::size_t k = 0; k < scene.spheres.size() && !blocked; ++k) {
                const auto hit = cross(line, Ball{scene.spheres[k].center, scene.spheres[k].radius});
                blocked = k != point.primitive && hit && hit->leave > 0.0;
            }
            for (std::size_t k = 0; k < scene.cylinders.size() && !blocked; ++k) {
                const Cylinder& rod = scene.cylinders[k];
                const auto hit = cross(line, Rod{rod.a, rod.b, rod.radius});
                blocked = k + scene.spheres.size() != point.primitive && hit && hit->leave > 0.0;
            }
            if (!blocked) ++open;
        }
        // Five standard deviations of the plain estimate, and what the lift of 1e-3 A may change.
        EXPECT_NEAR(traced.occlusionAt(point.position, point.normal), open / double{kCount},
                    5.0 * 0.5 / std::sqrt(double{kCount}) + 0.004);
    }
}

TEST(AmbientOcclusion, VisiblePointsOfAPileAreHalfOpen) {
    const Representation scene = pileOfSpheres();
    const std::vector<SurfacePoint> points = randomVisiblePoints(scene, 200);
    const OcclusionScene traced(scene);
    double sum = 0.0;
    for (const SurfacePoint& point : points) sum += traced.occlusionAt(point.position, point.normal);
    EXPECT_GT(sum / 200.0, 0.3);
    EXPECT_LT(sum / 200.0, 0.95);
}

}  // namespace
}  // namespace nacre::reference
