// Names that the built-in font has no letters for.

#include "app/panel/fonts.h"

#include "tests/panel/panel_bench.h"

namespace nacre::app::test {
namespace {

TEST(Fonts, LinesRunAsTheirScriptsDo) {
    EXPECT_EQ(visualText("4hhb.pdb"), "4hhb.pdb");
    EXPECT_EQ(visualText("h\u00e9mo \u4e2d\u6587.cif"), "h\u00e9mo \u4e2d\u6587.cif");
    // From the right: shin, lamed, vav, final mem; what is Latin in it runs on from the left.
    EXPECT_EQ(visualText("\u05e9\u05dc\u05d5\u05dd.pdb"), "pdb.\u05dd\u05d5\u05dc\u05e9");
    EXPECT_EQ(visualText("A \u05d0\u05d1 1"), "A 1 \u05d1\u05d0");  // digits go on as the letters before them
    // Joined: seen at the beginning, lam and alif in one, mim apart (Unicode's presentation forms).
    EXPECT_EQ(visualText("\u0633\u0644\u0627\u0645"), "\ufee1\ufefc\ufeb3");
}

TEST(Fonts, AreAskedForOnceForEachScript) {
    std::vector<std::vector<char32_t>> asked;
    ForeignGlyphs glyphs([&](const std::vector<char32_t>& characters) {
        asked.push_back(characters);
        return std::optional<FontFile>();
    });
    glyphs.read("4hhb \u00e9 \u03b1 \u0414.pdb");
    EXPECT_FALSE(glyphs.news());
    glyphs.read("\u4e2d\u6587 \u05d0 \xff\xe4");  // and what is no UTF-8
    EXPECT_TRUE(glyphs.news());
    glyphs.find();
    EXPECT_FALSE(glyphs.news());
    ASSERT_EQ(asked.size(), 2u);
    EXPECT_EQ(asked[0], std::vector<char32_t>{0x5d0});
    EXPECT_EQ(asked[1], (std::vector<char32_t>{0x4e2d, 0x6587}));
    glyphs.read("\u6587\u4e2d");
    EXPECT_FALSE(glyphs.news());
}

TEST(Fonts, OfTheSystemAreThereWithTheNextFrame) {
    Bench b("sample:dna", kUsual);
    b.panel.glyphs();
    EXPECT_FALSE(b.panel.glyphsChanged());
    b.recent.push_back({"\u05d0.pdb", "\u05d0.pdb", 0, 0, {}});
    b.panel.showStart();
    b.settle();
    EXPECT_TRUE(b.panel.glyphsChanged());
    EXPECT_GT(b.panel.glyphs().width, 0u);
    EXPECT_FALSE(b.panel.glyphsChanged());
    for (const ImFont* font : ImGui::GetIO().Fonts->Fonts) EXPECT_TRUE(font->FindGlyphNoFallback(0x5d0));
}

}  // namespace
}  // namespace nacre::app::test
