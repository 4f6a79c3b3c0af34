#pragma once
// Selections of atoms, in the words of PyMOL. The grammar:
//
//   selection     alternatives, optionally followed by `within N of T`: all of their atoms near T, as in PyMOL
//   alternatives  several `or` several ...  (also |)
//   several       term `and` term ...       (also &)
//   term          not T (also ! ~), byres T, bychain T, bymolecule T, neighbor T, within N of T, around N of T,
//                 or one of these: ( selection ), a test; followed by any of: around N, expand N, extend N (bonds),
//                 and as in ChimeraX :<N (whole residues), @<N, :>N, @>N
//   test          chain A+B   segi PROA   resn HEM+ATP   resi 10-20+35   name CA+CB   elem FE   altloc A   model 1
//                 ss helix+strand+loop   sequence GLN?A   b > 50   occupancy < 1   (also <= >= = !=)
//                 id 78+92-95   (1-based positions among the atom records of the file's drawn model)
//                 all none protein nucleic polymer ligand water ion backbone sidechain hydrogens hetatm helix strand
//                 loop   /A:10-20@CA   (ChimeraX: chains, numbers or names of residues, names of atoms, #1: model)
//
// `within`, `expand` and `<` include their reference, `around` excludes it. `bymolecule` is all that bonds connect;
// `segi` is the file's segment, or mmCIF's label_asym_id; `entity` is mmCIF's identifier or the name in a packed
// scene. After `and`, `or` and `not`, the reference of a following
// `around`, `expand`, `extend` or zone needs parentheses. `not`, `byres` and `within N of` apply to the next term. If
// that has no parentheses and an operator follows, `byres` and `within` are refused as ambiguous: PyMOL would include
// the operator. Lists use + or commas; values may be quoted, '' is the empty one; * matches any characters. Case
// matters in names of chains and segments only. A residue number may be negative (also written \-5), and may have an
// insertion code (82A), which it then must match; as the end of a range it includes all codes: 80-82 includes 82A.
// Distances are at most N Å. `ss` is the protein's secondary structure. `sequence` finds consecutive residues by
// one-letter codes, ? for any. PyMOL's short forms (c. r. i. n. e. h. br. w. ...) work as well.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// A step of a selection: a test pushes a set of atoms, an operation pops one or two sets and pushes its result.
enum class SelectionTest : std::uint8_t {
    all,
    none,
    protein,
    nucleic,
    polymer,
    ligand,
    water,
    ion,
    backbone,
    sidechain,
    hydrogen,
    hetatm,
    chain,
    segment,
    entity,
    residueName,
    residueNumber,
    atomName,
    element,
    alternate,
    model,
    atomNumber,
    secondary,
    sequence,
    temperatureFactor,
    occupancy,
    within,
    around,
    expand,  ///< like within, after its operand
    extend,  ///< by bonds; `distance` is their number
    byResidue,
    byChain,
    byMolecule,
    neighbor,
    negation,
    conjunction,
    disjunction
};

/// Numbers first..last. Insertion codes count at the ends only: from firstCode, and up to lastCode.
struct NumberRange {
    std::int32_t first = 0, last = 0;
    char firstCode = '\0', lastCode = '\0';
    friend bool operator==(const NumberRange&, const NumberRange&) = default;
};

/// A bit mask: 1 less, 2 equal, 4 greater.
enum class Comparison : std::uint8_t {
    less = 1,
    equal = 2,
    lessOrEqual = 3,
    greater = 4,
    notEqual = 5,
    greaterOrEqual = 6
};

struct SelectionStep {
    SelectionTest test = SelectionTest::all;
    /// Values of chain, segment, entity, residueName, atomName, element, alternate, sequence; for secondary "HELIX",
    /// "STRAND", "LOOP".
    std::vector<std::string> words;
    std::vector<NumberRange> numbers;           ///< for residueNumber, model and atomNumber
    double distance = 0;                        ///< for within, around, expand (Å) and extend
    Comparison comparison = Comparison::equal;  ///< for temperatureFactor and occupancy, with `value`
    double value = 0;
    friend bool operator==(const SelectionStep&, const SelectionStep&) = default;
};

/// A plain value: steps in postfix order. The parser limits the stack's depth.
struct Selection {
    std::string text;  ///< as written, for messages and legends
    std::vector<SelectionStep> steps;
    friend bool operator==(const Selection&, const Selection&) = default;
};

/// @throws Error with the column (from 1), what was expected there, and what was found
Selection parseSelection(std::string_view text);

/// One value per atom. The selection must come from parseSelection().
std::vector<bool> selectAtoms(const ResidueFacts& facts, const Selection& selection);

}  // namespace nacre
