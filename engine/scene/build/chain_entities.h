#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// Chemically identical molecules form one entity.
struct ResidueEntities {
    std::vector<std::string> labels;       ///< "1" or a name from the file; else "chains A, C", "HEM", "water"
    std::vector<std::uint32_t> ofResidue;  ///< index into labels
};

/// The file's entities. Without them: chains whose polymers have the same residue sequence (as far as modelled), and
/// other residues by name.
ResidueEntities residueEntities(const ResidueFacts& facts);

}  // namespace nacre
