#pragma once
// Helices and strands from coordinates: W. Kabsch and C. Sander, Biopolymers 22, 2577 (1983).

#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// What each residue's place in the fold is: as the file states it or, if it states nothing, by kabschSander(), and by
/// zhangSkolnik() in chains of alpha carbons.
std::vector<SecondaryStructure> secondaryStructure(const ResidueFacts& facts);

/// Helices and strands by the pattern of hydrogen bonds between peptide groups, of each residue; whatever the file
/// states is left out of account. `helix` is any of alpha, 3-10 and pi; `strand` any residue of a ladder or a bridge.
/// A residue needs N, CA, C and O, in the conformer that is drawn; hydrogens are put where they must be, 1 Å from N.
/// Chains break where C and the next N are over 2.5 Å apart. Of several models each stands for itself. Time grows with
/// the number of residues; where over 400 lie within 9 Å of one (atoms upon one another), that one has no structure.
std::vector<SecondaryStructure> kabschSander(const ResidueFacts& facts);

}  // namespace nacre
