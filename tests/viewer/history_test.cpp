// Undo and redo: whatever was done, taking all of it back ends where it began, and doing it again where it ended.

#include "app/viewer/history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "app/picture/appearance_values.h"
#include "app/viewer/parts.h"
#include "app/viewer/viewer.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"

namespace nacre::app {
namespace {

class StillScreen : public Screen {
public:
    void setScene(Representation) override {}
    double advanceOcclusion(const RenderSettings&, const OcclusionPace&) override { return 1; }
    FrameOutcome present(const RenderSettings&, const WindowFrame&) override { return FrameOutcome::shown; }
    PixelSize windowSize() const override { return {640, 480}; }
    std::uint32_t atomAt(const RenderSettings&, double x, double, double) override { return x > 400 ? 0 : 7; }
};

struct Desk {
    StillScreen screen;
    Viewer viewer;
    double now = 100;

    Desk()
        : viewer(screen, {[](const PictureDescription& v) { return sampleMolecule(v.input.path.substr(7)); }}, first(),
                 {}) {
        viewer.frames().resize({640, 480}, 1, now);
        rest();
    }
    static PictureDescription first() {
        PictureDescription v;
        v.input.path = "sample:dna";
        return v;
    }
    void rest(double seconds = 3) {
        for (const double end = now + seconds; now < end; now += 0.05) {
            viewer.reading().loader().wait();
            viewer.update(now);
        }
    }
    std::string text() const { return savedViewJson(viewer.view()); }
};

void drag(Desk& d, std::mt19937& random, MouseButton button) {
    const glm::dvec2 from(random() % 640, random() % 480), to(random() % 640, random() % 480);
    d.viewer.mouseMove(from, d.now);
    d.viewer.mouseButton(button, true, from, {}, d.now);
    for (int i = 1; i <= 4; ++i) d.viewer.mouseMove(from + (to - from) * (i / 4.0), d.now += 0.02);
    d.viewer.mouseButton(button, false, to, {}, d.now += 0.3);
}

void changeLook(Desk& d, std::mt19937& random) {
    PictureDescription look = d.viewer.view();
    const auto share = [&] { return static_cast<double>(random() % 100) / 100; };
    Effects& e = look.effects;
    switch (random() % 12) {
        case 5:
            e.contours.width = 8 * share();
            e.contours.weights = random() % 2 ? 3 : 1;
            break;
        case 6:
            e.halos.width = 24 * share();
            e.halos.strength = share();
            break;
        case 7:
            e.fog.range = random() % 2 ? Fog::Range::given : Fog::Range::automatic;
            e.fog.strength = share();
            e.fog.start = e.fog.range == Fog::Range::given ? -9 * share() : 0;
            e.fog.end = e.fog.range == Fog::Range::given ? 1 + 9 * share() : 0;
            break;
        case 8:
            e.clip.near = random() % 2 ? -5 * share() : -Clip::kNone;
            e.clip.far = random() % 2 ? 5 + share() : Clip::kNone;
            break;
        case 9:
            e.shadow.strength = share();
            e.light.highlight = 6 * share();
            e.light.occlusion = share();
            e.light.direct = 2 * share();
            break;
        case 10:
            look.look.style = random() % 2 ? Style::cartoon : Style::surface;
            look.look.cartoonOpacity = 0.1 + 0.9 * share();
            look.look.surfaceOpacity = 0.1 + 0.9 * share();
            break;
        case 11:
            e.contours.color = e.halos.color = {static_cast<float>(random() % 256) / 255.0f, 0, 1};
            look.words.measures.push_back(parseMeasure("1," + std::to_string(2 + random() % 9)));
            break;
        case 0:
            look.look.rules.push_back(parseHide("resi " + std::to_string(1 + random() % 9)));
            break;
        case 1:
            look.words.title = "title " + std::to_string(random() % 3);
            break;
        case 2:
            look.background = parseColor(random() % 2 ? "black" : "white");
            break;
        case 3: {
            const std::vector<Part> parts = listParts(*d.viewer.document()->molecule);
            PartLook of = findLook(look, parts[random() % parts.size()]);
            of.style = Style::licorice;
            setPartLook(look, parts[random() % parts.size()], of);
            break;
        }
        default:
            look.effects.light.ambient = static_cast<double>(random() % 100) / 50;
    }
    d.viewer.setLook(look, d.now);
}

/// Something that changes what is seen; camera, look, or molecule.
void act(Desk& d, std::mt19937& random) {
    using C = ViewerCommand;
    constexpr C kCommands[] = {
        C::rotateLeft, C::zoomIn,    C::panUp,          C::rollLeft,   C::fit,      C::reset,      C::orient,
        C::spacefill,  C::licorice,  C::nextColor,      C::nextPreset, C::nextLook, C::hydrogens,  C::perspective,
        C::lighting,   C::occlusion, C::nextBackground, C::legend,     C::scaleBar, C::autoRotate, C::rock};
    switch (random() % 8) {
        case 0:
            return drag(d, random, MouseButton::left);
        case 1:
            return drag(d, random, MouseButton::right);
        case 2:
            return d.viewer.wheel(2, {100, 200}, d.now += 1);
        case 3:
        case 4:
            return changeLook(d, random);
        case 5:
            if (random() % 4 == 0) d.viewer.reading().add("sample:buckyball", d.now);
            if (random() % 4 == 0) d.viewer.reading().open(random() % 2 ? "sample:glucose" : "sample:dna", d.now);
            return;
        default:
            return d.viewer.run(kCommands[random() % std::size(kCommands)], d.now);
    }
}

TEST(History, AllTakenBackIsTheStartAndAllDoneAgainTheEnd) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        Desk d;
        std::mt19937 random(seed);
        const std::string start = d.text();
        for (int i = 0; i < 25; ++i) {
            act(d, random);
            // At rest, or in the middle of whatever moves.
            d.rest(random() % 3 == 0 ? 0.1 : 1);
            if (random() % 6 == 0) d.viewer.undo(d.now);
        }
        d.viewer.run(ViewerCommand::rotateLeft, d.now);  // ends what moves by itself
        d.rest();
        const std::string end = d.text();
        int steps = 0;
        for (; d.viewer.canUndo(); ++steps) {
            d.viewer.undo(d.now);
            d.rest(random() % 2 ? 0.02 : 0.5);
            ASSERT_LT(steps, 100);
        }
        d.rest();
        EXPECT_EQ(d.text(), start) << seed;
        EXPECT_GT(steps, 5);
        while (d.viewer.canRedo()) d.viewer.redo(d.now);
        d.rest();
        EXPECT_EQ(d.text(), end) << seed;
    }
}

TEST(History, ADragIsOneStepAndASliderToo) {
    Desk d;
    EXPECT_FALSE(d.viewer.canUndo());
    const std::string start = d.text();
    std::mt19937 random(3);
    drag(d, random, MouseButton::left);
    d.rest();
    PictureDescription look = d.viewer.view();
    for (int i = 0; i < 10; ++i) {
        look.effects.light.ambient = 0.1 * i;
        d.viewer.setLook(look, d.now, i > 0);
    }
    d.viewer.undo(d.now);
    d.rest();
    EXPECT_EQ(d.viewer.view().effects.light.ambient, 1);
    EXPECT_NE(d.text(), start);
    d.viewer.undo(d.now);
    d.rest();
    EXPECT_EQ(d.text(), start);
    EXPECT_FALSE(d.viewer.canUndo());
    EXPECT_TRUE(d.viewer.canRedo());
}

TEST(History, WhatIsDoneAnewForgetsWhatWasTakenBack) {
    Desk d;
    d.viewer.run(ViewerCommand::licorice, d.now);
    d.viewer.undo(d.now);
    d.viewer.run(ViewerCommand::nextBackground, d.now);
    EXPECT_FALSE(d.viewer.canRedo());
    d.viewer.redo(d.now);
    EXPECT_EQ(d.viewer.view().look.style, std::nullopt);
}

TEST(Parts, RowsOfAMolecule) {
    const Molecule m = sampleMolecule("dna");
    const std::vector<Part> parts = listParts(m);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].name, "Chain A");
    EXPECT_EQ(parts[0].selection, "chain A and polymer");
    EXPECT_EQ(parts[0].residues, 12u);
    const std::vector<std::uint32_t> sequence = findSequence(m, 0);
    std::string letters;
    for (const std::uint32_t r : sequence) letters += residueLetter(m.residues[r]);
    EXPECT_EQ(letters, "CGCGAATTCGCG");
    EXPECT_EQ(residuesText(m, sequence[2], sequence[4]), "chain A and resi 3-5");
}

TEST(Parts, OfAPackedSceneAreCompartmentsAndEntities) {
    Molecule cell = readMolecule("a.pdb",
                                 "ATOM      1  CA  ALA A   1       0.000   0.000   0.000  1.00  0.00\n"
                                 "ATOM      2  CA  ALA B   1       4.000   0.000   0.000  1.00  0.00\n"
                                 "ATOM      3  CA  ALA C   1       8.000   0.000   0.000  1.00  0.00\n");
    cell.entities = {"1", "2", "3"};
    for (std::uint32_t i = 0; i < 3; ++i) cell.residues[i].entity = i + 1;
    cell.file.packed = "1";
    cell.file.entityNames = {{"1", "cell.membrane.spike"}, {"2", "cell.membrane.pore"}, {"3", "cell.interior.enzyme"}};
    const ResidueFacts facts(cell);
    const std::vector<Part> parts = listParts(facts);
    std::vector<std::string> names;
    for (const Part& part : parts) names.push_back(part.name);
    EXPECT_EQ(names, (std::vector<std::string>{"Compartment cell.membrane", "Compartment cell.interior",
                                               "cell.membrane.spike", "cell.membrane.pore", "cell.interior.enzyme"}));
    const std::size_t atoms[] = {2, 1, 1, 1, 1};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        EXPECT_EQ(parts[i].atoms, atoms[i]) << names[i];
        const std::vector<bool> chosen = selectAtoms(facts, parseSelection(parts[i].selection));
        EXPECT_EQ(std::count(chosen.begin(), chosen.end(), true), static_cast<std::ptrdiff_t>(atoms[i])) << names[i];
    }
}

TEST(Parts, ALookThatIsGivenIsTheOneThatIsFound) {
    const Molecule m = sampleMolecule("dna");
    const Part part = listParts(m)[1];
    PictureDescription view;
    view.look.rules.push_back(parseHide("resi 1"));
    for (int i = 0; i < 8; ++i) {
        PartLook look;
        look.seen = i & 1;
        if (i & 2) look.style = Style::licorice;
        if (i & 4) look.coloring = Coloring::uniform(0xff112233);
        setPartLook(view, part, look);
        const PartLook found = findLook(view, part);
        EXPECT_EQ(found.seen, look.seen);
        EXPECT_EQ(found.style, look.style);
        EXPECT_EQ(found.coloring, look.coloring);
        // And the scene has it: a chain of 12 residues more or less.
        const Appearance seen = makeAppearance(m, drawnAtoms(m), view.look);
        EXPECT_EQ(seen.atoms.size() > m.atoms.size() / 2, look.seen) << i;
        EXPECT_EQ(parseSavedView(savedViewJson(view), "it").look, view.look);
    }
    EXPECT_EQ(view.look.rules.front().selection.text, "resi 1");
}

TEST(Parts, CompletionsGoOnWithWhatIsTyped) {
    const Molecule m = sampleMolecule("dna");
    EXPECT_EQ(completions("chain ", m, 9), (std::vector<std::string>{"chain A", "chain B"}));
    EXPECT_EQ(completions("chain A and si", m, 9), std::vector<std::string>{"chain A and sidechain"});
    EXPECT_EQ(completions("resn d", m, 2), (std::vector<std::string>{"resn DA", "resn DC"}));
    EXPECT_TRUE(completions("", m, 9).empty());
    for (const std::string& text : completions("n", m, 9)) EXPECT_EQ(text[0], 'n');
}

}  // namespace
}  // namespace nacre::app
