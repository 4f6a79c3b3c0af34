#pragma once

#include <cstdint>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

struct DrawnAtomsOptions {
    bool water = false;
    bool hydrogens = true;
    friend bool operator==(const DrawnAtomsOptions&, const DrawnAtomsOptions&) = default;
};

/// Whether a residue of this name is water: HOH WAT H2O DOD SOL TIP TIP3 TIP4 SPC.
bool isWater(const Name& residueName);

/// Indices of the drawn atoms, ascending. Waters and hydrogens by option; at each residue position (chain, number,
/// insertion code) one conformer: atoms without alternate location, and those of the location with the highest mean
/// occupancy (first in the file if equal).
std::vector<std::uint32_t> drawnAtoms(const Molecule& molecule, const DrawnAtomsOptions& options = {});

}  // namespace nacre
