#pragma once
// Helices and strands from coordinates: W. Kabsch and C. Sander, Biopolymers 22, 2577 (1983).

#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// Secondary structure per residue. A chain for which the file states some keeps that; any other gets kabschSander(),
/// or zhangSkolnik() if it has only alpha carbons.
std::vector<SecondaryStructure> secondaryStructure(const ResidueFacts& facts);

/// Helices and strands from hydrogen bonds between peptide groups, per residue; ignores the file's own. `helix` is any
/// of alpha, 3-10 and pi; `strand` any residue of a ladder or a bridge. A residue needs N, CA, C and O in the drawn
/// conformer; hydrogens are placed 1 Å from N. Chains break where C and the next N are over 2.5 Å apart. Models are
/// treated separately. Time is linear in the number of residues; a residue with over 400 others within 9 Å (overlapping
/// atoms) has no structure.
std::vector<SecondaryStructure> kabschSander(const ResidueFacts& facts);

}  // namespace nacre
