// What the palettes promise: that people tell their colours apart, whatever cones they have.

#include "engine/scene/color/palettes.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "engine/scene/color/colors.h"
#include "tests/support/color_difference.h"

namespace nacre {
namespace {

using test::apartFor;
using test::kVisions;
using test::Triple;
using test::Vision;

struct SharmaPair {
    Triple one, two;
    double difference;
};
// The test data of Sharma, Wu and Dalal 2005, table 1.
const SharmaPair kSharma[] = {{{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
                              {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
                              {{50, 2.8361, -74.0200}, {50, 0, -82.7485}, 3.4412},
                              {{50, -1.3802, -84.2814}, {50, 0, -82.7485}, 1.0000},
                              {{50, -1.1848, -84.8006}, {50, 0, -82.7485}, 1.0000},
                              {{50, -0.9009, -85.5211}, {50, 0, -82.7485}, 1.0000},
                              {{50, 0, 0}, {50, -1, 2}, 2.3669},
                              {{50, -1, 2}, {50, 0, 0}, 2.3669},
                              {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0009}, 7.1792},
                              {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0010}, 7.1792},
                              {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0011}, 7.2195},
                              {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0012}, 7.2195},
                              {{50, -0.0010, 2.4900}, {50, 0.0009, -2.4900}, 4.8045},
                              {{50, -0.0010, 2.4900}, {50, 0.0010, -2.4900}, 4.8045},
                              {{50, -0.0010, 2.4900}, {50, 0.0011, -2.4900}, 4.7461},
                              {{50, 2.5, 0}, {50, 0, -2.5}, 4.3065},
                              {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
                              {{50, 2.5, 0}, {61, -5, 29}, 22.8977},
                              {{50, 2.5, 0}, {56, -27, -3}, 31.9030},
                              {{50, 2.5, 0}, {58, 24, 15}, 19.4535},
                              {{50, 2.5, 0}, {50, 3.1736, 0.5854}, 1.0000},
                              {{50, 2.5, 0}, {50, 3.2972, 0}, 1.0000},
                              {{50, 2.5, 0}, {50, 1.8634, 0.5757}, 1.0000},
                              {{50, 2.5, 0}, {50, 3.2592, 0.3350}, 1.0000},
                              {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
                              {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
                              {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
                              {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
                              {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
                              {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
                              {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
                              {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
                              {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
                              {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082}};

TEST(ColorDifference, IsThatOfThePublishedPairs) {
    for (const SharmaPair& pair : kSharma) {
        EXPECT_NEAR(test::ciede2000(pair.one, pair.two), pair.difference, 5e-5) << pair.one[1] << " " << pair.two[1];
        EXPECT_NEAR(test::ciede2000(pair.two, pair.one), pair.difference, 5e-5);
    }
}

TEST(ColorDifference, SimulationsLeaveGraysAndMixWhatConesTell) {
    for (const Vision vision : kVisions) {
        const Triple gray = test::seenBy(vision, {0.5, 0.5, 0.5});
        for (const double c : gray) EXPECT_NEAR(c, 0.5, 1e-4);
    }
    // A red and a green that only the long and middle cones tell apart, a blue and a green that only the short do.
    EXPECT_LT(apartFor(Vision::deuteranopia, packedColor(0xc07060), packedColor(0x8c8c5a)), 8);
    EXPECT_GT(apartFor(Vision::normal, packedColor(0xc07060), packedColor(0x8c8c5a)), 25);
}

double least(Palette palette, std::size_t count, Vision vision) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, apartFor(vision, kindColor(i, palette), kindColor(j, palette)));
    return least;
}

struct Promise {
    Palette palette;
    std::size_t colors;
    double normal, protanopia, deuteranopia, tritanopia;
};

/// These stand in docs/pictures.md: the smallest distance between any two colours.
TEST(Palettes, KindsAreAsFarApartAsTheDocumentationSays) {
    for (const Promise& p :
         {Promise{Palette::distinct, 8, 17.4, 16.8, 17.0, 17.0}, Promise{Palette::distinct, 4, 30.9, 26.9, 23.7, 28.4},
          Promise{Palette::light, 8, 9.3, 8.8, 7.9, 7.5}, Promise{Palette::okabeIto, 7, 14.6, 10.5, 9.2, 8.2},
          Promise{Palette::bright, 7, 20.5, 14.2, 14.8, 8.6}, Promise{Palette::vibrant, 7, 18.3, 13.7, 14.4, 8.6},
          Promise{Palette::muted, 9, 15.0, 11.8, 14.3, 11.5}}) {
        const double promised[] = {p.normal, p.protanopia, p.deuteranopia, p.tritanopia};
        for (std::size_t v = 0; v < 4; ++v)
            EXPECT_NEAR(least(p.palette, p.colors, kVisions[v]), promised[v], 0.1)
                << paletteName(p.palette) << " " << p.colors << " " << v;
    }
    EXPECT_EQ(kindCount(Palette::distinct), 8u);
}

/// A ligand's carbons have the grey of the element, its other atoms their own colours, beside chains' carbons.
TEST(Palettes, ChainColorsAreFarFromThoseOfElements) {
    for (std::size_t i = 0; i < kindCount(kChainPalette); ++i)
        for (const Element element : {Element{6}, Element{7}, Element{8}, Element{16}})
            EXPECT_GT(apartFor(Vision::normal, kindColor(i, kChainPalette), elementColor(element)), 15)
                << i << " " << int{element};
}

TEST(Palettes, DarkerTonesFollowAndThenTheyRepeat) {
    for (const Palette palette : allPalettes()) {
        if (isRamp(palette)) continue;
        const std::size_t count = kindCount(palette);
        std::set<std::uint32_t> different;
        for (std::size_t i = 0; i < 2 * count; ++i) different.insert(kindColor(i, palette));
        EXPECT_EQ(different.size(), 2 * count) << paletteName(palette);
        EXPECT_EQ(kindColor(count, palette), darkerColor(kindColor(0, palette)));
        EXPECT_EQ(kindColor(2 * count, palette), kindColor(0, palette));
    }
}

/// Lightness alone tells the order of viridis, plasma and grays; and from end to end no colour comes back.
TEST(Palettes, RampsRiseForEveryone) {
    for (const Palette ramp : {Palette::viridis, Palette::plasma, Palette::grays})
        for (const Vision vision : kVisions) {
            double before = -1;
            for (int i = 0; i <= 32; ++i) {
                const Triple seen = test::seenBy(vision, test::toLinear(paletteColor(ramp, i / 32.0)));
                const double lightness = test::toLab(seen)[0];
                EXPECT_GT(lightness, before) << paletteName(ramp) << " " << i;
                before = lightness;
            }
        }
    for (const Palette ramp : {Palette::viridis, Palette::plasma, Palette::grays, Palette::sunset,
                               Palette::blueWhiteRed, Palette::redWhiteBlue, Palette::lipophilicity})
        for (const Vision vision : kVisions)
            EXPECT_GT(apartFor(vision, paletteColor(ramp, 0), paletteColor(ramp, 1)), 25) << paletteName(ramp);
}

TEST(Palettes, RampsEndWhereTheyShould) {
    for (const Palette palette : allPalettes()) {
        if (!isRamp(palette)) continue;
        EXPECT_EQ(paletteColor(palette, -1), paletteColor(palette, 0));
        EXPECT_EQ(paletteColor(palette, 2), paletteColor(palette, 1));
        EXPECT_EQ(paletteColor(palette, std::nan("")), paletteColor(palette, 0));
        EXPECT_NE(paletteColor(palette, 0), paletteColor(palette, 1));
    }
    EXPECT_EQ(colorText(paletteColor(Palette::lipophilicity, 0.5)), "#ffffff");
    EXPECT_EQ(colorText(paletteColor(Palette::lipophilicity, 0.75)), "#dcc385");
}

TEST(Palettes, ARampHasOwnColours) {
    const AnyPalette ramp = AnyPalette::ramp({0xffffff, 0xff0000});
    EXPECT_TRUE(isRamp(ramp));
    EXPECT_EQ(paletteName(ramp), "#ffffff:#ff0000");
    EXPECT_EQ(AnyPalette::ramp({0xffffff, 0xff0000}), ramp);
    EXPECT_NE(AnyPalette::ramp({0xffffff, 0x00ff00}), ramp);
    EXPECT_NE(ramp, Palette::automatic);
    EXPECT_EQ(paletteColor(ramp, 0), packedColor(0xffffff));
    EXPECT_EQ(paletteColor(ramp, 0.5), packedColor(0xff8080));
    EXPECT_EQ(paletteColor(ramp, 1), packedColor(0xff0000));
}

TEST(Palettes, NamesGoBothWays) {
    for (const Palette palette : allPalettes()) EXPECT_EQ(paletteFromName(paletteName(palette)), palette);
    EXPECT_FALSE(paletteFromName(""));
    EXPECT_EQ(paletteName(Palette::automatic), "");
}

}  // namespace
}  // namespace nacre
