#pragma once
// Colour schemes that sort atoms into classes. Internal to color_schemes.cpp.

#include "engine/scene/color/color_schemes.h"

namespace nacre {

/// Legend labels of the chains. @param before  prefix of each name
std::vector<std::string> chainLabels(const ResidueFacts& facts, const std::string& before);

/// Legend label of residues without hydropathy.
inline constexpr std::string_view kNoAminoAcid = "not an amino acid";

/// colorAtoms() for element, chain, input, residue, hydrophobicity, charge, secondaryStructure, plddt and entity.
ColoredAtoms colorByClass(const ResidueFacts& facts, std::span<const std::uint32_t> atoms, const Coloring& coloring);

}  // namespace nacre
