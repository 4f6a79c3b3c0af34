#include "engine/molecule/chemistry/hydrogens.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "engine/molecule/bonds/bonds.h"
#include "engine/molecule/drawn_atoms.h"
#include "tests/molecule/build_molecule.h"
#include "tests/molecule/build_peptide.h"

namespace nacre {
namespace {

using test::MoleculeText;

double degreesAt(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    return std::acos(glm::dot(glm::normalize(a - b), glm::normalize(c - b))) * 57.29577951308232;
}

Molecule hydrogenated(Molecule molecule) {
    perceiveBonds(molecule);
    return withHydrogens(molecule, perceiveChemistry(molecule, drawnAtoms(molecule, {.water = true})));
}

/// Positions of the hydrogens of the first atom.
std::vector<glm::dvec3> hydrogensOfFirst(const Molecule& molecule) {
    std::vector<glm::dvec3> found;
    for (const Bond& bond : molecule.bonds)
        if (bond.a == 0 && molecule.atoms[bond.b].element == 1) found.push_back(molecule.atoms[bond.b].position);
    return found;
}

TEST(Hydrogens, StandAtIdealAnglesAboutATetrahedralAtom) {
    MoleculeText text;
    text.residue("LIG").atom("C1", "C", {0, 0, 0}).atom("C2", "C", {1.53f, 0, 0}).atom("O", "O", {2, 1.34f, 0});
    const Molecule molecule = hydrogenated(text.molecule);
    const std::vector<glm::dvec3> h = hydrogensOfFirst(molecule);
    ASSERT_EQ(h.size(), 3u);
    for (const glm::dvec3& p : h) {
        EXPECT_NEAR(glm::length(p), 1.09, 1e-3);
        EXPECT_NEAR(degreesAt(p, {0, 0, 0}, {1.53, 0, 0}), 109.47, 0.1);
        for (const glm::dvec3& q : h) EXPECT_TRUE(p == q || std::abs(degreesAt(p, {0, 0, 0}, q) - 109.47) < 1);
    }
}

TEST(Hydrogens, LieInThePlaneOfAPlanarAtom) {
    MoleculeText text;  // of ethene
    text.residue("LIG").atom("C1", "C", {0, 0, 0}).atom("C2", "C", {1.33f, 0, 0}).atom("C3", "C", {2.08f, 1.3f, 0});
    text.atom("C4", "C", {2.08f, -1.3f, 0});
    const std::vector<glm::dvec3> h = hydrogensOfFirst(hydrogenated(text.molecule));
    ASSERT_EQ(h.size(), 2u);
    for (const glm::dvec3& p : h) {
        EXPECT_NEAR(p.z, 0, 1e-4);
        EXPECT_NEAR(degreesAt(p, {0, 0, 0}, {1.33, 0, 0}), 120, 0.1);
    }
}

TEST(Hydrogens, OfStandardResiduesBearThePdbsNames) {
    Molecule chain = test::buildChain(3, -60, -45);
    const Molecule full = hydrogenated(chain);
    std::string names;
    for (const Atom& atom : full.atoms)
        if (atom.element == 1) names += std::string(atom.name.view()) + std::to_string(atom.residue + 1) + " ";
    // Without side chains: the first nitrogen is an end, and carbons at gaps are no aldehydes.
    EXPECT_EQ(names, "H11 H21 H31 HA21 HA31 H2 HA22 HA32 H3 HA23 HA33 ");
    EXPECT_EQ(full.residues[2].atomCount, 7u);
    for (std::uint32_t i = 0; i < full.atoms.size(); ++i) {
        const Residue& residue = full.residues[full.atoms[i].residue];
        EXPECT_TRUE(i >= residue.firstAtom && i < residue.firstAtom + residue.atomCount);
    }
}

TEST(Hydrogens, ThatAreThereAreNotAddedAgain) {
    MoleculeText text;
    text.residue("LIG").atom("C1", "C", {0, 0, 0}).atom("C2", "C", {1.53f, 0, 0});
    const Molecule once = hydrogenated(text.molecule);
    EXPECT_EQ(once.atoms.size(), 8u);
    EXPECT_EQ(hydrogenated(once).atoms.size(), 8u);
    Molecule heavy = once;
    for (Atom& atom : heavy.atoms)
        if (atom.element == 1) atom.element = elementFromSymbol("D");
    EXPECT_EQ(hydrogenated(heavy).atoms.size(), 8u);
}

}  // namespace
}  // namespace nacre
