#include <gtest/gtest.h>

#include "engine/molecule/element.h"
#include "tests/molecule/expect_error.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

const std::string kHeader = "formate\n  test\n\n";
const std::string kAtomTable =
    "    0.0000    0.0000    0.0000 C   0  0  0  0  0  0\n"
    "    1.2000    0.0000    0.0000 O   0  0  0  0  0  0\n"
    "   -0.6000    1.0392    0.0000 O   0  5  0  0  0  0\n";
const std::string kBonds = "  1  2  2  0\n  1  3  1  0\n";
const std::string kTable = kHeader + "  3  2  0  0  0  0  0  0  0  0999 V2000\n" + kAtomTable + kBonds;
const std::string kFormate = kTable + "M  END\n";

const std::string kV3000 =
    kHeader + "  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\nM  V30 COUNTS 3 2 0 0 0\n";
const std::string kV3000Atoms =
    "M  V30 BEGIN ATOM\nM  V30 7 C 0 0 0 0\nM  V30 9 O 1.2 0 -\nM  V30 0 0\nM  V30 11 O -0.6 1.0392 0 0 CHG=-1\n"
    "M  V30 END ATOM\n";
const std::string kV3000Bonds = "M  V30 BEGIN BOND\nM  V30 1 2 7 9\nM  V30 2 1 7 11\nM  V30 END BOND\n";
const std::string kV3000End = "M  V30 END CTAB\nM  END\n";

void expectFormate(const Molecule& molecule) {
    ASSERT_EQ(molecule.atoms.size(), 3u);
    EXPECT_EQ(elementSymbol(molecule.atoms[0].element), "C");
    EXPECT_EQ(elementSymbol(molecule.atoms[2].element), "O");
    EXPECT_FLOAT_EQ(molecule.atoms[2].position.y, 1.0392f);
    EXPECT_EQ(molecule.atoms[1].charge, 0);
    EXPECT_EQ(molecule.atoms[2].charge, -1);
    ASSERT_EQ(molecule.bonds.size(), 2u);
    EXPECT_EQ(molecule.bonds[0].b, 1u);
    EXPECT_EQ(molecule.bonds[0].order, 2);
    EXPECT_EQ(molecule.bonds[1].b, 2u);
    EXPECT_EQ(molecule.bonds[1].order, 1);
    EXPECT_EQ(molecule.bonds[1].source, BondSource::file);
    EXPECT_EQ(molecule.file.title, "formate");
    EXPECT_EQ(molecule.file.bonds, 2);
}

TEST(ReadSdf, AtomsBondsChargesOfV2000) { expectFormate(readMolecule("a.mol", kFormate)); }

TEST(ReadSdf, AtomsBondsChargesOfV3000) {
    const Molecule molecule = readMolecule("a.mol", kV3000 + kV3000Atoms + kV3000Bonds + kV3000End);
    expectFormate(molecule);
    EXPECT_EQ(molecule.file.format, "sdf-v3000");
}

TEST(ReadSdf, ChargeLinesReplaceThoseOfTheAtoms) {
    const Molecule molecule = readMolecule("a.mol", kTable + "M  CHG  2   1   1   2  -2\nM  END\n");
    EXPECT_EQ(molecule.atoms[0].charge, 1);
    EXPECT_EQ(molecule.atoms[1].charge, -2);
    EXPECT_EQ(molecule.atoms[2].charge, 0);
    test::expectLeftOut("a.mol", kTable + "M  CHG  1   4   1\nM  END\n",
                        "left out 1 charge, line 10: of atoms that are not there");
}

TEST(ReadSdf, ColumnsMayTouchOrBeWords) {
    const std::string touching = "-1234.5678-2345.6789-3456.7891Cl  0  0\n";
    const Molecule molecule =
        readMolecule("a.mol", kHeader + "  1  0  0  0  0  0  0  0  0  0999 V2000\n" + touching + "M  END\n");
    EXPECT_FLOAT_EQ(molecule.atoms[0].position.y, -2345.6789f);
    EXPECT_EQ(elementSymbol(molecule.atoms[0].element), "Cl");
    const Molecule words =
        readMolecule("a.mol", kHeader + "2 1 0 V2000\n0 0 1.5 C 0 0\n0 0 0 N 0 0\n1 2 3 0\nM  END\n");
    EXPECT_FLOAT_EQ(words.atoms[0].position.z, 1.5f);
    EXPECT_EQ(words.bonds.at(0).order, 3);
}

TEST(ReadSdf, RecordsByNumber) {
    const std::string two = kFormate + "> <key>\nvalue\n\n$$$$\n" +
                            "second\n\n\n  1  0  0  0  0  0  0  0  0  0999 V2000\n" +
                            "    0.0000    0.0000    0.0000 U   0  0\nM  END\n$$$$\n\n";
    const Molecule first = readMolecule("a.sdf", two);
    expectFormate(first);
    EXPECT_EQ(first.file.records, 2);
    EXPECT_EQ(first.file.totalAtomsAllRecords, 4);
    EXPECT_EQ(first.file.totalBondsAllRecords, 2);
    ReadOptions options{.model = 2};
    const Molecule second = readMolecule("a.sdf", two, options);
    EXPECT_EQ(second.file.title, "second");
    EXPECT_EQ(elementSymbol(second.atoms.at(0).element), "U");
    EXPECT_EQ(second.file.totalAtomsAllRecords, 4);
    options.model = 3;
    test::expectError("a.sdf", two, {"no record 3; the file has 2"}, options);
    // Line numbers count from the beginning of the file.
    options.model = 2;
    std::string broken = two;
    broken.replace(broken.find(" U "), 3, " 7 ");
    test::expectError("a.sdf", broken, {"(line 19)"}, options);
}

TEST(ReadSdf, WhatIsWrongIsSaidWithItsLine) {
    const std::string counts = "  3  2  0  0  0  0  0  0  0  0999 V2000\n";
    test::expectError("a.sdf", "a\nb\n", {"ends before the counts line"});
    test::expectError("a.sdf", kHeader + "        V2000\n", {"(line 4)", "no counts"});
    test::expectError("a.sdf", kHeader + counts + kAtomTable, {"ends before bond 1 of 2"});
    test::expectLeftOut("a.sdf", kHeader + counts + kAtomTable + "  1  1  1\n  1  2  1\n",
                        "left out 1 bond, line 8: of an atom to itself");
    test::expectLeftOut("a.sdf", kHeader + counts + kAtomTable + "  0  1  1\n  1  2  1\n",
                        "left out 1 bond, line 8: of atoms that are not there");
    test::expectError("a.sdf", kHeader + "999999  0  0  0  0  0  0  0  0999 V2000\n", {"before atom 1 of 999"});
}

TEST(ReadSdf, WhatIsWrongInV3000) {
    test::expectError("a.sdf", kV3000 + kV3000Atoms + kV3000Bonds, {"before END CTAB"});
    test::expectError("a.sdf", kV3000 + "M  V30 BEGIN ATOM\nM  V30 1 C 0 0 0 0\n", {"inside its ATOM block"});
    test::expectError("a.sdf", kV3000 + "M  V30 BEGIN ATOM\nM  V30 C 0 0 0\n", {"(line 8)", "expected an atom, not"});
    test::expectError("a.sdf", kV3000 + "M  V30 BEGIN ATOM\nM  V30 1 C 0 0 0 0\nM  V30 1 C 0 0 0 0\nM  V30 END ATOM\n",
                      {"occurs twice"});
    test::expectLeftOut("a.sdf",
                        kV3000 + kV3000Atoms + "M  V30 BEGIN BOND\nM  V30 1 1 7 8\nM  V30 END BOND\nM  V30 END CTAB\n",
                        "left out 1 bond, line 14: of atoms that are not there");
    test::expectError("a.sdf", kV3000 + "something else\n", {"(line 7)", "M  V30"});
    const std::string huge = kHeader +
                             "  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\n"
                             "M  V30 COUNTS 4000000000 9000000000000 0 0 0\n";
    const Molecule molecule = readMolecule("a.sdf", huge + kV3000Atoms + kV3000Bonds + kV3000End);
    expectFormate(molecule);
    ASSERT_EQ(molecule.warnings.size(), 1u);
    EXPECT_NE(molecule.warnings[0].find("states 4000000000 atoms"), std::string::npos);
}

TEST(ReadSdf, AtomListsAndHydrogenBondsOfV3000) {
    const Molecule molecule = readMolecule(
        "a.sdf", kV3000 +
                     "M  V30 BEGIN ATOM\nM  V30 1 NOT [N, O] 1 2 3 0\nM  V30 2 C 9 9 9 0\nM  V30 END ATOM\n"
                     "M  V30 BEGIN BOND\nM  V30 1 10 1 2\nM  V30 END BOND\n" +
                     kV3000End);
    EXPECT_EQ(molecule.atoms.at(0).element, 0);
    EXPECT_FLOAT_EQ(molecule.atoms[0].position.z, 3);
    EXPECT_TRUE(molecule.bonds.empty());
}

TEST(ReadSdf, BothVersionsOfTyrosineAreTheSame) {
    NACRE_NEEDS_DATA();
    const Molecule a = readMoleculeFile(test::dataFile("small/tyr.sdf"));
    const Molecule b = readMoleculeFile(test::dataFile("small/tyr.v3000.sdf"));
    ASSERT_EQ(a.atoms.size(), b.atoms.size());
    for (std::size_t i = 0; i < a.atoms.size(); ++i) {
        EXPECT_EQ(a.atoms[i].element, b.atoms[i].element);
        EXPECT_EQ(a.atoms[i].charge, b.atoms[i].charge);
        for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(a.atoms[i].position[axis], b.atoms[i].position[axis]);
    }
    ASSERT_EQ(a.bonds.size(), 24u);
    ASSERT_EQ(b.bonds.size(), 24u);
    int doubles = 0;
    for (std::size_t i = 0; i < a.bonds.size(); ++i) {
        EXPECT_EQ(a.bonds[i].a, b.bonds[i].a);
        EXPECT_EQ(a.bonds[i].b, b.bonds[i].b);
        EXPECT_EQ(a.bonds[i].order, b.bonds[i].order);
        doubles += a.bonds[i].order == 2;
    }
    EXPECT_EQ(doubles, 4);  // the ring's three and the acid's one
}

TEST(ReadSdf, EveryPubchemRecordReads) {
    NACRE_NEEDS_DATA();
    std::int64_t atoms = 0;
    for (int record = 1; record <= 100; ++record) {
        const Molecule molecule = readMoleculeFile(test::dataFile("small/pubchem-cid1-100.sdf"), {.model = record});
        atoms += static_cast<std::int64_t>(molecule.atoms.size());
        EXPECT_EQ(molecule.file.totalAtomsAllRecords, 3363);
    }
    EXPECT_EQ(atoms, 3363);
}

}  // namespace
}  // namespace nacre
