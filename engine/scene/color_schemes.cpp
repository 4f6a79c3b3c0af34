#include "engine/scene/color_schemes.h"

#include <algorithm>
#include <cmath>

#include "engine/molecule/residue_kind.h"
#include "engine/molecule/text.h"
#include "engine/scene/color_classes.h"
#include "engine/scene/palettes.h"

namespace nacre {
namespace {

using Atoms = std::span<const std::uint32_t>;

constexpr std::uint32_t kOutside = packedColor(0xc4beb4);  // what a scheme says nothing about: warm grey
constexpr int kStops = 5;                                  // of a palette in the legend

struct SchemeName {
    std::string_view name;
    ColorScheme scheme;
};
// The first name of a scheme is the one it goes by.
constexpr SchemeName kNames[] = {{"element", ColorScheme::element},
                                 {"chain", ColorScheme::chain},
                                 {"residue", ColorScheme::residue},
                                 {"hydrophobicity", ColorScheme::hydrophobicity},
                                 {"residue-type", ColorScheme::hydrophobicity},
                                 {"charge", ColorScheme::charge},
                                 {"secondary-structure", ColorScheme::secondaryStructure},
                                 {"ss", ColorScheme::secondaryStructure},
                                 {"b-factor", ColorScheme::bFactor},
                                 {"bfactor", ColorScheme::bFactor},
                                 {"b", ColorScheme::bFactor},
                                 {"plddt", ColorScheme::plddt},
                                 {"rainbow", ColorScheme::rainbow},
                                 {"occupancy", ColorScheme::occupancy},
                                 {"entity", ColorScheme::entity}};

/// Two decimals at most, no more than are needed.
std::string shortNumber(double value) {
    const double rounded = std::round(value * 100) / 100;
    std::string text = std::to_string(rounded == 0 ? 0.0 : rounded);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

/// Colours by a number of each atom, the palette spread from `low` to `high`.
template <typename Value>
ColoredAtoms byNumber(Atoms atoms, Palette palette, double low, double high, const Value& valueOf) {
    ColoredAtoms result;
    result.colors.reserve(atoms.size());
    const double span = high - low;
    const auto place = [&](double value) { return span > 0 ? (value - low) / span : 0.5; };
    for (const std::uint32_t atom : atoms) result.colors.push_back(paletteColor(palette, place(valueOf(atom))));
    const int stops = span > 0 ? kStops : 1;
    for (int i = 0; i < stops; ++i) {
        const double value = low + span * i / (kStops - 1);
        result.legend.push_back({shortNumber(value), paletteColor(palette, place(value))});
    }
    return result;
}

ColoredAtoms byBFactor(const Molecule& molecule, Atoms atoms) {
    const auto valueOf = [&](std::uint32_t atom) {
        return static_cast<double>(molecule.atoms[atom].temperatureFactor);
    };
    std::vector<double> values;
    values.reserve(atoms.size());
    for (const std::uint32_t atom : atoms) values.push_back(valueOf(atom));
    // One atom that moves freely would leave a single colour for the rest.
    const auto percentile = [&](std::size_t percent) {
        const auto at = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * percent / 100);
        std::nth_element(values.begin(), at, values.end());
        return *at;
    };
    const double low = percentile(2), high = percentile(98);
    ColoredAtoms result = byNumber(atoms, Palette::sunset, low, high, valueOf);
    if (!(high > low)) {
        result.warning = "nearly all B factors are " + shortNumber(low);
    } else {
        result.legend.front().label += " or less";
        result.legend.back().label += " or more";
    }
    return result;
}

ColoredAtoms byRainbow(const Molecule& molecule, Atoms atoms) {
    const std::vector<ResidueKind> kinds = residueKinds(molecule);
    const auto inPolymer = [&](std::size_t residue) {
        return kinds[residue] == ResidueKind::protein || kinds[residue] == ResidueKind::nucleic;
    };
    std::vector<std::size_t> lengths(molecule.chains.size()), positions(molecule.residues.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (inPolymer(i)) positions[i] = lengths[molecule.residues[i].chain]++;
    ColoredAtoms result;
    result.colors.reserve(atoms.size());
    bool any = false, outside = false;
    for (const std::uint32_t atom : atoms) {
        const std::uint32_t residue = molecule.atoms[atom].residue;
        if (!inPolymer(residue)) {
            outside = true;
            result.colors.push_back(kOutside);
            continue;
        }
        any = true;
        const std::size_t length = lengths[molecule.residues[residue].chain];
        const double place =
            static_cast<double>(positions[residue]) / static_cast<double>(std::max<std::size_t>(length, 2) - 1);
        result.colors.push_back(paletteColor(Palette::rainbow, place));
    }
    constexpr std::string_view kLabels[kStops] = {"N or 5' end", "a quarter along", "middle", "three quarters along",
                                                  "C or 3' end"};
    for (int i = 0; any && i < kStops; ++i)
        result.legend.push_back({std::string(kLabels[i]), paletteColor(Palette::rainbow, i / double(kStops - 1))});
    if (outside) result.legend.push_back({"not in a chain", kOutside});
    if (!any) result.warning = "there is no protein or nucleic acid to colour along";
    return result;
}

}  // namespace

std::string_view colorSchemeName(ColorScheme scheme) {
    for (const SchemeName& entry : kNames)
        if (entry.scheme == scheme) return entry.name;
    return {};
}

std::optional<ColorScheme> colorSchemeFromName(std::string_view name) {
    const std::string lower = lowerCase(name);
    for (const SchemeName& entry : kNames)
        if (entry.name == lower) return entry.scheme;
    return std::nullopt;
}

std::string coloringText(const Coloring& coloring) {
    const std::string scheme(colorSchemeName(coloring.scheme));
    if (coloring.color == 0) return scheme;
    return scheme + (scheme.empty() ? "" : ":") + colorText(coloring.color);
}

ColoredAtoms colorAtoms(const Molecule& molecule, Atoms atoms, const Coloring& coloring) {
    if (atoms.empty()) return {};
    switch (coloring.scheme) {
        case ColorScheme::bFactor:
            return byBFactor(molecule, atoms);
        case ColorScheme::occupancy:
            return byNumber(atoms, Palette::viridis, 0, 1,
                            [&](std::uint32_t atom) { return static_cast<double>(molecule.atoms[atom].occupancy); });
        case ColorScheme::rainbow:
            return byRainbow(molecule, atoms);
        case ColorScheme::uniform:
            return {std::vector<std::uint32_t>(atoms.size(), coloring.color),
                    {{colorText(coloring.color), coloring.color}},
                    ""};
        default:
            return colorByClass(molecule, atoms, coloring);
    }
}

}  // namespace nacre
