#pragma once
// Roles of small molecules in a structure.

#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// The residue that "the ligand" means: the largest ligand, the first among equals. Sugars of glycans, buffers and
/// cryoprotectants only if there is no other. Empty: there is no ligand.
std::optional<std::uint32_t> findMainLigand(const ResidueFacts& facts);

/// Whether a residue of this name is a lipid of membranes, as force fields and the PDB name them.
bool isLipid(std::string_view name);

}  // namespace nacre
