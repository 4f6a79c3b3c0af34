#pragma once
// Contents of each chain, as far as it has coordinates: the polymer's sequence, ligands, ions, water.

#include <map>
#include <string>
#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

struct ChainSummary {
    std::string name;
    std::string sequence;                         ///< one letter per residue; modified residues as their parent, else X
    std::size_t aminoAcids = 0, nucleotides = 0;  ///< their sum is the sequence's length
    std::size_t waters = 0;
    std::map<std::string, std::size_t> ligands;  ///< residues by name
    std::map<std::string, std::size_t> ions;
};

/// One per chain of Molecule::chains, in order. Alternative residues at one position count once, as the first.
std::vector<ChainSummary> summariseChains(const ResidueFacts& facts);

}  // namespace nacre
