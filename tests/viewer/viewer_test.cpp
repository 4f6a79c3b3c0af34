// What the viewer shows: what is opened, its models, picks and looks.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/picture/appearance_values.h"
#include "app/picture/options.h"
#include "app/picture/words.h"
#include "tests/viewer/viewer_bench.h"

namespace nacre::app::test {
namespace {

TEST(Viewer, AQuestionIsAnsweredBeforeAnythingIsRead) {
    for (const bool yes : {true, false}) {
        bool allowed = false;
        CountingScreen screen;
        Sources asking = sampleSources();
        asking.read = [&allowed](const PictureDescription& v) {
            if (!allowed && v.input.path == "sample:glucose")
                throw Question("May it?", "Do it", [&] { allowed = true; });
            return sampleMolecule(v.input.path.substr(7));
        };
        Viewer viewer(screen, asking, Bench::makeView("sample:glucose"), {});
        viewer.frames().resize({640, 480}, 1, 100);
        viewer.reading().loader().wait();
        viewer.update(101);
        ASSERT_TRUE(viewer.reading().question());
        EXPECT_STREQ(viewer.reading().question()->what(), "May it?");
        EXPECT_EQ(viewer.reading().question()->yes(), "Do it");
        EXPECT_FALSE(viewer.document());
        if (yes)
            viewer.reading().answer(true, 102);
        else
            viewer.run(ViewerCommand::clearPicks, 102);  // Esc is a no
        EXPECT_FALSE(viewer.reading().question());
        viewer.reading().loader().wait();
        viewer.update(103);
        EXPECT_EQ(viewer.document() != nullptr, yes);
        EXPECT_EQ(allowed, yes);
        viewer.reading().open("sample:dna", 104);  // another file is no question
        viewer.reading().loader().wait();
        viewer.update(105);
        EXPECT_EQ(viewer.document()->view.input.path, "sample:dna");
    }
}

/// Three models of two atoms, as a source of files would have them.
Molecule threeModels(const PictureDescription& view) {
    return readMolecule("m.xyz", "2\n\nC 0 0 0\nO 1.2 0 0\n2\n\nC 0 0 0\nO 1.3 0 0\n2\n\nC 0 0 0\nO 1.4 0 0\n",
                        {.model = view.input.model});
}

TEST(Viewer, StepsThroughModelsAndPlaysThem) {
    CountingScreen screen;
    double now = 0;
    PictureDescription first;
    first.input.path = "m.xyz";
    Viewer viewer(screen, {threeModels}, first, {});
    viewer.frames().resize({640, 480}, 1, now);
    const auto run = [&](double seconds) {
        for (const double end = now + seconds; now < end; now += 1.0 / 60) {
            viewer.reading().loader().wait();
            viewer.update(now);
        }
    };
    run(1);
    viewer.run(ViewerCommand::rotateLeft, now);
    const glm::dquat turned = viewer.view().camera.orientation;
    viewer.run(ViewerCommand::nextModel, now);
    run(0.2);
    EXPECT_EQ(viewer.view().input.model, 2);
    EXPECT_EQ(viewer.document()->molecule->atoms[1].position.x, 1.3f);
    EXPECT_EQ(viewer.view().camera.orientation, turned) << "the camera stays";
    viewer.run(ViewerCommand::previousModel, now);
    run(0.2);
    viewer.run(ViewerCommand::previousModel, now);
    run(0.2);
    EXPECT_EQ(viewer.view().input.model, 3) << "the one before the first is the last";
    viewer.run(ViewerCommand::playModels, now);
    const int scenes = screen.scenes;
    run(2);
    EXPECT_NEAR(screen.scenes - scenes, 18, 4) << "ten per second, or as fast as they are read";
    EXPECT_TRUE(viewer.playback().playing());
    viewer.run(ViewerCommand::playModels, now);
    run(0.3);
    const int stopped = screen.scenes;
    run(1);
    EXPECT_EQ(screen.scenes, stopped);
}

TEST(Viewer, PicksNameAndMeasure) {
    Bench b;
    b.run(2);
    const auto tap = [&](std::uint32_t atom) {
        b.screen.atom = atom;
        b.viewer.touch({1, TouchPhase::began, {300, 200}}, b.now);
        b.viewer.touch({1, TouchPhase::ended, {300, 200}}, b.now + 0.05);
        b.run(1);
        return b.viewer.picking().annotations();
    };
    EXPECT_EQ(tap(1).measurement, "");
    EXPECT_NE(tap(1).atom.find("atom 1"), std::string::npos);  // the same again is no second one
    EXPECT_EQ(b.viewer.picking().picks().size(), 1u);
    EXPECT_EQ(tap(2).measurement, "");
    // Each kind takes its atoms; one more starts anew.
    constexpr const char* kBegins[] = {"distance 1", "angle ", "torsion "};
    for (std::uint32_t kind = 0; kind < 3; ++kind) {
        b.viewer.run(ViewerCommand::measure, b.now);
        b.viewer.picking().drop();
        for (std::uint32_t atom = 1; atom <= kind + 1; ++atom)
            EXPECT_NE(tap(atom).measurement.find(" more atom"), std::string::npos);
        EXPECT_EQ(tap(kind + 2).measurement.find(kBegins[kind]), 0u) << tap(kind + 2).measurement;
        EXPECT_EQ(tap(kind + 3).atoms.size(), 1u) << kind;
        EXPECT_EQ(tap(0).atoms.size(), 0u);
    }
    b.viewer.run(ViewerCommand::clearPicks, b.now);  // Esc leaves it
    EXPECT_EQ(b.viewer.picking().measuring(), Measuring::off);
    // Where the marks are is where the atoms are seen: atom 1 through the camera's own formula.
    tap(1);
    const View view = b.viewer.frames().settings().view;
    const Document& d = *b.viewer.document();
    const glm::dvec3 v = view.rotation * (glm::dvec3(d.molecule->atoms[0].position) - d.drawing.scene().center);
    EXPECT_NEAR(b.viewer.picking().annotations().atoms[0].x, 320 + v.x * view.pixelsPerAngstrom, 1e-9);
    EXPECT_NEAR(b.viewer.picking().annotations().atoms[0].y, 240 - v.y * view.pixelsPerAngstrom, 1e-9);
}

TEST(Viewer, AimsAtWhatIsPicked) {
    Bench b;
    b.viewer.frames().resize({640, 480}, 1, b.now);
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
    b.viewer.camera().aim(nothing, b.now);
    EXPECT_NE(b.viewer.picking().annotations().message.find("no such atoms"), std::string::npos);
    // What is aimed at before the molecule is there, is when it is.
    Aim flatAim;
    flatAim.principal = true;
    b.viewer.reading().open("sample:dna", b.now);
    b.viewer.camera().aim(flatAim, b.now);
    b.load();
    EXPECT_NE(b.viewer.view().camera.orientation, glm::dquat(1, 0, 0, 0));
    EXPECT_GT(b.viewer.view().camera.zoom, 1);  // as large as fits
    Aim before;
    before.clip = parseSelection("chain A");
    b.viewer.camera().aim(before, b.now);
    EXPECT_GT(b.viewer.view().effects.clip.near, -Clip::kNone);
}

TEST(Viewer, LeavesOutWhatHidesThePartOfAView) {
    Bench b("sample:dna");
    b.run(2);
    const std::size_t all = b.viewer.document()->drawing.scene().spheres.size();
    PictureDescription view = b.viewer.view();
    view.aim.uncover = parseSelection("chain B and resi 19");
    b.viewer.show(view, b.now, 0);
    b.load();
    b.run(1);
    EXPECT_LT(b.viewer.document()->drawing.scene().spheres.size(), all);
    EXPECT_EQ(b.viewer.view().aim.uncover, view.aim.uncover);
    b.viewer.run(ViewerCommand::undo, b.now);
    b.load();
    EXPECT_EQ(b.viewer.document()->drawing.scene().spheres.size(), all);
    b.viewer.show(view, b.now, 0);
    b.load();
    EXPECT_LT(b.viewer.document()->drawing.scene().spheres.size(), all);
    b.viewer.run(ViewerCommand::fit, b.now);  // all of it
    b.load();
    EXPECT_EQ(b.viewer.document()->drawing.scene().spheres.size(), all);
    EXPECT_FALSE(b.viewer.view().aim.uncover);
}

TEST(Viewer, ATouchIsAnsweredByTheNextFrameWhateverGoesOnAtRest) {
    // While it bakes, between the samples of the picture at rest, and when nothing goes on any more.
    for (const double rest : {0.0, 0.03, 0.06, 0.1, 0.3, 0.4, 3.0}) {
        Bench b;
        b.run(rest);
        b.viewer.touch({1, TouchPhase::began, {300, 200}}, b.now);
        b.viewer.touch({1, TouchPhase::moved, {300 + TouchGestures::kSlop + 1, 200}}, b.now);
        b.step();
        const std::size_t before = b.screen.frames.size();
        const glm::dmat3 seen = b.screen.settings.back().view.rotation;
        b.viewer.touch({1, TouchPhase::moved, {400, 200}}, b.now);
        b.step(0.001);
        ASSERT_EQ(b.screen.frames.size(), before + 1) << rest;
        EXPECT_EQ(b.screen.frames.back().quality, WindowFrame::Quality::live) << rest;
        EXPECT_NE(glm::dmat3(b.screen.settings.back().view.rotation), seen) << rest;
        // What is baked beside it is as much as a moving picture leaves room for, and no submission of it is long.
        for (const OcclusionPace& pace : b.screen.paces) EXPECT_LE(pace.sliceMilliseconds, 8) << rest;
        if (b.screen.occlusion < 1) {
            EXPECT_TRUE(b.screen.paces.back().mustFit) << rest;
            EXPECT_LE(b.screen.paces.back().sliceMilliseconds, 4) << rest;
        }
    }
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
    EXPECT_TRUE(b.viewer.picking().picks().empty());
    EXPECT_EQ(b.viewer.view().camera.zoom, 1);
    EXPECT_EQ(b.viewer.view().camera.pan, glm::dvec2(0));
}

TEST(Viewer, OpensFilesAndSaysWhatIsWrongWithThem) {
    Bench b;
    b.run(2);
    b.viewer.reading().open("bad", b.now);
    b.load();
    EXPECT_NE(b.viewer.picking().annotations().message.find("it is bad"), std::string::npos);
    EXPECT_EQ(b.viewer.title(), "sample:glucose - Nacre");
    b.viewer.wheel(5, {100, 100}, b.now);
    b.viewer.reading().open("sample:dna", b.now);
    EXPECT_TRUE(b.viewer.reading().loader().busy());
    b.load();
    EXPECT_EQ(b.viewer.document()->molecule->atoms.size(), sampleMolecule("dna").atoms.size());
    EXPECT_EQ(b.viewer.view().camera.zoom, 1);
    EXPECT_EQ(b.viewer.view().input.path, "sample:dna");
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
    EXPECT_LT(b.viewer.frames().occlusion(), 1);
    b.run(2);
    EXPECT_EQ(b.viewer.frames().occlusion(), 1);
}

TEST(Viewer, WhatItSavesIsWhereItGoesOn) {
    Bench a;
    a.run(1);
    a.viewer.touch({1, TouchPhase::began, {300, 200}}, a.now);
    for (int i = 1; i < 30; ++i) a.viewer.touch({1, TouchPhase::moved, {300.0 + 3 * i, 200.0 + i}}, a.now + i * 0.01);
    a.viewer.touch({1, TouchPhase::ended, {390, 230}}, a.now + 2);
    a.viewer.wheel(3, {10, 400}, a.now);
    a.viewer.run(ViewerCommand::licorice, a.now);
    a.viewer.reading().loader().wait();
    a.run(3);
    const std::string saved = savedViewJson(a.viewer.view());
    CountingScreen screen;
    Viewer back(screen, sampleSources(), parseSavedView(saved, "saved"), {});
    back.frames().resize({640, 480}, 1, 0);
    back.reading().loader().wait();
    back.update(1);
    EXPECT_EQ(savedViewJson(back.view()), saved);
    const View x = a.viewer.frames().settings().view, y = back.frames().settings().view;
    EXPECT_EQ(x.pan, y.pan);
    // Shells save a placed camera; this one fits the new scene, whose radius differs a little.
    EXPECT_NEAR(x.pixelsPerAngstrom, y.pixelsPerAngstrom, 0.02 * x.pixelsPerAngstrom);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(glm::distance(x.rotation[i], y.rotation[i]), 0, 1e-12);
}

TEST(Viewer, AKeptPictureHasTheMoleculeBesideItsLegend) {
    Bench b("sample:dna");
    b.run(1);
    const auto composed = [&](double shown) {
        PictureDescription picture = b.viewer.view();
        picture.size = {400, 400};
        picture.words.size = shown;
        return b.viewer.frames().compose(picture).view;
    };
    const auto left = [&](double shown) {  // pixels that the sphere leaves at the right of a square picture
        const View view = composed(shown);
        return 200 - (view.pan.x + view.radius) * view.pixelsPerAngstrom;
    };
    const double alone = left(14);
    EXPECT_EQ(composed(14).pan, b.viewer.frames().pictureSettings({400, 400}).view.pan);
    PictureDescription look = b.viewer.view();
    look.words.title = "A title that goes over the molecule";
    look.words.legend = true;
    b.viewer.setLook(look, b.now);
    b.load();
    const View beside = composed(40), over = b.viewer.frames().pictureSettings({400, 400}).view;
    EXPECT_LT(beside.pixelsPerAngstrom, over.pixelsPerAngstrom);
    EXPECT_GT(left(40), alone);
    // What was placed by hand stays there.
    b.viewer.wheel(2, {320, 240}, b.now);
    b.run(1);
    EXPECT_EQ(composed(40).pixelsPerAngstrom, b.viewer.frames().pictureSettings({400, 400}).view.pixelsPerAngstrom);
}

TEST(Viewer, WordsOfWhatIsHiddenWaitUntilItIsDrawnAgain) {
    Bench b;
    const auto show = [&](const PictureDescription& look) {
        b.viewer.setLook(look, b.now);
        b.load();
    };
    PictureDescription look = b.viewer.view();
    look.words.labels = {parseLabel("id 1=first"), parseLabel("id 2=second")};
    look.words.measures = {parseMeasure("1,2")};
    show(look);
    EXPECT_EQ(b.viewer.words().placed().labels.size(), 2u);
    EXPECT_EQ(b.viewer.words().placed().measures.size(), 1u);
    PictureDescription hidden = b.viewer.view();
    hidden.look.rules.push_back(parseHide("id 2"));
    show(hidden);
    ASSERT_EQ(b.viewer.words().placed().labels.size(), 1u);
    EXPECT_EQ(b.viewer.words().placed().labels[0].text, "first");
    EXPECT_TRUE(b.viewer.words().placed().measures.empty());
    EXPECT_EQ(b.viewer.view().words, look.words);
    EXPECT_NE(b.viewer.picking().annotations().message.find("id 2 and 1 more"), std::string::npos)
        << b.viewer.picking().annotations().message;
    show(look);
    EXPECT_EQ(b.viewer.words().placed().labels.size(), 2u);
    EXPECT_EQ(b.viewer.words().placed().measures.size(), 1u);
    // What the molecule does not have is not kept.
    look.words.labels.push_back(parseLabel("id 999=none"));
    show(look);
    EXPECT_EQ(b.viewer.view().words.labels.size(), 2u);
}

TEST(Viewer, ViewShadingAndWordsBuildNoSceneAndNoBake) {
    CountingScreen screen;
    Viewer viewer(screen, sampleSources(), Bench::makeView("sample:dna"), {});
    viewer.frames().resize({640, 480}, 1, 100);
    double now = 100;
    const auto rest = [&] {
        viewer.reading().loader().wait();
        for (const double end = now + 3; now < end; now += 0.05) viewer.update(now);
    };
    rest();
    ASSERT_EQ(viewer.frames().occlusion(), 1);
    const auto built = [&] { return viewer.document()->drawing.sceneNumber(); };
    const auto counts = [&] { return std::tuple(built(), screen.scenes, screen.paces.size()); };
    const auto before = counts();
    constexpr std::pair<const char*, const char*> kChanges[] = {{"projection", "perspective"},
                                                                {"fog", "auto"},
                                                                {"contours", "2"},
                                                                {"contour-weights", "3"},
                                                                {"background", "navy"},
                                                                {"lighting", "off"},
                                                                {"title", "DNA"},
                                                                {"legend", "on"},
                                                                {"clip", "0"},
                                                                {"scale-bar", "nm"},
                                                                {"ambient", "0.5"},
                                                                {"label", "chain A and resi 1={residue}"}};
    for (const auto& [key, value] : kChanges) {
        PictureDescription look = viewer.view();
        setOption(option(key), value, look);
        viewer.setLook(look, now);
        rest();
        EXPECT_EQ(option(key).value.print(viewer.view()), option(key).value.print(look)) << key;
        EXPECT_EQ(counts(), before) << key;
    }
    for (const auto& [key, value] : kChanges) {
        viewer.undo(now);
        rest();
        EXPECT_EQ(counts(), before) << "undo of a change, " << key << " and before";
    }
    EXPECT_FALSE(viewer.canUndo());
    viewer.run(ViewerCommand::occlusion, now);
    viewer.run(ViewerCommand::occlusion, now);
    rest();
    EXPECT_EQ(built(), std::get<0>(before));
    EXPECT_GT(screen.paces.size(), std::get<2>(before)) << "other directions are baked";
    viewer.run(ViewerCommand::hydrogens, now);
    rest();
    EXPECT_NE(built(), std::get<0>(before));
    EXPECT_EQ(screen.scenes, std::get<1>(before) + 1);
}

TEST(Viewer, HidesEverythingByHand) {
    Bench b("sample:dna");
    PictureDescription look = b.viewer.view();
    look.look.rules.push_back(parseHide("all"));
    b.viewer.setLook(look, b.now);
    b.load();
    EXPECT_EQ(b.viewer.messages().failure(), "");
    EXPECT_EQ(b.viewer.messages().message(), "all atoms are hidden");
    EXPECT_EQ(b.viewer.document()->drawing.scene().drawnAtoms, 0u);
    EXPECT_EQ(b.viewer.explanation(), "All atoms are hidden.");
    b.viewer.undo(b.now += 5);
    b.load();
    EXPECT_EQ(b.viewer.document()->drawing.scene().drawnAtoms, 486u);
}

TEST(Viewer, ExplainsOnlyWhatIsDrawn) {
    Bench glucose;
    EXPECT_EQ(
        glucose.viewer.explanation(),
        "Balls are atoms, and sticks are the bonds between them. Each element has its own colour. Carbon is grey, "
        "oxygen red.")
        << "no nitrogen";
    Bench b("sample:dna");
    PictureDescription look = b.viewer.view();
    look.look.style = Style::cartoon;
    look.look.color = ColorScheme::chainCarbons;
    b.viewer.setLook(look, b.now);
    b.load();
    EXPECT_EQ(b.viewer.explanation(), "Ribbons follow the backbone. Each chain has its own colour.")
        << "neither helices of a protein, nor strands, nor ligands";
    look.look.color = Coloring::uniform(0xff0000);
    look.look.rules.push_back(parseColorBy("chain A=element"));
    b.viewer.setLook(look, b.now += 5);
    b.load();
    EXPECT_EQ(
        b.viewer.explanation(),
        "Ribbons follow the backbone. All that has no colour of its own has one colour. Some parts have colours of "
        "their own.");
}

TEST(Viewer, AnInputThatCannotBeReadIsNotGoneOnWith) {
    Bench b("bad");
    EXPECT_FALSE(b.viewer.document());
    EXPECT_EQ(b.viewer.restartView().input.path, "");
}

TEST(Viewer, WordsFollowTheSizeOfTheWindowsText) {
    Bench b("sample:dna");
    const double usual = b.viewer.words().size();
    b.viewer.words().setTextPercent(200);
    EXPECT_DOUBLE_EQ(b.viewer.words().size(), 2 * usual);
    PictureDescription look = b.viewer.view();
    look.words.size = 10;
    b.viewer.setLook(look, b.now);
    EXPECT_DOUBLE_EQ(b.viewer.words().size(), 10) << "its own size is kept";
}

TEST(Viewer, OctantsOfEllipsoidsFollowTheCameraWithoutAnotherScene) {
    CountingScreen screen;
    Sources tensors{[](const PictureDescription&) {
        Molecule m = sampleMolecule("glucose");
        m.displacements.assign(m.atoms.size(), {0.04f, 0.03f, 0.02f, 0.004f, 0, 0});
        return m;
    }};
    PictureDescription view = Bench::makeView("sample:glucose");
    view.look.style = Style::ellipsoids;
    view.look.ellipsoids = EllipsoidForm::octants;
    Viewer viewer(screen, tensors, view, {});
    double now = 100;
    const auto rest = [&] {
        for (int i = 0; i < 30; ++i) {
            viewer.reading().loader().wait();
            viewer.update(now += 0.05);
        }
    };
    viewer.frames().resize({640, 480}, 1, now);
    rest();
    const int scenes = screen.scenes;
    for (int i = 0; i < 20; ++i) viewer.run(ViewerCommand::rotateLeft, now);
    viewer.update(now += 0.01);
    EXPECT_EQ(screen.scenes, scenes) << "it moves";
    rest();
    EXPECT_EQ(screen.scenes, scenes) << "it rests: shaders cut the octants that face it";
}

}  // namespace
}  // namespace nacre::app::test
