#pragma once
// Molecules with displacement tensors.

#include "engine/molecule/element.h"
#include "engine/molecule/read.h"

namespace nacre::test {

/// Glucose of which each atom but hydrogens has a tensor of its own.
inline Molecule glucoseWithTensors() {
    Molecule m = sampleMolecule("glucose");
    m.displacements.resize(m.atoms.size());
    for (std::uint32_t i = 0; i < m.atoms.size(); ++i) {
        const float turn = 0.002f * static_cast<float>(i % 7);
        const auto along = [i](std::uint32_t k) { return 0.02f + 0.015f * static_cast<float>((i + k) % 3); };
        if (!isHydrogen(m.atoms[i].element))
            m.displacements[i] = {along(0), along(1), along(2), turn - 0.006f, 0.004f, -turn / 2};
    }
    return m;
}

}  // namespace nacre::test
