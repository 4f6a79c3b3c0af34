#pragma once
// The colour schemes that sort atoms into kinds. Internal to color_schemes.cpp.

#include "engine/scene/color_schemes.h"

namespace nacre {

/// Of each chain, as legends have it. @param before  of its name
std::vector<std::string> chainLabels(const ResidueFacts& facts, const std::string& before);

/// colorAtoms() for element, chain, input, residue, hydrophobicity, charge, secondaryStructure, plddt and entity.
ColoredAtoms colorByClass(const ResidueFacts& facts, std::span<const std::uint32_t> atoms, const Coloring& coloring);

}  // namespace nacre
