#pragma once
// The residue types of an MMTF file: each is stated once and referred to by every residue of that kind.

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

/// Order as Molecule has it. MMTF also knows quadruple bonds, and -1 for a bond of unknown order.
std::uint8_t mmtfBondOrder(std::int64_t order);

/// @param mostAtoms  that the groups may have together, a few always; a group of more is none that a model could show
/// @throws Error if a group is malformed
std::vector<MmtfGroup> readMmtfGroups(const MmtfFields& fields, MoleculeBuilder& builder, std::size_t mostAtoms);

}  // namespace nacre
