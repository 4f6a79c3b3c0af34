#include "engine/scene/view/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <utility>

namespace nacre {
namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

void expectSame(const glm::dmat3& a, const glm::dmat3& b, double tolerance) {
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) EXPECT_NEAR(a[column][row], b[column][row], tolerance) << column << row;
}

TEST(Camera, QuarterTurnsAreRightHandedAndExact) {
    const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    EXPECT_EQ(rotationMatrix({90, 0, 0}) * y, z);
    EXPECT_EQ(rotationMatrix({90, 0, 0}) * z, -y);
    EXPECT_EQ(rotationMatrix({0, 90, 0}) * z, x);
    EXPECT_EQ(rotationMatrix({0, 90, 0}) * x, -z);
    EXPECT_EQ(rotationMatrix({0, 0, 90}) * x, y);
    EXPECT_EQ(rotationMatrix({0, 0, 90}) * y, -x);
    EXPECT_EQ(rotationMatrix({0, 0, -90}) * x, -y);
    EXPECT_EQ(rotationMatrix({0, 0, 180}) * x, -x);
    EXPECT_EQ(rotationMatrix({0, 0, -180}) * x, -x);
    EXPECT_EQ(rotationMatrix({0, 0, 270}) * x, -y);
    EXPECT_EQ(rotationMatrix({0, 0, 450}) * x, y);
    EXPECT_EQ(rotationMatrix({360, -720, 1080}), glm::dmat3(1.0));
}

TEST(Camera, TurnsAboutXFirstThenYThenZ) {
    const glm::dvec3 y(0, 1, 0);
    EXPECT_EQ(rotationMatrix({90, 90, 0}) * y, glm::dvec3(1, 0, 0));   // y -> z -> x
    EXPECT_EQ(rotationMatrix({90, 90, 90}) * y, glm::dvec3(0, 1, 0));  // y -> z -> x -> y
    EXPECT_EQ(rotationMatrix({0, 90, 90}) * y, glm::dvec3(-1, 0, 0));  // y -> y -> -x
}

TEST(Camera, AnyTurnIsThatOfQuaternions) {
    for (const glm::dvec3 degrees : {glm::dvec3(10, 20, 30), glm::dvec3(-75, 140, 333), glm::dvec3(0, 12.5, 0),
                                     glm::dvec3(91, 90, 1e-3), glm::dvec3(725, -1000, 45)}) {
        const auto about = [](double angle, const glm::dvec3& axis) { return glm::angleAxis(radians(angle), axis); };
        const glm::dquat turn = about(degrees.z, {0, 0, 1}) * about(degrees.y, {0, 1, 0}) * about(degrees.x, {1, 0, 0});
        const glm::dmat3 matrix = rotationMatrix(degrees);
        expectSame(matrix, glm::mat3_cast(turn), 1e-13);
        expectSame(matrix * glm::transpose(matrix), glm::dmat3(1.0), 1e-15);
        EXPECT_NEAR(glm::determinant(matrix), 1.0, 1e-15);
    }
}

TEST(Camera, OrthographicSphereFills95PercentOfTheShorterSide) {
    for (const auto& [width, height] : {std::pair{640u, 480u}, std::pair{480u, 960u}, std::pair{100u, 100u}}) {
        const View view = makeView(Camera{}, 12.5, width, height);
        EXPECT_NEAR(2.0 * 12.5 * view.pixelsPerAngstrom, 0.95 * std::min(width, height), 1e-10);
        EXPECT_EQ(view.width, width);
        EXPECT_EQ(view.height, height);
        EXPECT_EQ(view.radius, 12.5);
        EXPECT_EQ(view.eyeDistance, 0.0);
        EXPECT_EQ(view.projection, Projection::orthographic);
    }
}

TEST(Camera, ZoomScalesTheImagePlaneAlone) {
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        Camera camera{.projection = projection};
        const View plain = makeView(camera, 7.0, 300, 200);
        camera.zoom = 2.5;
        const View zoomed = makeView(camera, 7.0, 300, 200);
        EXPECT_DOUBLE_EQ(zoomed.pixelsPerAngstrom, 2.5 * plain.pixelsPerAngstrom);
        EXPECT_EQ(zoomed.eyeDistance, plain.eyeDistance);
    }
}

TEST(Camera, PerspectiveSpansTheFieldOfViewAndHoldsTheSphere) {
    for (const double fov : {5.0, 30.0, 60.0, 120.0})
        for (const auto& [width, height] : {std::pair{640u, 480u}, std::pair{480u, 960u}}) {
            Camera camera{.projection = Projection::perspective, .fovDegrees = fov};
            const double radius = 9.0, half = radians(fov) / 2.0, side = std::min(width, height);
            const View view = makeView(camera, radius, width, height);
            EXPECT_NEAR(view.eyeDistance * std::sin(half), radius / 0.95, 1e-12);
            EXPECT_GT(view.eyeDistance, radius);  // the eye stands outside

            // The edge of the shorter side, on the plane z = 0, is seen at half the field of view.
            const double edge = side / 2.0 / view.pixelsPerAngstrom;
            EXPECT_NEAR(std::atan2(edge, view.eyeDistance), half, 1e-12);

            // The sphere's tangent cone: sin of its half angle is R / D = 0.95 sin(fov / 2).
            const double cone = std::asin(radius / view.eyeDistance);
            EXPECT_NEAR(std::sin(cone), 0.95 * std::sin(half), 1e-12);
            const double diameter = 2.0 * view.eyeDistance * std::tan(cone) * view.pixelsPerAngstrom;
            EXPECT_LT(diameter, side);
            EXPECT_NEAR(diameter / side, std::tan(cone) / std::tan(half), 1e-12);
            if (fov <= 30.0) {  // near the axis sine and tangent agree: about 95 % there too
                EXPECT_NEAR(diameter / side, 0.95, 0.01);
            }
        }
}

TEST(Camera, ViewCarriesTheRotation) {
    EXPECT_EQ(makeView(Camera{.rotationDegrees = {10, 20, 30}}, 1.0, 10, 10).rotation, rotationMatrix({10, 20, 30}));
}

void expectSameView(const View& a, const View& b) {
    expectSame(a.rotation, b.rotation, 1e-12);
    EXPECT_NEAR(a.pixelsPerAngstrom, b.pixelsPerAngstrom, 1e-9 * a.pixelsPerAngstrom);
    EXPECT_NEAR(a.eyeDistance, b.eyeDistance, 1e-9 * std::max(a.eyeDistance, 1.0));
    EXPECT_NEAR(glm::distance(a.pan, b.pan), 0, 1e-12);
}

Camera anyCamera(Projection projection) {
    Camera camera;
    camera.projection = projection;
    camera.rotationDegrees = {20, -70, 130};
    camera.orientation = glm::normalize(glm::dquat(0.3, 0.5, -0.7, 0.2));
    camera.pan = {3, -1.5};
    camera.zoom = 1.7;
    camera.fovDegrees = 40;
    return camera;
}

TEST(Camera, AnAbsoluteOneMakesItsViewWhateverIsDrawn) {
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        const Camera camera = anyCamera(projection);
        const View view = makeView(camera, 20, 640, 480);
        const Camera absolute = absoluteCamera(view, camera.fovDegrees, {1, 2, 3});
        EXPECT_EQ(absolute.center, glm::dvec3(1, 2, 3));
        for (const double radius : {5.0, 20.0, 35.0}) expectSameView(makeView(absolute, radius, 640, 480), view);
        // The shorter side shows as much in a picture of another size.
        EXPECT_NEAR(makeView(absolute, 20, 480, 960).pixelsPerAngstrom, view.pixelsPerAngstrom, 1e-9);
        EXPECT_NEAR(makeView(absolute, 20, 1280, 960).pixelsPerAngstrom, 2 * view.pixelsPerAngstrom, 1e-9);
    }
}

TEST(Camera, ARelativeOneMakesTheSameViewByZoomAndRadius) {
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        const View view = makeView(anyCamera(projection), 20, 640, 480);
        const Camera absolute = absoluteCamera(view, 40, {});
        double radius = 12;  // of another scene
        const Camera relative = relativeCamera(absolute, radius);
        EXPECT_FALSE(relative.scale || relative.eyeDistance);
        expectSameView(makeView(relative, radius, 640, 480), view);
        if (projection == Projection::orthographic) {
            EXPECT_EQ(radius, 12);
        }
        // It zooms on from there.
        Camera nearer = relative;
        nearer.zoom *= 2;
        EXPECT_NEAR(makeView(nearer, radius, 640, 480).pixelsPerAngstrom, 2 * view.pixelsPerAngstrom, 1e-9);
    }
}

}  // namespace
}  // namespace nacre
