#pragma once
// Colour schemes: a colour for every atom, and the legend that explains them.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/residue_facts.h"
#include "engine/scene/palettes.h"

namespace nacre {

enum class ColorScheme {
    element,
    chain,
    chainCarbons,        ///< carbons by chain, all else by element
    input,               ///< of several molecules in one picture
    copy,                ///< of an assembly
    copyChain,           ///< likewise, its chains in tints of it
    copyEntity,          ///< likewise, its entities
    residue,             ///< residueColor() of colors.h
    hydrophobicity,      ///< of amino acids, J. Kyte and R. F. Doolittle, J. Mol. Biol. 157 (1982) 105
    charge,              ///< of residues at pH 7, formal charges elsewhere
    secondaryStructure,  ///< as the file states it, else by hydrogen bonds
    bFactor,             ///< from the 2nd to the 98th percentile of the coloured atoms
    plddt,               ///< B factor as AlphaFold's confidence, in its four bands and colours
    rainbow,             ///< along each chain, from N to C or 5' to 3'
    occupancy,           ///< 0 to 1
    entity,              ///< the file's entities; else chains of equal sequence, and residues of equal name
    uniform,             ///< one colour
};

/// What the palette of a scheme is of.
enum class PaletteUse : std::uint8_t { none, kinds, ramp };
PaletteUse paletteUse(ColorScheme scheme);
/// Whether the ends of its ramp can be given.
bool takesRange(ColorScheme scheme);

/// The name that `--color` takes ("b-factor"); empty for uniform.
std::string_view colorSchemeName(ColorScheme scheme);
/// The scheme of such a name; also knows "ss", "bfactor", "b", "residue-type" and "secondary-structure".
std::optional<ColorScheme> colorSchemeFromName(std::string_view name);

/// Values at the ends of a ramp; the first may be the larger one.
struct ColorRange {
    double first = 0, last = 1;
    friend bool operator==(const ColorRange&, const ColorRange&) = default;
};

/// A scheme, or one colour.
struct Coloring {
    ColorScheme scheme = ColorScheme::element;
    std::uint32_t color = 0;  ///< packed as in colors.h; of uniform, or of element's carbons: 0 is their usual one
    Palette palette = Palette::automatic;
    std::optional<ColorRange> range = {};  ///< of a ramp; empty: what the scheme finds

    Coloring() = default;
    Coloring(ColorScheme wanted) : scheme(wanted) {}
    static Coloring uniform(std::uint32_t color) {
        Coloring coloring(ColorScheme::uniform);
        coloring.color = color;
        return coloring;
    }
    /// Carbons in one colour and all else by element, so that ligands are told apart.
    static Coloring elementWithCarbons(std::uint32_t color) {
        Coloring coloring(ColorScheme::element);
        coloring.color = color;
        return coloring;
    }
    friend bool operator==(const Coloring&, const Coloring&) = default;
};

/// As `--color` takes it: "chain", "#rrggbb", "element:#rrggbb", "b-factor:10..60:viridis".
std::string coloringText(const Coloring& coloring);

struct LegendEntry {
    std::string label;
    std::uint32_t color = 0;
};

struct ColoredAtoms {
    std::vector<std::uint32_t> colors;  ///< same length as the atoms
    std::vector<LegendEntry> legend;    ///< of kinds, those that occur; of numbers, five along the palette
    Palette ramp = Palette::automatic;  ///< along which the first `stops` entries stand
    std::size_t stops = 0;              ///< entries from end to end of the ramp; what follows are kinds
    std::vector<std::uint32_t> tints;   ///< of the colour of its copy, for each atom; empty: colours are no copy's
    std::string warning;                ///< why the colours say little here; empty if they do
};

/// @param atoms  indices of the atoms to colour; of all others only what a scheme needs as context is looked at
ColoredAtoms colorAtoms(const ResidueFacts& facts, std::span<const std::uint32_t> atoms, const Coloring& coloring);

}  // namespace nacre
