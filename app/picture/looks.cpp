#include "app/picture/looks.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "app/files/json_text.h"
#include "app/picture/appearance_values.h"
#include "app/picture/option_text.h"
#include "app/picture/options.h"
#include "app/picture/saved_view.h"

namespace nacre::app {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// The options of a saved view that belong to looks.
Look lookOfView(const std::string& json, const std::string& name) {
    Look look{name, "", {}};
    const auto view = parseJson<OrderedJson>(json);
    for (const auto& [key, value] : view.items())
        if (const Option* found = findOption(key); found && found->look)
            look.options.emplace_back(key, value.is_string() ? value.get<std::string>() : value.dump());
    return look;
}

}  // namespace

std::span<const Look> looks() {
    static const std::vector<Look> kLooks{
        {"default", "calm colours, soft light, ambient occlusion", {}},
        {"qutemol",
         "on grey, deep clefts, a shadow: after QuteMol (Tarini, Cignoni, Montani 2006)",
         {{"background", "#808080"},
          {"color", "element:#a8a8a8"},
          {"ambient", "0.75"},
          {"direct", "0.95"},
          {"highlight", "0.6"},
          {"gloss", "20"},
          {"shadow", "0.85"}}},
        {"illustrative",
         "flat colours by chain, outlines of three weights: after Goodsell's Illustrate",
         {{"color", "chain"},
          {"lighting", "off"},
          {"occlusion-strength", "0.3"},
          {"contours", "2.5"},
          {"contour-weights", "3"},
          {"contour-depth", "1.3"}}},
        {"textbook",
         "pale light, thin outlines, fog",
         {{"ambient", "1.15"},
          {"direct", "0.5"},
          {"highlight", "0.4"},
          {"gloss", "20"},
          {"occlusion-strength", "0.7"},
          {"contours", "1"},
          {"contour-depth", "2.5"},
          {"contour-color", "#303030"},
          {"fog", "auto"},
          {"fog-strength", "0.6"}}},
        {"flat", "colour and occlusion, no light", {{"lighting", "off"}, {"occlusion-strength", "0.75"}}},
        {"matte", "like paper or clay", {{"ambient", "1.2"}, {"direct", "0.6"}, {"highlight", "0"}}},
        {"glossy",
         "like polished plastic",
         {{"ambient", "0.85"}, {"direct", "1.05"}, {"highlight", "4.5"}, {"gloss", "110"}}},
        {"dark",
         "on black, light from the side, dark fog",
         {{"background", "black"},
          {"ambient", "0.45"},
          {"direct", "1.5"},
          {"highlight", "1.3"},
          {"shadow", "0.6"},
          {"fog", "auto"},
          {"fog-strength", "0.9"}}},
    };
    return kLooks;
}

Look lookFromText(const std::string& json, const std::string& name) {
    parseSavedView(json, name);  // checks every key and value
    return lookOfView(json, name);
}

std::optional<Look> lookAlone(const std::string& path) {
    const std::string text = readViewText(path);
    Look look = lookFromText(text, path);
    if (look.options.size() != parseJson<OrderedJson>(text).size()) return std::nullopt;
    return look;
}

Look readLook(const std::string& nameOrFile) {
    std::vector<std::string> names;
    for (const Look& look : looks()) {
        if (look.name == nameOrFile) return look;
        names.push_back(look.name);
    }
    if (nameOrFile.ends_with(".json")) return lookFromText(readViewText(nameOrFile), nameOrFile);
    refuse(nameOrFile, joinWords(names) + ", or a file that ends in .json", names);
}

void applyLook(const Look& look, PictureDescription& view) {
    const PictureDescription plain;
    for (const Option& option : options())  // the style of cuts belongs to the cut
        if (option.look && option.key != "color" && option.needs != "clip")
            option.value.parse(option.value.print(plain), view);
    for (const auto& [key, value] : look.options) option(key).value.parse(value, view);
}

std::string lookJson(const Look& look) {
    OrderedJson json = OrderedJson::object();
    for (const auto& [key, value] : look.options) json[key] = value;
    return jsonText(json);
}

std::string lookJson(const PictureDescription& view) { return lookJson(lookOfView(savedViewJson(view), "")); }

void applyPocket(std::string_view text, PictureDescription& d) {
    if (text == "ligand") text = "mainligand";  // one of several equal ones, and no glycan
    const Selection ligand = parseSelection(text);
    const std::string it = "(" + std::string(text) + ")";
    const std::string around = "byres (within " + numberText(kPocketReach) + " of " + it + ")";
    d.look.style = Style::cartoon;
    d.look.color = Coloring::uniform(0xffc8c4be);  // a pale grey, as background
    d.look.cartoonOpacity = 0.3;
    const Rule rules[] = {parseShow(around + "=licorice"), parseColorBy(around + "=element:#b8b8b0"),
                          parseColorBy(it + "=element:#e8b04b")};
    d.look.rules.insert(d.look.rules.begin(), std::begin(rules), std::end(rules));
    d.look.contacts.of = ligand;
    d.look.contacts.with.reset();
    d.words.labels.insert(d.words.labels.begin(),
                          parseLabel(around + " and polymer and not " + it + "={residue} {number}"));
    d.words.seenOnly = true;
    d.aim.lookAt = ligand;
    d.aim.zoomTo = ligand;
    d.aim.uncovers = false;  // residues in front of the ligand may bind it
}

void applyInterface(std::string_view sides, PictureDescription& d) {
    const std::size_t comma = sides.find(',');
    if (comma == std::string_view::npos || sides.find(',', comma + 1) != std::string_view::npos)
        throw std::invalid_argument("expected two chains or selections, A,B");
    const auto side = [](std::string_view text) {
        const bool chains = !text.empty() && std::ranges::all_of(text, [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) || c == '+';
        });
        const std::string selection = chains ? "chain " + std::string(text) : std::string(text);
        parseSelection(selection);
        return "(" + selection + ")";
    };
    const std::string a = side(sides.substr(0, comma)), b = side(sides.substr(comma + 1));
    const std::string reach = numberText(kPocketReach);
    const auto near = [&](const std::string& one, const std::string& other) {
        return "byres (" + one + " and within " + reach + " of " + other + ")";
    };
    const std::string both = "(" + near(a, b) + " or " + near(b, a) + ")";
    d.look.style = Style::cartoon;
    d.look.cartoonOpacity = 0.4;
    const Rule rules[] = {parseHide("not (" + a + " or " + b + ")"),
                          parseShow(both + "=licorice"),
                          parseColorBy(a + "=#5fa8a0"),
                          parseColorBy(b + "=#d99a5b"),
                          parseColorBy(a + " and " + both + "=element:#5fa8a0"),
                          parseColorBy(b + " and " + both + "=element:#d99a5b")};
    d.look.rules.insert(d.look.rules.begin(), std::begin(rules), std::end(rules));
    d.look.contacts.of = parseSelection(a);
    d.look.contacts.with = parseSelection(b);
    d.aim.principal = d.aim.fromSide = true;
    d.aim.orientBy = d.aim.zoomTo = parseSelection(both);
    d.aim.left = parseSelection(a);
    d.aim.uncovers = false;
}

}  // namespace nacre::app
