#pragma once
// Shared by readers of topologies: atoms with masses, types and charges.

#include "engine/molecule/element.h"
#include "engine/molecule/formats/molecule_builder.h"
#include "engine/molecule/formats/pdb_fields.h"

namespace nacre {

/// What a topology states of an atom beside its names.
struct TopologyAtom {
    std::string_view type;
    double charge = 0;  ///< elementary charges
    double mass = 0;    ///< u; 0: a virtual site
};

/// Element by mass, or else by name; both are guesses. Of a virtual site: none.
Element elementOfTopology(MoleculeBuilder& builder, const TopologyAtom& stated, std::string_view name,
                          std::string_view residue);

/// Keeps what it states of the atom that was added last.
void keepTopology(MoleculeBuilder& builder, const TopologyAtom& stated);

/// A molecule whose atoms have no places yet.
Molecule withoutPositions(MoleculeBuilder& builder, const char* format);

}  // namespace nacre
