#pragma once
// Bonds of the residues that polymers are made of, by atom name.

#include <cstdint>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

struct ResidueTemplate {
    struct Bond {
        std::uint8_t a;  ///< index into atoms
        std::uint8_t b;
        std::uint8_t order;  ///< aromatic rings in one Kekulé structure
    };
    std::vector<Name> atoms;  ///< heavy atoms, wwPDB version 3 names; at most kMaxTemplateAtoms
    std::vector<Bond> bonds;
};

constexpr std::size_t kMaxTemplateAtoms = 32;

/// Template of a residue by its name: the 20 amino acids (also under the usual names of their protonation states),
/// MSE, SEC, PYL, and the nucleotides A C G U I, DA DC DG DT DU DI, T. Null for any other.
const ResidueTemplate* residueTemplate(const Name& residueName);

/// wwPDB version 3 name of an atom named by an older convention ("O5*", "O1P", "C5M"); others stay as they are.
Name currentAtomName(const Name& name);

}  // namespace nacre
