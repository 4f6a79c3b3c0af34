#pragma once
// Molecules for cartoons, and cartoons of them.

#include <glm/vec3.hpp>
#include <vector>

#include "engine/mesh/cartoon.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/kabsch_sander.h"
#include "tests/mesh/mesh_checks.h"
#include "tests/molecule/build_molecule.h"
#include "tests/molecule/build_peptide.h"

namespace nacre::test {

/// The same structure for every residue.
inline std::vector<SecondaryStructure> all(const Molecule& molecule, SecondaryStructure kind) {
    return std::vector<SecondaryStructure>(molecule.residues.size(), kind);
}

inline Mesh makeCartoon(const Molecule& molecule, const std::vector<SecondaryStructure>& secondary,
                        const CartoonOptions& options = {}) {
    return cartoon(molecule, drawnAtoms(molecule), secondary, options, {});
}

inline Mesh makeCartoon(const Molecule& molecule, const CartoonOptions& options = {}) {
    return makeCartoon(molecule, secondaryStructure(molecule), options);
}

/// Alpha carbons alone, one residue each.
inline Molecule alphaCarbons(const std::vector<glm::vec3>& places) {
    MoleculeText text;
    int number = 0;
    for (const glm::vec3& place : places) text.residue("ALA", ++number).atom("CA", "C", place);
    return text.molecule;
}

/// A strand along z whose alpha carbons zigzag along y.
inline Molecule zigzag(int residues) {
    std::vector<glm::vec3> places;
    for (int i = 0; i < residues; ++i) places.emplace_back(0, i % 2 ? 0.9 : -0.9, 3.3 * i);
    return alphaCarbons(places);
}

}  // namespace nacre::test
