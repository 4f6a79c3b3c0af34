#pragma once
// An assembly with its copies' atoms written out one by one: what instancing must look like.

#include "engine/molecule/molecule.h"

namespace nacre::test {

/// Every part's subchains, moved by each of its transforms; bonds between atoms of the same subchain are copied along.
inline Molecule writtenOut(const Molecule& molecule, const Assembly& assembly) {
    constexpr std::uint32_t kNone = UINT32_MAX;
    Molecule result;
    result.chains = molecule.chains;
    result.subchains = molecule.subchains;
    for (const AssemblyPart& part : assembly.parts)
        for (const glm::mat4x3& transform : part.transforms)
            for (const std::uint32_t subchain : part.subchains) {
                std::vector<std::uint32_t> place(molecule.atoms.size(), kNone);
                for (const Residue& residue : molecule.residues) {
                    if (residue.subchain != subchain) continue;
                    Residue copy = residue;
                    copy.firstAtom = static_cast<std::uint32_t>(result.atoms.size());
                    for (std::uint32_t i = residue.firstAtom; i < residue.firstAtom + residue.atomCount; ++i) {
                        Atom atom = molecule.atoms[i];
                        const glm::dvec4 from(atom.position, 1.0);
                        atom.position = glm::vec3(glm::dmat4x3(transform) * from);
                        atom.residue = static_cast<std::uint32_t>(result.residues.size());
                        place[i] = static_cast<std::uint32_t>(result.atoms.size());
                        result.atoms.push_back(atom);
                    }
                    result.residues.push_back(copy);
                }
                for (Bond bond : molecule.bonds) {
                    bond.a = place[bond.a], bond.b = place[bond.b];
                    if (bond.a != kNone && bond.b != kNone) result.bonds.push_back(bond);
                }
            }
    return result;
}

}  // namespace nacre::test
