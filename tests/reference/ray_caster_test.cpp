#include "tests/reference/ray_caster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <numbers>
#include <optional>
#include <random>

#include "tests/reference/scenes.h"

namespace nacre::reference {
namespace {

/// A pixel's place on the plane z = 0, written out from camera.h once more.
glm::dvec2 planePoint(const View& view, std::uint32_t column, std::uint32_t row) {
    return {(2.0 * column + 1.0 - view.width) / (2.0 * view.pixelsPerAngstrom),
            (view.height - 2.0 * row - 1.0) / (2.0 * view.pixelsPerAngstrom)};
}

glm::dvec3 normalAt(const Layers& layers, std::size_t at) { return {layers.nx[at], layers.ny[at], layers.nz[at]}; }

template <typename Visit>
void forEachPixel(const Layers& layers, Visit visit) {
    for (std::uint32_t row = 0; row < layers.height; ++row)
        for (std::uint32_t column = 0; column < layers.width; ++column) visit(column, row, layers.index(column, row));
}

void expectBackground(const Layers& layers, std::size_t at) {
    EXPECT_EQ(layers.id[at], 0u);
    EXPECT_EQ(layers.primitive[at], kNoPrimitive);
    EXPECT_EQ(layers.z[at], std::numeric_limits<float>::infinity());
    EXPECT_EQ(normalAt(layers, at), glm::dvec3(0.0));
}

TEST(RayCaster, OrthographicSphereHasItsExactDepthAndNormal) {
    Representation scene;
    addSphere(scene, {1.0f, -0.5f, 2.0f}, 1.5f, 42);
    View view = viewOfScene(scene, Projection::orthographic, 97, 64);
    const Layers layers = castRays(scene, view);
    int covered = 0;
    forEachPixel(layers, [&](std::uint32_t column, std::uint32_t row, std::size_t at) {
        const glm::dvec2 off = planePoint(view, column, row) - glm::dvec2(1.0, -0.5);
        const double rest = 1.5 * 1.5 - off.x * off.x - off.y * off.y;
        if (rest < 0.0) return expectBackground(layers, at);
        ++covered;
        EXPECT_EQ(layers.id[at], 42u);
        EXPECT_EQ(layers.primitive[at], 0u);
        EXPECT_EQ(layers.gap[at], std::numeric_limits<float>::infinity());
        EXPECT_NEAR(layers.z[at], scene.radius - (2.0 + std::sqrt(rest)), 1e-6);
        EXPECT_NEAR(glm::length(normalAt(layers, at) - glm::dvec3(off, std::sqrt(rest)) / 1.5), 0.0, 1e-6);
    });
    EXPECT_NEAR(covered, std::numbers::pi * std::pow(1.5 * view.pixelsPerAngstrom, 2), 20.0);
}

TEST(RayCaster, PerspectiveSphereLiesOnItsRayAndInItsTangentCone) {
    Representation scene;
    addSphere(scene, {1.0f, -0.5f, 2.0f}, 1.5f, 42);
    const View view = viewOfScene(scene, Projection::perspective, 97, 128);
    const Layers layers = castRays(scene, view);
    const glm::dvec3 eye(0, 0, view.eyeDistance), toCenter = glm::dvec3(1.0, -0.5, 2.0) - eye;
    const double cone = std::asin(1.5 / glm::length(toCenter));
    int covered = 0;
    forEachPixel(layers, [&](std::uint32_t column, std::uint32_t row, std::size_t at) {
        const glm::dvec2 place = planePoint(view, column, row);
        const glm::dvec3 ray(place, -view.eyeDistance);
        const double angle = std::atan2(glm::length(glm::cross(ray, toCenter)), glm::dot(ray, toCenter));
        if (angle > cone) return expectBackground(layers, at);
        ++covered;
        // Z runs along -z, so the point on the ray scales with it.
        const glm::dvec3 point = eye + ray * (layers.z[at] / view.eyeDistance);
        const glm::dvec3 outward = point - glm::dvec3(1.0, -0.5, 2.0);
        EXPECT_NEAR(glm::length(outward), 1.5, 2e-5);
        EXPECT_LE(glm::dot(outward, ray), 1e-3);  // the near of the two roots
        EXPECT_NEAR(glm::length(normalAt(layers, at) - outward / 1.5), 0.0, 2e-5);
    });
    EXPECT_GT(covered, 1000);
}

TEST(RayCaster, PerspectiveSphereAtTheCentreCoversItsDisc) {
    Representation scene;
    addSphere(scene, {0, 0, 0}, 2.0f, 1);
    const View view = viewOfScene(scene, Projection::perspective, 300, 200);
    const Layers layers = castRays(scene, view);
    const double radius = std::tan(std::asin(2.0 / view.eyeDistance)) * view.eyeDistance * view.pixelsPerAngstrom;
    EXPECT_LT(radius, 100.0);
    EXPECT_GT(radius, 90.0);
    const auto covered = std::count(layers.id.begin(), layers.id.end(), 1u);
    EXPECT_NEAR(static_cast<double>(covered), std::numbers::pi * radius * radius, 0.002 * 40000);
}

TEST(RayCaster, TwoSpheresMeetInTheirRadicalPlane) {
    // Along z, the heights over the plane z = 0 are equal where x = (d^2 + r1^2 - r2^2) / (2 d).
    Representation scene;
    addSphere(scene, {0, 0, 0}, 2.0f, 7);
    addSphere(scene, {1.5f, 0, 0}, 1.25f, 9);
    const View view = viewOfScene(scene, Projection::orthographic, 200, 200);
    const Layers layers = castRays(scene, view);
    const double plane = (1.5 * 1.5 + 2.0 * 2.0 - 1.25 * 1.25) / 3.0;
    int first = 0, second = 0;
    forEachPixel(layers, [&](std::uint32_t column, std::uint32_t row, std::size_t at) {
        const glm::dvec2 place = planePoint(view, column, row);
        const double one = 4.0 - glm::dot(place, place);
        const double two = 1.5625 - (place.x - 1.5) * (place.x - 1.5) - place.y * place.y;
        if (one < 0.0 && two < 0.0) return expectBackground(layers, at);
        EXPECT_EQ(layers.id[at], (one < 0.0 || (two >= 0.0 && place.x > plane)) ? 9u : 7u);
        ++(layers.id[at] == 9 ? second : first);
        if (one >= 0.0 && two >= 0.0) {
            EXPECT_NEAR(layers.gap[at], std::abs(std::sqrt(one) - std::sqrt(two)), 1e-6);
        } else {
            EXPECT_EQ(layers.gap[at], std::numeric_limits<float>::infinity());
        }
    });
    EXPECT_GT(first, 1000);
    EXPECT_GT(second, 1000);
}

TEST(RayCaster, EqualSpheresTieAndTheFirstWins) {
    Representation scene;
    addSphere(scene, {0, 0, 0}, 1.0f, 3);
    addSphere(scene, {0, 0, 0}, 1.0f, 4);
    const Layers layers = castRays(scene, viewOfScene(scene, Projection::orthographic, 64, 64));
    const std::size_t middle = layers.index(32, 32);
    EXPECT_EQ(layers.id[middle], 3u);
    EXPECT_EQ(layers.gap[middle], 0.0f);
}

TEST(RayCaster, RotationTurnsTheSceneAsTheCameraSays) {
    Representation scene;
    addSphere(scene, {5, 0, 0}, 1.0f, 1);
    addSphere(scene, {0, 3, 0}, 1.0f, 2);
    // A quarter turn about z takes +x up and +y to the left.
    const View view = viewOfScene(scene, Projection::orthographic, 100, 100, {0, 0, 90});
    const Layers layers = castRays(scene, view);
    const auto row = static_cast<std::uint32_t>(50.0 - 5.0 * view.pixelsPerAngstrom);
    const auto column = static_cast<std::uint32_t>(50.0 - 3.0 * view.pixelsPerAngstrom);
    EXPECT_EQ(layers.id[layers.index(50, row)], 1u);
    EXPECT_EQ(layers.id[layers.index(column, 50)], 2u);
}

TEST(RayCaster, RodShowsItsTwoHalvesAndItsCaps) {
    Representation scene;
    addRod(scene, {-3, 0, 0}, {3, 0, 0}, 0.5f, 11, 12);
    const View flat = viewOfScene(scene, Projection::orthographic, 121, 61);
    const Layers side = castRays(scene, flat);
    forEachPixel(side, [&](std::uint32_t column, std::uint32_t row, std::size_t at) {
        const glm::dvec2 place = planePoint(flat, column, row);
        if (std::abs(place.x) > 3.0 || std::abs(place.y) > 0.5) return expectBackground(side, at);
        const bool atMiddle = std::abs(place.x) < 1e-9;  // either half may own it
        EXPECT_TRUE(atMiddle || side.id[at] == (place.x < 0.0 ? 11u : 12u));
        EXPECT_NEAR(side.z[at], scene.radius - std::sqrt(0.25 - place.y * place.y), 1e-6);
    });
    // Turned by 90 degrees about y, +x points away from the viewer: the cap of a stands in front.
    const View onEnd = viewOfScene(scene, Projection::orthographic, 61, 61, {0, 90, 0});
    const Layers cap = castRays(scene, onEnd);
    const std::size_t middle = cap.index(30, 30);
    EXPECT_EQ(cap.id[middle], 11u);
    EXPECT_NEAR(cap.z[middle], scene.radius - 3.0, 1e-6);
    EXPECT_NEAR(cap.nz[middle], 1.0, 1e-12);
    EXPECT_EQ(cap.gap[middle], std::numeric_limits<float>::infinity());
}

/// Every primitive against every pixel: shows that no bounding rectangle cuts anything off.
Layers withoutBounds(const Representation& scene, const View& view) {
    Layers layers = emptyLayers(view.width, view.height);
    forEachPixel(layers, [&](std::uint32_t column, std::uint32_t row, std::size_t at) {
        const Line line = pixelLine(view, column, row);
        double nearest = std::numeric_limits<double>::infinity();
        const auto offer = [&](const std::optional<Crossing>& crossing, std::uint32_t atomA, std::uint32_t atomB) {
            if (!crossing || crossing->enter >= nearest) return;
            nearest = crossing->enter;
            layers.id[at] = crossing->along < 0.5 ? atomA : atomB;
        };
        for (std::size_t i = 0; i < scene.spheres.size(); ++i)
            offer(cross(line, Ball{view.rotation * glm::dvec3(scene.spheres[i].center), scene.spheres[i].radius}),
                  scene.sphereLooks[i].atom, scene.sphereLooks[i].atom);
        for (std::size_t i = 0; i < scene.cylinders.size(); ++i)
            offer(cross(line, Rod{view.rotation * glm::dvec3(scene.cylinders[i].a),
                                  view.rotation * glm::dvec3(scene.cylinders[i].b), scene.cylinders[i].radius}),
                  scene.cylinderLooks[i].atomA, scene.cylinderLooks[i].atomB);
    });
    return layers;
}

/// A ball of atoms as dense as a protein, each bonded to the next.
Representation cloud(std::uint32_t atoms) {
    std::mt19937 engine(5);
    std::uniform_real_distribution<float> spread(-1.0f, 1.0f);
    const auto reach = static_cast<float>(std::cbrt(atoms * 15.0 * 3.0 / (4.0 * std::numbers::pi)));  // 15 A^3 each
    Representation scene;
    while (scene.spheres.size() < atoms) {
        const glm::vec3 place(spread(engine), spread(engine), spread(engine));
        if (glm::length(place) > 1.0f) continue;
        const auto id = static_cast<std::uint32_t>(scene.spheres.size() + 1);
        addSphere(scene, reach * place, 0.4f, id);
        if (id > 1) addRod(scene, scene.spheres[id - 2].center, reach * place, 0.15f, id - 1, id);
    }
    return scene;
}

TEST(RayCaster, BoundingRectanglesCutNothingOff) {
    const Representation scene = cloud(40);
    for (const Projection projection : {Projection::orthographic, Projection::perspective})
        for (const double zoom : {1.0, 3.0}) {
            const View view = viewOfScene(scene, projection, 90, 70, {30, 40, 50}, zoom);
            const Layers layers = castRays(scene, view);
            EXPECT_EQ(layers.id, withoutBounds(scene, view).id);
            EXPECT_GT(std::count(layers.id.begin(), layers.id.end(), 0u), 100);
        }
}

TEST(RayCaster, WideFieldsOfViewCutNothingOff) {
    // Near the eye a sphere's image reaches far beyond its radius over its distance.
    Representation scene;
    addSphere(scene, {0.5f, 0.25f, 0.5f}, 2.0f, 1);
    addRod(scene, {-1.0f, -1.5f, 1.5f}, {2.0f, -1.0f, 0.5f}, 0.8f, 2, 3);
    Camera camera{.projection = Projection::perspective, .fovDegrees = 120.0};
    const View view = makeView(camera, scene.radius, 200, 160);
    const Layers layers = castRays(scene, view);
    EXPECT_EQ(layers.id, withoutBounds(scene, view).id);
    for (const std::uint32_t atom : {1u, 2u, 3u}) EXPECT_GT(std::count(layers.id.begin(), layers.id.end(), atom), 100);
}

TEST(RayCaster, SurfacePointsLieOnTheirPrimitives) {
    const Representation scene = cloud(200);
    const View view = viewOfScene(scene, Projection::perspective, 80, 80, {20, 70, 10});
    const Layers layers = castRays(scene, view);
    int points = 0;
    forEachPixel(layers, [&](std::uint32_t column, std::uint32_t row, std::size_t at) {
        const auto point = surfacePoint(scene, view, layers, column, row);
        ASSERT_EQ(point.has_value(), layers.id[at] != 0);
        if (!point) return;
        ++points;
        if (point->primitive < scene.spheres.size()) {
            const Sphere& sphere = scene.spheres[point->primitive];
            const glm::dvec3 outward = point->position - glm::dvec3(sphere.center);
            EXPECT_NEAR(glm::length(outward - double{sphere.radius} * point->normal), 0.0, 1e-12);
        }
        const glm::dvec3 seen = view.rotation * point->position;
        EXPECT_NEAR(view.eyeDistance - seen.z, layers.z[at], 1e-5);
        EXPECT_NEAR(glm::length(view.rotation * point->normal - normalAt(layers, at)), 0.0, 1e-6);
    });
    EXPECT_GT(points, 500);
}

}  // namespace
}  // namespace nacre::reference
