#pragma once
// Bonds of polymer residues and of haem, by atom name.

#include <cstdint>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

struct ResidueTemplate {
    struct Bond {
        std::uint8_t a;  ///< index into atoms
        std::uint8_t b;
        std::uint8_t order;  ///< aromatic rings as one Kekulé structure
    };
    std::vector<Name> atoms;  ///< heavy atoms, wwPDB version 3 names; at most kMaxTemplateAtoms
    std::vector<Bond> bonds;
    bool polymer = true;
};

constexpr std::size_t kMaxTemplateAtoms = 48;

/// Template of a residue: the 20 amino acids (also under common names of protonation states and chain ends), MSE, SEC,
/// PYL, and the nucleotides A C G U I, DA DC DG DT DU DI, T. Null for any other.
const ResidueTemplate* residueTemplate(const Name& residueName);
/// As above, also of haem (HEM).
const ResidueTemplate* bondTemplate(const Name& residueName);

/// Three-letter name of an amino acid that has four letters in AMBER, PDB2PQR and GROMOS, for its place or protonation
/// ("NALA", "HISE", "LYSH"); other names stay.
Name threeLetterName(const Name& residueName);

/// wwPDB version 3 name of an atom with an older name ("O5*", "O1P", "C5M"); other names stay.
Name currentAtomName(const Name& name);

}  // namespace nacre
