#pragma once

#include "engine/molecule/molecule.h"

namespace nacre {

/// Finds coarse grains by the names of atoms and residues: Martini's proteins, lipids, sterols and waters, and models
/// of one grain per amino acid. They get a radius instead of an element, and the bonds of Martini's topologies (source:
/// residueTemplate); Martini's waters become waters. Ions keep their elements.
void findCoarseGrains(Molecule& molecule);

}  // namespace nacre
