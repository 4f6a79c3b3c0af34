#pragma once
// A molecule beside an image of itself: everything twice, what is of the image after what is not. Internal to this
// folder.

#include <glm/mat4x3.hpp>

#include "engine/molecule/chemistry/features.h"

namespace nacre {

/// Atoms, residues and chains alone: what a search for interactions reads.
Molecule withImage(const Molecule& molecule, const glm::dmat4x3& image);
Chemistry withImage(const Chemistry& chemistry);
/// @param chemistry  of the molecule alone
Features withImage(const Features& features, const Chemistry& chemistry);

}  // namespace nacre
