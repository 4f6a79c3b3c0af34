#pragma once
// What stands in each chain, as far as it has coordinates: the polymer's sequence, ligands, ions, water.

#include <map>
#include <string>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

struct ChainSummary {
    std::string name;
    std::string sequence;                         ///< one letter a residue; a modified one as its parent, else X
    std::size_t aminoAcids = 0, nucleotides = 0;  ///< together the sequence's length
    std::size_t waters = 0;
    std::map<std::string, std::size_t> ligands;  ///< residues by name
    std::map<std::string, std::size_t> ions;
};

/// One for each of Molecule::chains, in their order. What a residue is goes by its name (gemmi's table, and the names
/// of protonation states); one that no table knows counts as part of a polymer if it has a polymer's backbone and is no
/// HETATM, and one atom alone is an ion: bonds, which residue_kind.h asks, need not be known. A position where residues
/// alternate counts once, with its first.
std::vector<ChainSummary> summariseChains(const Molecule& molecule);

}  // namespace nacre
