#pragma once
// What stands in each chain, as far as it has coordinates: the polymer's sequence, ligands, ions, water.

#include <map>
#include <string>
#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

struct ChainSummary {
    std::string name;
    std::string sequence;                         ///< one letter a residue; a modified one as its parent, else X
    std::size_t aminoAcids = 0, nucleotides = 0;  ///< together the sequence's length
    std::size_t waters = 0;
    std::map<std::string, std::size_t> ligands;  ///< residues by name
    std::map<std::string, std::size_t> ions;
};

/// One for each of Molecule::chains, in their order. A position where residues alternate counts once, with its first.
std::vector<ChainSummary> summariseChains(const ResidueFacts& facts);

}  // namespace nacre
