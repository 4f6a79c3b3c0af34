#include "app/picture/option_values.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/picture/appearance_values.h"
#include "app/picture/words.h"
#include "engine/srgb.h"
#include "tests/support/error_text.h"

namespace nacre::app {
namespace {

std::string catchError(const std::function<void()>& call) {
    return test::errorText<std::invalid_argument>([&] { call(); });
}

TEST(OptionValues, Size) {
    EXPECT_EQ(parseSize("640x480").width, 640u);
    EXPECT_EQ(parseSize("640x480").height, 480u);
    EXPECT_EQ(parseSize("32768x1").width, 32768u);
    for (const char* text : {"", "x", "640", "640x", "x480", "0x10", "10x0", "32769x10", "10x32769", "-1x10",
                             "10x10x10", "10 x10", "1e3x10", "99999999999x10", "+5x5", "nanxnan"})
        EXPECT_NE(catchError([&] { parseSize(text); }), "") << text;
}

TEST(OptionValues, Rotation) {
    EXPECT_EQ(parseRotation("-20,45.5,0"), glm::dvec3(-20, 45.5, 0));
    for (const char* text : {"", "1", "1,2", "1,2,", ",,", "1,2,3,4", "nan,0,0", "0,inf,0", "a,b,c", "1, 2,3"})
        EXPECT_NE(catchError([&] { parseRotation(text); }), "") << text;
}

TEST(OptionValues, Color) {
    EXPECT_EQ(parseColor("transparent"), (std::array<float, 4>{0, 0, 0, 0}));
    EXPECT_EQ(parseColor("WHITE"), (std::array<float, 4>{1, 1, 1, 1}));
    EXPECT_EQ(parseColor("#f00"), (std::array<float, 4>{1, 0, 0, 1}));
    EXPECT_EQ(parseColor("#00ff00"), (std::array<float, 4>{0, 1, 0, 1}));
    EXPECT_EQ(parseColor("#0000FF33"), (std::array<float, 4>{0, 0, 1, 0.2f}));
    EXPECT_EQ(parseColor("#a5c"), parseColor("#aa55cc"));
    for (const char* text : {"", "#", "#12", "#1234", "#12345", "#1234567", "#123456789", "ff0000", "#-12345", "#ggg",
                             "mauve-ish", "#0xff00"})
        EXPECT_NE(catchError([&] { parseColor(text); }), "") << text;
}

TEST(OptionValues, RampsAreNotCounted) {
    for (int i = 0; i < 1000; ++i) {
        char text[32];
        std::snprintf(text, sizeof text, "b-factor:#%06x:red", i);
        const Coloring coloring = parseColoring(text);
        EXPECT_EQ(coloring.palette.own, (std::vector<std::uint32_t>{static_cast<std::uint32_t>(i), 0xff0000})) << text;
    }
}

TEST(OptionValues, NumbersKeepTheirLimits) {
    EXPECT_EQ(parseNumber("1.5", 1, 2), 1.5);
    EXPECT_EQ(parseNumber("2", 1, 2), 2.0);
    for (const char* text : {"", "nan", "inf", "-inf", "0.999", "2.001", "1.5x", " 1.5", "1e400"})
        EXPECT_NE(catchError([&] { parseNumber(text, 1, 2); }), "") << text;
    EXPECT_EQ(parseInteger("8", 1, 8), 8);
    for (const char* text : {"", "0", "9", "1.5", "nan", "1e0", "99999999999999999999"})
        EXPECT_NE(catchError([&] { parseInteger(text, 1, 8); }), "") << text;
    EXPECT_EQ(parseOcclusion("off"), 0);
    EXPECT_EQ(parseOcclusion("4096"), 4096);
    for (const char* text : {"0", "-1", "4097", "on", "nan"}) EXPECT_NE(catchError([&] { parseOcclusion(text); }), "");
}

TEST(OptionValues, AReasonNamesTheLimitsAndTheValue) {
    EXPECT_EQ(catchError([] { parseNumber("0", 1e-4, 1e4); }), "expected a number from 0.0001 to 10000, not '0'");
    EXPECT_EQ(catchError([] { parseChoice("c", {"a", "b", "d"}); }), "expected a, b or d, not 'c'");
    EXPECT_EQ(parseChoice("b", {"a", "b"}), 1u);
}

TEST(OptionValues, SamplesAreBounded) {
    checkSamples({16384, 8192}, 1, kMostSamplesHeld);
    EXPECT_NE(catchError([] { checkSamples({16384, 8193}, 1, kMostSamplesHeld); }), "");
    checkSamples({32768, 32768}, 2);
    EXPECT_NE(catchError([] { checkSamples({32768, 32768}, 3); }), "");
}

TEST(OptionValues, LengthsArePixelsOrPaper) {
    EXPECT_NEAR(parseLength("85mm").pixels(300), 85 / 25.4 * 300, 1e-9);
    EXPECT_NEAR(parseLength("8.5cm").pixels(300), 85 / 25.4 * 300, 1e-9);
    EXPECT_NEAR(parseLength("3.3in").pixels(100), 330, 1e-9);
    EXPECT_EQ(parseLength("1200px").pixels(300), 1200);
    EXPECT_EQ(catchError([&] { parseLength("85"); }), "a length needs a unit: 85mm or 85px");
    for (const char* text : {"", "mm", "85 mm", "-1mm", "0mm", "nanin", "85pt", "1e9cm", "85mmm", "px"})
        EXPECT_NE(catchError([&] { parseLength(text); }), "") << text;
    EXPECT_EQ(parsePoints("1.5pt"), 1.5);
    EXPECT_EQ(parsePoints("1.5"), std::nullopt);
    EXPECT_EQ(parsePixels("3pt", 1, 5), 4);
    EXPECT_EQ(parsePixels("3px", 1, 5), 3);
    for (const char* text : {"", "pt", "4pt", "0.5pt", "6px", "nanpt"})
        EXPECT_NE(catchError([&] { parsePixels(text, 1, 5); }), "") << text;
}

TEST(Srgb, EveryCodeSurvivesTheWayToLinearLightAndBack) {
    for (int code = 0; code < 256; ++code)
        EXPECT_EQ(toByte(linearToSrgb(srgbToLinear(static_cast<float>(code) / 255.0f))), code);
}

// Values of IEC 61966-2-1 at its joint and in the middle.
TEST(Srgb, KnownValues) {
    EXPECT_NEAR(linearToSrgb(0.0031308f), 0.04045f, 1e-5f);
    EXPECT_NEAR(linearToSrgb(0.2140411f), 0.5f, 1e-5f);
    EXPECT_EQ(linearToSrgb(-1.0f), 0.0f);
    EXPECT_EQ(linearToSrgb(2.0f), 1.0f);
    EXPECT_EQ(toByte(linearToSrgb(std::nanf(""))), 0);
}

// About each value at which a code begins, and far from them.
TEST(Srgb, ATableGivesTheSameBytes) {
    const auto same = [](std::uint32_t bits) {
        const auto linear = std::bit_cast<float>(bits);
        return linearToByte(linear) == toByte(linearToSrgb(linear));
    };
    for (int code = 1; code < 256; ++code) {
        const float begins = srgbToLinear((static_cast<float>(code) - 0.5f) / 255.0f);
        const auto middle = std::bit_cast<std::uint32_t>(begins);
        for (std::uint32_t bits = middle - 300; bits < middle + 300; ++bits) ASSERT_TRUE(same(bits)) << code;
    }
    for (std::uint32_t bits = 0; bits < std::bit_cast<std::uint32_t>(2.0f); bits += 9973)
        ASSERT_TRUE(same(bits)) << bits;
    const float infinite = std::numeric_limits<float>::infinity();
    for (const float special :
         {-1.0f, -0.0f, 0.0f, 1.0f, std::nextafter(1.0f, 0.0f), infinite, -infinite, std::nanf("")})
        EXPECT_TRUE(same(std::bit_cast<std::uint32_t>(special))) << special;
}

TEST(Titles, AreFilledWithFrameAndTime) {
    EXPECT_EQ(filledTitle("{frame}: {time}, {frame}", {12, 3.5}), "12: 3.5 ps, 12");
    EXPECT_EQ(filledTitle("{time}", {1, 1500.0}), "1.5 ns");
    EXPECT_EQ(filledTitle("{time}", {1, {}}), "?");
    EXPECT_TRUE(titleMoves("at {time}") && titleMoves("{frame}"));
    EXPECT_FALSE(titleMoves("frame time"));
}

}  // namespace
}  // namespace nacre::app
