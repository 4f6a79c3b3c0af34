// The page of parts: rows, several molecules, the sequence.

#include <imgui.h>

#include "app/panel/panel.h"
#include "app/picture/appearance_values.h"
#include "tests/panel/panel_bench.h"

namespace nacre::app::test {
namespace {

TEST(Panel, RowsOfPartsHideAndColour) {
    Bench b("sample:dna", kUsual);
    b.panel.showPage("Parts");
    b.settle();
    const std::size_t all = b.viewer.document()->drawing.scene().drawnAtoms;
    b.click("Hide Chain A");
    EXPECT_LT(b.viewer.document()->drawing.scene().drawnAtoms, all);
    b.click("Show Chain A");
    EXPECT_EQ(b.viewer.document()->drawing.scene().drawnAtoms, all);
    EXPECT_TRUE(b.viewer.view().look.rules.empty());
    b.click("Undo");
    EXPECT_LT(b.viewer.document()->drawing.scene().drawnAtoms, all);
    b.click("Colour of Chain B");
    b.click("Vermilion");
    ASSERT_EQ(b.viewer.view().look.rules.size(), 2u);
    EXPECT_EQ(b.viewer.view().look.rules.back().coloring, Coloring::uniform(IM_COL32(0xd5, 0x5e, 0, 255)));
    b.panel.showPage("Select");
    b.settle();
    bool named = false;
    for (const Control& c : b.panel.controls()) named |= c.role == "button" && c.name.ends_with(": Vermilion");
    EXPECT_TRUE(named);
}

TEST(Panel, PartsOfAScenesStructuresNeedNoNames) {
    Bench b("scene.mvsj", kUsual, 1, PanelHand::mouse, {[](const PictureDescription&) {
                Molecule scene = sampleMolecule("dna");
                scene.modelsAreInputs = true;
                scene.chains.at(1).model = 2;
                return scene;
            }});
    b.panel.showPage("Parts");
    b.settle();
    b.click("Hide Chain B");
    ASSERT_EQ(b.viewer.view().look.rules.size(), 1u);
    EXPECT_EQ(b.viewer.view().look.rules[0].selection.text, "chain B and polymer");
}

TEST(Panel, AnotherMoleculeStandsBesideWhatIsOpen) {
    Bench b("sample:dna", {1000, 900});
    b.panel.showStart();
    b.settle();
    b.click("Add to current scene");
    b.click("Buckyball");
    ASSERT_EQ(b.viewer.document()->molecule->atoms.size(), 486u + 60u);
    EXPECT_EQ(b.viewer.title(), "sample:dna + sample:buckyball - Nacre");
    EXPECT_EQ(b.viewer.playback().models(), 1) << "molecules are no models to step through";
    ASSERT_EQ(b.viewer.view().look.rules.size(), 1u);
    EXPECT_EQ(b.viewer.view().look.rules[0].selection.text, "/buckyball");
    b.panel.showPage("Parts");
    b.settle();
    expectReadable(b, "parts of two molecules");
    const auto drawn = [&] { return b.viewer.document()->drawing.scene().drawnAtoms; };
    const std::size_t all = drawn();
    b.click("Hide 60C");
    EXPECT_EQ(drawn(), all - 60);
    b.click("Hide Chain A");
    EXPECT_LT(drawn(), 300u);
    EXPECT_EQ(b.viewer.view().look.rules.back().selection.text, "/dna and chain A and polymer");
    // A click says which molecule it means, and so does what is typed.
    b.viewer.picking().select("/buckyball");
    EXPECT_EQ(b.viewer.picking().selection().count, 60u);
    // What is saved with both is read with both, and means the same.
    const PictureDescription again = parseSavedView(savedViewJson(b.viewer.view()), "view");
    EXPECT_EQ(again.input.further, b.viewer.view().input.further);
    EXPECT_EQ(again.look.rules, b.viewer.view().look.rules);
    for (int i = 0; i < 3; ++i) b.click("Undo");
    EXPECT_EQ(b.viewer.document()->molecule->atoms.size(), 486u);
    EXPECT_TRUE(b.viewer.view().look.rules.empty());
    b.click("Redo");
    EXPECT_EQ(b.viewer.document()->molecule->atoms.size(), 546u);
    b.viewer.reading().open("sample:glucose", b.now);
    b.settle();
    EXPECT_TRUE(b.viewer.view().input.further.empty());
}

TEST(Panel, StructuresAreTakenForConformations) {
    Sources sources = sampleSources();
    sources.motion = [](const std::shared_ptr<const Molecule>& molecule,
                        const PictureDescription& v) -> std::unique_ptr<Motion> {
        auto models = trajectoryOfModels(molecule, v.input.model);
        return models ? std::make_unique<Motion>(std::move(models), *molecule, MotionOptions()) : nullptr;
    };
    Bench b("sample:dna", {1500, 1400}, 1, PanelHand::mouse, sources);
    b.panel.showPage("Parts");
    b.settle();
    EXPECT_FALSE(b.find("Conformations of one molecule"));
    b.viewer.reading().add("sample:dna", b.now);
    b.settle();
    EXPECT_EQ(b.viewer.document()->molecule->atoms.size(), 2 * 486u);
    b.click("Conformations of one molecule");
    EXPECT_EQ(b.viewer.document()->molecule->atoms.size(), 486u);
    EXPECT_TRUE(b.viewer.view().look.rules.empty()) << "/dna_2 is none of its atoms";
    EXPECT_EQ(b.viewer.playback().clock().frames(), 2u);
    EXPECT_TRUE(b.viewer.playback().canMorph());
    expectReadable(b, "conformations");
    const PictureDescription again = parseSavedView(savedViewJson(b.viewer.view()), "view");
    EXPECT_TRUE(again.input.conformations);
    b.click("Conformations of one molecule");
    EXPECT_EQ(b.viewer.document()->molecule->atoms.size(), 2 * 486u);
    EXPECT_EQ(b.viewer.view().look.rules.size(), 1u) << "colours tell them apart again";
    b.click("Undo");
    EXPECT_EQ(b.viewer.document()->molecule->atoms.size(), 486u);
}

TEST(Panel, StructuresAreRenamedAndRemoved) {
    Bench b("sample:dna", {1500, 1400});
    b.viewer.reading().add("sample:buckyball", b.now);
    b.settle();
    PictureDescription look = b.viewer.view();
    look.look.rules.push_back(parseHide("/dna and chain A"));
    look.look.rules.push_back(parseHide("/buckyball and id 1"));
    b.viewer.setLook(look, b.now);
    b.panel.showPage("Parts");
    b.settle();
    b.click("Rename dna");
    b.click("Name of dna");
    const auto rename = [&](const std::string& to) {
        for (int i = 0; i < 20; ++i) b.press(SpecialKey::backspace);
        for (const char c : to) {
            b.panel.input().character(static_cast<char32_t>(c));
            b.frame();
        }
        b.press(SpecialKey::enter);
        b.settle();
    };
    rename("buckyball");
    EXPECT_TRUE(b.find("another structure is named buckyball", "text"));
    b.click("Name of dna");
    rename("helix");
    EXPECT_EQ(b.viewer.view().input.name, "helix");
    EXPECT_EQ(b.viewer.view().look.rules[1].selection.text, "/helix and chain A");
    EXPECT_EQ(b.viewer.view().look.rules[2].selection.text, "/buckyball and id 1") << "of the other one";
    EXPECT_TRUE(b.find("Hide helix"));
    b.viewer.picking().select("/helix and chain B");
    EXPECT_EQ(b.viewer.picking().selection().count, 243u) << "half of 486 atoms";
    b.click("Remove buckyball");
    EXPECT_TRUE(b.viewer.view().input.further.empty());
    EXPECT_EQ(b.viewer.document()->molecule->atoms.size(), 486u);
    EXPECT_TRUE(b.viewer.view().look.rules.empty()) << "names mean nothing for one structure";
}

TEST(Panel, SwatchesAndSequenceShowTheDrawnColor) {
    PictureDescription picture = Bench::makeView("sample:dna");
    picture.look.style = Style::cartoon;
    picture.look.color = ColorScheme::chainCarbons;
    Bench b("sample:dna", {1000, 1000});
    b.viewer.setLook(picture, b.now);
    b.panel.showPage("Parts");
    b.settle();
    b.click("Chain A");
    const Representation& scene = b.viewer.document()->drawing.scene();
    ASSERT_FALSE(scene.meshLooks.empty());
    const std::uint32_t drawn = scene.meshLooks.front().color | 0xff000000u;
    const Control* swatch = b.find("Colour of Chain A");
    const Control* sequence = b.find("Sequence of Chain A");
    ASSERT_TRUE(swatch && sequence);
    const Overlay& overlay = *b.panel.draw(b.viewer, b.size, b.now);
    std::size_t inSwatch = 0, inSequence = 0;
    for (const OverlayVertex& v : overlay.vertices) {
        if (v.color != drawn) continue;
        const auto within = [&](const Control& c) {
            return v.x >= c.left && v.x <= c.right && v.y >= c.top && v.y <= c.bottom;
        };
        inSwatch += within(*swatch);
        inSequence += within(*sequence);
    }
    EXPECT_GT(inSwatch, 3u);
    EXPECT_GE(inSequence, 12u * 4) << "a bar for each of 12 nucleotides";
}

TEST(Panel, SeveralMoleculesAreLaidOntoTheFirst) {
    Bench b("sample:dna", {1000, 900});
    b.viewer.reading().open(std::vector<std::string>{"sample:dna", "sample:dna"}, b.now);
    b.settle();
    ASSERT_EQ(b.viewer.document()->molecule->atoms.size(), 2u * 486u);
    b.panel.showPage("Parts");
    b.settle();
    b.click("Superposed on dna");
    ASSERT_EQ(b.viewer.view().input.fits.size(), 1u);
    EXPECT_EQ(b.viewer.view().input.fits[0].fixed.text, "/dna");
    EXPECT_EQ(b.viewer.document()->view.input.fits, b.viewer.view().input.fits) << b.viewer.messages().failure();
    expectReadable(b, "a fit");
    b.click("Superposed on dna");
    EXPECT_TRUE(b.viewer.view().input.fits.empty());
    b.click("Undo");
    EXPECT_EQ(b.viewer.view().input.fits.size(), 1u);
    // What cannot be laid stays where it is, and the view does not say otherwise.
    Sources unlike = sampleSources();
    unlike.read = [read = unlike.read](const PictureDescription& view) {
        if (!view.input.fits.empty())
            throw Error("cannot fit", "/dna_2", "fewer than three of its atoms have a counterpart");
        return read(view);
    };
    Bench other("sample:dna", {1000, 900}, 1, PanelHand::mouse, unlike);
    other.viewer.reading().add("sample:dna", other.now);
    other.panel.showPage("Parts");
    other.settle();
    other.click("Superposed on dna");
    EXPECT_NE(other.viewer.messages().failure(), "");
    const PictureDescription& view = other.viewer.view();
    EXPECT_TRUE(view.input.fits.empty());
    EXPECT_EQ(other.find("Superposed on dna")->value, "off");
}

TEST(Panel, ADragAcrossTheSequenceSelectsResidues) {
    Bench b("sample:dna", kUsual);
    b.panel.showPage("Parts");
    b.settle();
    b.click("Chain A");
    const Control* sequence = b.find("Sequence of Chain A");
    ASSERT_TRUE(sequence);
    const double y = sequence->top + 15, x = sequence->left + 36, letter = 11.5;
    b.panel.input().pointer({x + letter * 2.5, y});
    b.frame();
    b.panel.input().button(MouseButton::left, true);
    b.frame();
    b.panel.input().pointer({x + letter * 4.5, y});
    b.frame();
    b.panel.input().button(MouseButton::left, false);
    b.settle();
    EXPECT_EQ(b.viewer.picking().selection().text, "chain A and resi 3-5");
    EXPECT_GT(b.viewer.picking().selection().count, 50u);
    const std::vector<bool>& marked = b.viewer.frames().marks().selected;
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(marked, true)), b.viewer.picking().selection().count);
}

TEST(Panel, KeysGoAlongTheSequence) {
    Bench b("sample:dna", kUsual);
    b.panel.showPage("Parts");
    b.settle();
    b.click("Chain A");
    const auto focused = [&] {
        const Control* sequence = b.find("Sequence of Chain A");
        return sequence && sequence->focused;
    };
    for (int i = 0; i < 60 && !focused(); ++i) b.press(SpecialKey::tab);
    ASSERT_TRUE(focused());
    b.press(SpecialKey::right);
    b.settle();
    EXPECT_EQ(b.viewer.picking().selection().text, "chain A and resi 1");
    b.press(SpecialKey::right);
    b.press(SpecialKey::right, {true, false});
    b.settle();
    EXPECT_EQ(b.viewer.picking().selection().text, "chain A and resi 2-3");
    EXPECT_TRUE(focused());
}

}  // namespace
}  // namespace nacre::app::test
