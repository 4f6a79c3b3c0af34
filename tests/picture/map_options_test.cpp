#include "app/picture/map_options.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "app/picture/options.h"
#include "tests/support/error_text.h"

namespace nacre::app {
namespace {

TEST(MapOptions, AValueMapIsAFileWithARangeAndAPalette) {
    EXPECT_EQ(parseValueMap("none"), ValueMap{});
    const ValueMap plain = parseValueMap("../a.dx");
    EXPECT_EQ(plain.file, "../a.dx");
    EXPECT_FALSE(plain.range);
    for (const char* text : {"emdb:3001:2..6:viridis", "emdb:3001:viridis:2..6"}) {
        const ValueMap map = parseValueMap(text);
        EXPECT_EQ(map.file, "emdb:3001") << text;
        EXPECT_EQ(map.range, (ColorRange{2, 6})) << text;
        EXPECT_EQ(map.palette, Palette::viridis) << text;
        EXPECT_EQ(valueMapText(map), "emdb:3001:2..6:viridis");
    }
    EXPECT_EQ(parseValueMap("a.dx:5..-5").range, (ColorRange{5, -5}));
    for (const char* text : {"a.dx:muted", "a.dx:1..1", "a.dx:1..x", ":1..2"})
        EXPECT_THROW(parseValueMap(text), std::invalid_argument) << text;
}

TEST(MapOptions, ASliceIsAnAxisAndAPlace) {
    EXPECT_EQ(parseMapSlice("none").axis, -1);
    EXPECT_EQ(parseMapSlice("b"), (MapSliceOption{1, 0.5}));
    EXPECT_EQ(mapSliceText(parseMapSlice("c,0.25")), "c,0.25");
    for (const char* text : {"x", "a,2", "a,", ""}) EXPECT_THROW(parseMapSlice(text), std::invalid_argument) << text;
    test::expectThrows<std::invalid_argument>([&] { parseMapSlice("c:0.5"); }, "an axis and a place as c,0.5");
}

TEST(MapOptions, ATransferFunctionIsLevelsWithColoursAndOpacities) {
    EXPECT_TRUE(parseMapTransfer("auto").empty());
    const MapTransfer transfer = parseMapTransfer("1.5sigma=blue@0, top1%=#ff8000@0.25,0.5=white@1");
    ASSERT_EQ(transfer.size(), 3u);
    EXPECT_EQ(transfer[0].level, (MapLevel{MapLevel::Unit::sigma, 1.5}));
    EXPECT_EQ(transfer[1].level, (MapLevel{MapLevel::Unit::top, 1}));
    EXPECT_EQ(transfer[1].opacity, 0.25);
    EXPECT_EQ(transfer[2].color, (std::array<float, 4>{1, 1, 1, 1}));
    EXPECT_EQ(mapTransferText(transfer), "1.5sigma=#0000ff@0,top1%=#ff8000@0.25,0.5=white@1");
    EXPECT_EQ(parseMapTransfer(mapTransferText(transfer)), transfer);
    for (const char* text : {"", "1=red@0.5", "1=red@0,2=red", "1=red@0,2=red@1.5", "1=red@0,=red@0.5",
                             "1=red@0,auto=red@0", "1=red@0,2=transparent@0.5", "1=red@0,2@red=0.5"})
        EXPECT_THROW(parseMapTransfer(text), std::invalid_argument) << text;
    std::string many = "0=red@0";
    for (int i = 1; i < 9; ++i) many += "," + std::to_string(i) + "=red@0.5";
    EXPECT_THROW(parseMapTransfer(many), std::invalid_argument);
}

TEST(MapOptions, APlaceIsASelectionOrTheFocus) {
    MapOptions maps;
    EXPECT_EQ(mapAroundText(maps), "");
    for (const char* text : {"ligand", "ligand,3.5", "focus", "focus,12", "resi 1,9"}) {
        parseMapAround(text, maps);
        EXPECT_EQ(mapAroundText(maps), text);
        EXPECT_EQ(maps.aroundFocus, std::string_view(text).starts_with("focus")) << text;
        EXPECT_NE(maps.aroundFocus, maps.around.has_value()) << text;
    }
    parseMapAround("focus", maps);
    EXPECT_EQ(maps.usualReach(), kMapReachOfFocus);
    parseMapAround("", maps);
    EXPECT_FALSE(maps.aroundFocus);
    for (const char* text : {"focus,0", "focus,x", "focus,2000"})
        EXPECT_THROW(parseMapAround(text, maps), std::invalid_argument) << text;
}

TEST(MapOptions, EveryFileIsNamedOnce) {
    PictureDescription d;
    for (const auto& [key, value] : {std::pair{"map", "a.mrc"},
                                     {"map", "b.mrc"},
                                     {"map-color-from", "none"},
                                     {"map-color-from", "a.mrc:1..2"},
                                     {"surface-color-from", "c.dx"}})
        setOption(option(key), value, d);
    EXPECT_EQ(mapFiles(d.maps), (std::vector<std::string>{"a.mrc", "b.mrc", "c.dx"}));
    changeMapFiles(d.maps, [](const std::string& file) { return "x/" + file; });
    EXPECT_EQ(valueMapText(d.maps.values[1]), "x/a.mrc:1..2");
    EXPECT_EQ(d.maps.values[0].file, "");
}

TEST(MapOptions, ElectrostaticsIsNoFile) {
    PictureDescription d;
    setOption(option("electrostatics"), "on", d);
    EXPECT_TRUE(mapFiles(d.maps).empty());
    EXPECT_EQ(option("electrostatics").value.print(d), "on");
    EXPECT_EQ(option("surface-color-from").value.print(d), "none");
    changeMapFiles(d.maps, [](const std::string& file) { return "x/" + file; });
    EXPECT_EQ(option("electrostatics").value.print(d), "on");
    setOption(option("electrostatics"), "-10..10", d);
    EXPECT_EQ(option("electrostatics").value.print(d), "-10..10");
    EXPECT_EQ(d.maps.surface.range->last, 10);
    setOption(option("surface-color-from"), "a.dx", d);
    EXPECT_EQ(option("electrostatics").value.print(d), "off");
    EXPECT_THROW(setOption(option("electrostatics"), "strong", d), std::invalid_argument);
}

}  // namespace
}  // namespace nacre::app
