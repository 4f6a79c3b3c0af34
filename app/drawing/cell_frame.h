#pragma once
// The unit cell of a crystal, or the periodic box of a simulation, as lines around the molecule.

#include "engine/molecule/molecule.h"
#include "engine/scene/build/primitives.h"

namespace nacre::app {

/// Twelve edges: those along a, b and c from the cell's corner are red, green and blue, with names at their ends. A
/// crystal's cell is the one that contains the middle of the atoms, as with --assembly unit-cell. Empty if the file
/// states neither.
Primitives cellFrame(const Molecule& molecule);

}  // namespace nacre::app
