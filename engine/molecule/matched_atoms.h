#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// Atoms of one selection and their counterparts in another, in pairs.
struct AtomPairs {
    std::vector<std::uint32_t> first, second;                     ///< same length
    std::size_t residues = 0;                                     ///< of the shorter side of each pair of chains
    std::size_t sameResidues = 0;                                 ///< residue pairs with equal names
    std::vector<std::pair<std::uint32_t, std::uint32_t>> chains;  ///< pairs of chains, if both are polymers
};

/// Whether the first selection is to be moved onto the second, or is already in place.
enum class Placing : std::uint8_t { free, settled };

/// If both selections have atoms of proteins or nucleic acids, pairs only those, chain by chain. The chains with the
/// best-scoring sequences are the first pair; among equals, the pair whose superposition brings most residues together
/// (then the lowest RMSD). Other chains are paired if at least 30 % of the shorter one's residues are equal (more, up
/// to 80 %, below 57 residues: C. Sander and R. Schneider, Proteins 9 (1991) 56), and if that superposition brings them
/// to within 8 Å RMSD, nearest first. Settled molecules stay as they are, and the nearest similar chains are paired.
///
/// Pairs residues by global sequence alignment (O. Gotoh, J. Mol. Biol. 162 (1982) 705): amino acids score by BLOSUM62
/// (S. Henikoff and J. G. Henikoff, PNAS 89 (1992) 10915), modified ones as their parents; other residues score 5 for
/// equal names and -4 for different ones. The first residue of a gap costs 11, each further one 1, end gaps nothing.
/// Within a residue pair, atoms of the same name are paired: those of the drawn conformer, if the selection has any of
/// it. Ignores waters.
/// @param first, second  one value per atom
/// @throws Error if a selection has more than 20,000 residues
AtomPairs matchAtoms(const ResidueFacts& facts, const std::vector<bool>& first, const std::vector<bool>& second,
                     Placing placing = Placing::free);

}  // namespace nacre
