#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// Molecules that are the same chemically count as one entity.
struct ResidueEntities {
    std::vector<std::string> labels;       ///< "1" as the file names it; else "chains A, C", "HEM", "water"
    std::vector<std::uint32_t> ofResidue;  ///< index into labels
};

/// Entities as the file states them; where it does not, chains whose polymers have the same sequence of residues
/// (as far as it has coordinates), and other residues by name.
ResidueEntities residueEntities(const ResidueFacts& facts);

}  // namespace nacre
