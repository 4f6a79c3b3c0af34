// Annotations of a scene: remapped columns, palettes, formatted texts.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

#include "app/mvs/text_format.h"
#include "app/mvs/value_palette.h"
#include "engine/scene/color/palettes.h"
#include "tests/mvs/small_scene.h"

namespace nacre::app::mvs {
namespace {

/// Largest difference of two colours in a channel.
int distance(std::uint32_t a, std::uint32_t b) {
    int most = 0;
    for (int shift = 0; shift < 24; shift += 8)
        most = std::max(most, std::abs(static_cast<int>(a >> shift & 0xff) - static_cast<int>(b >> shift & 0xff)));
    return most;
}

std::vector<AnnotationRow> rowsWith(const std::vector<std::string>& values) {
    std::vector<AnnotationRow> rows;
    for (const std::string& value : values) rows.emplace_back().values.emplace_back(value);
    return rows;
}

std::optional<std::uint32_t> colorIn(const char* palette, const std::string& value,
                                     const std::vector<std::string>& all = {}) {
    return colorsOfPalette(Json::parse(palette), rowsWith(all))(value);
}

constexpr std::uint32_t kRed = packedColor(0xff0000), kLime = packedColor(0x00ff00), kBlue = packedColor(0x0000ff);

TEST(ScenePalettes, ContinuousOnesMixTheirColours) {
    const char* plain = R"({"kind": "continuous", "colors": ["red", "blue"]})";
    const std::vector<std::string> values{"10", "20", "30", "x"};
    EXPECT_EQ(colorIn(plain, "10", values), kRed);
    EXPECT_EQ(colorIn(plain, "30", values), kBlue);
    EXPECT_LE(distance(colorIn(plain, "20", values).value(), packedColor(0x800080)), 1);
    EXPECT_EQ(colorIn(plain, "31", values), std::nullopt);
    EXPECT_EQ(colorIn(plain, "x", values), std::nullopt);
    const char* wide = R"({"kind": "continuous", "colors": ["red", "blue"], "reverse": true, "value_domain": [0, null],
        "underflow_color": "auto", "overflow_color": "lime"})";
    EXPECT_EQ(colorIn(wide, "-5", values), kBlue);
    EXPECT_EQ(colorIn(wide, "31", values), kLime);
    EXPECT_LE(distance(colorIn(wide, "15", values).value(), packedColor(0x800080)), 1);
    const char* absolute = R"({"kind": "continuous", "mode": "absolute", "colors": [["blue", 100], ["red", 50]]})";
    EXPECT_EQ(colorIn(absolute, "50"), kRed);
    EXPECT_LE(distance(colorIn(absolute, "62.5").value(), packedColor(0xbf0040)), 1);
    EXPECT_EQ(colorIn(absolute, "49"), std::nullopt);
}

TEST(ScenePalettes, DiscreteOnesHaveSteps) {
    const char* plain = R"({"kind": "discrete", "colors": ["red", "lime", "blue"], "value_domain": [0, 9]})";
    EXPECT_EQ(colorIn(plain, "0"), kRed);
    EXPECT_EQ(colorIn(plain, "2.9"), kRed);
    EXPECT_EQ(colorIn(plain, "3"), kLime);
    EXPECT_EQ(colorIn(plain, "9"), kBlue);
    EXPECT_EQ(colorIn(plain, "9.1"), std::nullopt);
    // As AlphaFold's confidence is shown.
    const char* starts =
        R"({"kind": "discrete", "mode": "absolute", "colors": [["red", 0], ["lime", 50], ["blue", 70]]})";
    EXPECT_EQ(colorIn(starts, "49.9"), kRed);
    EXPECT_EQ(colorIn(starts, "50"), kLime);
    EXPECT_EQ(colorIn(starts, "1000"), kBlue);
    EXPECT_EQ(colorIn(starts, "-1"), std::nullopt);
    const char* ranges = R"({"kind": "discrete", "mode": "absolute", "colors": [["red", null, 5], ["lime", 4, 6],
        [null, 5.5, 5.6]]})";
    EXPECT_EQ(colorIn(ranges, "-1e9"), kRed);
    EXPECT_EQ(colorIn(ranges, "4"), kLime);  // the later one
    EXPECT_EQ(colorIn(ranges, "5.55"), std::nullopt);
    EXPECT_EQ(colorIn(ranges, "7"), std::nullopt);
}

TEST(ScenePalettes, CategoricalOnesNameWordsOrCountThem) {
    const char* words = R"({"kind": "categorical", "colors": {"Helix": "red"}, "missing_color": "lime"})";
    EXPECT_EQ(colorIn(words, "Helix"), kRed);
    EXPECT_EQ(colorIn(words, "HELIX"), kLime);
    const char* any = R"({"kind": "categorical", "colors": {"Helix": "red"}, "case_insensitive": true})";
    EXPECT_EQ(colorIn(any, "hELIX"), kRed);
    EXPECT_EQ(colorIn(any, "coil"), std::nullopt);
    const std::vector<std::string> values{"10", "9", "10", "8"};
    const char* list = R"({"kind": "categorical", "colors": ["red", "lime"]})";
    EXPECT_EQ(colorIn(list, "10", values), kRed);
    EXPECT_EQ(colorIn(list, "9", values), kLime);
    EXPECT_EQ(colorIn(list, "8", values), std::nullopt);
    const char* sorted =
        R"({"kind": "categorical", "colors": ["red", "lime"], "sort": "numeric", "repeat_color_list": true})";
    EXPECT_EQ(colorIn(sorted, "8", values), kRed);
    EXPECT_EQ(colorIn(sorted, "9", values), kLime);
    EXPECT_EQ(colorIn(sorted, "10", values), kRed);
    const char* down = R"({"kind": "categorical", "colors": ["red", "lime", "blue"], "sort": "lexical",
        "sort_direction": "descending"})";
    EXPECT_EQ(colorIn(down, "9", values), kRed);
    EXPECT_EQ(colorIn(R"({"kind": "categorical"})", "a", {"a"}), packedColor(0x1f77b4));  // the first of Category10
    EXPECT_EQ(colorIn(R"({"kind": "categorical", "colors": "SecondaryStructure"})", "H"), packedColor(0xff0080));
    EXPECT_EQ(colorIn(R"({"kind": "categorical", "colors": "ElementSymbol"})", "C"), std::nullopt);
    EXPECT_NE(colorIn(R"({"kind": "categorical", "colors": "ElementSymbol"})", "FE"), std::nullopt);
}

// D3's formula of the one; the other as the engine has it from Matplotlib, by fewer stops.
TEST(ScenePalettes, ListsAreThoseOfTheirAuthors) {
    const std::vector<std::uint32_t> sinebow = namedColorList("Sinebow"), viridis = namedColorList("Viridis");
    ASSERT_EQ(sinebow.size(), 51u);
    for (std::size_t i = 0; i < sinebow.size(); ++i) {
        const double t = (0.5 - static_cast<double>(i) / 50) * std::numbers::pi;
        std::uint32_t rgb = 0;
        for (int k = 0; k < 3; ++k)
            rgb = rgb << 8 |
                  static_cast<std::uint32_t>(std::lround(255 * std::pow(std::sin(t + k * std::numbers::pi / 3), 2)));
        EXPECT_LE(distance(sinebow[i], packedColor(rgb)), 1) << i;
    }
    for (std::size_t i = 0; i < viridis.size(); ++i)
        EXPECT_LE(distance(viridis[i], paletteColor(Palette::viridis, (static_cast<double>(i) + 0.5) / 51)), 20) << i;
    for (const char* name : {"Reds", "YlGn", "RdBu", "Set1", "Turbo", "Chainbow", "Accent", "Spectral"})
        EXPECT_GE(namedColorList(name).size(), 8u) << name;
    EXPECT_TRUE(namedColorList("reds").empty());
}

TEST(ScenePalettes, FaultsAreToldAndLeftOut) {
    for (const char* palette :
         {R"(3)", R"({"kind": "none"})", R"({"kind": "continuous", "colors": []})",
          R"({"kind": "continuous", "colors": "Nothing"})", R"({"kind": "continuous", "colors": ["red", ["blue", 1]]})",
          R"({"kind": "discrete", "colors": [["red", "1"]]})", R"({"kind": "discrete", "colors": [[]]})",
          R"({"kind": "continuous", "value_domain": [1]})", R"({"kind": "categorical", "colors": {"a": "nothing"}})",
          R"({"kind": "categorical", "colors": 4})", R"({"kind": "categorical", "colors": [["red", 1]]})"})
        EXPECT_THROW(colorsOfPalette(Json::parse(palette), {}), std::invalid_argument) << palette;
    Json many{{"kind", "discrete"}, {"colors", Json::array()}};
    for (std::size_t i = 0; i <= kMostPaletteColors; ++i) many["colors"].push_back("red");
    EXPECT_THROW(colorsOfPalette(many, {}), std::invalid_argument);
    const std::string node = R"({"kind": "color_from_uri", "params": {"uri": "b.json", "format": "json",
        "schema": "auth_residue", "palette": {"kind": "none"}}})";
    const Molecule molecule = built(scene(component(R"("all")", balls(node))), R"([{"color": "red"}])");
    ASSERT_EQ(molecule.guide->warnings.size(), 1u);
    EXPECT_NE(molecule.guide->warnings[0].find("color_from_uri 1: its palette is of no kind"), std::string::npos);
    EXPECT_EQ(molecule.guide->layers.at(0).colors[0], 0xffffffffu);
}

TEST(SceneAnnotations, ColumnsAreRemappedAndASelectorLimitsColours) {
    const std::string annotations = R"([{"number": 101, "auth_seq_id": 102, "score": 0.5},
        {"number": 102, "auth_seq_id": 101, "score": 1.5}])";
    const auto colors = [&](const std::string& more) {
        const std::string node = R"({"kind": "color_from_uri", "params": {"uri": "b.json", "format": "json",
            "schema": "auth_residue", "field_name": "score", "palette": {"kind": "discrete", "mode": "absolute",
            "colors": [["red", 0], ["blue", 1]]})" +
                                 more + "}}";
        return built(scene(component(R"("polymer")", balls(node))), annotations).guide->layers.at(0).colors;
    };
    const std::string remapped = R"(, "field_remapping": {"auth_seq_id": "number"})";
    EXPECT_EQ(colors("").at(0), kBlue);
    EXPECT_EQ(colors("").at(4), kRed);
    EXPECT_EQ(colors(remapped).at(0), kRed);
    EXPECT_EQ(colors(remapped).at(4), kBlue);
    EXPECT_EQ(colors(R"(, "field_remapping": {"auth_seq_id": null})").at(0), kBlue);  // each row is of all
    const auto some = colors(remapped + R"(, "selector": {"label_atom_id": "CA"})");
    EXPECT_EQ(some.at(0), 0xffffffffu);
    EXPECT_EQ(some.at(1), kRed);
    EXPECT_EQ(some.at(5), kBlue);
}

// Right-hand sides are Python 3's.
TEST(SceneTexts, FormatsAreThoseOfPython) {
    const auto text = [](const std::string& format, const std::string& value) {
        return TextFormat(format).of({value}, 1).value_or("none");
    };
    EXPECT_EQ(text("{:.2f}", "3.14159"), "3.14");
    EXPECT_EQ(text("{:8.3f}", "-2.5"), "  -2.500");
    EXPECT_EQ(text("{:+.1e}", "12345.678"), "+1.2e+04");
    EXPECT_EQ(text("{:,.1f}", "1234567.89"), "1,234,567.9");
    EXPECT_EQ(text("{:06.2f}", "-3.14159"), "-03.14");
    EXPECT_EQ(text("{:.0%}", "0.256"), "26%");
    EXPECT_EQ(text("{:*^9}", "abc"), "***abc***");
    EXPECT_EQ(text("{:>5}", "ab"), "   ab");
    EXPECT_EQ(text("{:<5}|", "ab"), "ab   |");
    EXPECT_EQ(text("{:05d}", "42"), "00042");
    EXPECT_EQ(text("{:<05d}", "42"), "42000");
    EXPECT_EQ(text("{:*<05d}", "42"), "42***");
    EXPECT_EQ(text("{:<+05d}", "42"), "+4200");
    EXPECT_EQ(text("{{{}}}", "a"), "{a}");
    EXPECT_EQ(text("{:.1f} Å", "none"), "none Å");
    for (const char* fault : {"{", "a}", "{a{", "{:x}", "{:.999f}", "{:q}"})
        EXPECT_THROW(TextFormat{fault}, std::invalid_argument) << fault;
    EXPECT_THROW(TextFormat(std::string(10'001, 'a')), std::invalid_argument);
}

TEST(SceneTexts, LabelsNameFieldsAndJoinRows) {
    const std::string rows = R"([{"auth_seq_id": 101, "name": "a", "score": 0.5, "site": "s"},
        {"auth_seq_id": 102, "name": "b", "score": 1.0, "site": "s"}, {"auth_seq_id": 200, "name": "c"}])";
    const auto labels = [&](const std::string& more) {
        std::vector<std::string> texts;
        const std::string node = R"({"kind": "label_from_uri", "params": {"uri": "b.json", "format": "json",
            "schema": "auth_residue", "field_name": "name")" +
                                 more + "}}";
        for (const Primitives::Label& label :
             built(scene(node + "," + component(R"("all")", balls())), rows).guide->primitives.labels)
            texts.push_back(label.text);
        return texts;
    };
    using Texts = std::vector<std::string>;
    EXPECT_EQ(labels(""), (Texts{"a", "b", "c"}));
    EXPECT_EQ(labels(R"(, "text_format": "{}: {score:.1f}")"), (Texts{"a: 0.5", "b: 1.0"}));
    EXPECT_EQ(labels(R"(, "group_by_fields": ["site"])"), (Texts{"a", "c"}));
    EXPECT_EQ(labels(R"(, "group_by_fields": [])"), (Texts{"a"}));
    EXPECT_EQ(labels(R"(, "field_remapping": {"group_id": "site"})"), (Texts{"a", "c"}));
    EXPECT_TRUE(labels(R"(, "text_format": "{")").empty());
    EXPECT_EQ(labels(R"(, "field_name": "score")"), (Texts{"0.5", "1"}));  // 1.0 as Mol* writes it
}

TEST(SceneAnnotations, SchemasKnowNamesAndIndicesOfResidues) {
    const auto painted = [](const std::string& schema, const std::string& row) {
        const std::string node =
            R"({"kind": "color_from_uri", "params": {"uri": "b.json", "format": "json", "schema": ")" + schema + "\"}}";
        const auto colors =
            built(scene(component(R"("all")", balls(node))), "[" + row + "]").guide->layers.at(0).colors;
        std::string marks;
        for (const std::uint32_t color : colors) marks += color == kRed ? 'x' : '-';
        return marks;
    };
    const std::string byName = R"({"label_comp_id": "GLY", "color": "red"})";
    EXPECT_EQ(painted("all_atomic", byName), "----xx---");
    EXPECT_EQ(painted("residue", byName), "xxxxxxxxx");  // it ignores the name
    for (const char* schema : {"residue", "auth_residue", "atom", "auth_atom", "all_atomic"})
        EXPECT_EQ(painted(schema, R"({"residue_index": 2, "color": "red"})"), "------xx-") << schema;
}

}  // namespace
}  // namespace nacre::app::mvs
