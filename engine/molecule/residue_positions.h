#pragma once
// Which records are one residue of a chain.

#include <cstdint>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// The first residue record of the position (chain, number, insertion code) of each: where residues alternate, several
/// stand in a row.
std::vector<std::uint32_t> residuePositions(const Molecule& molecule);

}  // namespace nacre
