#pragma once
// Contents of a molecule, and of each chain as far as it is modelled: the polymer's sequence, ligands, ions, water.

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/molecule/molecule.h"
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

/// Contents of one molecule, counted over all its atom records.
struct MoleculeCounts {
    std::size_t atoms = 0;
    std::size_t hetatm = 0;
    std::size_t altlocAtoms = 0;          ///< atoms with an alternate location
    std::size_t insertionCodeAtoms = 0;   ///< atoms of residues with an insertion code
    std::size_t negativeResnumAtoms = 0;  ///< atoms of residues with a negative number
    std::size_t bondsFromFile = 0, bondsFromTemplates = 0, bondsByDistance = 0;
    std::optional<std::array<glm::vec3, 2>> bbox;  ///< lowest and highest coordinates, Å; empty without atoms
};

MoleculeCounts countMolecule(const Molecule& molecule);

}  // namespace nacre
