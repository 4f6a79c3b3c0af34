#pragma once

#include <cstdint>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Atoms of one selection and their counterparts in another, in pairs.
struct AtomPairs {
    std::vector<std::uint32_t> first, second;  ///< of one length
    std::size_t residues = 0;                  ///< of the selection with fewer
    std::size_t sameResidues = 0;              ///< pairs of residues that have one name
};

/// Residues are paired by aligning the sequences of their names (Needleman and Wunsch, gemmi's; a match counts 1,
/// another residue or a gap -1), and in each pair the atoms of one name. Atoms that occur twice, as other conformers
/// do, count once, waters not at all.
/// @param first, second  one value an atom
/// @throws Error if a selection has more than 20,000 residues, or names of too many kinds
AtomPairs matchAtoms(const Molecule& molecule, const std::vector<bool>& first, const std::vector<bool>& second);

}  // namespace nacre
