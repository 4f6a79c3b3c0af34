#include "app/picture/options.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

#include "app/picture/option_json.h"
#include "app/picture/saved_view.h"

namespace nacre::app {
namespace {

/// A value of an option that differs from its default: one of an unusual form, or the first that it takes of its
/// choices and some common ones.
std::string otherValue(const Option& option) {
    static const std::map<std::string_view, std::string> kUnusual{
        {"hash", "12-ab"},
        {"name", "receptor"},
        {"fit", "/a\nresn STI"},
        {"align", "/a\nresn STI"},
        {"mvs-map", "https://a.b/=c"},
        {"trajectory-hash", "5-cd"},
        {"fit-frames", "backbone"},
        {"color-from", "a.csv:10..60:viridis"},
        {"interactions", "ligand,protein"},
        {"interaction-kinds", "hydrogen-bond,metal"},
        {"map-level", "1.5sigma"},
        {"map-color-from", "emdb:3001:2..6:viridis"},
        {"map-slice", "b,0.25"},
        {"map-transfer", "1sigma=blue@0,0.5=white@0.25"},
        {"map-around", "ligand,3"},
        {"surface-color-from", "a.dx:-5..5"},
        {"fov", "41.7"},
        {"orientation", "0,1,0,0"},
        {"pan", "1.5,-2"},
        {"rotate", "10,20,30"},
        {"look-at", "ligand"},
        {"zoom-to", "ligand"},
        {"uncover", "ligand"},
        {"fog", "-5,20"},
        {"clip", "-3,4"},
        {"label", "ligand={residue}"},
        {"measure", "1,2"},
        {"size", "640x480"},
        {"width", "85mm"},
        {"height", "100px"},
        {"text-size", "13.3"},
        {"layers", "a.exr"},
        {"stats", "a.json"},
        {"capture", "a.rdc"},
        {"output", "a.png"},
        {"primitives", "a.json"},
        {"trajectory", "md.xtc"},
        {"input", "a.pdb"},
        {"map", "a.ccp4"},
        {"title", "DNA"},
        {"focus-depth", "-4.5"},
        {"scale", "12.5A"},
        {"center", "1,-2.5,3"},
        {"camera-distance", "80"},
        {"save-view", "a.view.json"},
        {"surface-form", "mesh"},
        {"cap-color", "#302010"},
        {"clip-spare", "ligand"},
        {"label-color", "ligand=#ff0000"},
        {"label-offset", "ligand=2,1.5"},
        {"legend-title", "Potential (kT/e)"},
        {"interaction-color", "metal=#ff0000"},
    };
    if (const auto unusual = kUnusual.find(option.key); unusual != kUnusual.end()) return unusual->second;
    std::vector<std::string> values = option.choices;
    for (const auto& choice : option.control.choices) values.push_back(choice.value);
    std::istringstream syntax(option.syntax);
    for (std::string word; std::getline(syntax, word, '|');) values.push_back(word);
    for (const char* common : {"0.25",  "0.5",  "2",       "4",      "7",        "64",    "100",     "1000",
                               "on",    "off",  "#203040", "ligand", "pdb",      "model", "muted",   "plates",
                               "tiles", "r32f", "tube",    "ladder", "gaussian", "plip",  "surface", ""})
        values.emplace_back(common);
    const std::string standard = option.value.print(PictureDescription());
    for (const std::string& value : values) try {
            PictureDescription other;
            option.value.parse(value, other);
            if (option.value.print(other) != standard) return value;
        } catch (const std::exception&) {
            // not one of its values
        }
    throw std::logic_error("list a value of " + std::string(option.key) + " that differs from its default");
}

TEST(Options, EachHasAKeyOfItsOwnAndAHelp) {
    std::set<std::pair<std::string_view, bool>> keys;
    for (const Option& option : options()) {
        const bool saved = option.topic == Topic::saved;
        EXPECT_TRUE(keys.emplace(option.key, saved).second) << option.key;
        EXPECT_NE(saved, !option.help.empty()) << option.key;
        EXPECT_TRUE(option.needs.empty() || findOption(option.needs)) << option.key;
        EXPECT_TRUE(option.excludes.empty() || findOption(option.excludes)) << option.key;
        EXPECT_EQ(option.syntax.empty(), saved || option.positional || option.kind == Option::Kind::flag) << option.key;
    }
}

TEST(Options, WhatEachPrintsIsWhatItReads) {
    const PictureDescription plain;
    for (const Option& option : options()) {
        if (!option.value.print || !option.value.parse) continue;
        SCOPED_TRACE(option.key);
        PictureDescription other;
        EXPECT_NO_THROW(option.value.parse(otherValue(option), other));
        const std::string text = option.value.print(other);
        EXPECT_NE(text, option.value.print(plain)) << option.key;
        EXPECT_EQ(difference(plain, other) & static_cast<Facets>(option.facet), static_cast<Facets>(option.facet))
            << option.key;
        if (option.kind == Option::Kind::pair || option.positional) continue;  // print for people, divided otherwise
        PictureDescription again;
        option.value.parse(text, again);
        EXPECT_EQ(option.value.print(again), text) << option.key;
        EXPECT_EQ(difference(again, other), 0u) << option.key;
    }
}

TEST(Options, ASavedViewKeepsEachThatIsSaved) {
    const PictureDescription plain;
    PictureDescription all;
    for (const Option& option : options())
        if (option.save != Option::Save::never && option.value.parse) option.value.parse(otherValue(option), all);
    option("show").value.parse("ligand=spacefill", all);
    option("hide").value.parse("water", all);
    all.look.rules.back().on = false;
    all.input.further.push_back({"drug", "b.sdf", "3-ef"});
    const std::string json = savedViewJson(all);
    const PictureDescription read = parseSavedView(json, "test");
    EXPECT_EQ(savedViewJson(read), json);
    for (const Option& option : options())
        if (option.save != Option::Save::never) {
            EXPECT_EQ(option.value.print(read), option.value.print(all)) << option.key;
        }
    EXPECT_EQ(difference(plain, parseSavedView(savedViewJson(plain), "test")), 0u);
}

TEST(Options, DifferenceIsInThePartsThatDiffer) {
    const PictureDescription plain;
    const auto changed = [&](std::string_view key, const std::string& value) {
        PictureDescription other;
        option(key).value.parse(value, other);
        return difference(plain, other);
    };
    EXPECT_EQ(difference(plain, plain), 0u);
    EXPECT_EQ(changed("fog", "auto"), static_cast<Facets>(Facet::shading));
    EXPECT_EQ(changed("rotate", "1,2,3"), static_cast<Facets>(Facet::view));
    EXPECT_EQ(changed("title", "A"), static_cast<Facets>(Facet::annotation));
    EXPECT_EQ(changed("show", "ligand=licorice"), static_cast<Facets>(Facet::scene));
    EXPECT_EQ(changed("format", "pdb"), static_cast<Facets>(Facet::input));
    EXPECT_EQ(changed("model", "2"), static_cast<Facets>(Facet::frame));
    EXPECT_EQ(changed("occlusion", "64"), static_cast<Facets>(Facet::occlusion));
    EXPECT_EQ(changed("look", "dark"), static_cast<Facets>(Facet::shading));
    EXPECT_EQ(changed("look", "illustrative"), Facet::scene | Facet::shading);
}

TEST(OptionJson, TakesWhatACommandLineTakes) {
    PictureDescription job;
    setOptions(
        parseOptionValues(R"({"input": ["a=a.pdb", "b=b.sdf"], "output": "a.png", "size": [64, 48], "legend": true,
                                  "rotate": [1, 2, 3], "validate": true, "fit": ["/b", "/a"], "zoom": 2, "title": null,
                                  "rules": [{"hide": "water"}, {"show": "ligand=licorice"}]})"),
        job);
    EXPECT_EQ(job.input.name, "a");
    EXPECT_EQ(job.input.further.at(0).path, "b.sdf");
    EXPECT_EQ(job.size.width, 64u);
    EXPECT_TRUE(job.words.legend && job.device.validate);
    EXPECT_EQ(job.camera.rotationDegrees.z, 3);
    EXPECT_EQ(job.input.fits.size(), 1u);
    EXPECT_EQ(job.look.rules.size(), 2u);
    EXPECT_TRUE(job.given.contains("zoom") && !job.given.contains("title"));
    for (const char* bad : {"[]", "{\"zoom\": true}", "{\"zom\": 2}", "{\"zoom\": 1, \"zoom\": 2}", "{\"output\": 3}",
                            "{\"hash\": \"1-2\"}"})
        EXPECT_THROW(parseOptionValues(bad), UsageError) << bad;
    EXPECT_THROW(setOptions(parseOptionValues(R"({"clip": "1", "slab": 3})"), job), UsageError);
    EXPECT_THROW(setOptions(parseOptionValues(R"({"zoom": -1})"), job), UsageError);
}

TEST(Options, ChoicesOfControlsAreTheirValues) {
    for (const Option& option : options()) {
        const auto& choices = option.control.choices;
        if (choices.empty()) continue;
        PictureDescription picture;
        for (std::size_t i = 0; i < choices.size(); ++i) {
            option.value.parse(choices[i].value, picture);
            EXPECT_EQ(option.value.print(picture), choices[i].value) << option.key;
            EXPECT_EQ(chosen(option, picture), i) << option.key;
        }
        EXPECT_EQ(stepOption(option, picture), 0u) << option.key << ": from the last to the first";
    }
    PictureDescription picture;
    setOption(option("occlusion"), "64", picture);
    EXPECT_EQ(stepOption(option("occlusion"), picture), 0u) << "from a value that is none of them to off";
}

TEST(Options, EverySchemeIsOfferedInThePanel) {
    for (int scheme = 0; scheme < static_cast<int>(ColorScheme::uniform); ++scheme) {
        PictureDescription picture;
        picture.look.color = static_cast<ColorScheme>(scheme);
        EXPECT_LT(chosen(option("color"), picture), option("color").control.choices.size()) << scheme;
    }
}

}  // namespace
}  // namespace nacre::app
