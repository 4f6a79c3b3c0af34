// What the panel does: keys, clicks, rows, rules, the sequence.

#include "app/panel/panel.h"

#include "app/picture/appearance_values.h"
#include "app/picture/options.h"
#include "tests/panel/panel_bench.h"

namespace nacre::app::test {
namespace {

TEST(Panel, AListClosesOnEscapeAndOnAClickBeside) {
    for (const bool escape : {true, false}) {
        Bench b("sample:dna", kUsual);
        b.click("Colours");
        ASSERT_TRUE(b.find("Rainbow, start to end"));
        EXPECT_TRUE(b.panel.input().ownsKeys());
        if (escape)
            b.press(SpecialKey::escape);
        else
            b.clickAt(800, 300);
        b.settle();
        EXPECT_FALSE(b.find("Rainbow, start to end"));
        EXPECT_FALSE(b.panel.input().ownsKeys());
        EXPECT_EQ(b.viewer.view().look.color, Coloring(ColorScheme::element));
    }
}

TEST(Panel, AnErrorStaysUntilItIsRead) {
    Bench b("", kUsual);
    b.viewer.reading().open("nothing.pdb", b.now);
    b.settle();
    b.now += 60;
    b.settle();
    ASSERT_TRUE(b.find("Close"));
    bool advised = false;
    for (const Control& c : b.panel.controls()) advised |= c.name.find("Check the name") != std::string::npos;
    EXPECT_TRUE(advised);
    b.click("Close");
    EXPECT_EQ(b.viewer.messages().failure(), "");
    EXPECT_TRUE(b.find("DNA"));
}

TEST(Panel, ACardIsAsHighAsWhatComesToStandInIt) {
    Bench b("", kUsual);
    for (int i = 0; i < 10; ++i) b.frame();
    ASSERT_FALSE(b.panel.restless());
    b.viewer.messages().fail("the file is gone", b.now);
    // Frames are drawn as long as they are asked for, as in a shell.
    b.frame();
    for (int i = 0; i < 20 && b.panel.restless(); ++i) b.frame();
    for (const char* name : {"Close", "Open", "DNA", "Help"}) EXPECT_TRUE(b.find(name)) << name;
}

/// Of the controls of a window those that keys do not come to.
std::vector<std::string> unreached(Bench& b, const std::string& window) {
    std::vector<std::string> missed;
    for (const Control& c : b.panel.controls())
        if (c.role != "text" && c.enabled && c.window == window) missed.push_back(c.name);
    EXPECT_GE(missed.size(), 2u);
    const std::size_t most = missed.size();
    const auto look = [&](std::vector<std::string>& met) {
        for (const Control& c : b.panel.controls()) {
            if (!c.focused) continue;
            EXPECT_TRUE(c.seen()) << c.name << " is scrolled to";
            met.push_back(c.name);
            std::erase(missed, c.name);
        }
    };
    // One after the other, as they stand, and back.
    std::vector<std::string> forth, back;
    for (std::size_t i = 0; i < most; ++i) b.press(SpecialKey::tab), look(forth);
    for (std::size_t i = 1; i < most; ++i) b.press(SpecialKey::tab, {true, false}), look(back);
    std::reverse(forth.begin(), forth.end());
    EXPECT_EQ(std::vector(forth.begin() + 1, forth.end()), back);
    return missed;
}

TEST(Panel, KeysReachEveryControl) {
    for (const std::string_view page : kPages) {
        Bench b("sample:dna", kUsual);
        b.panel.showPage(page);
        b.settle();
        EXPECT_EQ(unreached(b, "Nacre"), std::vector<std::string>()) << page;
        EXPECT_TRUE(b.panel.input().ownsKeys());
        b.press(SpecialKey::escape);
        EXPECT_FALSE(b.panel.input().ownsKeys());
    }
    const auto cards = {
        std::pair("Save", &Panel::showSave), {"Start", &Panel::showStart}, {"Help", &Panel::toggleHelp}};
    for (const auto& [window, show] : cards) {
        Bench b("sample:dna", kUsual);
        (b.panel.*show)();
        b.settle();
        EXPECT_EQ(unreached(b, window), std::vector<std::string>()) << window;
    }
}

TEST(Panel, EnterPressesWhatHasTheFocus) {
    Bench b("sample:dna", kUsual);
    const auto goTo = [&](const std::string& name) {
        const auto there = [&] {
            const auto& all = b.panel.controls();
            return std::any_of(all.begin(), all.end(), [&](const Control& c) { return c.focused && c.name == name; });
        };
        for (int i = 0; i < 60 && !there(); ++i) b.press(SpecialKey::tab);
        ASSERT_TRUE(there()) << name;
    };
    goTo("Licorice");
    b.press(SpecialKey::enter);
    EXPECT_EQ(b.viewer.view().look.style, Style::licorice);
    goTo("Colours");
    EXPECT_EQ(b.find("Colours")->value, "By element");
    b.press(SpecialKey::enter);  // the list, whose second line is taken
    b.press(SpecialKey::down);
    b.press(SpecialKey::enter);
    b.settle();
    EXPECT_EQ(b.find("Colours")->value, "By chain");
    EXPECT_EQ(b.viewer.view().look.style, Style::licorice);
}

TEST(Panel, TheFieldOfTheSelectionKeepsTheFocus) {
    Bench b("sample:dna", kUsual);
    b.panel.showPage("Select");
    b.settle();
    const auto typed = [&](const std::string& text) {
        for (const char c : text) b.panel.input().character(static_cast<char32_t>(c));
        b.settle();
        b.press(SpecialKey::enter);
        b.settle();
    };
    b.click("Selection");
    typed("chain A");
    EXPECT_EQ(b.viewer.picking().selection().text, "chain A");
    const PictureDescription before = b.viewer.view();
    typed("chain B");  // in its place: no shortcuts, and not behind it
    EXPECT_EQ(b.viewer.picking().selection().text, "chain B");
    EXPECT_EQ(savedViewJson(b.viewer.view()), savedViewJson(before));
}

TEST(Panel, RulesAreSwitchedOffEditedAndMoved) {
    Bench b("sample:dna", kUsual);
    PictureDescription look = b.viewer.view();
    look.look.rules = {parseHide("chain A"), parseShow("chain B=licorice")};
    b.viewer.setLook(look, b.now);
    b.panel.showPage("Select");
    b.settle();
    const auto drawn = [&] { return b.viewer.document()->drawing.scene().drawnAtoms; };
    const std::size_t half = drawn();
    b.click("Switch off: Hide chain A");
    EXPECT_EQ(drawn(), 486u);
    EXPECT_LT(half, 300u);
    b.click("Switch on: Hide chain A");
    EXPECT_EQ(drawn(), half);
    b.click("Hide chain A");
    b.click("Atoms of the rule");
    b.press(SpecialKey::end);
    for (const char c : std::string(" and resi 1")) {
        b.panel.input().character(static_cast<char32_t>(c));
        b.frame();
    }
    b.settle();
    EXPECT_EQ(b.viewer.view().look.rules[0].selection.text, "chain A and resi 1");
    EXPECT_GT(drawn(), 400u);
    expectReadable(b, "an open rule");
    b.press(SpecialKey::escape);
    b.click("Later");
    EXPECT_EQ(b.viewer.view().look.rules[1].action, Rule::Action::hide);
    b.click("chain B: Licorice");
    ASSERT_TRUE(b.find("Style of the rule"));
    b.click("Remove");
    ASSERT_EQ(b.viewer.view().look.rules.size(), 1u);
    EXPECT_EQ(b.viewer.view().look.rules[0].action, Rule::Action::hide);
    // What is typed after a click into the field replaces what stands there, as after a click on the molecule.
    b.click("Nucleic acid");
    b.settle();
    EXPECT_EQ(b.viewer.picking().selection().text, "nucleic");
    b.click("Selection");
    for (const char c : std::string("chain B")) {
        b.panel.input().character(static_cast<char32_t>(c));
        b.frame();
    }
    b.settle();
    EXPECT_EQ(b.viewer.picking().selection().text, "chain B");
    b.press(SpecialKey::escape);
}

TEST(Panel, RibbonsAndSurfacesLetThroughWhatASliderSays) {
    Bench b("sample:dna", {1600, 1500});
    PictureDescription look = b.viewer.view();
    look.look.rules = {parseShow("chain B and resi 1-2=surface"), parseShow("chain A and resi 3=licorice")};
    b.viewer.setLook(look, b.now);
    b.click("Cartoon");
    for (const auto& [name, value] : {std::pair("Cartoon opacity", &RepresentationOptions::cartoonOpacity),
                                      {"Surface opacity", &RepresentationOptions::surfaceOpacity},
                                      {"Atom opacity", &RepresentationOptions::atomOpacity}}) {
        const Control* slider = b.find(name, "slider");
        ASSERT_TRUE(slider) << name;
        EXPECT_EQ(b.viewer.view().look.*value, 1);
        b.panel.input().pointer({slider->right - 5, (slider->top + slider->bottom) / 2});
        b.frame();
        b.panel.input().button(MouseButton::left, true);
        b.frame();
        b.panel.input().pointer({(slider->left + slider->right) / 2, (slider->top + slider->bottom) / 2});
        for (int i = 0; i < 4; ++i) b.frame();
        EXPECT_EQ(b.viewer.view().look.*value, 1) << "while it is held no scene is built";
        b.panel.input().button(MouseButton::left, false);
        b.settle();
        EXPECT_NEAR(b.viewer.view().look.*value, 0.55, 0.02) << name;
        EXPECT_NEAR(parseSavedView(savedViewJson(b.viewer.view()), "view").look.*value, 0.55, 0.02) << name;
    }
    expectReadable(b, "opacities");
}

TEST(Panel, LinesHalosAndFogHaveSlidersAndColours) {
    Bench b("sample:dna", {1900, 1800});
    const auto effects = [&]() -> const Effects& { return b.viewer.view().effects; };
    const auto slideTo = [&](const std::string& name, double share) {
        const Control* slider = b.find(name, "slider");
        ASSERT_TRUE(slider) << name;
        const float track = slider->right - slider->left - 2 * slider->inset;
        b.clickAt(slider->left + slider->inset + share * track, (slider->top + slider->bottom) / 2);
    };
    const auto color = [&](const std::string& name) {
        b.click(name);
        b.click("Vermilion");
        b.press(SpecialKey::escape);
        b.settle();
    };
    b.click("Light, outlines, fog");
    EXPECT_FALSE(b.find("Outline colour"));
    slideTo("Outlines", 0.5);
    EXPECT_NEAR(effects().contours.width, 4, 0.3);
    color("Outline colour");
    const auto [r, g, blue, a] = parseColor("#d55e00");
    EXPECT_EQ(effects().contours.color, (std::array{r, g, blue}));
    slideTo("Halos", 0.5);
    color("Halo colour");
    EXPECT_EQ(effects().halos.color, (std::array{r, g, blue}));
    slideTo("Fog", 0.7);
    EXPECT_EQ(effects().fog.range, Fog::Range::automatic);
    expectReadable(b, "all effects");
    slideTo("Start of fog", 0.4);
    EXPECT_EQ(effects().fog.range, Fog::Range::given);
    const double radius = b.viewer.document()->drawing.scene().radius;
    EXPECT_NEAR(effects().fog.start, -0.4 * radius, 0.1 * radius);
    EXPECT_NEAR(effects().fog.end, radius, 1);
    slideTo("End of fog", 0.3);
    EXPECT_NEAR(effects().fog.end, -0.8 * radius, 0.1 * radius);
    EXPECT_LT(effects().fog.start, effects().fog.end);
    // What was saved with it is read again.
    EXPECT_EQ(parseSavedView(savedViewJson(b.viewer.view()), "view").effects, effects());
    b.click("Fog from the centre to the far end");
    EXPECT_EQ(effects().fog.range, Fog::Range::automatic);
    b.click("Clipping planes");
    slideTo("Back clipping plane", 0.6);
    EXPECT_LT(effects().clip.far, 0.3 * radius);
    EXPECT_EQ(parseSavedView(savedViewJson(b.viewer.view()), "view").effects, effects());
}

TEST(Panel, MeasurementsAreToldByTheirAtoms) {
    Bench b("sample:dna", kUsual);
    PictureDescription look = b.viewer.view();
    look.words.measures.push_back(parseMeasure("chain A and resi 1 and name C1',chain B and resi 24 and name C1'"));
    b.viewer.setLook(look, b.now);
    b.panel.showPage("Labels");
    b.settle();
    const auto told = [&](const std::string& words) {
        return std::any_of(b.panel.controls().begin(), b.panel.controls().end(), [&](const Control& c) {
            return c.role == "text" && c.name.find(words) != std::string::npos;
        });
    };
    EXPECT_TRUE(told(" Å, DC 1 C1' to DG 24 C1'"));
    EXPECT_FALSE(told("Atoms "));
    // Of what is not drawn nothing is measured: the row stays, so that it can be removed.
    b.viewer.run(ViewerCommand::undo, b.now);
    look.look.rules.push_back(parseHide("chain B"));
    b.viewer.setLook(look, b.now);
    b.settle();
    EXPECT_TRUE(told("Atoms chain A and resi 1 and name C1',chain B"));
    b.click("Remove");
    EXPECT_TRUE(b.viewer.view().words.measures.empty());
}

TEST(Panel, ADoubleClickOnASliderTypesItsNumber) {
    Bench b("sample:dna", kUsual);
    PictureDescription look = b.viewer.view();
    look.look.style = Style::cartoon;
    b.viewer.setLook(look, b.now);
    b.settle();
    const Control* slider = b.find("Cartoon opacity");
    ASSERT_NE(slider, nullptr);
    b.panel.input().pointer({(slider->left + slider->right) / 2, (slider->top + slider->bottom) / 2});
    for (int i = 0; i < 2; ++i) {
        b.panel.input().button(MouseButton::left, true);
        b.frame();
        b.panel.input().button(MouseButton::left, false);
        b.frame();
    }
    ASSERT_TRUE(b.panel.input().ownsKeys());
    for (const char c : std::string("0.25")) b.panel.input().character(static_cast<char32_t>(c)), b.frame();
    b.press(SpecialKey::enter);
    b.settle();
    EXPECT_EQ(b.viewer.view().look.cartoonOpacity, 0.25);
    EXPECT_FALSE(b.panel.input().ownsKeys());
}

TEST(Panel, LabelsOfAnaglyphsHaveTheDepthOfTheirAtoms) {
    Bench b("sample:glucose", {800, 600});
    PictureDescription look = b.viewer.view();
    setOption(option("stereo"), "anaglyph", look);
    setOption(option("label"), "id 1=I", look);
    setOption(option("eye-distance"), "12", look);
    setOption(option("legend"), "off", look);
    b.viewer.setLook(look, b.now);
    b.settle();
    const Overlay& overlay = *b.panel.draw(b.viewer, b.size, b.now);
    std::array<double, 3> sum{}, count{};  // by eye
    for (const OverlayBatch& batch : overlay.batches)
        for (std::uint32_t i = 0; i < batch.indexCount; ++i) {
            sum[static_cast<std::size_t>(batch.eye)] += overlay.vertices[overlay.indices[batch.firstIndex + i]].x;
            count[static_cast<std::size_t>(batch.eye)] += 1;
        }
    ASSERT_GT(count[1], 0);
    EXPECT_EQ(count[1], count[2]);
    const Document& document = *b.viewer.document();
    const glm::dvec3 atom = glm::dvec3(document.placed->atoms[0].position) - document.drawing.scene().center;
    const std::vector<FreePart> parts = b.viewer.frames().freeParts();
    const auto measureColumn = [&](const FreePart& part) { return b.viewer.frames().projectPoint(atom, part.view).x; };
    const double apart = measureColumn(parts[1]) - measureColumn(parts[0]);
    EXPECT_GT(std::abs(apart), 1.5);
    EXPECT_NEAR(sum[2] / count[2] - sum[1] / count[1], apart, 1.1);  // text stands on whole pixels
}

}  // namespace
}  // namespace nacre::app::test
