#pragma once
// Which atoms belong together where lines are drawn between groups: chain by chain, and along a chain.

#include <cstdint>
#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// As shaders have them (shaders/common/layout.h): bits of a residue in an atom's word, and how many residues apart in
/// its chain another group begins.
constexpr int kResidueBits = 12, kGroupResidues = 6;

/// A word for each atom: in the lowest bits where its residue stands in its
/// chain, above them its chain. A ligand, an ion or a water is far from every residue of the chain that it is listed
/// in.
std::vector<std::uint32_t> atomGroups(const ResidueFacts& facts);

}  // namespace nacre
