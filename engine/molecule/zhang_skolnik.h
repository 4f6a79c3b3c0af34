#pragma once
// Helices and strands of chains of which only alpha carbons are known: Y. Zhang and J. Skolnik, Nucleic Acids Research
// 33, 2302 (2005).

#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// Helices and strands by the distances between five alpha carbons in a row, of each residue; whatever the file states
/// is left out of account. Those of four residues and more are kept of helices, of three of strands. Only chains in
/// which no residue has both N and O beside CA are looked at: of others kabschSander() knows more. Linear time.
std::vector<SecondaryStructure> zhangSkolnik(const ResidueFacts& facts);

}  // namespace nacre
