#pragma once
// Whether atoms that a file calls bonded can be bonded. Some files apply the CONECT records of one model to another, or
// state links to a crystal copy without naming the copy.

#include <cstdint>

#include "engine/molecule/molecule.h"

namespace nacre {

/// False for atoms farther apart than any bond. Coarse grains, which have no neighbours at atomic distances, may be 12
/// Å apart, or as far as the caller knows of others.
/// @param farthest  of other grains, Å
bool mayBeBonded(const Molecule& molecule, std::uint32_t a, std::uint32_t b, float farthest = 0);

}  // namespace nacre
