#pragma once
// The style of pictures that set none.

#include <cstdint>
#include <span>

#include "app/picture/description.h"
#include "engine/molecule/residue_facts.h"

namespace nacre::app {

/// Proteins from this many amino acids on are cartoons: shorter peptides show their atoms.
constexpr std::size_t kFewestOfCartoon = 10;

/// Sets the style of a look without one, where it differs from defaultStyle(). Proteins are cartoons with their
/// ligands, coloured by chain, or by confidence for predictions, unless the picture sets a colour. Residues around
/// interactions are sticks as well. With maps, only predictions are cartoons. Scene files have their own styles, packed
/// scenes are spheres.
/// @param drawn  indices of drawn atoms, ascending
/// @param look  of the picture, changed
void takeDefaultLook(const ResidueFacts& facts, std::span<const std::uint32_t> drawn, const PictureDescription& picture,
                     RepresentationOptions& look);

}  // namespace nacre::app
