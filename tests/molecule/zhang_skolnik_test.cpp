#include "engine/molecule/zhang_skolnik.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/kabsch_sander.h"
#include "engine/molecule/read.h"
#include "tests/molecule/build_peptide.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

using test::buildChain;

std::string foldOfCarbons(const std::vector<SecondaryStructure>& kinds) {
    std::string text;
    for (const SecondaryStructure kind : kinds) text += "-HE"[static_cast<int>(kind)];
    return text;
}

/// The rest of the backbone gets other names.
Molecule keepCarbons(Molecule molecule) {
    for (Atom& atom : molecule.atoms)
        if (atom.name != Name("CA")) atom.name = Name("X");
    return molecule;
}

TEST(ZhangSkolnik, HelicesAndStrandsByTheirTorsions) {
    const Molecule helix = keepCarbons(buildChain(12, -57, -47)), strand = keepCarbons(buildChain(12, -120, 130));
    EXPECT_EQ(foldOfCarbons(zhangSkolnik(helix)), "--HHHHHHHH--");
    EXPECT_EQ(foldOfCarbons(zhangSkolnik(strand)), "--EEEEEEEE--");
    EXPECT_EQ(foldOfCarbons(zhangSkolnik(keepCarbons(buildChain(12, 60, 90)))), "------------");
    EXPECT_EQ(foldOfCarbons(secondaryStructure(helix)), "--HHHHHHHH--");
}

TEST(ZhangSkolnik, WhereTheBackboneIsWholeItHasNoSay) {
    const Molecule whole = buildChain(12, -57, -47);
    EXPECT_EQ(foldOfCarbons(zhangSkolnik(whole)), "------------");
    EXPECT_EQ(foldOfCarbons(secondaryStructure(whole)), "-HHHHHHHHHH-");
    Molecule both = whole;  // a chain of carbons behind it
    both.chains.push_back({"B", 1});
    const Molecule carbons = keepCarbons(whole);
    for (Atom atom : carbons.atoms) {
        atom.residue += 12;
        both.atoms.push_back(atom);
    }
    for (Residue residue : carbons.residues) {
        residue.chain = 1;
        residue.firstAtom += static_cast<std::uint32_t>(whole.atoms.size());
        both.residues.push_back(residue);
    }
    EXPECT_EQ(foldOfCarbons(secondaryStructure(both)), "-HHHHHHHHHH---HHHHHHHH--");
}

TEST(ZhangSkolnik, BreaksShortPiecesAndCalcium) {
    Molecule broken = keepCarbons(buildChain(16, -57, -47));
    for (std::size_t i = 7 * 4; i < broken.atoms.size(); ++i) broken.atoms[i].position.x += 30;
    EXPECT_EQ(foldOfCarbons(zhangSkolnik(broken)), "---------HHHHH--");  // of the first seven three would be one
    EXPECT_EQ(foldOfCarbons(zhangSkolnik(keepCarbons(buildChain(6, -120, 130)))), "------");
    EXPECT_EQ(foldOfCarbons(zhangSkolnik(keepCarbons(buildChain(7, -120, 130)))), "--EEE--");
    Molecule calcium = keepCarbons(buildChain(12, -57, -47));
    for (Atom& atom : calcium.atoms) atom.element = 20;
    EXPECT_EQ(foldOfCarbons(zhangSkolnik(calcium)), "------------");
}

TEST(ZhangSkolnik, PlacesThatAreNone) {
    Molecule nowhere = keepCarbons(buildChain(12, -57, -47)), together = nowhere;
    for (Atom& atom : together.atoms) atom.position = {};
    EXPECT_EQ(foldOfCarbons(zhangSkolnik(together)), "------------");
    for (Atom& atom : nowhere.atoms) atom.position.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(foldOfCarbons(zhangSkolnik(nowhere)), "------------");
    EXPECT_TRUE(zhangSkolnik(Molecule()).empty());
}

TEST(ZhangSkolnik, AgreesMostlyWithHydrogenBonds) {
    NACRE_NEEDS_DATA();
    std::size_t same = 0, all = 0, opposite = 0;
    for (const char* name : {"1crn.pdb", "4hhb.pdb", "1stp-v5.cif", "gfp-1ema.cif"}) {
        const Molecule molecule = readMoleculeFile(test::dataFile(name));
        const std::string bonds = foldOfCarbons(kabschSander(molecule));
        const std::string carbons = foldOfCarbons(zhangSkolnik(keepCarbons(molecule)));
        for (const std::uint32_t index : drawnAtoms(molecule)) {
            if (molecule.atoms[index].name != Name("CA")) continue;
            const char b = bonds[molecule.atoms[index].residue], c = carbons[molecule.atoms[index].residue];
            ++all;
            same += b == c;
            opposite += b != '-' && c != '-' && b != c;
        }
    }
    EXPECT_GT(all, 900u);
    EXPECT_GE(same, all * 78 / 100) << same << " of " << all;
    EXPECT_LE(opposite, all / 100) << opposite << " of " << all;
}

}  // namespace
}  // namespace nacre
