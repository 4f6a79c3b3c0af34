#pragma once
// Groups of atoms between which outlines are drawn: by chain, and along a chain.

#include <cstdint>
#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// As in shaders (shaders/common/layout.h): bits for a residue in an atom's word, and the distance in residues along a
/// chain from which another group begins.
constexpr int kResidueBits = 12, kGroupResidues = 6;

/// One word per atom: the residue's index in its chain in the low bits, the chain above. A ligand, ion or water is far
/// from every residue of the chain that lists it.
std::vector<std::uint32_t> atomGroups(const ResidueFacts& facts);

}  // namespace nacre
