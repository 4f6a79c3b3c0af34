#pragma once
// The residue types of an MMTF file: each is stored once and referred to by its residues.

#include <cstdint>
#include <vector>

#include "engine/molecule/formats/mmtf_fields.h"
#include "engine/molecule/formats/molecule_builder.h"

namespace nacre {

struct MmtfGroup {
    struct Bond {
        std::uint32_t a, b;  ///< different indices into atoms
        std::uint8_t order;
    };
    std::string name;
    std::vector<Atom> atoms;  ///< name, element, charge and hetero are set
    std::vector<Bond> bonds;  ///< no pair twice
};

/// Order for Molecule. MMTF also has quadruple bonds, and -1 for unknown orders.
std::uint8_t mmtfBondOrder(std::int64_t order);

/// @param mostAtoms  of all groups together; a few are always allowed
/// @throws Error if a group is malformed
std::vector<MmtfGroup> readMmtfGroups(const MmtfFields& fields, MoleculeBuilder& builder, std::size_t mostAtoms);

}  // namespace nacre
