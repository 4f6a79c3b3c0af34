#include <gtest/gtest.h>

#include "engine/molecule/element.h"
#include "tests/molecule/expect_error.h"

namespace nacre {
namespace {

TEST(ReadXyz, SymbolsInEveryForm) {
    const Molecule molecule = readMolecule(
        "a.xyz", "8\n\nC 0 0 0\nfe 10 0 0\nCL 20 0 0 0.5 extra\n26 30 0 0\nD 40 0 0\nC12 50 0 0\nT 60 0 0\nX 70 0 0\n");
    const char* const expected[] = {"C", "Fe", "Cl", "Fe", "D", "C", "H"};
    for (std::size_t i = 0; i < std::size(expected); ++i)
        EXPECT_EQ(elementSymbol(molecule.atoms.at(i).element), expected[i]) << i;
    EXPECT_EQ(molecule.atoms.at(7).element, 0);
    ASSERT_EQ(molecule.warnings.size(), 1u);
    EXPECT_EQ(molecule.warnings[0], "atoms of unknown element: 1, the first 'X' in line 10");
    EXPECT_TRUE(molecule.atoms[3].name == Name("Fe"));
}

TEST(ReadXyz, FramesByNumber) {
    const std::string three = "1\nfirst\nC 0 0 0\n2\nsecond\nN 1 0 0\nN 2 0 0\n\n\n1\nthird\nO 0 0 9\n";
    ReadOptions options;
    for (int frame = 1; frame <= 3; ++frame) {
        options.model = frame;
        const Molecule molecule = readMolecule("a.xyz", three, options);
        EXPECT_EQ(molecule.file.models, 3);
        EXPECT_EQ(molecule.file.totalAtomsAllModels, 4);
        EXPECT_EQ(molecule.atoms.size(), frame == 2 ? 2u : 1u);
        EXPECT_EQ(molecule.file.title, frame == 1 ? "first" : frame == 2 ? "second" : "third");
        EXPECT_TRUE(molecule.warnings.empty());
    }
    options.model = 4;
    test::expectError("a.xyz", three, {"no frame 4; the file has 3"}, options);
}

TEST(ReadXyz, AFrameCutShortIsAnErrorOnlyIfItIsAskedFor) {
    const std::string cut = "1\nfirst\nC 0 0 0\n2\nsecond\nN 1 0 0\n";
    const Molecule molecule = readMolecule("a.xyz", cut);
    EXPECT_EQ(molecule.file.models, 1);
    EXPECT_EQ(molecule.warnings.size(), 1u);
    test::expectError("a.xyz", cut, {"ends after 1 of 2 atoms"}, {.model = 2});
    EXPECT_EQ(readMolecule("a.xyz", "1\nfirst\nC 0 0 0\nsome remark\n").warnings.size(), 1u);
}

TEST(ReadXyz, ExtendedColumns) {
    const Molecule molecule = readMolecule(
        "a.xyz",
        "1\nLattice=\"9 0 0 0 9 0 0 0 9\" Properties=\"id:I:1:pos:R:3:species:S:1\" pbc=\"T T T\"\n77 1 2 3 Mg\n");
    EXPECT_EQ(elementSymbol(molecule.atoms.at(0).element), "Mg");
    EXPECT_FLOAT_EQ(molecule.atoms[0].position.z, 3);
    const Molecule numbers = readMolecule("a.xyz", "1\nProperties=Z:I:1:pos:R:3\n12 1 2 3\n");
    EXPECT_EQ(elementSymbol(numbers.atoms.at(0).element), "Mg");
    for (const char* bad : {"Properties=", "Properties=species:S:1:pos:R:ff",
                            "Properties=species:S:1:pos:R:3:x:R:99999", "Properties=species:S:1", "Properties=::::"}) {
        const Molecule usual = readMolecule("a.xyz", std::string("1\n") + bad + "\nC 1 2 3\n");
        EXPECT_FLOAT_EQ(usual.atoms.at(0).position.x, 1) << bad;
        EXPECT_EQ(usual.warnings.size(), 1u) << bad;
    }
}

// The extended XYZ specification's old and new lists.
TEST(ReadXyz, LatticesInEveryForm) {
    for (const char* lattice :
         {"Lattice=\"4 0 0 0 5 0 0 0 6\" pbc=\"T T F\"", "lattice='4 0 0 0 5 0 0 0 6' pbc='T T F'",
          "Lattice={4 0 0 0 5 0 0 0 6} pbc={1 1 0}", "Lattice=[[4, 0, 0], [0, 5, 0], [0, 0, 6]] pbc=[T, T, F]",
          "Lattice=\"[[4, 0, 0], [0, 5, 0], [0, 0, 6]]\" pbc=\"[True, True, False]\""}) {
        SCOPED_TRACE(lattice);
        const Molecule read = readMolecule("a.xyz", "1\n" + std::string(lattice) + "\nC 0 0 0\n");
        ASSERT_TRUE(read.file.box.has_value());
        EXPECT_EQ((*read.file.box)[1], glm::vec3(0, 5, 0));
        EXPECT_EQ((*read.file.box)[2], glm::vec3(0, 0, 6));
        EXPECT_EQ(read.file.boxRepeats, (std::array<bool, 3>{true, true, false}));
    }
}

TEST(ReadXyz, WhatIsWrongIsSaidWithItsLine) {
    for (const char* number : {"nan", "inf", "-inf", "1e400", "1e12", "abc", "0x10", "1,5", "--1"})
        test::expectError("a.xyz", std::string("1\n\nC 0 ") + number + " 0\n", {"(line 3)", "invalid y coordinate"});
    test::expectError("a.xyz", "1\n\nC 0 0\n", {"(line 3)", "three coordinates"});
    test::expectError("a.xyz", "1\n\n\n", {"(line 3)", "three coordinates"});
    test::expectError("a.xyz", "1\n", {"ends after 0 of 1"});
    test::expectError("a.xyz", "0\nnothing\n", {"no atoms"});
    test::expectError("a.xyz", "\n \n", {"no frames"});
    test::expectError("a.xyz", "-3\n\nC 0 0 0\n", {"(line 1)", "expected a number of atoms"});
    test::expectError("a.xyz", "2147483648\n\nC 0 0 0\n", {"(line 1)", "but does not have as many"});
    test::expectError("a.xyz", "100000000000000000000\n\nC 0 0 0\n", {"(line 1)", "but does not have as many"});
    EXPECT_EQ(readMolecule("a.xyz", std::string("1\n\nC\0 0 0 0\n", 12)).atoms.at(0).element, 0);
    test::expectError("a.xyz", std::string("1\n\nC 0\0 0 0\n", 12), {"(line 3)", "0\\x00"});
}

}  // namespace
}  // namespace nacre
