#pragma once

#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// Distance of each residue from its counterpart in another INPUT, in their current positions, Å: between alpha
/// carbons, or C4' of nucleotides, else the RMS distance of the paired atoms. Residues of further INPUTs are compared
/// with the first INPUT, those of the first with the next one that has a counterpart. NaN for the others.
std::vector<double> residueDistances(const ResidueFacts& facts);

}  // namespace nacre
