#include "app/picture/appearance_values.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "app/picture/geometry_options.h"
#include "app/picture/option_text.h"
#include "app/picture/option_values.h"
#include "engine/molecule/text.h"
#include "engine/scene/color/palettes.h"

namespace nacre::app {
namespace {

/// Names from other programs.
struct Synonym {
    std::string_view theirs, ours;
};
// PyMOL, ChimeraX, Mol*, Jmol and RasMol, VMD.
constexpr Synonym kStyleSynonyms[] = {{"sticks", "licorice"},
                                      {"stick", "licorice"},
                                      {"spheres", "spacefill"},
                                      {"sphere", "spacefill"},
                                      {"vdw", "spacefill"},
                                      {"cpk", "spacefill"},
                                      {"space-filling", "spacefill"},
                                      {"spacefilling", "spacefill"},
                                      {"balls-and-sticks", "ball-and-stick"},
                                      {"ball+stick", "ball-and-stick"},
                                      {"ballandstick", "ball-and-stick"},
                                      {"ball-stick", "ball-and-stick"},
                                      {"cartoons", "cartoon"},
                                      {"ribbon", "cartoon"},
                                      {"ribbons", "cartoon"},
                                      {"newcartoon", "cartoon"},
                                      {"lines", "line"},
                                      {"wireframe", "line"},
                                      {"wire", "line"},
                                      {"trace", "backbone"},
                                      {"carbohydrates", "carbohydrate"},
                                      {"snfg", "carbohydrate"},
                                      {"ellipsoid", "ellipsoids"},
                                      {"ortep", "ellipsoids"},
                                      {"molecular-surface", "surface"},
                                      {"surf", "surface"},
                                      {"quicksurf", "surface"}};
constexpr Synonym kColorSynonyms[] = {{"cpk", "element"},
                                      {"elements", "element"},
                                      {"byelement", "element"},
                                      {"element-symbol", "element"},
                                      {"heteroatom", "element"},
                                      {"chains", "chain"},
                                      {"cbc", "chain-carbons"},
                                      {"carbons-by-chain", "chain-carbons"},
                                      {"byhetero", "chain-carbons"},
                                      {"by-copy", "copy"},
                                      {"operator-name", "copy"},
                                      {"symmetry", "copy"},
                                      {"bychain", "chain"},
                                      {"chain-id", "chain"},
                                      {"spectrum", "rainbow"},
                                      {"sequence-id", "rainbow"},
                                      {"structure", "secondary-structure"},
                                      {"secondary", "secondary-structure"},
                                      {"b", "b-factor"},
                                      {"temperature", "b-factor"},
                                      {"bfactors", "b-factor"},
                                      {"confidence", "plddt"},
                                      {"hydrophobic", "hydrophobicity"},
                                      {"byresidue", "residue"}};

void addSynonyms(std::span<const Synonym> synonyms, std::vector<std::string>& words) {
    for (const Synonym& synonym : synonyms) words.emplace_back(synonym.theirs);
}

std::string_view ours(std::string_view text, std::span<const Synonym> synonyms) {
    const std::string word = lowerCase(text);
    for (const Synonym& synonym : synonyms)
        if (synonym.theirs == word) return synonym.ours;
    return text;
}

}  // namespace

Style parseStyle(std::string_view text) {
    if (lowerCase(text) == "putty")
        throw std::invalid_argument("putty is a form of cartoons: --style cartoon --putty on");
    std::vector<std::string> words;
    for (const auto& [name, style] : kStyles) {
        if (ours(text, kStyleSynonyms) == name) return style;
        words.emplace_back(name);
    }
    const std::string wanted = joinAlternatives(words);
    addSynonyms(kStyleSynonyms, words);
    refuse(text, wanted, words);
}

namespace {

/// A colour for atoms, packed like the engine's.
std::uint32_t parseAtomColor(std::string_view text) {
    const std::array<float, 4> color = parseColor(text);
    if (color[3] < 1.0f) throw std::invalid_argument("atoms cannot be transparent: '" + std::string(text) + "'");
    return opaqueColor(color);
}

bool isColor(std::string_view text) {
    try {
        parseColor(text);
    } catch (const std::invalid_argument&) {
        return false;
    }
    return true;
}

std::vector<std::string> listPalettes(bool ramps) {
    std::vector<std::string> names;
    for (const Palette palette : allPalettes())
        if (isRamp(palette) == ramps) names.emplace_back(paletteName(palette));
    return names;
}

std::string rampChoices() { return "one of " + joinWords(listPalettes(true)) + ", or colours such as white:red"; }

/// Takes a ramp of colours from the start of a text: "white:red:10..60" leaves "10..60". @returns nothing, and does not
/// change the text, if it does not begin with two colours
std::optional<AnyPalette> takeRamp(std::string_view& text) {
    std::vector<std::uint32_t> colors;
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::string_view part = rest.substr(0, rest.find(':'));
        if (!isColor(part)) break;
        const std::uint32_t packed = parseAtomColor(part);
        colors.push_back((packed & 0xff) << 16 | (packed & 0xff00) | (packed >> 16 & 0xff));
        rest = part.size() == rest.size() ? std::string_view() : rest.substr(part.size() + 1);
    }
    if (colors.size() < 2) return std::nullopt;
    if (colors.size() > kMostRampColors)
        throw std::invalid_argument("a ramp has at most " + std::to_string(kMostRampColors) + " colours");
    text = rest;
    return AnyPalette::ramp(std::move(colors));
}

/// Parses the part after a scheme's name: its range, its palette, or the colour of its carbons.
void parseColoringPart(std::string_view text, Coloring& coloring) {
    const std::string name(colorSchemeName(coloring.scheme));
    const PaletteUse use = paletteUse(coloring.scheme);
    if (const auto range = parseColorRange(text)) {
        if (!takesRange(coloring.scheme))
            throw std::invalid_argument("'" + name +
                                        "' takes no range; b-factor, occupancy, rmsd, distance and charge do");
        coloring.range = range;
    } else if (const auto palette = paletteFromName(lowerCase(text))) {
        if (use != (isRamp(*palette) ? PaletteUse::ramp : PaletteUse::kinds))
            throw std::invalid_argument("'" + name + "' takes no palette" +
                                        (use == PaletteUse::none   ? std::string()
                                         : use == PaletteUse::ramp ? " for categories: one of " + paletteNames(true)
                                                                   : " for numbers: one of " + paletteNames(false)));
        coloring.palette = *palette;
    } else if (coloring.scheme == ColorScheme::element) {
        coloring.color = parseAtomColor(text);
    } else if (use != PaletteUse::none) {
        const std::vector<std::string> palettes = listPalettes(use == PaletteUse::ramp);
        refuse(text,
               (takesRange(coloring.scheme) ? "a range such as 10..60, or " : "") +
                   (use == PaletteUse::ramp ? rampChoices() : "one of " + joinWords(palettes)) + " after '" + name +
                   ":'",
               palettes);
    } else {
        throw std::invalid_argument("'" + name + "' takes no further value, such as '" + std::string(text) +
                                    "' (element:COLOR has a colour for carbons)");
    }
}

}  // namespace

std::optional<ColorRange> parseColorRange(std::string_view text) {
    const std::size_t dots = text.find("..");
    if (dots == std::string_view::npos) return std::nullopt;
    ColorRange range;
    if (!readWhole(text.substr(0, dots), range.first) || !readWhole(text.substr(dots + 2), range.last) ||
        !std::isfinite(range.first) || !std::isfinite(range.last) || range.first == range.last)
        refuse(text, "FROM..TO, two different numbers, such as 10..60");
    return range;
}

std::string paletteNames(bool ramps) { return joinWords(listPalettes(ramps)); }

namespace {

std::vector<std::string> allSchemes() {
    std::vector<std::string> names;
    for (int s = 0; s < static_cast<int>(ColorScheme::uniform); ++s)
        names.emplace_back(colorSchemeName(static_cast<ColorScheme>(s)));
    return names;
}

/// The word of a list whose plural is `text`: "entity" for "entities". Empty if there is none.
std::string findSingular(std::string_view text, std::span<const std::string> words) {
    const std::string word = lowerCase(text);
    for (const std::string& one : words)
        if (word == one + "s" || word == one + "es" ||
            (one.ends_with('y') && word == one.substr(0, one.size() - 1) + "ies"))
            return one;
    return {};
}

/// Throws for a text that is neither a colour nor begins with a scheme before its first colon.
[[noreturn]] void refuseColoring(std::string_view text) {
    const std::string_view scheme = text.substr(0, text.find(':'));
    std::string_view rest = text;
    if (takeRamp(rest) && rest.empty())
        throw std::invalid_argument("a ramp of colours goes with a scheme of numbers, such as b-factor:" +
                                    std::string(text));
    if (isColor(scheme) && scheme.size() < text.size())
        throw std::invalid_argument("a colour takes no palette or range: '" + std::string(text) +
                                    "' (a scheme does, such as b-factor:10..60:viridis)");
    std::vector<std::string> words = allSchemes();
    const std::string wanted = schemeNames() + ", a colour's name, #rrggbb or element:COLOR for carbons in one colour";
    if (const std::string one = findSingular(scheme, words); !one.empty())
        throw std::invalid_argument("expected " + wanted + ", not '" + std::string(text) + "' (did you mean '" + one +
                                    std::string(text.substr(scheme.size())) + "'?)");
    addSynonyms(kColorSynonyms, words);
    if (scheme.size() == text.size())
        for (std::string& name : colorNames()) words.push_back(std::move(name));
    refuse(scheme, wanted, words);
}

}  // namespace

std::string schemeNames() { return joinWords(allSchemes()); }

AnyPalette parsePalette(std::string_view text) {
    if (const auto palette = paletteFromName(lowerCase(text))) return *palette;
    std::string_view rest = text;
    if (const auto ramp = takeRamp(rest); ramp && rest.empty()) return *ramp;
    std::vector<std::string> words;
    for (const Palette palette : allPalettes()) words.emplace_back(paletteName(palette));
    refuse(text,
           "one of " + paletteNames(false) + " for categories, or " + paletteNames(true) +
               " or colours such as white:red for numbers",
           words);
}

Coloring parseColoring(std::string_view text) {
    std::string_view rest = text;
    const auto part = [&] {
        const std::size_t colon = rest.find(':');
        const std::string_view first = rest.substr(0, colon);
        rest = colon == std::string_view::npos ? std::string_view() : rest.substr(colon + 1);
        return first;
    };
    if (const auto scheme = colorSchemeFromName(ours(part(), kColorSynonyms)); scheme && !text.ends_with(':')) {
        Coloring coloring(*scheme);
        while (!rest.empty()) {
            const auto ramp = paletteUse(*scheme) == PaletteUse::ramp ? takeRamp(rest) : std::nullopt;
            if (ramp)
                coloring.palette = *ramp;
            else
                parseColoringPart(part(), coloring);
        }
        return coloring;
    }
    if (isColor(text)) return Coloring::uniform(parseAtomColor(text));
    refuseColoring(text);
}

namespace {

/// Letters and hyphens, like the names of palettes.
bool isWord(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) { return c == '-' || (c >= 'a' && c <= 'z'); });
}

}  // namespace

Coloring parseColorSource(std::string_view text) {
    Coloring coloring(ColorScheme::table);
    if (isTableText(text)) {
        if (text.size() > kLongestGeometryText)
            throw std::invalid_argument("a table in an option is at most " +
                                        std::to_string(kLongestGeometryText >> 20) + " MB long (put it in a file)");
        coloring.source = isJsonText(text) ? parsePrimitiveSource(text).text : text.starts_with("csv:") ? "" : "csv:";
        if (!isJsonText(text)) coloring.source += text;
        std::replace(coloring.source.begin(), coloring.source.end(), '\n', ';');
        std::erase(coloring.source, '\r');
        return coloring;
    }
    constexpr std::string_view kColumn = "value=";
    // Colours at the end, or before a range, form a ramp.
    for (std::size_t at = text.find(':'); at != std::string_view::npos; at = text.find(':', at + 1)) {
        std::string_view rest = text.substr(at + 1);
        const auto ramp = takeRamp(rest);
        if (!ramp) continue;
        const std::string kept = std::string(text.substr(0, at)) + (rest.empty() ? "" : ":" + std::string(rest));
        coloring = parseColorSource(kept);
        coloring.palette = *ramp;
        return coloring;
    }
    for (std::size_t colon; (colon = text.rfind(':')) != std::string_view::npos;) {
        const std::string_view part = text.substr(colon + 1);
        const auto palette = paletteFromName(lowerCase(part));
        if (part.starts_with(kColumn))
            coloring.column = part.substr(kColumn.size());
        else if (palette && isRamp(*palette))
            coloring.palette = *palette;
        else if (part.find("..") != std::string_view::npos && part.find_first_of("/\\") == std::string_view::npos)
            coloring.range = parseColorRange(part);
        else if (palette)
            throw std::invalid_argument("values take no palette of kinds: one of " + paletteNames(true));
        else if (isWord(part) && text.substr(0, colon).find('.') != std::string_view::npos)  // after a file's extension
            refuse(part, "value=COLUMN, a range such as 10..60, or " + rampChoices(), listPalettes(true));
        else
            break;
        text = text.substr(0, colon);
    }
    coloring.source = fileName(text);
    return coloring;
}

std::string colorSourceText(const Coloring& coloring) {
    std::string text = coloring.source;
    if (!coloring.column.empty()) text += ":value=" + coloring.column;
    if (coloring.range) text += ":" + exactText(coloring.range->first) + ".." + exactText(coloring.range->last);
    if (coloring.palette != Palette::automatic) text += ":" + paletteName(coloring.palette);
    return text;
}

bool isTableText(std::string_view text) {
    return isJsonText(text) || text.starts_with("csv:") || text.find('\n') != std::string_view::npos;
}

void setStyle(Style style, RepresentationOptions& look) {
    look.style = style;
    if ((style == Style::cartoon || style == Style::backbone) && look.color == Coloring())
        look.color = ColorScheme::chainCarbons;
}

namespace {

/// A selection may contain no '=', so the last one divides.
std::pair<std::string_view, std::string_view> divide(std::string_view text, const char* wanted) {
    const std::size_t sign = text.rfind('=');
    if (sign == std::string_view::npos) refuse(text, wanted);
    const auto trimmed = [](std::string_view part) {
        const std::size_t first = std::min(part.find_first_not_of(' '), part.size());
        return part.substr(first, part.find_last_not_of(' ') + 1 - first);
    };
    return {trimmed(text.substr(0, sign)), trimmed(text.substr(sign + 1))};
}

}  // namespace

Rule parseShow(std::string_view text) {
    std::string_view rest = text;
    /// Cuts off a separator and the text after it, and returns that text.
    const auto cut = [&](std::string_view separator) -> std::optional<std::string_view> {
        const std::size_t at = rest.rfind(separator);
        if (at == std::string_view::npos) return std::nullopt;
        const std::string_view value = rest.substr(at + separator.size());
        rest = rest.substr(0, at);
        return value;
    };
    const std::optional<std::string_view> material = cut(":material="), opacity = cut(":opacity=");
    const auto [selection, style] = divide(rest, "SELECTION=STYLE");
    Rule rule;
    rule.action = Rule::Action::show;
    rule.selection = parseSelection(selection);
    rule.style = parseStyle(style);
    const auto refused = [&](const char* why) {
        return std::invalid_argument(std::string(why) + ": '" + std::string(text) + "'");
    };
    if (opacity && (rule.style == Style::line || rule.style == Style::carbohydrate))
        throw refused("lines and symbols of sugars are opaque");
    if (opacity && material) throw refused("a rule gives a material or an opacity, not both");
    if (material && rule.style == Style::line) throw refused("lines have no material");
    if (opacity) rule.opacity = parseNumber(*opacity, kLeastOpacity, 1);
    if (material) rule.material = static_cast<Material>(parseChoice(*material, kMaterialNames));
    return rule;
}

Rule parseHide(std::string_view text) {
    Rule rule;
    rule.action = Rule::Action::hide;
    rule.selection = parseSelection(text);
    return rule;
}

Rule parseColorBy(std::string_view text) {
    const auto [selection, coloring] = divide(text, "SELECTION=SCHEME or SELECTION=COLOR");
    Rule rule;
    rule.action = Rule::Action::color;
    rule.selection = parseSelection(selection);
    rule.coloring = parseColoring(coloring);
    return rule;
}

}  // namespace nacre::app
