// Cameras of a headset's eyes, judged by the projection that OpenXR's specification states.

#include "app/xr/eyes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace nacre::app {
namespace {

constexpr std::uint32_t kWidth = 640, kHeight = 600;

std::array<EyePose, 2> lookingAhead() {
    std::array<EyePose, 2> eyes;
    const glm::dquat head = glm::angleAxis(0.2, glm::normalize(glm::dvec3(0.3, 1, -0.2)));
    for (std::size_t i = 0; i < 2; ++i) {
        const double side = i == 0 ? -1 : 1;
        eyes[i].orientation = head;
        eyes[i].position = glm::dvec3(0.1, 1.6, 0.3) + head * glm::dvec3(side * 0.032, 0, 0);
        eyes[i].left = i == 0 ? -1.1 : -0.9, eyes[i].right = i == 0 ? 0.9 : 1.1;
        eyes[i].down = -1.2, eyes[i].up = 0.95;
    }
    return eyes;
}

Placement molecule() {
    Placement p;
    p.center = {-0.05, 1.5, -0.5};
    p.rotation = glm::mat3_cast(glm::angleAxis(1.1, glm::normalize(glm::dvec3(1, 2, 3))));
    p.metresPerAngstrom = 0.01;
    p.radius = 25;
    return p;
}

/// The pixel of a point of the room: its tangents, between those of the picture's edges.
glm::dvec2 toPixel(const EyePose& eye, const glm::dvec3& point) {
    const glm::dvec3 e = glm::inverse(eye.orientation) * (point - eye.position);
    const glm::dvec2 t(e.x / -e.z, e.y / -e.z);
    return {(t.x - eye.left) / (eye.right - eye.left) * kWidth, (eye.up - t.y) / (eye.up - eye.down) * kHeight};
}

/// As camera.h says.
glm::dvec2 toPixel(const View& view, const glm::dvec3& atom) {
    const glm::dvec3 v = view.rotation * atom + view.shift;
    const glm::dvec2 plane = glm::dvec2(v) * (view.eyeDistance / (view.eyeDistance - v.z));
    return {(plane.x + view.pan.x) * view.pixelsPerAngstrom + view.width / 2.0,
            view.height / 2.0 - (plane.y + view.pan.y) * view.pixelsPerAngstrom};
}

TEST(HeadsetEyes, AtomsAreWhereOpenXrProjectsThem) {
    const Placement p = molecule();
    for (const bool canted : {false, true}) {
        auto eyes = lookingAhead();
        if (canted) eyes[1].orientation = eyes[1].orientation * glm::angleAxis(-0.1, glm::dvec3(0, 1, 0));
        const EyeViews seen = makeViews(p, eyes, kWidth, kHeight);
        for (const glm::dvec3 atom : {glm::dvec3(0), glm::dvec3(10, -4, 3), glm::dvec3(-3, 14, -9)})
            for (std::size_t i = 0; i < 2; ++i) {
                const glm::dvec3 there = p.center + p.metresPerAngstrom * (p.rotation * atom);
                EXPECT_LT(glm::distance(toPixel(seen.views[i], atom), toPixel(seen.eyes[i], there)), 1e-6);
            }
    }
}

TEST(HeadsetEyes, PixelsAreSquaresAndShowAllThatTheEyeSees) {
    const auto eyes = lookingAhead();
    const EyeViews seen = makeViews(molecule(), eyes, kWidth, kHeight);
    for (std::size_t i = 0; i < 2; ++i) {
        const EyePose& wide = seen.eyes[i];
        EXPECT_NEAR((wide.right - wide.left) / kWidth, (wide.up - wide.down) / kHeight, 1e-12);
        EXPECT_LE(wide.left, eyes[i].left + 1e-12);
        EXPECT_GE(wide.right, eyes[i].right - 1e-12);
        EXPECT_LE(wide.down, eyes[i].down + 1e-12);
        EXPECT_GE(wide.up, eyes[i].up - 1e-12);
    }
}

TEST(HeadsetEyes, ParallelEyesDifferByShiftAndPanAlone) {
    auto eyes = lookingAhead();
    eyes[1].position += glm::dvec3(1e-8, -2e-8, 1e-8);  // as floats round
    const EyeViews seen = makeViews(molecule(), eyes, kWidth, kHeight);
    View right = otherView(paired(seen.views[0], seen.views[1]));
    EXPECT_EQ(right.rotation, seen.views[1].rotation);
    EXPECT_EQ(right.eyeDistance, seen.views[1].eyeDistance);
    EXPECT_EQ(right.pixelsPerAngstrom, seen.views[1].pixelsPerAngstrom);
    EXPECT_EQ(right.shift.y, seen.views[1].shift.y);
    EXPECT_EQ(right.pan.y, seen.views[1].pan.y);
    EXPECT_NEAR(seen.views[0].shift.x - seen.views[1].shift.x, 6.4, 1e-5);
}

TEST(HeadsetEyes, AHeadPushesTheMoleculeThatItWouldEnter) {
    const auto eyes = lookingAhead();
    Placement p = molecule();
    p.center = eyes[0].position + eyes[0].orientation * glm::dvec3(0, 0, -0.1);
    const Placement shown = keepInFront(p, eyes);
    EXPECT_EQ(shown.center, p.center);
    for (const EyePose& eye : eyes) {
        const double ahead = -(glm::inverse(eye.orientation) * (p.center - eye.position)).z;
        EXPECT_GT(ahead, p.radius * p.metresPerAngstrom);
    }
}

TEST(HeadsetEyes, AMoleculeBehindTheHeadStaysAndDoesNotShow) {
    const auto eyes = lookingAhead();
    Placement p = molecule();
    p.center = eyes[0].position + eyes[0].orientation * glm::dvec3(0, 0, 0.7);
    const glm::dvec3 before = p.center;
    const Placement shown = keepInFront(p, eyes);
    EXPECT_EQ(p.center, before);
    const EyeViews seen = makeViews(shown, eyes, kWidth, kHeight);
    for (const View& view : seen.views) {
        EXPECT_GT(view.eyeDistance, view.radius);
        EXPECT_GT(toPixel(view, {0, 0, 0}).x - view.radius * view.pixelsPerAngstrom, kWidth);
    }
}

TEST(HeadsetEyes, AHandTurnsAndScalesWhatItHolds) {
    const glm::dquat start = glm::angleAxis(0.4, glm::dvec3(0, 0, 1));
    const glm::dvec3 head(0, 1.6, 0);
    Pose hand{{0, 1.6, -0.5}, glm::angleAxis(0.3, glm::dvec3(1, 0, 0))};
    const Grip grip(hand, head, start, 1.5);
    EXPECT_NEAR(grip.zoom(hand), 1.5, 1e-12);
    EXPECT_NEAR(std::abs(glm::dot(grip.orientation(hand), start)), 1, 1e-12);
    hand.position.z += Grip::kMetresPerDouble;
    const glm::dquat turn = glm::angleAxis(0.5, glm::dvec3(0, 1, 0));
    hand.orientation = turn * hand.orientation;
    EXPECT_NEAR(grip.zoom(hand), 3, 1e-12);
    EXPECT_NEAR(std::abs(glm::dot(grip.orientation(hand), turn * start)), 1, 1e-12);
}

}  // namespace
}  // namespace nacre::app
