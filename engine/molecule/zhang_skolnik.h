#pragma once
// Helices and strands of chains with alpha carbons only: Y. Zhang and J. Skolnik, Nucleic Acids Research 33, 2302
// (2005).

#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// Helices and strands from the distances between five consecutive alpha carbons, per residue; ignores the file's own.
/// Keeps helices of four or more residues and strands of three or more. Skips chains in which any residue also has both
/// N and O: kabschSander() is better there. Linear time.
std::vector<SecondaryStructure> zhangSkolnik(const ResidueFacts& facts);

}  // namespace nacre
