#pragma once

#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Atoms at most `distance` (Å) from any marked atom, marked ones included. By a tree of boxes: n log n in the number
/// of atoms, for any distance and distribution.
/// @param marked  one value per atom
std::vector<bool> atomsNear(const Molecule& molecule, const std::vector<bool>& marked, double distance);

}  // namespace nacre
