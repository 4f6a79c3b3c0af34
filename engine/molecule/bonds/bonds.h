#pragma once

#include "engine/molecule/molecule.h"

namespace nacre {

/// Completes Molecule::bonds. What the file stated (already there) stays; residue templates of amino acids and
/// nucleotides come next; pairs farther than 0.4 Å and nearer than the sum of covalent radii + 0.45 Å fill in the
/// rest. Never between alternate locations that exclude each other, never H-H by distance, no pair twice, a < b,
/// sorted. Linear time by a grid.
void perceiveBonds(Molecule& molecule);

/// Sorts, drops what is no pair of two different atoms, and joins repeated pairs: what the file stated comes first and
/// keeps its source, while a higher order than 1 is taken from whoever knows it (CONECT mostly knows none).
void mergeBonds(std::vector<Bond>& bonds, std::size_t atoms);

}  // namespace nacre
