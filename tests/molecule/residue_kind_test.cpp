#include "engine/molecule/residue_kind.h"

#include <gtest/gtest.h>

#include "tests/molecule/build_molecule.h"

namespace nacre {
namespace {

ResidueKind kindOf(const char* name, const char* atom = "X", const char* symbol = "C") {
    test::MoleculeText text;
    text.residue(name).atom(atom, symbol, {0, 0, 0});
    return residueKinds(text.molecule).at(0);
}

TEST(ResidueKind, ByName) {
    for (const char* name : {"ALA", "MSE", "HID", "HSP", "CYX", "SEP", "UNK", "ACE", "PYL"})
        EXPECT_EQ(kindOf(name), ResidueKind::protein) << name;
    for (const char* name : {"A", "DA", "U", "T", "DT", "PSU", "H2U"})
        EXPECT_EQ(kindOf(name), ResidueKind::nucleic) << name;
    for (const char* name : {"HOH", "WAT", "DOD", "TIP3", "SOL"}) EXPECT_EQ(kindOf(name), ResidueKind::water) << name;
    for (const char* name : {"SO4", "PO4", "NO3"}) EXPECT_EQ(kindOf(name), ResidueKind::ion) << name;
    for (const char* name : {"HEM", "ATP", "NAG", "GOL", "", "QQQ"})
        EXPECT_EQ(kindOf(name), ResidueKind::ligand) << name;
}

TEST(ResidueKind, SingleMetalsAndHalogensAreIonsButNobleGasesAreNot) {
    EXPECT_EQ(kindOf("ZN", "ZN", "ZN"), ResidueKind::ion);
    EXPECT_EQ(kindOf("CL", "CL", "CL"), ResidueKind::ion);
    EXPECT_EQ(kindOf("XE", "XE", "XE"), ResidueKind::ligand);
    EXPECT_EQ(kindOf("", "Au", "AU"), ResidueKind::ligand);  // an atom of a cluster in a format without residues
    test::MoleculeText text;
    text.residue("CA").atom("CA", "CA", {0, 0, 0}, 'A').atom("CA", "CA", {1, 0, 0}, 'B');
    EXPECT_EQ(residueKinds(text.molecule).at(0), ResidueKind::ion);
}

TEST(ResidueKind, UnknownNamesCountAsPolymerIfTheyAreBondedIntoOne) {
    test::MoleculeText text;
    text.residue("QQQ", 1).atom("N", "N", {0, 0, 0}).atom("CA", "C", {1.5f, 0, 0}).atom("C", "C", {3, 0, 0});
    text.residue("ALA", 2).atom("N", "N", {4.3f, 0, 0});
    EXPECT_EQ(residueKinds(text.molecule).at(0), ResidueKind::ligand);
    text.molecule.bonds.push_back({2, 3, 1, BondSource::distance});
    EXPECT_EQ(residueKinds(text.molecule).at(0), ResidueKind::protein);
    test::MoleculeText other;
    other.residue("QQ2", 1).atom("C1*", "C", {0, 0, 0}).atom("C3*", "C", {1, 0, 0}).atom("O3*", "O", {2, 0, 0});
    other.residue("DA", 2).atom("P", "P", {3.6f, 0, 0});
    other.molecule.bonds.push_back({2, 3, 1, BondSource::distance});
    EXPECT_EQ(residueKinds(other.molecule).at(0), ResidueKind::nucleic);
}

TEST(ResidueKind, LettersOfAminoAcids) {
    EXPECT_EQ(aminoAcidLetter(Name("TRP")), 'W');
    EXPECT_EQ(aminoAcidLetter(Name("MSE")), 'M');
    EXPECT_EQ(aminoAcidLetter(Name("HIE")), 'H');
    for (const char* name : {"UNK", "DA", "HEM", "", "HOH"}) EXPECT_EQ(aminoAcidLetter(Name(name)), '\0') << name;
}

TEST(ResidueKind, BackboneByName) {
    EXPECT_TRUE(isBackbone(ResidueKind::protein, Name("OXT")));
    EXPECT_FALSE(isBackbone(ResidueKind::protein, Name("CB")));
    EXPECT_TRUE(isBackbone(ResidueKind::nucleic, Name("O1P")));
    EXPECT_TRUE(isBackbone(ResidueKind::nucleic, Name("C2'")));
    EXPECT_FALSE(isBackbone(ResidueKind::nucleic, Name("N9")));
    EXPECT_FALSE(isBackbone(ResidueKind::ligand, Name("CA")));
}

}  // namespace
}  // namespace nacre
