#pragma once

#include "engine/molecule/molecule.h"

namespace nacre {

/// Completes Molecule::bonds. Bonds from the file stay; residue templates of amino acids and nucleotides come next; the
/// others are pairs farther apart than 0.7 times the sum of their covalent radii (0.6 with hydrogens and metals) and
/// closer than the sum + 0.45 Å. Never between coarse grains, nor between alternate locations that exclude each other,
/// never H-H by distance, no pair twice, a < b, sorted. Linear time by a grid.
void perceiveBonds(Molecule& molecule);

/// Sorts, drops invalid pairs, and merges repeated ones: a bond from the file has precedence and keeps its source, but
/// takes an order above 1 from any other (CONECT rarely states orders).
void mergeBonds(std::vector<Bond>& bonds, std::size_t atoms);

}  // namespace nacre
