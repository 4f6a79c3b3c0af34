#pragma once
// Gathers the other models of a molecule's file, as far as a camera that all of them share wants them.

#include <cstddef>
#include <cstdint>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Of models that have the molecule's own atoms the places alone are kept, in a file if they are many, of others all
/// but their bonds.
class OtherModels {
public:
    /// @param own       gets them
    /// @param maxAtoms  of the molecule; the others together take no more than a part of what that many take
    OtherModels(Molecule& own, std::size_t maxAtoms);
    /// Whether any more are wanted.
    bool wanted() const { return wanted_; }
    void add(Molecule model);

private:
    Molecule& own_;
    std::size_t mostBytes_, bytes_ = 0;
    bool wanted_ = true;
};

/// Makes `placed` what another model of a molecule's file is; without bonds.
void place(const Molecule& molecule, const OtherModel& other, Molecule& placed);

}  // namespace nacre
