#pragma once

#include <cstdint>
#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// Atoms of one selection and their counterparts in another, in pairs.
struct AtomPairs {
    std::vector<std::uint32_t> first, second;  ///< of one length
    std::size_t residues = 0;                  ///< of the selection with fewer
    std::size_t sameResidues = 0;              ///< pairs of residues that have one name
};

/// Residues are paired by aligning their sequences from end to end (O. Gotoh, J. Mol. Biol. 162 (1982) 705): amino
/// acids score by BLOSUM62 (S. Henikoff and J. G. Henikoff, PNAS 89 (1992) 10915), modified ones as their parents;
/// other residues 5 for the same name and -4 for another. The first residue of a gap costs 11, each further one 1, gaps
/// at the ends nothing. In each pair of residues the atoms of one name are paired: those of the conformer that is
/// drawn, if the selection holds any of it. Waters are left out.
/// @param first, second  one value per atom
/// @throws Error if a selection has more than 20,000 residues
AtomPairs matchAtoms(const ResidueFacts& facts, const std::vector<bool>& first, const std::vector<bool>& second);

}  // namespace nacre
