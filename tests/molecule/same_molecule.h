#pragma once

#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>
#include <string>

#include "engine/molecule/molecule.h"

namespace nacre::test {

inline bool sameAtom(const Atom& a, const Atom& b) {
    return a.position == b.position && a.name == b.name && a.element == b.element && a.residue == b.residue &&
           a.alternate == b.alternate && a.hetero == b.hetero && a.occupancy == b.occupancy &&
           a.temperatureFactor == b.temperatureFactor && a.charge == b.charge;
}

inline bool sameResidue(const Residue& a, const Residue& b) {
    return a.name == b.name && a.number == b.number && a.insertionCode == b.insertionCode && a.chain == b.chain &&
           a.subchain == b.subchain && a.firstAtom == b.firstAtom && a.atomCount == b.atomCount;
}

/// Everything about an atom but its place in the file.
inline std::string described(const Molecule& molecule, const Atom& atom) {
    const Residue& residue = molecule.residues[atom.residue];
    std::ostringstream text;
    text << molecule.chains[residue.chain].name << '/' << molecule.subchains[residue.subchain] << '/' << residue.number
         << residue.insertionCode << residue.name.view() << '/' << atom.name.view() << atom.alternate << ' '
         << int(atom.element) << ' ' << atom.hetero << ' ' << atom.occupancy << ' ' << atom.temperatureFactor << ' '
         << int(atom.charge) << std::setprecision(9);
    for (int axis = 0; axis < 3; ++axis) text << ' ' << atom.position[axis];
    return text.str();
}

/// The same atoms in the same residues and chains, to the last bit. Stops at the first that differs.
inline void expectSameAtoms(const Molecule& a, const Molecule& b) {
    ASSERT_EQ(a.atoms.size(), b.atoms.size());
    ASSERT_EQ(a.residues.size(), b.residues.size());
    for (std::size_t i = 0; i < a.atoms.size(); ++i) ASSERT_TRUE(sameAtom(a.atoms[i], b.atoms[i])) << "atom " << i;
    for (std::size_t i = 0; i < a.residues.size(); ++i)
        ASSERT_TRUE(sameResidue(a.residues[i], b.residues[i])) << "residue " << i;
    ASSERT_EQ(a.chains.size(), b.chains.size());
    for (std::size_t i = 0; i < a.chains.size(); ++i) EXPECT_EQ(a.chains[i].name, b.chains[i].name);
    EXPECT_EQ(a.subchains, b.subchains);
}

inline void expectSameBonds(const Molecule& a, const Molecule& b) {
    ASSERT_EQ(a.bonds.size(), b.bonds.size());
    for (std::size_t i = 0; i < a.bonds.size(); ++i) {
        const Bond &x = a.bonds[i], &y = b.bonds[i];
        ASSERT_TRUE(x.a == y.a && x.b == y.b && x.order == y.order && x.source == y.source) << "bond " << i;
    }
}

inline void expectSameAssemblies(const Molecule& a, const Molecule& b) {
    ASSERT_EQ(a.assemblies.size(), b.assemblies.size());
    for (std::size_t i = 0; i < a.assemblies.size(); ++i) {
        EXPECT_EQ(a.assemblies[i].id, b.assemblies[i].id);
        ASSERT_EQ(a.assemblies[i].parts.size(), b.assemblies[i].parts.size());
        for (std::size_t p = 0; p < a.assemblies[i].parts.size(); ++p) {
            const AssemblyPart &x = a.assemblies[i].parts[p], &y = b.assemblies[i].parts[p];
            EXPECT_EQ(x.subchains, y.subchains);
            EXPECT_TRUE(x.transforms == y.transforms);
        }
    }
}

}  // namespace nacre::test
