#include <gtest/gtest.h>

#include <string>

#include "app/picture/option_json.h"
#include "app/picture/options.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

std::string catchError(const char* key, const char* value) {
    PictureDescription picture;
    try {
        setOption(option(key), value, picture);
    } catch (const std::invalid_argument& error) {
        return error.what();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

void expectError(const char* key, const char* value, const char* words) {
    const std::string error = catchError(key, value);
    EXPECT_NE(error.find(words), std::string::npos) << "--" << key << " " << value << ": " << error;
}

// What users typed, and what helps them.
TEST(OptionErrors, NameTheUnknownPart) {
    expectError("color-from", "pae.csv:0..30:green-white", "not 'green-white'");
    expectError("color-from", "pae.csv:0..30:green-white", "or colours such as white:red");
    expectError("color", "b-factor:wite:red", "or colours such as white:red after 'b-factor:', not 'wite'");
    expectError("color-from", "pae.csv:virids", "did you mean 'viridis'?");
    expectError("color", "element:oragne", "'orange'?");
    expectError("color", "element:#ff000080", "transparent");
    expectError("color", "#ff000080", "transparent");
    expectError("color", "chain:orange", "one of distinct");
    expectError("color", "chain:1..2", "takes no range");
    expectError("color", "chain:viridis", "for numbers");
    expectError("color", "charge:muted", "takes no palette");
    expectError("color", "b-factor:muted", "for categories");
    expectError("color", "b-factor:5", "10..60");
    expectError("color", "b-factor:5..5", "two different numbers");
    expectError("palette", "mutd", "'muted'?");
    expectError("hide", "chain A and resi x", "column 18: expected a residue number, found 'x'");
    expectError("show", "chain A", "SELECTION=STYLE");
    expectError("show", "chain A=hologram", "hologram");
    expectError("color-by", "all=", "rainbow");
    expectError("color-by", "all=#12345", "#rrggbb");
    expectError("label", "all={foo}", "not '{foo}'");
    expectError("measure", "1", "two atoms");
    expectError("title", "\\alpa", "'alpha'");
    expectError("interactions", "ligand,foo", "'foo'");
    expectError("interaction-kinds", "hbond", "did you mean 'hydrogen-bond'?");
    expectError("interaction-kinds", "hydrogen-bnd", "did you mean 'hydrogen-bond'?");
    expectError("color", "cyan:viridis", "a colour takes no palette");
    expectError("color", "white:red", "b-factor:white:red");
    expectError("width", "85", "a length needs a unit: 85mm or 85px");
    expectError("orient", "prncipal", "did you mean 'principal'?");
    expectError("map-around", "fcous", "did you mean 'focus'?");
    expectError("fog", "aut", "did you mean 'auto'?");
    for (const char* key : {"line-width", "stick-radius", "text-size"})
        expectError(key, "2mm", "not '2mm' (8pt is a size in points)");
}

TEST(OptionErrors, SpacesAndListsAreNone) {
    EXPECT_EQ(catchError("show", "chain A = licorice"), "");
    EXPECT_EQ(catchError("interactions", "chain A,B"), "");
    EXPECT_EQ(catchError("interactions", "ligand,protein"), "");
    for (const char* source : {"pae.csv", "pae.csv:0..30:viridis", "data/a.b:value=x", "csv:chain,value\nA,1"})
        EXPECT_EQ(catchError("color-from", source), "") << source;
}

TEST(OptionErrors, BooleansSwitchWhatCanBeOff) {
    const auto parseValue = [](const char* json) { return parseOptionValues(json).at(0).value; };
    EXPECT_EQ(parseValue(R"({"fog": true})"), "auto");
    EXPECT_EQ(parseValue(R"({"fog": false})"), "off");
    EXPECT_EQ(parseValue(R"({"gaps": true})"), "dashed");
    EXPECT_EQ(parseValue(R"({"occlusion": true})"), "128");
    EXPECT_EQ(parseValue(R"({"carbohydrates": true})"), "on");
    EXPECT_EQ(parseValue(R"({"interaction_labels": true})"), "distance");
    EXPECT_THROW(parseValue(R"({"halos": true})"), UsageError);
    EXPECT_THROW(parseValue(R"({"zoom": false})"), UsageError);
}

}  // namespace
}  // namespace nacre::app
