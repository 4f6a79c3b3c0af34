// Paths of a movie's camera, against what a path has to be: through its views, without a jump, without a detour.

#include "app/movie/camera_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace nacre::app {
namespace {

double angleBetween(const glm::dquat& a, const glm::dquat& b) {
    return 2 * std::acos(std::min(1.0, std::abs(glm::dot(a, b))));
}

double distance(const Lens& a, const Lens& b) {
    return angleBetween(a.rotation, b.rotation) + glm::distance(a.focus, b.focus) +
           std::abs(std::log(a.scale / b.scale)) + std::abs(a.distance - b.distance);
}

std::vector<Lens> lenses() {
    std::vector<Lens> all(4);
    all[1].rotation = glm::angleAxis(1.2, glm::dvec3(0, 1, 0));
    all[1].focus = {3, -2, 1};
    all[1].scale = 8;
    all[2].rotation = -glm::angleAxis(2.9, glm::normalize(glm::dvec3(1, 1, 0)));
    all[2].focus = {3, 5, 1};
    all[2].scale = 2;
    all[3].rotation = glm::angleAxis(-1.0, glm::dvec3(1, 0, 0));
    all[3].distance = 4;
    return all;
}

TEST(CameraPath, PassesThroughEveryView) {
    for (const bool closed : {false, true}) {
        const CameraPath path(lenses(), closed);
        ASSERT_EQ(path.stretches(), closed ? 4u : 3u);
        for (std::size_t i = 0; i <= path.stretches(); ++i)
            EXPECT_LT(distance(path.at(static_cast<double>(i)), lenses()[i % 4]), 1e-6) << i;
    }
}

TEST(CameraPath, HasNoJumpAndNoKink) {
    for (const bool closed : {false, true}) {
        const CameraPath path(lenses(), closed);
        const double end = static_cast<double>(path.stretches()), step = 1e-3;
        for (double t = 0; t < end; t += step) EXPECT_LT(distance(path.at(t), path.at(t + step)), 0.05) << t;
        // The pace before a view is that after it.
        for (std::size_t i = 1; i < path.stretches(); ++i) {
            const double t = static_cast<double>(i);
            const Lens before = path.at(t - step), at = path.at(t), after = path.at(t + step);
            EXPECT_NEAR(glm::distance(at.focus, before.focus), glm::distance(at.focus, after.focus), 1e-3) << i;
            EXPECT_NEAR(angleBetween(before.rotation, at.rotation), angleBetween(at.rotation, after.rotation), 2e-4)
                << i;
        }
    }
}

TEST(CameraPath, OfTwoViewsIsTheStraightWay) {
    std::vector<Lens> two(2);
    two[1].rotation = glm::angleAxis(1.0, glm::dvec3(0, 0, 1));
    two[1].focus = {2, 0, 0};
    two[1].scale = 4;
    const Lens middle = CameraPath(two, false).at(0.5);
    EXPECT_LT(angleBetween(middle.rotation, glm::angleAxis(0.5, glm::dvec3(0, 0, 1))), 1e-7);
    EXPECT_NEAR(middle.focus.x, 1, 1e-12);
    EXPECT_NEAR(middle.scale, 2, 1e-12);
}

TEST(CameraPath, NeverOvershoots) {
    std::vector<Lens> steps(4);
    steps[2].focus = steps[3].focus = {10, 0, 0};
    const CameraPath path(steps, false);
    for (double t = 0; t <= 3; t += 0.01) {
        EXPECT_GE(path.at(t).focus.x, 0) << t;
        EXPECT_LE(path.at(t).focus.x, 10) << t;
        EXPECT_TRUE(t > 1 || path.at(t).focus.x == 0) << "what rests moves";
        EXPECT_LT(angleBetween(path.at(t).rotation, steps[0].rotation), 1e-7);
    }
}

TEST(CameraPath, ALensShowsWhatItsViewShows) {
    Camera camera{.rotationDegrees = {20, 50, -70}, .pan = {1.5, -2}, .zoom = 1.7};
    const glm::dvec3 center(3, 4, 5), other(5, 3, 4), atom(1, 7, 2);
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        camera.projection = projection;
        const View view = makeView(camera, 20, 300, 200);
        const auto pixel = [&](const View& v, const glm::dvec3& c) {
            const glm::dvec3 p = v.rotation * (atom - c);
            const double scale = v.eyeDistance > 0 ? v.eyeDistance / (v.eyeDistance - p.z) : 1;
            return (glm::dvec2(p) * scale + v.pan) * v.pixelsPerAngstrom;
        };
        EXPECT_LT(glm::distance(pixel(view, center), pixel(viewThrough(makeLens(view, center), view, center), center)),
                  1e-9);
        // Of a molecule with another centre: exact in parallel projection, in which the eye is nowhere.
        const glm::dvec2 moved =
            pixel(viewThrough(makeLens(view, center), makeView(camera, 25, 300, 200), other), other);
        EXPECT_LT(glm::distance(pixel(view, center), moved), projection == Projection::perspective ? 3 : 1e-9);
    }
}

TEST(Turned, IsRotateAboutThePicturesAxes) {
    const View view = makeView({}, 10, 100, 100);
    Camera camera{.rotationDegrees = {0, 40, 0}};
    EXPECT_EQ(turned(view, {0, 1, 0}, 40).rotation, makeView(camera, 10, 100, 100).rotation);
    EXPECT_EQ(turned(view, {0, 1, 0}, 360).rotation, view.rotation) << "a whole turn ends where it began";
    const glm::dvec3 axis = parseAxis("1,1,1");
    EXPECT_LT(glm::distance(turned(view, axis, 120).rotation * glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)), 1e-12);
}

TEST(ParseAxis, TakesNamesAndVectors) {
    EXPECT_EQ(parseAxis("z"), glm::dvec3(0, 0, 1));
    EXPECT_NEAR(glm::length(parseAxis("3,4,0")), 1, 1e-15);
    for (const char* text : {"", "w", "0,0,0", "1,2", "nan,0,1", "1e300,0,0"})
        EXPECT_THROW(parseAxis(text), std::invalid_argument) << text;
}

TEST(Easing, StartsAndEndsAtRest) {
    for (const Easing easing : {Easing::linear, Easing::smooth, Easing::stops}) {
        EXPECT_EQ(eased(easing, 0), 0);
        EXPECT_EQ(eased(easing, 1), 1);
        EXPECT_EQ(eased(easing, 0.5), 0.5);
        for (double t = 0; t < 1; t += 0.01) EXPECT_LT(eased(easing, t), eased(easing, t + 0.01));
    }
    EXPECT_LT(eased(Easing::smooth, 0.01), 0.001);
}

}  // namespace
}  // namespace nacre::app
