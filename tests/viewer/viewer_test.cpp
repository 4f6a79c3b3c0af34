// The viewer on a screen that only counts: when it draws, what, and that it stops.

#include "app/viewer/viewer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"

namespace nacre::app {
namespace {

class CountingScreen : public Screen {
public:
    std::vector<WindowFrame> frames;
    std::vector<RenderSettings> settings;
    int scenes = 0;
    double occlusion = 0;
    std::uint32_t atom = 0;
    FrameOutcome outcome = FrameOutcome::shown;
    double milliseconds = 0, millisecondsOfWhole = 0;  ///< of a frame; of one at full resolution
    int awaited = 0;

    int failures = 0;  ///< of the calls that follow
    std::string loss;

    void mayFail() {
        if (!loss.empty()) throw Error("the device was lost", "", "");
        if (failures == 0) return;
        --failures;
        throw Error("out of memory", "the screen", "it was too much");
    }
    void setScene(const Representation&) override {
        mayFail();
        ++scenes;
        occlusion = 0;
    }
    double advanceOcclusion(const RenderSettings&, const OcclusionPace&) override {
        mayFail();
        return occlusion = std::min(occlusion + 0.125, 1.0);
    }
    std::string deviceLoss() const override { return loss; }
    FrameOutcome present(const RenderSettings& s, const WindowFrame& frame) override {
        mayFail();
        if (outcome == FrameOutcome::shown) frames.push_back(frame), settings.push_back(s);
        return outcome;
    }
    PixelSize windowSize() const override { return {640, 480}; }
    void awaitFrame() override { ++awaited; }
    double frameMilliseconds() const override {
        if (millisecondsOfWhole == 0 || frames.empty()) return milliseconds;
        return millisecondsOfWhole * frames.back().scale * frames.back().scale;
    }
    std::uint32_t atomAt(const RenderSettings&, double, double, double) override {
        mayFail();
        return atom;
    }
    int count(WindowFrame::Quality quality) const {
        return static_cast<int>(
            std::count_if(frames.begin(), frames.end(), [&](const WindowFrame& f) { return f.quality == quality; }));
    }
};

Sources sources() {
    return {[](const SavedView& v) {
                if (v.input == "bad") throw Error("cannot read molecule", "bad", "it is bad");
                return sampleMolecule(v.input.substr(7));
            },
            [](const Molecule& m, const SavedView& v) { return represent(m, drawnAtoms(m, v.drawn), v.look); }};
}

struct Bench {
    CountingScreen screen;
    Viewer viewer;
    double now = 100;

    explicit Bench(const char* input = "sample:glucose") : viewer(screen, sources(), viewOf(input), {}) {
        viewer.resize({640, 480}, 1, now);
        load();
    }
    static SavedView viewOf(const char* input) {
        SavedView v;
        v.input = input;
        return v;
    }
    void load() {
        viewer.waitForLoading();
        step();
    }
    double step(double frame = 1.0 / 60) {
        now += frame;
        return viewer.update(now);
    }
    /// As a shell does: draws as often as it is asked to, waits where it may.
    void run(double seconds, double frame = 1.0 / 60) {
        const double end = now + seconds;
        while (now < end) {
            const double wake = viewer.update(now);
            now = std::min(std::max(now + frame, std::isinf(wake) ? end : wake), end);
        }
    }
};

using Quality = WindowFrame::Quality;

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

TEST(Viewer, AQuestionIsAnsweredBeforeAnythingIsRead) {
    for (const bool yes : {true, false}) {
        bool allowed = false;
        CountingScreen screen;
        Sources asking = sources();
        asking.read = [&allowed](const SavedView& v) {
            if (!allowed && v.input == "sample:glucose") throw Question("May it?", "Do it", [&] { allowed = true; });
            return sampleMolecule(v.input.substr(7));
        };
        Viewer viewer(screen, asking, Bench::viewOf("sample:glucose"), {});
        viewer.resize({640, 480}, 1, 100);
        viewer.waitForLoading();
        viewer.update(101);
        ASSERT_TRUE(viewer.question());
        EXPECT_STREQ(viewer.question()->what(), "May it?");
        EXPECT_EQ(viewer.question()->yes(), "Do it");
        EXPECT_FALSE(viewer.document());
        if (yes)
            viewer.answer(true, 102);
        else
            viewer.run(ViewerCommand::clearPicks, 102);  // Esc is a no
        EXPECT_FALSE(viewer.question());
        viewer.waitForLoading();
        viewer.update(103);
        EXPECT_EQ(viewer.document() != nullptr, yes);
        EXPECT_EQ(allowed, yes);
        viewer.open("sample:dna", 104);  // another file is no question
        viewer.waitForLoading();
        viewer.update(105);
        EXPECT_EQ(viewer.document()->view.input, "sample:dna");
    }
}

TEST(Viewer, EveryChangeIsDrawnAndRefinedOnce) {
    Bench b;
    b.run(2);
    for (const ViewerCommand command : {ViewerCommand::rotateLeft, ViewerCommand::zoomIn, ViewerCommand::lighting,
                                        ViewerCommand::nextBackground, ViewerCommand::perspective}) {
        const std::size_t before = b.screen.frames.size();
        const int refined = b.screen.count(Quality::refined);
        b.viewer.run(command, b.now);
        b.run(2);
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
    b.viewer.overlayChanged();
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
    EXPECT_FALSE(b.viewer.autoRotating());
}

/// Three models of two atoms, as a source of files would have them.
Molecule threeModels(const SavedView& view) {
    ReadOptions options;
    options.model = view.model;
    return readMolecule("m.xyz", "2\n\nC 0 0 0\nO 1.2 0 0\n2\n\nC 0 0 0\nO 1.3 0 0\n2\n\nC 0 0 0\nO 1.4 0 0\n",
                        options);
}

TEST(Viewer, StepsThroughModelsAndPlaysThem) {
    CountingScreen screen;
    double now = 0;
    SavedView first;
    first.input = "m.xyz";
    Viewer viewer(
        screen,
        {threeModels, [](const Molecule& m, const SavedView& v) { return represent(m, drawnAtoms(m), v.look); }}, first,
        {});
    viewer.resize({640, 480}, 1, now);
    const auto run = [&](double seconds) {
        for (const double end = now + seconds; now < end; now += 1.0 / 60) {
            viewer.waitForLoading();
            viewer.update(now);
        }
    };
    run(1);
    viewer.run(ViewerCommand::rotateLeft, now);
    const glm::dquat turned = viewer.view().camera.orientation;
    viewer.run(ViewerCommand::nextModel, now);
    run(0.2);
    EXPECT_EQ(viewer.view().model, 2);
    EXPECT_EQ(viewer.document()->molecule->atoms[1].position.x, 1.3f);
    EXPECT_EQ(viewer.view().camera.orientation, turned) << "the camera stays";
    viewer.run(ViewerCommand::previousModel, now);
    run(0.2);
    viewer.run(ViewerCommand::previousModel, now);
    run(0.2);
    EXPECT_EQ(viewer.view().model, 3) << "the one before the first is the last";
    viewer.run(ViewerCommand::playModels, now);
    const int scenes = screen.scenes;
    run(2);
    EXPECT_NEAR(screen.scenes - scenes, 18, 4) << "ten a second, or as fast as they are read";
    EXPECT_TRUE(viewer.playing());
    viewer.run(ViewerCommand::playModels, now);
    run(0.3);
    const int stopped = screen.scenes;
    run(1);
    EXPECT_EQ(screen.scenes, stopped);
}

TEST(Viewer, ResolutionDropsWhileFramesAreLateAndReturnsAtRest) {
    Bench b;
    b.run(2);
    b.viewer.run(ViewerCommand::autoRotate, b.now);
    b.run(3, 0.05);  // 20 frames a second
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
        b.viewer.setDisplayInterval(1 / hertz);
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

TEST(Viewer, ResolutionDoesNotSwing) {
    // The device takes as much as there are pixels: what fits at three quarters does not at the whole.
    Bench b;
    b.run(2);
    b.viewer.run(ViewerCommand::autoRotate, b.now);
    b.screen.millisecondsOfWhole = 20;
    b.run(1);
    const double settled = b.screen.frames.back().scale;
    EXPECT_EQ(settled, 0.75);
    const std::size_t before = b.screen.frames.size();
    b.run(5);
    for (std::size_t i = before; i < b.screen.frames.size(); ++i) EXPECT_EQ(b.screen.frames[i].scale, settled);
}

TEST(Viewer, WaitsForRoomOnlyIfAFrameIsToBeDrawn) {
    Bench b;
    b.run(2);
    b.viewer.awaitFrame(b.now);
    EXPECT_EQ(b.screen.awaited, 0);
    b.viewer.run(ViewerCommand::rotateLeft, b.now);
    b.viewer.awaitFrame(b.now);
    EXPECT_EQ(b.screen.awaited, 1);
}

TEST(Viewer, ResolutionStaysWhileFramesAreInTime) {
    Bench b;
    b.run(2);
    b.viewer.run(ViewerCommand::autoRotate, b.now);
    b.run(3);
    for (const WindowFrame& frame : b.screen.frames) EXPECT_EQ(frame.scale, 1);
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
    b.viewer.resize({800, 600}, 1, b.now);
    b.screen.outcome = FrameOutcome::resized;  // it is 640 x 480 again
    b.step();
    b.screen.outcome = FrameOutcome::shown;
    b.run(2);
    EXPECT_EQ(b.screen.settings.back().view.width, 640u);
    EXPECT_EQ(b.screen.frames.back().quality, Quality::refined);
}

TEST(Viewer, PicksNameAndMeasure) {
    Bench b;
    b.run(2);
    const auto tap = [&](std::uint32_t atom) {
        b.screen.atom = atom;
        b.viewer.touch({1, TouchPhase::began, {300, 200}}, b.now);
        b.viewer.touch({1, TouchPhase::ended, {300, 200}}, b.now + 0.05);
        b.run(1);
        return b.viewer.annotations();
    };
    EXPECT_EQ(tap(1).measurement, "");
    EXPECT_NE(tap(1).atom.find("atom 1"), std::string::npos);  // the same again is no second one
    EXPECT_EQ(b.viewer.picks().size(), 1u);
    EXPECT_EQ(tap(2).measurement.substr(0, 8), "distance");
    EXPECT_EQ(tap(3).measurement.substr(0, 5), "angle");
    EXPECT_EQ(tap(4).measurement.substr(0, 7), "torsion");
    EXPECT_EQ(tap(5).atoms.size(), 1u);
    EXPECT_EQ(tap(0).atoms.size(), 0u);
    // Where the marks are is where the atoms are seen: atom 1 through the camera's own formula.
    tap(1);
    const View view = b.viewer.settings().view;
    const Document& d = *b.viewer.document();
    const glm::dvec3 v = view.rotation * (glm::dvec3(d.molecule->atoms[0].position) - d.scene.center);
    EXPECT_NEAR(b.viewer.annotations().atoms[0].x, 320 + v.x * view.pixelsPerAngstrom, 1e-9);
    EXPECT_NEAR(b.viewer.annotations().atoms[0].y, 240 - v.y * view.pixelsPerAngstrom, 1e-9);
}

TEST(Viewer, AimsAtWhatIsPicked) {
    Bench b;
    b.viewer.resize({640, 480}, 1, b.now);
    b.run(2);
    b.viewer.run(ViewerCommand::orient, b.now);
    b.run(1);
    const glm::dquat flat = b.viewer.view().camera.orientation;
    EXPECT_NE(flat, glm::dquat(1, 0, 0, 0));
    b.screen.atom = 3;
    b.viewer.touch({1, TouchPhase::began, {300, 200}}, b.now);
    b.viewer.touch({1, TouchPhase::ended, {300, 200}}, b.now + 0.05);
    b.run(1);
    b.viewer.run(ViewerCommand::zoomTo, b.now);
    b.run(1);
    EXPECT_GT(b.viewer.view().camera.zoom, 0.3);
    EXPECT_NE(b.viewer.view().camera.zoom, 1);
    EXPECT_EQ(b.viewer.view().camera.orientation, flat);
    Aim nothing;
    nothing.lookAt = parseSelection("resn XYZ");
    b.viewer.aim(nothing, b.now);
    EXPECT_NE(b.viewer.annotations().message.find("no such atoms"), std::string::npos);
    // What is aimed at before the molecule is there, is when it is.
    Aim flatAim;
    flatAim.principal = true;
    b.viewer.open("sample:dna", b.now);
    b.viewer.aim(flatAim, b.now);
    b.load();
    EXPECT_NE(b.viewer.view().camera.orientation, glm::dquat(1, 0, 0, 0));
    EXPECT_GT(b.viewer.view().camera.zoom, 1);  // as large as fits
}

TEST(Viewer, ADoubleTapFitsAndPicksNothing) {
    Bench b;
    b.run(2);
    b.viewer.wheel(5, {100, 100}, b.now);
    b.run(1);
    b.screen.atom = 3;
    for (const double t : {0.0, 0.2}) {
        b.viewer.touch({1, TouchPhase::began, {300, 200}}, b.now + t);
        b.viewer.touch({1, TouchPhase::ended, {300, 200}}, b.now + t + 0.05);
    }
    b.run(2);
    EXPECT_TRUE(b.viewer.picks().empty());
    EXPECT_EQ(b.viewer.view().camera.zoom, 1);
    EXPECT_EQ(b.viewer.view().camera.pan, glm::dvec2(0));
}

TEST(Viewer, OpensFilesAndSaysWhatIsWrongWithThem) {
    Bench b;
    b.run(2);
    b.viewer.open("bad", b.now);
    b.load();
    EXPECT_NE(b.viewer.annotations().message.find("it is bad"), std::string::npos);
    EXPECT_EQ(b.viewer.title(), "sample:glucose - Nacre");
    b.viewer.wheel(5, {100, 100}, b.now);
    b.viewer.open("sample:dna", b.now);
    EXPECT_TRUE(b.viewer.loading());
    b.load();
    EXPECT_EQ(b.viewer.document()->molecule->atoms.size(), sampleMolecule("dna").atoms.size());
    EXPECT_EQ(b.viewer.view().camera.zoom, 1);
    EXPECT_EQ(b.viewer.view().input, "sample:dna");
    EXPECT_NE(b.viewer.title().find("occlusion"), std::string::npos);
    b.run(2);
    EXPECT_EQ(b.viewer.title(), "sample:dna - Nacre");
}

TEST(Viewer, AnotherStyleIsBuiltWithoutReadingAndRestartsOcclusion) {
    Bench b;
    b.run(2);
    const Molecule* before = b.viewer.document()->molecule.get();
    const int scenes = b.screen.scenes;
    b.viewer.run(ViewerCommand::licorice, b.now);
    b.load();
    EXPECT_EQ(b.viewer.document()->molecule.get(), before);
    EXPECT_EQ(b.screen.scenes, scenes + 1);
    EXPECT_LT(b.viewer.occlusion(), 1);
    b.run(2);
    EXPECT_EQ(b.viewer.occlusion(), 1);
}

TEST(Viewer, WhatItSavesIsWhereItGoesOn) {
    Bench a;
    a.run(1);
    a.viewer.touch({1, TouchPhase::began, {300, 200}}, a.now);
    for (int i = 1; i < 30; ++i) a.viewer.touch({1, TouchPhase::moved, {300.0 + 3 * i, 200.0 + i}}, a.now + i * 0.01);
    a.viewer.touch({1, TouchPhase::ended, {390, 230}}, a.now + 2);
    a.viewer.wheel(3, {10, 400}, a.now);
    a.viewer.run(ViewerCommand::licorice, a.now);
    a.viewer.waitForLoading();
    a.run(3);
    const std::string saved = savedViewJson(a.viewer.view());
    CountingScreen screen;
    Viewer back(screen, sources(), parseSavedView(saved, "saved"), {});
    back.resize({640, 480}, 1, 0);
    back.waitForLoading();
    back.update(1);
    EXPECT_EQ(savedViewJson(back.view()), saved);
    const View x = a.viewer.settings().view, y = back.settings().view;
    EXPECT_EQ(x.pan, y.pan);
    EXPECT_EQ(x.pixelsPerAngstrom, y.pixelsPerAngstrom);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(glm::distance(x.rotation[i], y.rotation[i]), 0, 1e-12);
}

TEST(Viewer, ADeviceThatIsLostIsToldAndItsSceneSetAgain) {
    Bench b;
    b.run(2);
    b.screen.outcome = FrameOutcome::lost;
    b.viewer.run(ViewerCommand::rotateLeft, b.now);
    b.step();
    EXPECT_TRUE(b.viewer.deviceLost());
    const int scenes = b.screen.scenes;
    b.screen.outcome = FrameOutcome::shown;
    b.viewer.screenLost(b.now);
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
    const Viewer viewer(screen, sources(), Bench::viewOf("sample:glucose"), options);
    EXPECT_EQ(viewer.settings().occlusion.bytes, 3u << 20);
    EXPECT_EQ(viewer.settings().occlusion.cache, "kept here");
}

TEST(Viewer, DebugViewsComeOneAfterTheOtherAndAreNotAveraged) {
    Bench b;
    b.run(2);
    for (std::size_t i = 1; i <= debugViewNames().size(); ++i) {
        const auto wanted = static_cast<DebugView>(i % debugViewNames().size());
        b.viewer.setDebugView(wanted, b.now);
        b.run(2);
        EXPECT_EQ(b.screen.settings.back().debug, wanted);
        EXPECT_EQ(b.screen.frames.back().samples == 1, wanted != DebugView::none);
    }
}

TEST(Viewer, LowMemoryEndsSupersampling) {
    Bench b;
    b.viewer.lowMemory();
    b.run(2);
    EXPECT_EQ(b.screen.frames.back().quality, Quality::refined);
    EXPECT_EQ(b.screen.frames.back().samples, 1u);
}

TEST(Viewer, WhatFailsIsSaidAndTriedAgainLaterAndLater) {
    Bench b;
    b.screen.failures = 3;  // occlusion and frame; then one of them again
    b.step();
    EXPECT_EQ(b.viewer.annotations().message, "out of memory: the screen: it was too much");
    EXPECT_EQ(b.screen.failures, 1);
    for (int i = 0; i < 20; ++i) b.step();
    EXPECT_EQ(b.screen.failures, 1);  // not within a third of a second
    EXPECT_LT(b.viewer.update(b.now), b.now + 1);
    b.run(12);
    EXPECT_EQ(b.screen.failures, 0);
    EXPECT_EQ(b.screen.occlusion, 1);
    EXPECT_EQ(b.screen.count(Quality::refined), 16);
    EXPECT_EQ(b.viewer.annotations().message, "");
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
    b.viewer.open("sample:dna", b.now);
    b.load();
    EXPECT_EQ(b.viewer.annotations().message, "out of memory: the screen: it was too much");
    EXPECT_EQ(b.viewer.document()->molecule->atoms.size(), atoms);
    b.viewer.open("sample:dna", b.now);
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
        ASSERT_TRUE(b.viewer.deviceLost()) << when;
        b.screen.loss.clear();
        const int scenes = b.screen.scenes, refined = b.screen.count(Quality::refined);
        b.viewer.screenLost(b.now);
        EXPECT_FALSE(b.viewer.deviceLost());
        EXPECT_EQ(b.screen.scenes, scenes + 1);
        EXPECT_EQ(b.viewer.annotations().message, "the device was lost: so and so");
        b.run(6);
        EXPECT_EQ(b.screen.count(Quality::refined), refined + 16);
    }
}

}  // namespace
}  // namespace nacre::app
