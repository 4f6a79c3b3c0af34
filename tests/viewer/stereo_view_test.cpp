// The window's view for two eyes: their parts, and their cameras.

#include <gtest/gtest.h>

#include "app/drawing/stereo.h"
#include "app/picture/options.h"
#include "tests/viewer/viewer_bench.h"

namespace nacre::app::test {
namespace {

const WindowFrame& shownBy(Bench& b, const char* mode) {
    PictureDescription look = b.viewer.view();
    setOption(option("stereo"), mode, look);
    b.viewer.setLook(look, b.now);
    b.run(2);
    return b.screen.frames.back();
}

TEST(StereoView, TheKeyGoesFromAnaglyphToSideBySideAndOn) {
    Bench b;
    b.run(1);
    EXPECT_FALSE(b.screen.frames.back().eyes);
    b.viewer.run(ViewerCommand::stereo, b.now);
    EXPECT_EQ(b.viewer.view().stereo.mode, Stereo::Mode::anaglyph);
    b.viewer.run(ViewerCommand::stereo, b.now);
    EXPECT_EQ(b.viewer.view().stereo.mode, Stereo::Mode::sideBySide);
}

TEST(StereoView, EachEyeHasItsPartOfTheWindow) {
    Bench b;
    const std::optional<std::array<WindowEye, 2>> beside = shownBy(b, "side-by-side").eyes;
    ASSERT_TRUE(beside);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ((*beside)[i].view.width, 320u);
        EXPECT_EQ((*beside)[i].view.height, 480u);
        EXPECT_EQ((*beside)[i].view.projection, Projection::perspective);
        EXPECT_EQ((*beside)[i].x, i == 0 ? 0 : 320);
    }
    const auto crossed = shownBy(b, "cross-eyed").eyes;
    EXPECT_EQ((*crossed)[0].x, 320);
    EXPECT_EQ((*crossed)[1].x, 0);
    const auto stacked = shownBy(b, "top-bottom").eyes;
    EXPECT_EQ((*stacked)[1].y, 240);
    EXPECT_EQ((*stacked)[1].view.width, 640u);
    const auto both = shownBy(b, "anaglyph").eyes;
    EXPECT_EQ((*both)[0].view.width, 640u);
    EXPECT_EQ((*both)[1].channels, kAnaglyphRight);
    EXPECT_FALSE(shownBy(b, "left").eyes);
    EXPECT_GT(b.screen.settings.back().view.shift.x, 0);  // the scene, for an eye on the left
}

TEST(StereoView, BothEyesLookInParallelAtOneScreen) {
    Bench b;
    const auto eyes = shownBy(b, "side-by-side").eyes;
    const View &left = (*eyes)[0].view, &right = (*eyes)[1].view;
    EXPECT_EQ(left.rotation, right.rotation);
    EXPECT_NEAR(left.shift.x - right.shift.x, left.eyeDistance / 30, 1e-9);
    // The picture's centre is at the screen: at one place of both parts.
    const auto projectColumn = [](const View& v, const glm::dvec3& p) {
        const glm::dvec3 at = v.seen(p);
        return at.x * v.eyeDistance / (v.eyeDistance - at.z) + v.pan.x;
    };
    EXPECT_NEAR(projectColumn(left, {}), projectColumn(right, {}), 1e-9);
    ASSERT_TRUE(left.other);
    EXPECT_NEAR(left.shift.x + left.other->shift, right.shift.x, 1e-12);
    EXPECT_NEAR(left.pan.x + left.other->pan, right.pan.x, 1e-12);
}

TEST(StereoView, TheEyesShareWhatThePanelLeavesFree) {
    for (const bool left : {true, false}) {
        SCOPED_TRACE(left);
        Bench b;
        const float panel = 160;
        b.viewer.frames().setCovered({left ? panel : 0, 0, left ? 0 : panel, 0}, b.now);
        const auto eyes = shownBy(b, "side-by-side").eyes;
        const std::vector<FreePart> parts = b.viewer.frames().freeParts();
        ASSERT_EQ(parts.size(), 2u);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_EQ(parts[i].view.width, 240u);  // of 480 that are free
            EXPECT_EQ(parts[i].corner, glm::dvec2((left ? 160 : 0) + (i == 0 ? 0 : 240), 0));
            // Both are as large, and together cover the window.
            EXPECT_EQ((*eyes)[i].view.width, 400u);
            // The molecule is in the middle of its free half.
            const View& v = (*eyes)[i].view;
            const View middle = parts[i].view;
            EXPECT_NEAR((*eyes)[i].x + v.width / 2.0 + v.pan.x * v.pixelsPerAngstrom,
                        parts[i].corner.x + 120 + middle.pan.x * middle.pixelsPerAngstrom, 1e-9);
        }
        EXPECT_LE((*eyes)[0].x, 0);
        EXPECT_EQ((*eyes)[0].x + 400, (*eyes)[1].x);
        EXPECT_GE((*eyes)[1].x + 400, 640);
        shownBy(b, "off");
        EXPECT_EQ(b.viewer.frames().freeParts().size(), 1u);
    }
}

TEST(StereoView, AnaglyphsHaveAPartOfTheWindowForEachEye) {
    Bench b;
    const auto eyes = shownBy(b, "anaglyph").eyes;
    const std::vector<FreePart> parts = b.viewer.frames().freeParts();
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].eye, OverlayEye::left);
    EXPECT_EQ(parts[1].eye, OverlayEye::right);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(parts[i].corner, glm::dvec2(0));
        EXPECT_EQ(parts[i].view.shift, (*eyes)[i].view.shift);
        EXPECT_EQ(parts[i].view.pan, (*eyes)[i].view.pan);
    }
}

}  // namespace
}  // namespace nacre::app::test
