// What pointing does: hover, click, double click, the selection; and reading that is stopped.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "app/viewer/viewer.h"
#include "engine/error.h"
#include "engine/molecule/read.h"

namespace nacre::app {
namespace {

class OneAtomScreen : public Screen {
public:
    std::uint32_t atom = 0;
    int asked = 0;
    int scenes = 0, drawn = 0;  ///< drawn: pictures of the atom in each pixel
    double milliseconds = 1;    ///< that those take
    SeenAtoms atoms(const RenderSettings& settings) override {
        ++drawn;
        return {std::vector<std::uint32_t>(std::size_t{settings.view.width} * settings.view.height, atom),
                milliseconds};
    }
    void setScene(Representation) override { ++scenes; }
    double advanceOcclusion(const RenderSettings&, const OcclusionPace&) override { return 1; }
    FrameOutcome present(const RenderSettings&, const WindowFrame&) override { return FrameOutcome::shown; }
    PixelSize windowSize() const override { return {640, 480}; }
    std::uint32_t atomAt(const RenderSettings&, double, double, double) override { return ++asked, atom; }
};

struct Stand {
    OneAtomScreen screen;
    std::atomic<bool> cancelled{false};
    Viewer viewer;
    double now = 100;

    explicit Stand(Style style = Style::spacefill) : Stand(first(style)) {}
    explicit Stand(const PictureDescription& picture)
        : viewer(screen,
                 {[this](const PictureDescription& v) {
                      for (int i = 0; v.input.path == "slow" && !cancelled && i < 1000; ++i)
                          std::this_thread::sleep_for(std::chrono::milliseconds(5));
                      if (v.input.path == "slow") throw Error("stopped", "", "");
                      Molecule molecule = sampleMolecule("dna");
                      molecule.modelsAreInputs = v.input.path == "scene";  // the second structure of one
                      for (Chain& chain : molecule.chains) chain.model = v.input.path == "scene" ? 2 : chain.model;
                      return molecule;
                  },
                  [] { return 0.25; }, [this] { cancelled = true; }},
                 picture, {}) {
        viewer.frames().resize({640, 480}, 1, now);
        viewer.reading().loader().wait();
        rest(1);
    }
    static PictureDescription first(Style style) {
        PictureDescription v;
        v.input.path = "sample:dna";
        v.look.style = style;
        return v;
    }
    void rest(double seconds) {
        for (const double end = now + seconds; now < end; now += 0.02) viewer.update(now);
    }
    /// Another view, in which one atom is everywhere.
    void see(std::uint32_t other) {
        screen.atom = other;
        viewer.run(ViewerCommand::rotateLeft, now);
        rest(1);
    }
    void click() {
        viewer.mouseButton(MouseButton::left, true, {300, 200}, {}, now);
        viewer.mouseButton(MouseButton::left, false, {300, 200}, {}, now += 0.05);
    }
};

std::size_t marked(const Viewer& viewer) {
    const std::vector<bool>& selected = viewer.frames().marks().selected;
    return static_cast<std::size_t>(std::count(selected.begin(), selected.end(), true));
}

TEST(Pointing, ANameIsLookedForOnceThePointerRests) {
    Stand s;
    s.screen.atom = 40;
    for (int i = 0; i < 10; ++i) {
        s.viewer.mouseMove({300.0 + i, 200}, s.now);
        s.rest(0.02);
    }
    EXPECT_EQ(s.screen.asked, 0);
    s.rest(1);
    EXPECT_EQ(s.screen.asked, 1);
    EXPECT_NE(s.viewer.picking().annotations().hover.find("atom 40"), std::string::npos);
    s.viewer.picking().pointerLeft();
    EXPECT_EQ(s.viewer.picking().annotations().hover, "");
}

TEST(Pointing, ANameGoesWithWhatMovesAwayUnderThePointer) {
    Stand s;
    s.screen.atom = 40;
    s.viewer.mouseMove({300, 200}, s.now);
    s.rest(1);
    ASSERT_NE(s.viewer.picking().annotations().hover.find("atom 40"), std::string::npos);
    s.screen.atom = 41;
    s.viewer.run(ViewerCommand::autoRotate, s.now);
    s.rest(1);
    EXPECT_EQ(s.viewer.picking().annotations().hover, "") << "what turns has no name";
    EXPECT_EQ(s.screen.asked, 1) << "and is not looked for in each frame";
    s.viewer.run(ViewerCommand::autoRotate, s.now);
    s.rest(2);
    EXPECT_NE(s.viewer.picking().annotations().hover.find("atom 41"), std::string::npos);
    EXPECT_EQ(s.screen.asked, 2);
    s.screen.atom = 42;
    s.viewer.frames().resize({500, 300}, 1, s.now);
    s.rest(1);
    EXPECT_NE(s.viewer.picking().annotations().hover.find("atom 42"), std::string::npos);
    s.viewer.picking().pointerLeft();
    s.viewer.frames().resize({600, 400}, 1, s.now);
    s.rest(1);
    EXPECT_EQ(s.viewer.picking().annotations().hover, "");
    EXPECT_EQ(s.screen.asked, 3);
}

TEST(Pointing, AClickSelectsTheResidueAndOneBesideNothing) {
    Stand s;
    s.screen.atom = 1;
    s.click();
    EXPECT_EQ(s.viewer.picking().selection().text, "chain A and resi 1");
    EXPECT_EQ(marked(s.viewer), s.viewer.picking().selection().count);
    EXPECT_GT(s.viewer.picking().selection().count, 10u);
    s.rest(1);
    s.see(0);
    s.click();
    EXPECT_EQ(s.viewer.picking().selection().text, "");
    EXPECT_EQ(marked(s.viewer), 0u);
}

TEST(Pointing, StructuresOfASceneHaveNoNamesInASelection) {
    PictureDescription scene = Stand::first(Style::spacefill);
    scene.input.path = "scene";
    Stand s(scene);
    s.screen.atom = 1;
    s.click();
    EXPECT_EQ(s.viewer.picking().selection().text, "chain A and resi 1");
}

TEST(Pointing, ADashIsReadItsResiduesAreSelectedAndFlownTo) {
    PictureDescription view = Stand::first(Style::licorice);
    view.look.contacts.of = parseSelection("chain A and resi 4");
    Stand s(view);
    const Representation& scene = s.viewer.document()->drawing.scene();
    ASSERT_FALSE(scene.contacts.empty());
    s.screen.atom = scene.firstContact;
    s.viewer.mouseMove({300, 200}, s.now);
    s.rest(1);
    EXPECT_NE(s.viewer.picking().annotations().hover.find("bond"), std::string::npos);
    s.click();
    const Interaction& contact = scene.contacts.front().interaction;
    const std::string both =
        "byres (id " + std::to_string(contact.a.atoms[0] + 1) + "+" + std::to_string(contact.b.atoms[0] + 1) + ")";
    EXPECT_EQ(s.viewer.picking().selection().text, both);
    s.click();
    s.rest(2);
    EXPECT_GT(s.viewer.view().camera.zoom, 1.5) << "the second click flies there";
    EXPECT_EQ(s.viewer.picking().annotations().hover, "");
}

TEST(Pointing, WhatAClickSelectsIsMarkedInTheFrame) {
    Stand s;
    s.screen.atom = 42;
    const int scenes = s.screen.scenes;
    s.viewer.mouseMove({300, 200}, s.now);
    s.rest(1);
    const Molecule& m = *s.viewer.document()->molecule;
    const Residue& residue = m.residues[m.atoms[41].residue];
    EXPECT_EQ(s.viewer.frames().marks().firstHovered, residue.firstAtom);
    EXPECT_EQ(s.viewer.frames().marks().hovered, residue.atomCount) << "what a click would take";
    const auto shownAlpha = [&] {
        const auto& spans = s.viewer.frames().shownMarks().spans;
        return spans.empty() ? 0 : int{spans.front().alpha};
    };
    const int hovered = shownAlpha();
    EXPECT_GT(hovered, 0);
    s.click();
    s.rest(1);
    EXPECT_GT(shownAlpha(), hovered) << "more strongly";
    s.see(0);
    s.click();
    s.rest(1);
    EXPECT_EQ(shownAlpha(), 0) << "and no more";
    EXPECT_EQ(s.screen.scenes, scenes) << "marks upload nothing";
}

TEST(Pointing, HoverDrawsTheAtomsOnceForAView) {
    Stand s;
    s.screen.atom = 42;
    for (int i = 0; i < 5; ++i) {
        s.viewer.mouseMove({300.0 + 10 * i, 200}, s.now);
        s.rest(0.3);
        EXPECT_NE(s.viewer.picking().annotations().hover.find("atom 42"), std::string::npos);
    }
    EXPECT_EQ(s.screen.drawn, 1);
    EXPECT_EQ(s.screen.asked, 1) << "then its pixels tell";
    s.viewer.run(ViewerCommand::rotateLeft, s.now);
    s.rest(0.5);
    EXPECT_EQ(s.screen.drawn, 2) << "another view";
}

TEST(Pointing, TheSelectionIsOutlinedInMotionIfThatIsQuick) {
    for (const bool quick : {true, false}) {
        Stand s;
        s.screen.atom = 42;
        s.screen.milliseconds = quick ? 1 : 500;
        s.click();
        s.rest(1);
        const int before = s.screen.drawn;
        EXPECT_GT(before, 0);
        s.viewer.run(ViewerCommand::autoRotate, s.now);
        s.rest(1);
        EXPECT_EQ(s.screen.drawn > before + 10, quick);
        EXPECT_EQ(s.viewer.frames().shownMarks().spans.empty(), !quick);
    }
}

TEST(Pointing, ARibbonIsMarkedWhereItIs) {
    Stand s(Style::cartoon);
    s.viewer.picking().select("chain A");
    EXPECT_EQ(s.viewer.picking().selection().count, 243u);
    const std::size_t ofAll = marked(s.viewer);
    EXPECT_GE(ofAll, 12u);                              // nucleotides
    EXPECT_LE(ofAll, 36u);                              // their backbones and bases
    s.viewer.picking().select("chain A and name OP1");  // nothing is drawn of them alone
    EXPECT_EQ(s.viewer.picking().selection().count, 11u);
    EXPECT_EQ(marked(s.viewer), 11u);
}

TEST(Pointing, ADoubleClickZoomsToTheResidue) {
    Stand s;
    s.screen.atom = 1;
    s.click();
    s.now += 0.1;
    s.click();
    s.rest(1);
    EXPECT_GT(s.viewer.view().camera.zoom, 1.5);
    s.see(0);
    s.click();
    s.now += 0.1;
    s.click();
    s.rest(1);
    EXPECT_EQ(s.viewer.view().camera.zoom, 1);
}

TEST(Pointing, ATypedSelectionIsCountedOrSaysWhatIsWrong) {
    Stand s;
    s.viewer.picking().select("chain A");
    EXPECT_TRUE(s.viewer.picking().selection().any());
    EXPECT_EQ(s.viewer.picking().selection().count, 243u);
    s.viewer.picking().select("chain A and si");
    EXPECT_FALSE(s.viewer.picking().selection().any());
    EXPECT_NE(s.viewer.picking().selection().error, "");
    EXPECT_EQ(marked(s.viewer), 0u);
}

TEST(Pointing, WhatAPanelCoversMovesTheMoleculeAside) {
    Stand s;
    const View whole = s.viewer.frames().settings().view;
    s.viewer.frames().setCovered({200, 0, 0, 0}, s.now);
    const View beside = s.viewer.frames().settings().view;
    EXPECT_EQ(beside.width, 640u);
    EXPECT_NEAR(beside.pan.x * beside.pixelsPerAngstrom, 100, 1e-9);
    EXPECT_NEAR(beside.pixelsPerAngstrom, whole.pixelsPerAngstrom * 440 / 480, 1e-9);
    EXPECT_EQ(s.viewer.frames().pictureSettings({640, 480}).view.pan, glm::dvec2(0));
    // What is under the pointer stays there.
    const glm::dvec2 before = planePointAt(beside, 500, 100);
    s.viewer.wheel(4, {500, 100}, s.now);
    const glm::dvec2 after = planePointAt(s.viewer.frames().settings().view, 500, 100);
    EXPECT_NEAR(before.x, after.x, 1e-6);
    EXPECT_NEAR(before.y, after.y, 1e-6);
}

TEST(Pointing, ALookThatIsTakenMeanwhileDoesNotStopReading) {
    Stand s;
    s.viewer.reading().open("another", s.now);
    s.viewer.run(ViewerCommand::licorice, s.now);
    for (int i = 0; i < 3; ++i) {
        s.viewer.reading().loader().wait();
        s.rest(0.1);
    }
    EXPECT_EQ(s.viewer.view().input.path, "another");
    EXPECT_EQ(s.viewer.document()->view.look.style, Style::licorice);
    EXPECT_GT(s.viewer.document()->drawing.scene().drawnBonds, 100u);
}

TEST(Pointing, ReadingThatIsStoppedLeavesWhatWasThere) {
    Stand s;
    s.viewer.reading().open("slow", s.now);
    EXPECT_TRUE(s.viewer.reading().loader().busy());
    EXPECT_EQ(s.viewer.reading().loader().progress(), 0.25);
    s.viewer.reading().cancel(s.now);
    EXPECT_FALSE(s.viewer.reading().loader().busy());
    EXPECT_TRUE(s.cancelled);
    s.viewer.reading().loader().wait();
    s.rest(0.2);
    EXPECT_EQ(s.viewer.picking().annotations().message, "stopped");
    EXPECT_EQ(s.viewer.view().input.path, "sample:dna");
    // And another can be read.
    s.viewer.reading().open("sample:dna", s.now);
    s.viewer.reading().loader().wait();
    s.rest(0.2);
    EXPECT_FALSE(s.viewer.reading().loader().busy());
}

}  // namespace
}  // namespace nacre::app
