#include "app/viewer/camera_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace nacre::app {
namespace {

constexpr Viewport kWindow{800, 600};
constexpr double kRadius = 20;

/// Where a point of the molecule is seen, points from the window's top left.
glm::dvec2 seen(const Camera& camera, const glm::dvec3& p) {
    const View view = makeView(camera, kRadius, 800, 600);
    const glm::dvec3 v = view.rotation * p;
    const double magnify = view.projection == Projection::perspective ? view.eyeDistance / (view.eyeDistance - v.z) : 1;
    const glm::dvec2 q = (glm::dvec2(v) * magnify + view.pan) * view.pixelsPerAngstrom;
    return {400 + q.x, 300 - q.y};
}

double rotationAngle(const glm::dquat& q) { return glm::degrees(2 * std::acos(std::min(std::abs(q.w), 1.0))); }

TEST(CameraMotion, ADegreeAPointAndTheFrontFollowsTheHand) {
    CameraMotion motion;
    motion.rotate({90, 0}, 0);
    EXPECT_NEAR(rotationAngle(motion.camera().orientation), 90, 1e-9);
    const glm::dvec3 front = motion.camera().orientation * glm::dvec3(0, 0, 1);
    EXPECT_NEAR(front.x, 1, 1e-12);
    CameraMotion down;
    down.rotate({0, 90}, 0);
    EXPECT_NEAR((down.camera().orientation * glm::dvec3(0, 0, 1)).y, -1, 1e-12);
}

TEST(CameraMotion, ZoomKeepsWhatIsUnderThePointer) {
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        CameraMotion motion;
        Camera camera{.projection = projection, .rotationDegrees = {10, 20, 30}, .pan = {2, -1}, .zoom = 1.5};
        motion.set(camera);
        const glm::dvec3 point(3, 4, -2);
        const glm::dvec2 before = seen(motion.camera(), point);
        motion.zoom(1.7, before, kRadius, kWindow);
        const glm::dvec2 after = seen(motion.camera(), point);
        EXPECT_NEAR(after.x, before.x, 1e-9);
        EXPECT_NEAR(after.y, before.y, 1e-9);
        EXPECT_NEAR(motion.camera().zoom, 1.5 * 1.7, 1e-12);
    }
}

TEST(CameraMotion, PanMovesByPointsAndNeverLosesTheMolecule) {
    CameraMotion motion;
    const glm::dvec3 point(1, 2, 3);
    const glm::dvec2 before = seen(motion.camera(), point);
    motion.pan({30, -12}, kRadius, kWindow);
    EXPECT_NEAR(glm::distance(seen(motion.camera(), point), before + glm::dvec2(30, -12)), 0, 1e-9);
    for (int i = 0; i < 1000; ++i) motion.pan({100, 100}, kRadius, kWindow);
    EXPECT_LT(glm::length(motion.camera().pan), 200);
}

TEST(CameraMotion, RollTurnsThePictureClockwise) {
    CameraMotion motion;
    motion.pan({50, 0}, kRadius, kWindow);
    motion.roll(std::numbers::pi / 2);
    const glm::dvec2 centre = seen(motion.camera(), {});
    EXPECT_NEAR(centre.x, 400, 1e-9);
    EXPECT_NEAR(centre.y, 350, 1e-9);  // what was right of the middle is now below it
}

TEST(CameraMotion, InertiaIsTheSameWhateverTheSteps) {
    const auto glide = [](double step) {
        CameraMotion motion;
        for (int i = 1; i <= 20; ++i) motion.rotate({1, 0}, i * 0.01);
        motion.release(0.2);
        for (double t = 0.2; t < 3; t += step) motion.advance(t);
        return motion;
    };
    const CameraMotion fine = glide(0.001), coarse = glide(0.05);
    EXPECT_FALSE(fine.moving());
    EXPECT_FALSE(coarse.moving());
    EXPECT_GT(rotationAngle(fine.camera().orientation), 35);  // it went on after the hand's 20 degrees
    EXPECT_NEAR(rotationAngle(fine.camera().orientation), rotationAngle(coarse.camera().orientation), 2.0);
}

TEST(CameraMotion, AHandThatRestsBeforeItLetsGoLeavesThePictureAlone) {
    CameraMotion motion;
    for (int i = 1; i <= 20; ++i) motion.rotate({5, 0}, i * 0.01);
    motion.release(0.5);
    EXPECT_FALSE(motion.moving());
    EXPECT_FALSE(motion.advance(0.6));
}

TEST(CameraMotion, RocksToEitherSideAndBack) {
    CameraMotion motion;
    motion.advance(0);
    motion.setRocking(true);
    EXPECT_TRUE(motion.moving());
    const auto angle = [&] {
        const glm::dquat q = motion.camera().orientation;
        return glm::degrees(2 * std::atan2(q.y, q.w));
    };
    double least = 0, most = 0;
    for (int i = 1; i <= 400; ++i) {
        motion.advance(i * CameraMotion::kRockSeconds / 400);
        least = std::min(least, angle());
        most = std::max(most, angle());
    }
    EXPECT_NEAR(most, CameraMotion::kRockDegrees, 0.1);
    EXPECT_NEAR(least, -CameraMotion::kRockDegrees, 0.1);
    EXPECT_NEAR(angle(), 0, 1e-9) << "a swing ends where it began";
    motion.touch();
    EXPECT_FALSE(motion.moving());
}

TEST(CameraMotion, AutoRotationIsThirtyDegreesASecondAndStopsOnTouch) {
    CameraMotion motion;
    motion.advance(1.0);
    motion.setAutoRotation(true);
    for (int i = 1; i <= 100; ++i) motion.advance(1.0 + i * 0.01);
    EXPECT_NEAR(rotationAngle(motion.camera().orientation), 30, 1e-6);
    motion.touch();
    EXPECT_FALSE(motion.moving());
    EXPECT_FALSE(motion.advance(3.0));
}

TEST(CameraMotion, FitKeepsTheOrientationAndResetDoesNot) {
    CameraMotion motion;
    Camera camera{.rotationDegrees = {10, 20, 30}, .pan = {3, 3}, .zoom = 4};
    motion.set(camera);
    const glm::dquat orientation = motion.camera().orientation;
    motion.fit(1.0);
    for (double t = 1.0; motion.moving(); t += 0.02) motion.advance(t);
    EXPECT_EQ(motion.camera().zoom, 1);
    EXPECT_EQ(motion.camera().pan, glm::dvec2(0));
    EXPECT_NEAR(std::abs(glm::dot(motion.camera().orientation, orientation)), 1, 1e-12);
    motion.reset(5.0);
    for (double t = 5.0; motion.moving(); t += 0.02) motion.advance(t);
    EXPECT_EQ(motion.camera().orientation, glm::dquat(1, 0, 0, 0));
}

TEST(CameraMotion, WhatWasSetInAnglesIsSeenTheSame) {
    Camera camera;
    camera.rotationDegrees = {15, -40, 70};
    camera.orientation = glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 2, 3)));
    CameraMotion motion;
    motion.set(camera);
    const glm::dmat3 a = makeView(camera, kRadius, 10, 10).rotation,
                     b = makeView(motion.camera(), kRadius, 10, 10).rotation;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(glm::distance(a[i], b[i]), 0, 1e-12);
}

}  // namespace
}  // namespace nacre::app
