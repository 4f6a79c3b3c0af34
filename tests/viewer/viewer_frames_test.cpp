// The viewer on a screen that only counts: when it draws, what, and that it stops.

#include <gtest/gtest.h>

#include "app/picture/options.h"
#include "tests/viewer/viewer_bench.h"

namespace nacre::app::test {
namespace {

TEST(Viewer, ConvergesRefinesOnceAndThenDrawsNothing) {
    Bench b;
    b.run(2);
    EXPECT_EQ(b.screen.occlusion, 1);
    EXPECT_GE(b.screen.count(Quality::live), 8);  // one for each step of the occlusion
    EXPECT_EQ(b.screen.count(Quality::refined), 16);
    EXPECT_EQ(b.screen.frames.back().quality, Quality::refined);
    const std::size_t drawn = b.screen.frames.size();
    b.run(5);
    EXPECT_EQ(b.screen.frames.size(), drawn);
    // However often it is asked.
    for (int i = 0; i < 300; ++i) b.step();
    EXPECT_EQ(b.screen.frames.size(), drawn);
    EXPECT_TRUE(std::isinf(b.step()));
}

TEST(Viewer, AnEmptyOneRestsToo) {
    Bench b("");
    b.run(2);
    const std::size_t drawn = b.screen.frames.size();
    EXPECT_GT(drawn, 0u);
    EXPECT_TRUE(std::isinf(b.step())) << "there is nothing to bake, and nobody is to wait for it";
    b.viewer.reading().open("sample:glucose", b.now);
    b.load();
    b.run(2);
    EXPECT_EQ(b.screen.occlusion, 1);
    EXPECT_TRUE(std::isinf(b.step()));
}

TEST(Viewer, EveryChangeIsDrawnAndRefinedOnce) {
    Bench b;
    b.run(2);
    for (const ViewerCommand command : {ViewerCommand::rotateLeft, ViewerCommand::zoomIn, ViewerCommand::lighting,
                                        ViewerCommand::nextBackground, ViewerCommand::perspective}) {
        const std::size_t before = b.screen.frames.size();
        const int refined = b.screen.count(Quality::refined);
        b.viewer.run(command, b.now);
        b.run(8);  // what it says is gone by then
        EXPECT_EQ(b.screen.count(Quality::refined), refined + 16);
        EXPECT_GE(b.screen.frames.size(), before + 2);
        const std::size_t after = b.screen.frames.size();
        b.run(5);
        EXPECT_EQ(b.screen.frames.size(), after);
    }
}

TEST(Viewer, SamplesFollowEachOtherAndATouchEndsThem) {
    Bench b;
    b.run(2);
    for (std::uint32_t i = 0; i < 16; ++i) {
        const WindowFrame& frame = b.screen.frames[b.screen.frames.size() - 16 + i];
        EXPECT_EQ(frame.quality, Quality::refined);
        EXPECT_EQ(frame.samples, 16u);
        EXPECT_EQ(frame.sample, i);
    }
    b.viewer.run(ViewerCommand::rotateLeft, b.now);
    for (int i = 0; i < 100 && b.screen.frames.back().sample != 5; ++i) b.step();
    ASSERT_EQ(b.screen.frames.back().sample, 5u);
    b.viewer.mouseButton(MouseButton::left, true, {300, 200}, {}, b.now);
    b.viewer.mouseMove({310, 200}, b.now);
    b.step();  // the very next frame
    EXPECT_EQ(b.screen.frames.back().quality, Quality::live);
    b.viewer.mouseButton(MouseButton::left, false, {310, 200}, {}, b.now);
    b.run(4);
    EXPECT_EQ(b.screen.frames.back().sample, 15u);
}

TEST(Viewer, AnOverlayThatChangesCostsOneFrameOfTheKeptPicture) {
    Bench b;
    b.run(2);
    const std::size_t before = b.screen.frames.size();
    b.viewer.schedule().overlayChanged();
    b.run(5);
    ASSERT_EQ(b.screen.frames.size(), before + 1);
    EXPECT_EQ(b.screen.frames.back().quality, Quality::kept);
}

TEST(Viewer, TurnsByItselfUntilTouched) {
    Bench b;
    b.run(2);
    b.viewer.run(ViewerCommand::autoRotate, b.now);
    const std::size_t before = b.screen.frames.size();
    b.run(2);
    EXPECT_NEAR(static_cast<double>(b.screen.frames.size() - before), 120, 3);
    b.viewer.touch({1, TouchPhase::began, {300, 200}}, b.now);
    b.viewer.touch({1, TouchPhase::ended, {300, 200}}, b.now + 0.05);
    b.run(6);  // the pick's words go as well
    const std::size_t after = b.screen.frames.size();
    b.run(5);
    EXPECT_EQ(b.screen.frames.size(), after);
    EXPECT_FALSE(b.viewer.motion().autoRotation());
}

TEST(Viewer, NothingIsDrawnWhilePausedOrHidden) {
    Bench b;
    b.run(2);
    b.viewer.pause();
    const std::size_t before = b.screen.frames.size();
    b.viewer.run(ViewerCommand::autoRotate, b.now);
    b.run(5);
    EXPECT_EQ(b.screen.frames.size(), before);
    b.viewer.run(ViewerCommand::autoRotate, b.now);
    b.viewer.resume(b.now);
    b.run(2);
    EXPECT_GT(b.screen.frames.size(), before);
    EXPECT_EQ(b.screen.frames.back().quality, Quality::refined);
    b.screen.outcome = FrameOutcome::hidden;
    b.viewer.run(ViewerCommand::rotateLeft, b.now);
    EXPECT_TRUE(std::isinf(b.step()));
}

TEST(Viewer, AWindowThatChangedMeanwhileIsDrawnInItsNewSize) {
    Bench b;
    b.run(2);
    b.viewer.frames().resize({800, 600}, 1, b.now);
    b.screen.outcome = FrameOutcome::resized;  // it is 640 x 480 again
    b.step();
    b.screen.outcome = FrameOutcome::shown;
    b.run(2);
    EXPECT_EQ(b.screen.settings.back().view.width, 640u);
    EXPECT_EQ(b.screen.frames.back().quality, Quality::refined);
}

TEST(Viewer, ADeviceThatIsLostIsToldAndItsSceneSetAgain) {
    Bench b;
    b.run(2);
    b.screen.outcome = FrameOutcome::lost;
    b.viewer.run(ViewerCommand::rotateLeft, b.now);
    b.step();
    EXPECT_TRUE(b.viewer.frames().lost());
    const int scenes = b.screen.scenes;
    b.screen.outcome = FrameOutcome::shown;
    b.viewer.frames().replaced(b.now);
    b.run(2);
    EXPECT_EQ(b.screen.scenes, scenes + 1);
    EXPECT_EQ(b.screen.occlusion, 1);
    EXPECT_EQ(b.screen.frames.back().quality, Quality::refined);
}

TEST(Viewer, BakesWithinTheMemoryAndIntoTheCacheThatItWasGiven) {
    CountingScreen screen;
    ViewerOptions options;
    options.occlusionBytes = 3 << 20;
    options.occlusionCache = "kept here";
    const Viewer viewer(screen, sampleSources(), Bench::makeView("sample:glucose"), options);
    EXPECT_EQ(viewer.frames().settings().occlusion.bytes, 3u << 20);
    EXPECT_EQ(viewer.frames().settings().occlusion.cache, "kept here");
}

TEST(Viewer, DebugViewsComeOneAfterTheOtherAndAreNotAveraged) {
    Bench b;
    b.run(2);
    for (std::size_t i = 1; i <= debugViewNames().size(); ++i) {
        const auto wanted = static_cast<DebugView>(i % debugViewNames().size());
        b.viewer.frames().setDebugView(wanted, b.now);
        b.run(2);
        EXPECT_EQ(b.screen.settings.back().debug, wanted);
        EXPECT_EQ(b.screen.frames.back().samples == 1, wanted != DebugView::none);
    }
}

TEST(Viewer, RestsThroughManyPointsOfALens) {
    Bench b;
    PictureDescription look = b.viewer.view();
    setOption(option("depth-of-field"), "5", look);
    b.viewer.setLook(look, b.now);
    b.run(4);
    EXPECT_EQ(b.screen.frames.back().quality, Quality::refined);
    EXPECT_EQ(b.screen.frames.back().samples, 64u);
    EXPECT_EQ(b.screen.settings.back().effects.depthOfField.strength, 0.05);
    EXPECT_TRUE(b.screen.settings.back().effects.depthOfField.focus);
}

TEST(Viewer, LowMemoryEndsSupersampling) {
    Bench b;
    b.viewer.frames().setMostSamples(1);
    b.run(2);
    EXPECT_EQ(b.screen.frames.back().quality, Quality::refined);
    EXPECT_EQ(b.screen.frames.back().samples, 1u);
}

TEST(Viewer, WhatFailsIsSaidAndTriedAgainLaterAndLater) {
    Bench b;
    b.screen.failures = 3;  // occlusion and frame; then one of them again
    b.step();
    EXPECT_EQ(b.viewer.picking().annotations().message, "out of memory: the screen: it was too much");
    EXPECT_EQ(b.screen.failures, 1);
    for (int i = 0; i < 20; ++i) b.step();
    EXPECT_EQ(b.screen.failures, 1);  // not within a third of a second
    EXPECT_LT(b.viewer.update(b.now), b.now + 1);
    b.run(12);
    EXPECT_EQ(b.screen.failures, 0);
    EXPECT_EQ(b.screen.occlusion, 1);
    EXPECT_EQ(b.screen.count(Quality::refined), 16);
    EXPECT_EQ(b.viewer.picking().annotations().message, "");
}

TEST(Viewer, APersistentFailureCostsLittle) {
    Bench b;
    b.run(2);
    b.screen.failures = 1000000;
    b.viewer.run(ViewerCommand::rotateLeft, b.now);
    b.run(60);
    EXPECT_GT(b.screen.failures, 1000000 - 15);
    b.screen.failures = 0;
    b.run(10);
    EXPECT_EQ(b.screen.frames.back().quality, Quality::refined);
}

TEST(Viewer, ASceneThatFindsNoRoomLeavesTheOneBefore) {
    Bench b;
    b.run(2);
    const Document* before = b.viewer.document();
    const std::size_t atoms = before->molecule->atoms.size();
    b.screen.failures = 1;
    b.viewer.reading().open("sample:dna", b.now);
    b.load();
    EXPECT_EQ(b.viewer.picking().annotations().message, "out of memory: the screen: it was too much");
    EXPECT_EQ(b.viewer.document()->molecule->atoms.size(), atoms);
    b.viewer.reading().open("sample:dna", b.now);
    b.load();
    EXPECT_NE(b.viewer.document()->molecule->atoms.size(), atoms);
}

TEST(Viewer, ALossIsNoticedWhereverItComesAndSaidAfterwards) {
    for (int when = 0; when < 3; ++when) {
        Bench b;
        b.run(2);
        b.screen.loss = "the device was lost: so and so";
        if (when == 0) b.viewer.run(ViewerCommand::rotateLeft, b.now);
        if (when == 1) b.viewer.run(ViewerCommand::occlusion, b.now), b.viewer.run(ViewerCommand::occlusion, b.now);
        if (when == 2) {
            b.viewer.touch({1, TouchPhase::began, {300, 200}}, b.now);
            b.viewer.touch({1, TouchPhase::ended, {300, 200}}, b.now + 0.05);
            b.now += 0.05;
        }
        b.run(1);
        ASSERT_TRUE(b.viewer.frames().lost()) << when;
        b.screen.loss.clear();
        const int scenes = b.screen.scenes, refined = b.screen.count(Quality::refined);
        b.viewer.frames().replaced(b.now);
        EXPECT_FALSE(b.viewer.frames().lost());
        EXPECT_EQ(b.screen.scenes, scenes + 1);
        EXPECT_EQ(b.viewer.picking().annotations().message, "the device was lost: so and so");
        b.run(6);
        EXPECT_EQ(b.screen.count(Quality::refined), refined + 16);
    }
}

}  // namespace
}  // namespace nacre::app::test
