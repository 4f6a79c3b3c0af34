// The palette of commands and options, and the menu of a right click.

#include <algorithm>

#include "tests/panel/panel_bench.h"

namespace nacre::app::test {
namespace {

void typeKeys(Bench& b, const std::string& text) {
    for (const char c : text) {
        EXPECT_FALSE(b.panel.input().type(static_cast<char32_t>(c)));
        b.frame();
    }
    b.settle();
}

void openPalette(Bench& b) {
    b.panel.showPalette();
    b.settle();
}

TEST(Palette, FindsOptionsByLabelAndHelp) {
    Bench b("sample:dna", kUsual);
    openPalette(b);
    typeKeys(b, "licorice");
    ASSERT_TRUE(b.find("Style: Licorice"));
    b.press(SpecialKey::enter);
    b.settle();
    EXPECT_EQ(b.viewer.view().look.style, Style::licorice);
    EXPECT_FALSE(b.find("Find")) << "it is closed";
    EXPECT_TRUE(b.viewer.canUndo());
    openPalette(b);
    typeKeys(b, "sphere van der waals");  // of its meaning
    EXPECT_TRUE(b.find("Style: Spacefill"));
}

TEST(Palette, SetsAnOptionToAValue) {
    Bench b("sample:dna", kUsual);
    openPalette(b);
    typeKeys(b, "contours 2.5");
    b.press(SpecialKey::enter);
    b.settle();
    EXPECT_EQ(b.viewer.view().effects.contours.width, 2.5);
    openPalette(b);
    typeKeys(b, "contours wide");
    b.press(SpecialKey::enter);
    b.settle();
    EXPECT_EQ(b.viewer.view().effects.contours.width, 2.5) << "that is none";
}

TEST(Palette, AsksForTheValueOfAnOptionWithoutAControl) {
    Bench b("sample:dna", kUsual);
    const auto open = [&](const std::string& words) {
        openPalette(b);
        typeKeys(b, words);
        b.press(SpecialKey::enter);
        b.settle();
    };
    open("contours");
    ASSERT_TRUE(b.find("Value of contours"));
    EXPECT_EQ(b.find("Value of contours")->value, "off") << "what it is now";
    typeKeys(b, "wide");  // in place of it
    EXPECT_TRUE(std::ranges::any_of(b.panel.controls(), [](const Control& c) {
        return c.window == "Commands" && c.name.find("expected") != std::string::npos;
    })) << "what is wrong";
    b.press(SpecialKey::enter);
    b.settle();
    EXPECT_TRUE(b.find("Value of contours")) << "it stays until it is right";
    typeKeys(b, "2.5");
    ASSERT_EQ(b.find("Value of contours")->value, "2.5") << "it is typed anew";
    b.press(SpecialKey::enter);
    b.settle();
    EXPECT_FALSE(b.find("Value of contours"));
    EXPECT_EQ(b.viewer.view().effects.contours.width, 2.5);
    open("pocket ...");
    typeKeys(b, "resi 5");
    b.press(SpecialKey::enter);
    b.settle();
    ASSERT_TRUE(b.viewer.view().look.contacts.of);
    EXPECT_EQ(b.viewer.view().look.contacts.of->text, "resi 5");
    open("contours");
    b.press(SpecialKey::escape);
    b.settle();
    openPalette(b);
    EXPECT_TRUE(b.find("Find")) << "it begins anew";
}

TEST(Palette, RunsCommandsChosenByArrows) {
    Bench b("sample:dna", kUsual);
    openPalette(b);
    typeKeys(b, "model or frame");
    const Control* second = nullptr;
    int rows = 0;
    for (const Control& c : b.panel.controls())
        if (c.window == "Commands" && c.name.find("model or frame") != std::string::npos && ++rows == 2) second = &c;
    ASSERT_TRUE(second);
    const std::string name = second->name;
    b.press(SpecialKey::down);
    b.settle();
    b.press(SpecialKey::enter);
    b.settle();
    ASSERT_EQ(b.asked.size(), 1u);
    const auto all = keyBindings();
    const auto binding = std::find_if(all.begin(), all.end(), [&](const Binding& of) { return of.what == name; });
    ASSERT_NE(binding, all.end());
    EXPECT_EQ(b.asked.front(), binding->command);
}

void rightClick(Bench& b) {
    b.viewer.mouseButton(MouseButton::right, true, {700, 300}, {}, b.now);
    b.viewer.mouseButton(MouseButton::right, false, {700, 300}, {}, b.now);
    b.settle();
}

TEST(ContextMenu, ActsOnTheResidueAndItsChain) {
    Bench b("sample:dna", kUsual);  // whose screen has atom 1 everywhere
    rightClick(b);
    EXPECT_TRUE(b.find("Hide"));
    b.click("Chain A");
    EXPECT_EQ(b.viewer.picking().selection().text, "chain A");
    const std::size_t all = b.viewer.document()->drawing.scene().drawnAtoms;
    b.click("Hide");
    b.settle();
    EXPECT_LT(b.viewer.document()->drawing.scene().drawnAtoms, all);
    EXPECT_FALSE(b.find("Hide")) << "the menu is closed";
    rightClick(b);
    EXPECT_TRUE(b.find("Hide"));
    EXPECT_EQ(b.panel.input().press(SpecialKey::escape, true), ViewerCommand::clearPicks);
    EXPECT_TRUE(b.panel.closeTop());
}

TEST(ContextMenu, ADragWithTheRightButtonMovesThePicture) {
    Bench b("sample:dna", kUsual);
    b.viewer.mouseButton(MouseButton::right, true, {700, 300}, {}, b.now);
    b.viewer.mouseMove({740, 320}, b.now);
    b.viewer.mouseButton(MouseButton::right, false, {740, 320}, {}, b.now);
    b.settle();
    EXPECT_NE(b.viewer.view().camera.pan, glm::dvec2(0));
    EXPECT_FALSE(b.find("Hide"));
}

TEST(Structures, AreHiddenAndRemovedAsAWhole) {
    Bench b("sample:dna", {1000, 900});
    b.viewer.open({"sample:glucose"}, true, b.now);
    b.panel.showPage("Parts");
    b.settle();
    const std::size_t all = b.viewer.document()->drawing.scene().drawnAtoms;
    b.click("Hide dna");
    EXPECT_EQ(b.viewer.document()->drawing.scene().drawnAtoms, all - 486);
    b.click("Show dna");
    b.click("Remove dna");
    b.settle();
    EXPECT_EQ(b.viewer.document()->view.input.path, "sample:glucose");
    EXPECT_TRUE(b.viewer.document()->view.input.further.empty());
    EXPECT_TRUE(b.viewer.view().look.rules.empty());
    b.click("Undo");
    b.settle();
    EXPECT_EQ(b.viewer.document()->view.input.further.size(), 1u);
}

}  // namespace
}  // namespace nacre::app::test
