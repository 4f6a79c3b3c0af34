#pragma once
// Shared by readers of topologies: atoms with masses, types and charges.

#include <optional>
#include <utility>

#include "engine/molecule/element.h"
#include "engine/molecule/formats/molecule_builder.h"
#include "engine/molecule/formats/pdb_fields.h"

namespace nacre {

/// Properties of an atom in a topology.
struct TopologyAtom {
    std::string_view type;
    double charge = 0;                ///< elementary charges
    std::optional<double> mass = {};  ///< u; 0: a virtual site
};

/// Element by mass, else by name; both are guesses. 0 for a virtual site.
Element elementOfTopology(MoleculeBuilder& builder, const TopologyAtom& stated, std::string_view name,
                          std::string_view residue);

/// Number and insertion code of a residue: "163A".
std::pair<std::int32_t, char> residueNumber(std::string_view text);

/// Stores type, charge and mass of the most recently added atom.
void keepTopology(MoleculeBuilder& builder, const TopologyAtom& stated);

/// The molecule of a topology, whose atoms have no positions yet.
Molecule withoutPositions(MoleculeBuilder& builder, const char* format);

}  // namespace nacre
