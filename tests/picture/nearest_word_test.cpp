#include "engine/molecule/nearest_word.h"

#include <gtest/gtest.h>

#include <vector>

#include "app/picture/appearance_values.h"
#include "engine/scene/color/palettes.h"
#include "tests/support/error_text.h"

namespace nacre::app {
namespace {

const std::vector<std::string> kWords = {"spacefill", "licorice", "chain", "red", "b-factor"};

TEST(NearestWord, IsWithinTwoEditsAndOneOfShortWords) {
    EXPECT_EQ(nearestWord("spacefil", kWords), "spacefill");
    EXPECT_EQ(nearestWord("SpaceFlil", kWords), "spacefill");
    EXPECT_EQ(nearestWord("chian", kWords), "chain");
    EXPECT_EQ(nearestWord("liquorice", kWords), "licorice");
    EXPECT_EQ(nearestWord("rde", kWords), "red");
    EXPECT_EQ(nearestWord("ra", kWords), "");
    EXPECT_EQ(nearestWord("spcfl", kWords), "");
    EXPECT_EQ(nearestWord("", kWords), "");
    EXPECT_EQ(nearestWord(std::string(100000, 'x'), kWords), "");
    EXPECT_EQ(suggestion("cartoon", kWords), "");
    EXPECT_EQ(suggestion("chian", kWords), " (did you mean 'chain'?)");
}

std::string reason(const std::function<void()>& parse) {
    return test::errorText<std::exception>([&] { parse(); });
}

TEST(NearestWord, IsSuggestedForValues) {
    EXPECT_NE(reason([] { parseStyle("spacefil"); }).find("'spacefill'?"), std::string::npos);
    EXPECT_NE(reason([] { parseColoring("chian"); }).find("'chain'?"), std::string::npos);
    EXPECT_NE(reason([] { parseColoring("oragne"); }).find("'orange'?"), std::string::npos);
    EXPECT_NE(reason([] { parseColor("lightgrya"); }).find("'lightgra"), std::string::npos);
    EXPECT_EQ(reason([] { parseStyle("hologram"); }).find("did you mean"), std::string::npos);
}

TEST(Synonyms, OfOtherProgramsAreTaken) {
    for (const char* style : {"sticks", "Sticks", "licorice"}) EXPECT_EQ(parseStyle(style), Style::licorice) << style;
    for (const char* style : {"spheres", "vdw", "cpk", "VDW"}) EXPECT_EQ(parseStyle(style), Style::spacefill) << style;
    EXPECT_EQ(parseStyle("ball+stick"), Style::ballAndStick);
    EXPECT_EQ(parseColoring("cpk"), ColorScheme::element);
    EXPECT_EQ(parseColoring("spectrum"), ColorScheme::rainbow);
    EXPECT_EQ(parseColoring("structure"), ColorScheme::secondaryStructure);
    EXPECT_EQ(parseColoring("b"), ColorScheme::bFactor);
    EXPECT_EQ(parseColoring("ss"), ColorScheme::secondaryStructure);
    const Coloring carbons = parseColoring("CPK:Orange");
    EXPECT_EQ(carbons, Coloring::elementWithCarbons(packedColor(0xffa500)));
    EXPECT_EQ(parseColoring(coloringText(carbons)), carbons);
    EXPECT_EQ(parseColoring("Orange"), Coloring::uniform(packedColor(0xffa500)));
    EXPECT_NE(reason([] { parseStyle("Putty"); }).find("--putty on"), std::string::npos);
    EXPECT_EQ(parseShow("ligand=sticks").style, Style::licorice);
}

}  // namespace
}  // namespace nacre::app
