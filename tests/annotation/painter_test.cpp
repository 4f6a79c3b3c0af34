#include "app/annotation/painter.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/annotation/layout.h"
#include "engine/scene/color/palettes.h"
#include "tests/annotation/paper.h"

namespace nacre::app {
namespace {

Picture filled(std::uint32_t side, float value, float alpha) {
    Picture picture{side, side, {}};
    for (std::uint32_t i = 0; i < side * side; ++i)
        picture.rgba.insert(picture.rgba.end(), {value, value, value, alpha});
    return picture;
}

PlacedWords someWords() {
    PlacedWords words;
    words.title = "Cα of H_2O′";
    words.labels = {{{1, 2, 0}, "label", false, 1}};
    words.measures = {{{{-5, -3, 0}, {2, -3, 0}, {4, 0, 2}}, "99.9°"}};
    words.scaleBar = ScaleBar::angstrom;
    words.axes = makeAxes({});
    words.legends = {{"all", "b-factor", {{"1", 1}, {"2", 2}, {"3", 3}}, Palette::viridis, 3}};
    return words;
}

/// Sum of ink, of 1 a black pixel.
double measureInk(const Picture& picture) {
    double sum = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) sum += 1.0 - static_cast<double>(picture.rgba[i]);
    return sum;
}

TEST(WordPainter, DrawsTheSameInBandsAsAtOnce) {
    const WordPainter painter;
    const auto width = [&](const std::string& text, double size) { return painter.measureWidth(text, size); };
    const Marks marks = layOut(someWords(), square(300), 18, {}, kWhite, width);
    Picture whole = filled(300, 1, 1), bands = whole;
    painter.paint(marks, whole.rgba.data(), 300, 0, 300);
    for (std::uint32_t row = 0; row < 300; row += 37)
        painter.paint(marks, bands.rgba.data() + std::size_t{row} * 1200, 300, row, std::min(37u, 300 - row));
    EXPECT_EQ(whole.rgba, bands.rgba);
    EXPECT_GT(measureInk(whole), 500);
}

TEST(WordPainter, IsSharpAtAnySize) {
    // The ink of a word grows with the square of its size, and its edges stay a pixel wide.
    const WordPainter painter;
    const auto drawn = [&](double size) {
        Picture picture = filled(1200, 1, 1);
        Marks marks;
        marks.texts = {{{20, 600}, size, "Hα"}};
        marks.haloWidth = 0;
        painter.paint(marks, picture.rgba.data(), 1200, 0, 1200);
        return picture;
    };
    const double small = measureInk(drawn(100)), large = measureInk(drawn(400));
    EXPECT_NEAR(large / small, 16, 0.8);
    std::size_t partly = 0, fully = 0;
    const Picture picture = drawn(400);
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
        partly += picture.rgba[i] > 0.01f && picture.rgba[i] < 0.99f;
        fully += picture.rgba[i] <= 0.01f;
    }
    EXPECT_LT(static_cast<double>(partly), 0.12 * static_cast<double>(fully));
}

TEST(WordPainter, PlatesAreHalfOpaqueAndHaveNoSeams) {
    const WordPainter painter;
    Picture picture = filled(100, 1, 1);
    Marks marks;
    marks.plates = {{{{{20, 20}, {50, 20}, {50, 60}, {20, 60}}, {{50, 20}, {80, 40}, {50, 60}}}, 0xff000000}};
    painter.paint(marks, picture.rgba.data(), 100, 0, 100);
    const auto red = [&](std::size_t x, std::size_t y) { return picture.rgba[4 * (100 * y + x)]; };
    constexpr float kHalf = 0.214f;  // linear light of half of white, in sRGB
    EXPECT_NEAR(red(30, 40), kHalf, 0.01f);
    EXPECT_NEAR(red(49, 40), kHalf, 0.01f);
    EXPECT_NEAR(red(50, 40), kHalf, 0.01f);
    EXPECT_NEAR(red(60, 40), kHalf, 0.01f);
    EXPECT_EQ(red(90, 40), 1);
    Picture bands = filled(100, 1, 1);
    for (std::uint32_t row = 0; row < 100; row += 10)
        painter.paint(marks, bands.rgba.data() + std::size_t{row} * 400, 100, row, 10);
    EXPECT_EQ(picture.rgba, bands.rgba);
}

TEST(WordPainter, LeavesRightAlphaWhereNothingWas) {
    const WordPainter painter;
    Picture over = filled(200, 1, 1), clear = filled(200, 0, 0);
    painter.paint(someWords(), square(200), 14, {}, kNothing, over);
    painter.paint(someWords(), square(200), 14, {}, kNothing, clear);
    double most = 0;
    for (std::size_t i = 0; i < clear.rgba.size(); i += 4) {
        EXPECT_LE(clear.rgba[i], clear.rgba[i + 3] + 1e-5f);
        EXPECT_LE(clear.rgba[i + 3], 1.0f + 1e-5f);
        most = std::max(most, static_cast<double>(clear.rgba[i + 3]));
    }
    EXPECT_NEAR(most, 1, 1e-3);
}

TEST(WordPainter, KnowsTheSignsOfTheField) {
    const WordPainter painter;
    const double box = painter.measureWidth("\xef\xbf\xbd", 100);  // the box drawn for a missing glyph
    for (const char* sign : {"α", "Ω", "′", "″", "Å", "°", "−", "→", "²", "₂"}) {
        EXPECT_GT(painter.measureWidth(sign, 100), 15) << sign;
        EXPECT_LT(painter.measureWidth(sign, 100), box + 5) << sign;
    }
    EXPECT_NEAR(painter.measureWidth("HH", 100), 2 * painter.measureWidth("H", 100), 1e-9);
    EXPECT_LT(painter.measureWidth("AV", 100),
              painter.measureWidth("A", 100) + painter.measureWidth("V", 100));  // kerning
    EXPECT_EQ(painter.measureWidth("", 100), 0);
}

/// What the built-in font has not comes from another, at an em's size; that is opened once, and only when needed.
TEST(WordPainter, ForeignScriptsComeFromAnotherFont) {
    std::vector<std::vector<char32_t>> asked;
    const WordPainter painter([&](const std::vector<char32_t>& characters) {
        asked.push_back(characters);
        return systemFontWith(characters);
    });
    const auto drawn = [&](const WordPainter& by, const char* text) {
        Picture picture = filled(64, 1, 1);
        Marks marks;
        marks.texts = {{{8, 48}, 40, text}};
        by.paint(marks, picture.rgba.data(), 64, 0, 64);
        return picture.rgba;
    };
    const WordPainter alone(FindFont{});
    painter.measureWidth("Hα′", 40);
    EXPECT_TRUE(asked.empty());
    EXPECT_EQ(drawn(alone, "蛋"), drawn(alone, "白")) << "boxes";
    EXPECT_EQ(drawn(alone, "Ab"), drawn(painter, "Ab"));
    const std::vector<std::string> said = alone.listWarnings({});
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0], "no installed font has the characters U+767D, U+86CB: the picture shows boxes instead");
    EXPECT_TRUE(painter.listWarnings({}).empty() || !systemFontWith({U'蛋'}));
    if (!systemFontWith({U'蛋'}) || drawn(painter, "蛋") == drawn(alone, "蛋")) GTEST_SKIP() << "no Chinese font here";
    EXPECT_NE(drawn(painter, "蛋"), drawn(painter, "白"));
    EXPECT_EQ(asked.size(), 1u) << "the font that has one has the other";
    EXPECT_NEAR(painter.measureWidth("蛋白", 40), 80, 1) << "each fills an em";
    EXPECT_EQ(painter.measureWidth("\U0010fffd", 40), alone.measureWidth("\U0010fffd", 40)) << "nobody has it";
}

TEST(WordPainter, RightToLeftRunsFromTheRight) {
    const WordPainter painter;
    const auto ink = [&](const char* text) {
        Picture picture = filled(160, 1, 1);
        Marks marks;
        marks.texts = {{{8, 90}, 40, text}};
        painter.paint(marks, picture.rgba.data(), 160, 0, 160);
        return picture.rgba;
    };
    // Alef and bet: written with marks that force the order, they look as without, the other way round.
    EXPECT_EQ(ink("\u05d0\u05d1"), ink("\u202d\u05d1\u05d0\u202c"));
    EXPECT_NE(ink("\u05d0\u05d1"), ink("\u05d1\u05d0"));
}

/// Letters on anything: at least 4.5:1 beside the halo, as WCAG 2.1 asks of text.
TEST(WordPainter, AHaloKeepsTextReadable) {
    const WordPainter painter;
    for (const float ground : {0.0f, 0.2f, 0.5f, 1.0f}) {
        Picture picture = filled(120, ground, 1);
        PlacedWords words;
        words.labels = {{{0, 0, 0}, "HHHH", false, 1}};
        painter.paint(words, square(120), 24, {}, kWhite, picture);
        double darkest = 1, lightest = 0;
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
            darkest = std::min(darkest, static_cast<double>(picture.rgba[i]));
            lightest = std::max(lightest, static_cast<double>(picture.rgba[i]));
        }
        EXPECT_GT((lightest + 0.05) / (darkest + 0.05), 4.5) << ground;
    }
}

TEST(WordPainter, ABackingKeepsLegendsReadable) {
    const WordPainter painter;
    for (const float ground : {0.0f, 0.2f, 0.5f, 1.0f}) {
        Picture picture = filled(300, ground, 1);
        PlacedWords words;
        words.legends = {{"all", "chain", {{"A", packedColor(0xff0000)}}, Palette::automatic, 0}};
        const Marks marks = painter.layOut(words, square(300), 20, {}, kWhite);
        painter.paint(words, square(300), 20, {}, kWhite, picture);
        ASSERT_EQ(marks.backs.size(), 1u);
        const auto x = static_cast<std::size_t>(marks.backs[0].low.x) + 2;
        const auto y = static_cast<std::size_t>(marks.backs[0].low.y) + 2;
        const double ink = 0.013, back = static_cast<double>(picture.rgba[4 * (300 * y + x)]);  // linear
        EXPECT_GT((back + 0.05) / (ink + 0.05), 7) << ground;
    }
}

}  // namespace
}  // namespace nacre::app
