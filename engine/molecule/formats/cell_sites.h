#pragma once
// The content of a unit cell: copies of the asymmetric unit by symmetry, atoms on special positions once per site.

#include <gemmi/symmetry.hpp>
#include <gemmi/unitcell.hpp>
#include <map>
#include <string>
#include <vector>

#include "engine/molecule/formats/molecule_builder.h"

namespace nacre {

/// Groups of atoms with the same symmetry copies; each is a subchain.
class CellSites {
public:
    /// @param prefix  of the subchains' names, if a file has several crystals
    CellSites(const gemmi::UnitCell& cell, std::vector<gemmi::Op> operations, std::string prefix = "")
        : cell_(cell), operations_(std::move(operations)), prefix_(std::move(prefix)) {}

    /// The name of an atom's subchain.
    std::string add(const gemmi::Fractional& at);
    /// Adds the content of the cell as the assembly "unit-cell"; warns if that is impossible.
    void addUnitCell(MoleculeBuilder& builder) const;

private:
    gemmi::UnitCell cell_;
    std::vector<gemmi::Op> operations_;
    std::string prefix_;
    std::map<std::vector<std::uint32_t>, std::string> groups_;  ///< by the operations that give distinct positions
    gemmi::Vec3 sum_{0, 0, 0};
    std::size_t atoms_ = 0;
};

}  // namespace nacre
