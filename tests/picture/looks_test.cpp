#include "app/picture/looks.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "app/picture/color_values.h"
#include "app/picture/options.h"
#include "app/picture/saved_view.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

TEST(Looks, EachIsOneThatAFileCanHoldToo) {
    std::set<std::string> seen;
    const std::string path = testing::TempDir() + "look.json";
    for (const Look& look : looks()) {
        PictureDescription view;
        applyLook(look, view);
        EXPECT_TRUE(seen.insert(lookJson(view)).second) << look.name << " is another one's twin";
        std::ofstream(path) << lookJson(look);
        PictureDescription read;
        applyLook(readLook(path), read);
        EXPECT_EQ(savedViewJson(read), savedViewJson(view)) << look.name;
        EXPECT_EQ(readLook(look.name).options, look.options);
    }
    EXPECT_EQ(looks()[0].name, "default");
    PictureDescription view;
    applyLook(looks()[0], view);
    EXPECT_EQ(savedViewJson(view), savedViewJson(PictureDescription{}));
}

TEST(Looks, TakeThePlaceOfTheOneBeforeAndLeaveWhatIsSeen) {
    PictureDescription view = parseSavedView(
        R"({"input": "a.pdb", "style": "licorice", "zoom": 2, "clip": "1,7", "cap": "dark", "color": "residue",
            "contours": 4, "background": "navy", "lighting": "off"})",
        "test");
    applyLook(readLook("glossy"), view);
    EXPECT_EQ(view.effects.contours.width, 0);
    EXPECT_TRUE(view.lighting);
    EXPECT_EQ(view.background, parseColor("white"));
    EXPECT_GT(view.effects.light.highlight, 1);
    EXPECT_EQ(view.effects.clip.near, 1);
    EXPECT_EQ(view.effects.clip.far, 7);
    EXPECT_EQ(view.effects.clip.cap, Clip::Cap::dark);
    EXPECT_EQ(view.camera.zoom, 2);
    EXPECT_EQ(view.look.style, Style::licorice);
    EXPECT_EQ(view.look.color, Coloring(ColorScheme::residue));
    applyLook(readLook("illustrative"), view);
    EXPECT_EQ(view.look.color, Coloring(ColorScheme::chain));
}

TEST(Looks, ASavedViewServesAsOne) {
    const std::string path = testing::TempDir() + "saved.json";
    PictureDescription saved =
        parseSavedView(R"({"input": "b.pdb", "zoom": 3, "contours": 2.5, "fog": "-3,9", "clip": 0})", "test");
    std::ofstream(path) << savedViewJson(saved);
    PictureDescription view = parseSavedView(R"({"input": "a.pdb"})", "test");
    applyLook(readLook(path), view);
    EXPECT_EQ(view.input.path, "a.pdb");
    EXPECT_EQ(view.camera.zoom, 1);
    EXPECT_FALSE(view.effects.clip.on());
    EXPECT_EQ(view.effects.contours.width, 2.5);
    EXPECT_EQ(view.effects.fog.start, -3);
    EXPECT_EQ(view.effects.fog.end, 9);
}

TEST(Looks, WhatIsNoneIsRefused) {
    EXPECT_THROW(readLook("glosy"), std::invalid_argument);
    EXPECT_THROW(readLook(testing::TempDir() + "absent.json"), Error);
    const std::string path = testing::TempDir() + "bad.json";
    for (const char* bad : {"{\"contours\": -1}", "{\"shininess\": 3}", "[]", "{\"fog\": \"9,3\"}"}) {
        std::ofstream(path) << bad;
        EXPECT_THROW(readLook(path), Error) << bad;
    }
}

TEST(EffectOptions, WhatEachSaysIsWhatItReads) {
    const std::pair<const char*, const char*> cases[] = {
        {"contours", "1.5"},      {"contour-depth", "3"},  {"contour-weights", "3"},  {"contour-color", "#102030"},
        {"halos", "6"},           {"halo-depth", "20"},    {"halo-strength", "0.4"},  {"halo-color", "#203040"},
        {"fog", "-5,20.5"},       {"fog", "auto"},         {"fog-strength", "0.3"},   {"ambient", "0.5"},
        {"shadow", "0.75"},       {"depth-of-field", "7"}, {"depth-of-field", "0.3"}, {"focus-depth", "-2.5"},
        {"direct", "2"},          {"highlight", "0"},      {"gloss", "100"},          {"occlusion-strength", "0.25"},
        {"clip", "-3.25"},        {"clip", "-3,4"},        {"clip", ",2.5"},          {"cap", "hatched"},
        {"cap-color", "#302010"}, {"material", "metal"}};
    std::set<std::string_view> met;
    const PictureDescription plain;
    for (const auto& [key, value] : cases) {
        met.insert(key);
        PictureDescription view;
        option(key).value.parse(value, view);
        EXPECT_EQ(option(key).value.print(view), value) << key;
        EXPECT_NE(view.effects, plain.effects) << key;
        EXPECT_EQ(parseSavedView(savedViewJson(view), "test").effects, view.effects) << key;
    }
    for (const Option& option : options())
        if (option.topic == Topic::effects && option.value.print &&
            option.key != "clip-spare") {  // atoms, not an effect
            EXPECT_TRUE(met.contains(option.key)) << option.key;
        }
}

TEST(EffectOptions, NonsenseIsRefused) {
    const std::pair<const char*, const char*> cases[] = {{"contours", "0"},
                                                         {"contours", "on"},
                                                         {"contours", "65"},
                                                         {"contour-weights", "2"},
                                                         {"fog", "3"},
                                                         {"fog", "5,5"},
                                                         {"fog", "1,2,3"},
                                                         {"fog-strength", "1.1"},
                                                         {"clip", "4,1"},
                                                         {"clip", ","},
                                                         {"clip", ""},
                                                         {"clip", "nan"},
                                                         {"contour-color", "transparent"},
                                                         {"halos", "none"},
                                                         {"halo-depth", "0"},
                                                         {"halo-strength", "1.5"},
                                                         {"halo-color", "#00000080"},
                                                         {"cap", "round"},
                                                         {"shadow", "2"},
                                                         {"gloss", "0"},
                                                         {"ambient", "-1"},
                                                         {"occlusion-strength", "2"}};
    for (const auto& [name, value] : cases) {
        PictureDescription d;
        EXPECT_THROW(option(name).value.parse(value, d), std::exception) << name << " " << value;
        EXPECT_EQ(d.effects.contours, Contours{}) << "nothing half-set";
    }
}

}  // namespace
}  // namespace nacre::app
