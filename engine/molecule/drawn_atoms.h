#pragma once

#include <cstdint>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// The alternate locations that are drawn.
struct Altlocs {
    enum class Mode : std::uint8_t {
        chosen,  ///< the one with the highest mean occupancy, the first in the file if equal
        all,
        letter  ///< a given letter; in residues that lack it, the chosen one
    };
    Mode mode = Mode::chosen;
    char letter = '\0';
    friend bool operator==(const Altlocs&, const Altlocs&) = default;
};

struct DrawnAtomsOptions {
    bool water = false;
    bool hydrogens = true;
    Altlocs altlocs = {};
    friend bool operator==(const DrawnAtomsOptions&, const DrawnAtomsOptions&) = default;
};

/// Whether a residue of this name is water: HOH WAT H2O DOD SOL TIP TIP3 TIP4 SPC.
bool isWater(const Name& residueName);
/// By name, or by its kind: mmCIF's entities, and Martini's beads.
inline bool isWater(const Residue& residue) { return residue.entityKind == EntityKind::water || isWater(residue.name); }

/// Whether an atom is a dummy, a marker without an element: X, Xx, Du, LP.
bool isDummy(const Atom& atom);

/// Indices of the drawn atoms, ascending, without dummies. Waters, hydrogens and alternate locations by option; atoms
/// without alternate location are in every conformer. Conformers are chosen by residue position (chain, number,
/// insertion code).
std::vector<std::uint32_t> drawnAtoms(const Molecule& molecule, const DrawnAtomsOptions& options = {});

/// The drawn conformer, and one for each letter of alternate locations missing in it: together they contain all atoms.
std::vector<std::vector<std::uint32_t>> conformers(const Molecule& molecule, const DrawnAtomsOptions& options);

}  // namespace nacre
