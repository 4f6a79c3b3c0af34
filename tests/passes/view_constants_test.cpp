#include "engine/passes/view_constants.h"

#include <gtest/gtest.h>

namespace nacre::passes {
namespace {

View viewOfSphere(Projection projection) { return makeView(Camera{.projection = projection}, 10, 200, 100); }

layout::ViewConstants makeConstants(const View& view) {
    return viewConstants(view, view.width / 2.0, view.height / 2.0);
}

TEST(ViewConstants, TheEdgesOfThePictureAreThoseOfTheClipSpace) {
    const View view = viewOfSphere(Projection::orthographic);
    const layout::ViewConstants c = makeConstants(view);
    // Å from the middle to the right and to the upper edge; Vulkan's y points down.
    EXPECT_EQ(c.extent, view.width | view.height << 16);
    EXPECT_NEAR(c.pixel * view.pixelsPerAngstrom, 1, 1e-6);
}

TEST(ViewConstants, DepthSpansTheSphereAndAnAngstromBeforeAndBehindIt) {
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        const View view = viewOfSphere(projection);
        const layout::ViewConstants c = makeConstants(view);
        const auto depth = [&](double z) { return (c.origin - z - c.depthStart) * c.perRange; };
        EXPECT_NEAR(depth(view.radius + 1), 0, 1e-5);
        EXPECT_NEAR(depth(-view.radius - 1), 1, 1e-5);
        EXPECT_NEAR(depth(0), 0.5, 1e-5);
    }
}

TEST(ViewConstants, DistancesCountFromTheEyeOrFromTheNearestPlane) {
    const View ortho = viewOfSphere(Projection::orthographic), perspective = viewOfSphere(Projection::perspective);
    EXPECT_FLOAT_EQ(makeConstants(ortho).origin, static_cast<float>(ortho.radius));
    EXPECT_FLOAT_EQ(makeConstants(perspective).origin, static_cast<float>(perspective.eyeDistance));
    EXPECT_GT(perspective.eyeDistance, perspective.radius);
}

TEST(ViewConstants, PanMovesTheMiddleAndTurnsWithTheImage) {
    View view = viewOfSphere(Projection::orthographic);
    view.pan = glm::dvec2(30, 7) / view.pixelsPerAngstrom;  // right and up
    // Clockwise: right becomes down, up becomes right.
    const glm::vec2 expected[] = {{130, 43}, {107, 80}, {70, 57}, {93, 20}};
    for (int turns = 0; turns < 4; ++turns) {
        view.quarterTurns = turns;
        const glm::vec2 middle = makeConstants(view).axisPixel;
        EXPECT_NEAR(middle.x, expected[turns].x, 1e-4) << turns;
        EXPECT_NEAR(middle.y, expected[turns].y, 1e-4) << turns;
    }
}

}  // namespace
}  // namespace nacre::passes
