#pragma once
// Which atoms of a molecule are meant, in words that users of PyMOL know. The grammar:
//
//   selection  alternatives, perhaps followed by `within N of T`: those of all that are near T, as in PyMOL
//   alternatives  several `or` several ...  (also |)
//   several       term `and` term ...       (also &)
//   term       not T (also !), byres T, within N of T, around N of T, ( selection ), or a test
//   test       chain A+B   resn HEM+ATP   resi 10-20+35   name CA+CB   elem FE   altloc A   model 1
//              ss helix+strand+loop   sequence GLN?A   b > 50   occupancy < 1   (also <= >= = !=)
//              id 78+92-95   (positions of atoms among all records of the file's drawn model, from 1, as a click says
//              them) all none protein nucleic polymer ligand water ion backbone sidechain hydrogens hetatm helix strand
//              loop /A:10-20@CA, as ChimeraX has it: chains, numbers or names of residues, names of atoms, #1 for a
//              model
//
// `not`, `byres` and `within N of` apply to the one term that follows. Where that term stands without parentheses
// and an operator follows, `byres` and `within` are refused as ambiguous, for PyMOL would read on.
// Lists take + or commas; values may stand in quotes, '' is the empty one; * in a value stands for any characters.
// Key words and values are the same in capitals and small letters, except for chain names: as in PyMOL.
// A number of a residue may be negative (also written \-5), and may end in an insertion code (82A). Alone, it means
// that code and no other; as the end of a range it means all codes: 80-82 holds 82A.
// `within` means at most N Å, and includes what it is measured from; `around` leaves that out. `ss` is what the file
// says of proteins. `sequence` finds residues of a polymer in a row by their one-letter codes, ? for any. PyMOL's short
// forms (c. r. i. n. e. h. br. w. ...) are known too.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// A step of a selection: a test pushes a set of atoms, an operation takes one set or two and pushes its result.
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
    byResidue,
    negation,
    conjunction,
    disjunction
};

/// Numbers first..last; of the numbers at the ends only the insertion codes from firstCode and up to lastCode.
struct NumberRange {
    std::int32_t first = 0, last = 0;
    char firstCode = '\0', lastCode = '\0';
    friend bool operator==(const NumberRange&, const NumberRange&) = default;
};

/// What may hold: 1 less, 2 equal, 4 greater.
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
    /// Values of chain, residueName, atomName, element, alternate, sequence; of secondary "HELIX", "STRAND", "LOOP".
    std::vector<std::string> words;
    std::vector<NumberRange> numbers;           ///< of residueNumber, model and atomNumber
    double distance = 0;                        ///< of within and around, Å
    Comparison comparison = Comparison::equal;  ///< of temperatureFactor and occupancy, with `value`
    double value = 0;
    friend bool operator==(const SelectionStep&, const SelectionStep&) = default;
};

/// A plain value: steps in postfix order, in which the depth of the stack is bounded by the parser.
struct Selection {
    std::string text;  ///< as it was written, for messages and legends
    std::vector<SelectionStep> steps;
    friend bool operator==(const Selection&, const Selection&) = default;
};

/// @throws Error with the column (counted from 1), what was expected there, and what was found
Selection parseSelection(std::string_view text);

/// One value per atom. The selection must come from parseSelection().
std::vector<bool> selectAtoms(const ResidueFacts& facts, const Selection& selection);

}  // namespace nacre
