// The resolution of a moving picture: it drops while frames are late, and returns.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/viewer/viewer_bench.h"

namespace nacre::app::test {
namespace {

TEST(Viewer, ResolutionDropsWhileFramesAreLateAndReturnsAtRest) {
    Bench b;
    b.run(2);
    b.viewer.run(ViewerCommand::autoRotate, b.now);
    b.run(3, 0.05);  // 20 frames per second
    EXPECT_LT(b.screen.frames.back().scale, 0.5);
    b.viewer.run(ViewerCommand::autoRotate, b.now);
    b.run(2);
    EXPECT_EQ(b.screen.frames.back().quality, Quality::refined);
    b.viewer.run(ViewerCommand::rotateLeft, b.now);
    b.step();
    EXPECT_EQ(b.screen.frames.back().scale, 1);
}

TEST(Viewer, ResolutionGoesByTheDevicesTimeAndTheDisplaysInterval) {
    for (const double hertz : {60.0, 90.0, 120.0}) {
        Bench b;
        b.viewer.schedule().setDisplayInterval(1 / hertz);
        b.run(2, 1 / hertz);
        b.viewer.run(ViewerCommand::autoRotate, b.now);
        b.screen.milliseconds = 0.8 * 1000 / hertz;  // the display shows every frame, and has room to spare
        b.run(1, 1 / hertz);
        EXPECT_EQ(b.screen.frames.back().scale, 1) << hertz;
        b.screen.milliseconds = 0.95 * 1000 / hertz;  // still every frame, by a hair
        b.run(1, 1 / hertz);
        EXPECT_LT(b.screen.frames.back().scale, 1) << hertz;
        b.screen.milliseconds = 0.1 * 1000 / hertz;  // and it comes back in the motion
        b.run(3, 1 / hertz);
        EXPECT_EQ(b.screen.frames.back().scale, 1) << hertz;
    }
}

TEST(Viewer, AWarmDeviceDrawsFewerPixelsBeforeItIsSlowedDown) {
    Bench b;
    b.run(2);
    b.viewer.run(ViewerCommand::autoRotate, b.now);
    b.screen.milliseconds = 1;  // it keeps up with ease
    for (const auto& [heat, scale] :
         {std::pair(0.0, 1.0), {0.8, 1.0}, {0.9, 0.775}, {1.0, 0.55}, {1.5, 0.55}, {0.5, 1.0}, {1.0, 0.55}}) {
        b.viewer.schedule().setHeat(heat);
        b.run(0.5);
        EXPECT_NEAR(b.screen.frames.back().scale, scale, 1e-9) << heat;
    }
    b.viewer.run(ViewerCommand::autoRotate, b.now);
    b.run(2);
    EXPECT_EQ(b.screen.frames.back().scale, 1) << "a picture at rest is whole";
}

TEST(Viewer, ADisplayThatThereIsNotIsNotTaken) {
    Bench b;
    b.viewer.schedule().setDisplayInterval(1 / 120.0);
    for (const double rate : {0.0, -60.0, 0.5, 1e9, std::numeric_limits<double>::quiet_NaN()})
        b.viewer.schedule().setDisplayInterval(1 / rate);
    EXPECT_EQ(b.viewer.schedule().displayInterval(), 1 / 120.0);
}

TEST(Viewer, ADeviceOfSoftwareKeepsItsResolutionLonger) {
    // What takes less than 25 ms is whole; what takes a little more gives up the smallest step.
    for (const auto& [milliseconds, scale] :
         {std::pair(24.5, 1.0), {25.5, 0.85}, {28.0, 0.85}, {40.0, 0.7}, {200.0, 0.7}}) {
        Bench b;
        b.viewer.frames().keepSharp(0.025, 0.7);
        b.run(2);
        b.viewer.run(ViewerCommand::autoRotate, b.now);
        b.screen.millisecondsOfWhole = milliseconds;
        b.run(2 + milliseconds / 50, milliseconds / 1000);
        EXPECT_EQ(b.screen.frames.back().scale, scale) << milliseconds;
        const MotionFrames& moved = b.viewer.schedule().motionFrames();
        EXPECT_EQ(moved.smallestScale, scale) << milliseconds;
        EXPECT_EQ(moved.reduced > 0, scale < 1) << milliseconds;
        EXPECT_GT(moved.frames, moved.reduced) << "the first are whole";
        const std::string percent = std::to_string(std::lround(100 * scale)) + " %";
        EXPECT_EQ(b.viewer.picking().annotations().coarse.find(percent) != std::string::npos, scale < 1)
            << milliseconds;
        b.viewer.run(ViewerCommand::autoRotate, b.now);
        b.run(2);
        EXPECT_EQ(b.viewer.picking().annotations().coarse, "");
    }
}

TEST(Viewer, CartoonsGiveUpTrianglesBeforePixels) {
    for (const bool meshes : {true, false}) {
        Bench b("sample:dna");
        b.viewer.frames().keepSharp(0.025, 0.7);
        if (meshes) {
            PictureDescription look = b.viewer.view();
            look.look.style = Style::cartoon;
            b.viewer.setLook(look, b.now);
            b.load();
        }
        b.run(2);
        b.viewer.run(ViewerCommand::autoRotate, b.now);
        b.screen.milliseconds = 30;
        const std::size_t before = b.screen.frames.size();
        b.run(0.5, 0.03);
        const auto reduced = std::find_if(b.screen.frames.begin() + static_cast<std::ptrdiff_t>(before),
                                          b.screen.frames.end(), [](const WindowFrame& f) { return f.meshError > 2; });
        ASSERT_NE(reduced, b.screen.frames.end());
        EXPECT_EQ(reduced->scale, meshes ? 1 : 0.85);
        b.viewer.run(ViewerCommand::autoRotate, b.now);
        b.run(2);
        EXPECT_EQ(b.screen.frames.back().quality, Quality::refined);
    }
}

TEST(Viewer, ResolutionDoesNotSwing) {
    // The device takes as much as there are pixels: what fits at a smaller share does not at the whole.
    Bench b;
    b.run(2);
    b.viewer.run(ViewerCommand::autoRotate, b.now);
    b.screen.millisecondsOfWhole = 20;
    b.run(1);
    const double settled = b.screen.frames.back().scale;
    EXPECT_EQ(settled, 0.85);
    const std::size_t before = b.screen.frames.size();
    b.run(5);
    for (std::size_t i = before; i < b.screen.frames.size(); ++i) EXPECT_EQ(b.screen.frames[i].scale, settled);
}

TEST(Viewer, WaitsForRoomOnlyIfAFrameIsToBeDrawn) {
    Bench b;
    b.run(2);
    b.viewer.frames().await(b.now);
    EXPECT_EQ(b.screen.awaited, 0);
    b.viewer.run(ViewerCommand::rotateLeft, b.now);
    b.viewer.frames().await(b.now);
    EXPECT_EQ(b.screen.awaited, 1);
}

TEST(Viewer, ResolutionStaysWhileFramesAreInTime) {
    Bench b;
    b.run(2);
    b.viewer.run(ViewerCommand::autoRotate, b.now);
    b.run(3);
    for (const WindowFrame& frame : b.screen.frames) EXPECT_EQ(frame.scale, 1);
}

}  // namespace
}  // namespace nacre::app::test
