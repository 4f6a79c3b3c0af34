#include "engine/molecule/kabsch_sander.h"

#include <gtest/gtest.h>

#include "tests/molecule/build_molecule.h"
#include "tests/molecule/build_peptide.h"

namespace nacre {
namespace {

using test::buildChain;

std::string fold(const std::vector<SecondaryStructure>& kinds) {
    std::string text;
    for (const SecondaryStructure kind : kinds) text += "-HE"[static_cast<int>(kind)];
    return text;
}

TEST(KabschSander, HelicesByTheirTorsions) {
    // Alpha, 3-10 and pi; a straight chain has no bonds.
    EXPECT_EQ(fold(kabschSander(buildChain(12, -57, -47))), "-HHHHHHHHHH-");
    EXPECT_EQ(fold(kabschSander(buildChain(12, -49, -26))), "-HHHHHHHHHH-");
    EXPECT_EQ(fold(kabschSander(buildChain(12, -57, -70))), "-HHHHHHHHHH-");
    EXPECT_EQ(fold(kabschSander(buildChain(12, -135, 135))), "------------");
}

TEST(KabschSander, WhatTheFileStatesGoesFirst) {
    Molecule molecule = buildChain(12, -57, -47);
    EXPECT_EQ(fold(secondaryStructure(molecule)), "-HHHHHHHHHH-");
    molecule.statesSecondaryStructure = true;
    molecule.residues[0].secondary = SecondaryStructure::strand;
    EXPECT_EQ(fold(secondaryStructure(molecule)), "E-----------");
}

TEST(KabschSander, BreaksProlineAndWhatIsMissing) {
    Molecule broken = buildChain(12, -57, -47);
    for (std::size_t i = 6 * 4; i < broken.atoms.size(); ++i) broken.atoms[i].position.x += 30;
    EXPECT_EQ(fold(kabschSander(broken)), "-HHHH--HHHH-");
    Molecule proline = buildChain(12, -57, -47);
    proline.residues[5].name = Name("PRO");  // gives no bond to the second residue, so that no turn begins there
    EXPECT_EQ(fold(kabschSander(proline)), "---HHHHHHHH-");
    Molecule onlyCa = buildChain(12, -57, -47);
    for (Atom& atom : onlyCa.atoms)
        if (atom.name != Name("CA")) atom.name = Name("X");
    EXPECT_EQ(fold(kabschSander(onlyCa)), "------------");
    EXPECT_TRUE(kabschSander(Molecule()).empty());
}

TEST(KabschSander, ModelsUponOneAnotherStandForThemselves) {
    Molecule both = buildChain(12, -57, -47);
    const Molecule one = both;
    both.chains.push_back({"A", 2});
    for (Atom atom : one.atoms) {
        atom.residue += 12;
        both.atoms.push_back(atom);
    }
    for (Residue residue : one.residues) {
        residue.chain = 1;
        residue.firstAtom += 48;
        both.residues.push_back(residue);
    }
    EXPECT_EQ(fold(kabschSander(both)), "-HHHHHHHHHH--HHHHHHHHHH-");
}

TEST(KabschSander, AtomsAtOnePlaceEndSoon) {
    test::MoleculeText text;
    for (int i = 1; i <= 20'000; ++i)
        text.residue("ALA", i).atom("N", "N", {}).atom("CA", "C", {}).atom("C", "C", {}).atom("O", "O", {});
    EXPECT_EQ(fold(kabschSander(text.molecule)), std::string(20'000, '-'));
}

}  // namespace
}  // namespace nacre
