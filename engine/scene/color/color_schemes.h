#pragma once
// Colour schemes: a colour per atom, and the legend.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/residue_facts.h"
#include "engine/scene/color/palettes.h"

namespace nacre {

enum class ColorScheme {
    element,
    chain,
    chainCarbons,        ///< carbons by chain, the rest by element
    input,               ///< by molecule, if a picture has several
    copy,                ///< of an assembly
    copyChain,           ///< of an assembly, chains as tints
    copyEntity,          ///< of an assembly, entities as tints
    residue,             ///< residueColor() of colors.h
    hydrophobicity,      ///< of amino acids, J. Kyte and R. F. Doolittle, J. Mol. Biol. 157 (1982) 105
    charge,              ///< of residues at pH 7, formal charges elsewhere
    secondaryStructure,  ///< from the file, else from hydrogen bonds
    bFactor,             ///< from the 2nd to the 98th percentile of the coloured atoms
    plddt,               ///< B factor as AlphaFold's confidence, in its four bands and colours
    rainbow,             ///< along each chain, from N to C or 5' to 3'
    occupancy,           ///< 0 to 1
    rmsd,                ///< distance of residues from their counterparts in another INPUT (residue_distances.h)
    distance,            ///< from the centre of the coloured atoms, or of an assembly of 12 copies or more, Å
    entity,              ///< the file's entities; else chains of equal sequence, and residues of equal name
    uniform,             ///< one colour
    table,               ///< of the atoms that a table names (color_table.h); has no name
};

/// Kind of palette that a scheme uses.
enum class PaletteUse : std::uint8_t { none, kinds, ramp };
PaletteUse paletteUse(ColorScheme scheme);
/// Whether the range of the scheme's ramp can be set.
bool takesRange(ColorScheme scheme);

/// The scheme's name for `--color` ("b-factor"); empty for uniform.
std::string_view colorSchemeName(ColorScheme scheme);
/// The scheme of a name; also knows "ss", "bfactor", "b", "residue-type" and "secondary-structure".
std::optional<ColorScheme> colorSchemeFromName(std::string_view name);

/// Values at the ends of a ramp; the first may be larger.
struct ColorRange {
    double first = 0, last = 1;
    friend bool operator==(const ColorRange&, const ColorRange&) = default;
};

struct ColorTable;

/// A scheme, one colour, or a table.
struct Coloring {
    ColorScheme scheme = ColorScheme::element;
    std::uint32_t color = 0;  ///< packed as in colors.h; for uniform, and for element's carbons (0: the usual one)
    AnyPalette palette = {};
    std::optional<ColorRange> range = {};          ///< of a ramp; empty: automatic
    std::shared_ptr<const ColorTable> table = {};  ///< null: no atom
    std::string source = {};                       ///< where a frontend reads the table from
    std::string column = {};                       ///< column of its values; empty: the only one

    Coloring() = default;
    Coloring(ColorScheme wanted) : scheme(wanted) {}
    static Coloring uniform(std::uint32_t color) {
        Coloring coloring(ColorScheme::uniform);
        coloring.color = color;
        return coloring;
    }
    /// Carbons in one colour and the rest by element, to tell ligands apart.
    static Coloring elementWithCarbons(std::uint32_t color) {
        Coloring coloring(ColorScheme::element);
        coloring.color = color;
        return coloring;
    }
    friend bool operator==(const Coloring&, const Coloring&) = default;
};

/// The text for `--color`: "chain", "#rrggbb", "element:#rrggbb", "b-factor:10..60:viridis".
std::string coloringText(const Coloring& coloring);

struct LegendEntry {
    std::string label;
    std::uint32_t color = 0;
};

struct ColoredAtoms {
    std::vector<std::uint32_t> colors;  ///< same length as the atoms
    std::vector<LegendEntry> legend;    ///< classes that occur, or five values along the palette
    AnyPalette ramp = {};               ///< palette of the first `stops` entries
    std::size_t stops = 0;              ///< entries along the ramp, end to end; classes follow
    std::vector<std::uint32_t> tints;   ///< tint of the copy's colour, per atom; empty: not coloured by copy
    std::string warning;                ///< why the colours are of little use here; empty: they are useful
};

/// @param atoms  indices of the atoms to colour; others only provide context
ColoredAtoms colorAtoms(const ResidueFacts& facts, std::span<const std::uint32_t> atoms, const Coloring& coloring);

}  // namespace nacre
