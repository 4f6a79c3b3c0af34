#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Contents of one molecule, counted over all its atom records.
struct MoleculeCounts {
    std::size_t atoms = 0;
    std::size_t hetatm = 0;
    std::size_t altlocAtoms = 0;          ///< atoms with an alternate location
    std::size_t insertionCodeAtoms = 0;   ///< atoms of residues with an insertion code
    std::size_t negativeResnumAtoms = 0;  ///< atoms of residues with a negative number
    std::size_t bondsFromFile = 0, bondsFromTemplates = 0, bondsByDistance = 0;
    std::optional<std::array<glm::vec3, 2>> bbox;  ///< lowest and highest coordinates, Å; empty without atoms
};

MoleculeCounts countMolecule(const Molecule& molecule);

}  // namespace nacre
