#pragma once
// The colour schemes that sort atoms into kinds. Internal to color_schemes.cpp.

#include "engine/scene/color_schemes.h"

namespace nacre {

/// colorAtoms() for element, chain, residue, hydrophobicity, charge, secondaryStructure, plddt and entity.
ColoredAtoms colorByClass(const ResidueFacts& facts, std::span<const std::uint32_t> atoms, const Coloring& coloring);

}  // namespace nacre
