#include "engine/scene/color/color_schemes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <map>
#include <utility>

#include "engine/molecule/residue_distances.h"
#include "engine/molecule/text.h"
#include "engine/scene/build/chain_entities.h"
#include "engine/scene/color/color_classes.h"
#include "engine/scene/color/color_table.h"
#include "engine/scene/color/colors.h"

namespace nacre {
namespace {

using Atoms = std::span<const std::uint32_t>;

constexpr std::uint32_t kOutside = packedColor(0xc4beb4);  // atoms without a value: warm grey
constexpr std::size_t kMostLabels = 100;                   // of a table's colours in the legend
constexpr int kStops = 5;                                  // of a palette in the legend

struct SchemeName {
    std::string_view name;
    ColorScheme scheme;
};
// The first name of a scheme is its main one.
constexpr SchemeName kNames[] = {{"element", ColorScheme::element},
                                 {"chain", ColorScheme::chain},
                                 {"chain-carbons", ColorScheme::chainCarbons},
                                 {"input", ColorScheme::input},
                                 {"copy", ColorScheme::copy},
                                 {"copy-chain", ColorScheme::copyChain},
                                 {"copy-entity", ColorScheme::copyEntity},
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
                                 {"rmsd", ColorScheme::rmsd},
                                 {"distance", ColorScheme::distance},
                                 {"entity", ColorScheme::entity}};

/// At most two decimals, without trailing zeros.
std::string shortNumber(double value) {
    const double rounded = std::round(value * 100) / 100;
    std::string text = std::to_string(rounded == 0 ? 0.0 : rounded);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

std::size_t countDecimals(const std::string& number) {
    const std::size_t point = number.find('.');
    return point == std::string::npos ? 0 : number.size() - point - 1;
}

/// Equal numbers of decimals: the largest needed.
void alignDecimals(std::vector<LegendEntry>& numbers) {
    std::size_t most = 0;
    for (const LegendEntry& entry : numbers) most = std::max(most, countDecimals(entry.label));
    for (LegendEntry& entry : numbers) {
        const std::size_t missing = most - countDecimals(entry.label);
        if (missing == most && most > 0) entry.label += '.';
        entry.label.append(missing, '0');
    }
}

/// At most twelve digits: as written.
std::string exactNumber(double value) { return formatted("%.12g", value); }

/// The palette of a colouring, else the scheme's own.
AnyPalette chooseRamp(const Coloring& coloring, Palette own) {
    return coloring.palette == Palette::automatic ? own : coloring.palette;
}

/// Colours by a number per atom, with the ramp spread over the range.
template <typename Value>
ColoredAtoms byNumber(Atoms atoms, const AnyPalette& ramp, const ColorRange& range, const Value& getValue) {
    ColoredAtoms result;
    result.ramp = ramp;
    result.colors.reserve(atoms.size());
    const double span = range.last - range.first;
    const auto place = [&](double value) { return span != 0 ? (value - range.first) / span : 0.5; };
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const std::uint32_t atom : atoms) {
        const double value = getValue(atom);
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
        result.colors.push_back(paletteColor(ramp, place(value)));
    }
    const int stops = span != 0 ? kStops : 1;
    for (int i = 0; i < stops; ++i) {
        const double value = range.first + span * i / (kStops - 1);
        result.legend.push_back({shortNumber(value), paletteColor(ramp, place(value))});
    }
    if (stops == 1) return result;
    alignDecimals(result.legend);
    result.stops = kStops;
    // A clamped end stands for all values beyond it.
    LegendEntry& low = span > 0 ? result.legend.front() : result.legend.back();
    LegendEntry& high = span > 0 ? result.legend.back() : result.legend.front();
    if (lowest < std::min(range.first, range.last)) low.label += " or less";
    if (highest > std::max(range.first, range.last)) high.label += " or more";
    return result;
}

/// From the 2nd to the 98th percentile: otherwise one very mobile atom would leave a single colour for all others.
ColorRange usualRange(std::vector<double> values) {
    const auto percentile = [&](std::size_t percent) {
        const auto at = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * percent / 100);
        std::nth_element(values.begin(), at, values.end());
        return *at;
    };
    return {percentile(2), percentile(98)};
}

ColoredAtoms byBFactor(const Molecule& molecule, Atoms atoms, const Coloring& coloring) {
    const auto getValue = [&](std::uint32_t atom) {
        return static_cast<double>(molecule.atoms[atom].temperatureFactor);
    };
    std::vector<double> values;
    values.reserve(atoms.size());
    for (const std::uint32_t atom : atoms) values.push_back(getValue(atom));
    const ColorRange range = coloring.range ? *coloring.range : usualRange(std::move(values));
    ColoredAtoms result = byNumber(atoms, chooseRamp(coloring, Palette::sunset), range, getValue);
    if (range.first == range.last) result.warning = "nearly all B factors are " + shortNumber(range.first);
    return result;
}

/// By the distance of each residue from its counterpart, from 0 to the 98th percentile. Grey without one.
ColoredAtoms byFitDistance(const ResidueFacts& facts, Atoms atoms, const Coloring& coloring) {
    const Molecule& molecule = facts.molecule();
    const std::vector<double> distances = residueDistances(facts);
    const auto getValue = [&](std::uint32_t atom) { return distances[molecule.atoms[atom].residue]; };
    std::vector<std::uint32_t> paired;
    std::vector<double> values;
    for (const std::uint32_t atom : atoms)
        if (!std::isnan(getValue(atom))) {
            paired.push_back(atom);
            values.push_back(getValue(atom));
        }
    ColoredAtoms result;
    if (paired.empty()) {
        result.warning = "no residue has a counterpart in another INPUT";
        result.colors.assign(atoms.size(), kOutside);
        result.legend = {{"without a counterpart", kOutside}};
        return result;
    }
    const ColorRange range = coloring.range.value_or(ColorRange{0, usualRange(std::move(values)).last});
    result = byNumber(paired, chooseRamp(coloring, Palette::sunset), range, getValue);
    if (paired.size() == atoms.size()) return result;
    std::vector<std::uint32_t> colors;
    std::size_t next = 0;
    for (const std::uint32_t atom : atoms)
        colors.push_back(std::isnan(getValue(atom)) ? kOutside : result.colors[next++]);
    result.colors = std::move(colors);
    result.legend.push_back({"without a counterpart", kOutside});
    return result;
}

/// The centre of an assembly of many copies, such as a capsid's shell; otherwise of the atoms.
glm::dvec3 findCenter(const Molecule& molecule, Atoms atoms) {
    constexpr std::size_t kShell = 12;  // copies
    glm::dvec3 middle(0);
    for (const std::uint32_t atom : atoms)
        middle += glm::dvec3(molecule.atoms[atom].position) / static_cast<double>(atoms.size());
    for (const Assembly& assembly : molecule.assemblies) {
        glm::dvec3 sum(0);
        double copies = 0;
        for (const AssemblyPart& part : assembly.parts)
            for (const glm::mat4x3& transform : part.transforms) {
                sum += glm::dmat4x3(transform) * glm::dvec4(middle, 1.0);
                ++copies;
            }
        if (copies >= static_cast<double>(kShell)) return sum / copies;
    }
    return middle;
}

/// By the file's partial charges, over a range centred on 0.
ColoredAtoms byPartialCharge(const Molecule& molecule, Atoms atoms, const Coloring& coloring) {
    const auto getValue = [&](std::uint32_t atom) { return static_cast<double>(molecule.partialCharges[atom]); };
    std::vector<double> sizes;
    sizes.reserve(atoms.size());
    for (const std::uint32_t atom : atoms) sizes.push_back(std::abs(getValue(atom)));
    // The 98th percentile, or the largest of few: ions would make all other colours pale.
    const auto at = sizes.begin() + static_cast<std::ptrdiff_t>((sizes.size() * 98 + 99) / 100 - 1);
    std::nth_element(sizes.begin(), at, sizes.end());
    const double most = *at;
    return byNumber(atoms, chooseRamp(coloring, Palette::redWhiteBlue),
                    coloring.range.value_or(ColorRange{-most, most}), getValue);
}

ColoredAtoms byDistance(const Molecule& molecule, Atoms atoms, const Coloring& coloring) {
    const glm::dvec3 center = findCenter(molecule, atoms);
    const auto getValue = [&](std::uint32_t atom) {
        return glm::distance(glm::dvec3(molecule.atoms[atom].position), center);
    };
    std::vector<double> values;
    values.reserve(atoms.size());
    for (const std::uint32_t atom : atoms) values.push_back(getValue(atom));
    const ColorRange range = coloring.range ? *coloring.range : usualRange(std::move(values));
    return byNumber(atoms, chooseRamp(coloring, Palette::viridis), range, getValue);
}

/// Colours of a table, or values along a ramp. Atoms that the table does not match are grey.
ColoredAtoms byTable(const ResidueFacts& facts, Atoms atoms, const Coloring& coloring) {
    static const ColorTable kEmpty;
    const ColorTable& table = coloring.table ? *coloring.table : kEmpty;
    const TableMatch match = matchTable(facts, table);
    const auto findRow = [&](std::uint32_t atom) {
        const std::uint32_t row = match.rows[atom];
        return row == TableMatch::kNone ? nullptr : &table.rows[row];
    };
    std::vector<std::uint32_t> valued;
    std::vector<double> values;
    for (const std::uint32_t atom : atoms)
        if (const ColorTable::Row* row = findRow(atom); row && row->color == 0) {
            valued.push_back(atom);
            values.push_back(row->value);
        }
    ColoredAtoms result;
    if (!valued.empty()) {
        const ColorRange range = coloring.range ? *coloring.range : usualRange(std::move(values));
        result = byNumber(valued, chooseRamp(coloring, Palette::sunset), range,
                          [&](std::uint32_t atom) { return findRow(atom)->value; });
        if (range.first == range.last) result.warning = "nearly all values are " + shortNumber(range.first);
    }
    std::vector<std::uint32_t> colors;
    std::size_t next = 0;
    for (const std::uint32_t atom : atoms) {
        const ColorTable::Row* row = findRow(atom);
        colors.push_back(!row ? kOutside : row->color ? row->color : result.colors[next++]);
        if (!row || row->label.empty()) continue;
        const bool known = std::any_of(result.legend.begin(), result.legend.end(), [&](const LegendEntry& entry) {
            return entry.label == row->label && entry.color == row->color;
        });
        if (!known && row->color && result.legend.size() < kMostLabels)
            result.legend.push_back({row->label, row->color});
    }
    result.colors = std::move(colors);
    return result;
}

ColoredAtoms byRainbow(const ResidueFacts& facts, Atoms atoms, const AnyPalette& ramp) {
    const Molecule& molecule = facts.molecule();
    std::vector<std::size_t> lengths(molecule.chains.size()), positions(molecule.residues.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i)
        if (facts.isPolymer(i)) positions[i] = lengths[molecule.residues[i].chain]++;
    ColoredAtoms result;
    result.ramp = ramp;
    result.colors.reserve(atoms.size());
    bool any = false, outside = false;
    for (const std::uint32_t atom : atoms) {
        const std::uint32_t residue = molecule.atoms[atom].residue;
        if (!facts.isPolymer(residue)) {
            outside = true;
            result.colors.push_back(kOutside);
            continue;
        }
        any = true;
        const std::size_t length = lengths[molecule.residues[residue].chain];
        const double place =
            static_cast<double>(positions[residue]) / static_cast<double>(std::max<std::size_t>(length, 2) - 1);
        result.colors.push_back(paletteColor(ramp, place));
    }
    constexpr std::string_view kLabels[kStops] = {"N or 5' end", "a quarter along", "middle", "three quarters along",
                                                  "C or 3' end"};
    for (int i = 0; any && i < kStops; ++i)
        result.legend.push_back({std::string(kLabels[i]), paletteColor(ramp, i / double(kStops - 1))});
    result.stops = result.legend.size();
    if (outside) result.legend.push_back({"not in a chain", kOutside});
    if (!any) result.warning = "there is no protein or nucleic acid to colour along";
    return result;
}

/// By residue, with the scale in the legend rather than twenty names.
ColoredAtoms byHydropathy(const ResidueFacts& facts, Atoms atoms, const Coloring& coloring) {
    constexpr double kMost = 4.5;
    ColoredAtoms result = colorByClass(facts, atoms, coloring);
    if (!result.warning.empty()) return result;
    std::vector<LegendEntry> legend;
    result.ramp = chooseRamp(coloring, Palette::lipophilicity);
    for (int i = 0; i < kStops; ++i) {
        const double share = i / (kStops - 1.0);
        legend.push_back({shortNumber(kMost * (2 * share - 1)), paletteColor(result.ramp, share)});
    }
    alignDecimals(legend);
    result.stops = legend.size();
    for (const LegendEntry& entry : result.legend)
        if (entry.label == kNoAminoAcid) legend.push_back(entry);
    result.legend = std::move(legend);
    return result;
}

/// Names of the tinted parts within a copy, and the part of each atom.
struct TintKinds {
    std::vector<std::string> names;
    std::vector<std::uint32_t> ofAtom;
};
TintKinds tintKinds(const ResidueFacts& facts, Atoms atoms, ColorScheme scheme) {
    const Molecule& molecule = facts.molecule();
    TintKinds kinds;
    if (scheme == ColorScheme::copy) return {{""}, std::vector<std::uint32_t>(atoms.size(), 0)};
    std::optional<ResidueEntities> entities;
    if (scheme == ColorScheme::copyEntity) entities = residueEntities(facts);
    const std::vector<std::string> chains = chainLabels(facts, "chain ");
    std::map<std::uint32_t, std::uint32_t> numbers;
    for (const std::uint32_t atom : atoms) {
        const std::uint32_t residue = molecule.atoms[atom].residue, chain = molecule.residues[residue].chain;
        const std::uint32_t key = entities ? entities->ofResidue[residue] : chain;
        const auto [number, added] = numbers.emplace(key, static_cast<std::uint32_t>(kinds.names.size()));
        if (added) kinds.names.push_back(entities ? entities->labels[key] : chains[key]);
        kinds.ofAtom.push_back(number->second);
    }
    return kinds;
}

/// One copy has one colour; assembly_scene.cpp handles the copies of an assembly.
ColoredAtoms byCopy(const ResidueFacts& facts, Atoms atoms, const Coloring& coloring) {
    const std::uint32_t first = kindColor(0, chooseRamp(coloring, kChainPalette));
    const TintKinds kinds = tintKinds(facts, atoms, coloring.scheme);
    ColoredAtoms result;
    for (const std::uint32_t kind : kinds.ofAtom) {
        result.tints.push_back(copyTint(kind, kinds.names.size()));
        result.colors.push_back(tintedColor(first, result.tints.back()));
    }
    result.legend.push_back({"copy 1", first});
    for (std::size_t i = 0; i < kinds.names.size() && kinds.names.size() > 1; ++i)
        result.legend.push_back({kinds.names[i], tintedColor(first, copyTint(i, kinds.names.size()))});
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

PaletteUse paletteUse(ColorScheme scheme) {
    switch (scheme) {
        case ColorScheme::chain:
        case ColorScheme::chainCarbons:
        case ColorScheme::input:
        case ColorScheme::copy:
        case ColorScheme::copyChain:
        case ColorScheme::copyEntity:
        case ColorScheme::entity:
            return PaletteUse::kinds;
        case ColorScheme::hydrophobicity:
        case ColorScheme::bFactor:
        case ColorScheme::rainbow:
        case ColorScheme::occupancy:
        case ColorScheme::rmsd:
        case ColorScheme::distance:
        case ColorScheme::charge:
        case ColorScheme::table:
            return PaletteUse::ramp;
        default:
            return PaletteUse::none;
    }
}

bool takesRange(ColorScheme scheme) {
    return scheme == ColorScheme::bFactor || scheme == ColorScheme::occupancy || scheme == ColorScheme::rmsd ||
           scheme == ColorScheme::distance || scheme == ColorScheme::charge;
}

std::string coloringText(const Coloring& coloring) {
    if (coloring.scheme == ColorScheme::table) return coloring.table ? coloring.table->title : coloring.source;
    std::string text(colorSchemeName(coloring.scheme));
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ":") + part; };
    if (coloring.color != 0) add(colorText(coloring.color));
    if (coloring.range) add(exactNumber(coloring.range->first) + ".." + exactNumber(coloring.range->last));
    if (coloring.palette != Palette::automatic) add(paletteName(coloring.palette));
    return text;
}

ColoredAtoms colorAtoms(const ResidueFacts& facts, Atoms atoms, const Coloring& coloring) {
    const Molecule& molecule = facts.molecule();
    if (atoms.empty()) return {};
    switch (coloring.scheme) {
        case ColorScheme::bFactor:
            return byBFactor(molecule, atoms, coloring);
        case ColorScheme::occupancy:
            return byNumber(atoms, chooseRamp(coloring, Palette::viridis), coloring.range.value_or(ColorRange{0, 1}),
                            [&](std::uint32_t atom) { return static_cast<double>(molecule.atoms[atom].occupancy); });
        case ColorScheme::rmsd:
            return byFitDistance(facts, atoms, coloring);
        case ColorScheme::distance:
            return byDistance(molecule, atoms, coloring);
        case ColorScheme::charge:
            if (molecule.partialCharges.size() == molecule.atoms.size())
                return byPartialCharge(molecule, atoms, coloring);
            return colorByClass(facts, atoms, coloring);
        case ColorScheme::rainbow:
            return byRainbow(facts, atoms, chooseRamp(coloring, Palette::rainbow));
        case ColorScheme::copy:
        case ColorScheme::copyChain:
        case ColorScheme::copyEntity:
            return byCopy(facts, atoms, coloring);
        case ColorScheme::table:
            return byTable(facts, atoms, coloring);
        case ColorScheme::hydrophobicity:
            return byHydropathy(facts, atoms, coloring);
        case ColorScheme::uniform:
            return {std::vector<std::uint32_t>(atoms.size(), coloring.color),
                    {{colorText(coloring.color), coloring.color}},
                    Palette::automatic,
                    0,
                    {},
                    ""};
        default:
            return colorByClass(facts, atoms, coloring);
    }
}

}  // namespace nacre
