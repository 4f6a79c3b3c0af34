#pragma once

#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Which atoms lie at most `distance` (Å) from any of the marked ones; the marked ones do. By a tree of boxes: n log n
/// in the number of atoms, whatever the distance and however the atoms are spread.
/// @param marked  one value per atom
std::vector<bool> atomsNear(const Molecule& molecule, const std::vector<bool>& marked, double distance);

}  // namespace nacre
