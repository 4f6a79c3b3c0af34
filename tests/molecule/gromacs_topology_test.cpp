// GROMACS topologies: molecule types, their copies, and the preprocessor.
#include <gtest/gtest.h>

#include <string>

#include "tests/molecule/expect_error.h"

namespace nacre {
namespace {

const std::string kTypes = R"(; types of a force field
[ defaults ]
1 2 yes 0.5 0.8333
[ atomtypes ]
opls_135 CT 6 12.011 -0.18 A 0.35 0.276
HC 1 1.008 0.06 A 0.25 0.125
MW 0 0.0 0.0 D 0 0
)";
/// Two residues, of carbon and hydrogen.
const std::string kChain = R"([ moleculetype ]
Chain_A 3
[ atoms ]
1 opls_135 7  ALA CB 1
2 HC       7  ALA HB 1 0.25 4.032
3 opls_135 8A GLY CA 2 ; with the type's charge and mass
[bonds]
1 2 1 0.1 2000
1 3 \
  1
2 3 6 0.5 1000
)";
const std::string kIon = "[ moleculetype ]\nNA 1\n[ atoms ]\n1 Na+ 1 NA NA 1 1.0 22.99\n";

Molecule read(const std::string& text) { return readMolecule("a.top", text); }

TEST(GromacsTopology, Water) {
    const Molecule water = readMoleculeFile(NACRE_SOURCE_DIR "/tests/fuzz/seeds/water.top");
    EXPECT_EQ(water.file.format, "top");
    EXPECT_EQ(water.file.title, "A water");
    EXPECT_TRUE(water.lacksPositions);
    ASSERT_EQ(water.atoms.size(), 3u);
    EXPECT_EQ(water.atoms[0].element, 8);
    EXPECT_EQ(water.atoms[2].element, 1);
    EXPECT_EQ(water.partialCharges, (std::vector<float>{-0.834f, 0.417f, 0.417f}));
    ASSERT_EQ(water.bonds.size(), 2u);  // the oxygen to each hydrogen
    EXPECT_EQ(water.bonds[1].a, 0u);
    EXPECT_EQ(water.bonds[1].b, 2u);
    const auto include = std::ranges::find(water.notes, "included files", &ReadNote::what);
    ASSERT_NE(include, water.notes.end());
    EXPECT_EQ(include->count, 1);
}

TEST(GromacsTopology, CopiesOfMolecules) {
    const Molecule all = read(kTypes + kChain + kIon + "[ system ]\nx\n[ molecules ]\nChain_A 2\nNA 3\n");
    ASSERT_EQ(all.atoms.size(), 9u);
    EXPECT_EQ(all.bonds.size(), 4u);  // without the restraint
    ASSERT_EQ(all.chains.size(), 3u);
    EXPECT_EQ(all.chains[0].name, "A");
    EXPECT_EQ(all.chains[1].name, "B");
    ASSERT_EQ(all.residues.size(), 7u);
    EXPECT_EQ(all.residues[1].number, 8);
    EXPECT_EQ(all.residues[1].insertionCode, 'A');
    EXPECT_EQ(all.residues[4].number, 9);  // ions are numbered on from the chains
    EXPECT_EQ(all.residues[6].number, 11);
    EXPECT_EQ(all.bonds[2].a, 3u);
    EXPECT_EQ(all.atoms[1].element, 1);  // by the type's atomic number, in spite of its mass
    EXPECT_EQ(all.atoms[8].element, 11);
    EXPECT_FLOAT_EQ(all.masses[1], 4.032f);
    EXPECT_FLOAT_EQ(all.masses[2], 12.011f);
    EXPECT_FLOAT_EQ(all.partialCharges[2], -0.18f);
    EXPECT_EQ(all.types[2].view(), "opls_135");
}

TEST(GromacsTopology, MoleculesOfOneResidueStayApart) {
    const Molecule apart = read(kIon + "[ molecules ]\nNA 1\nNA 2\n");
    ASSERT_EQ(apart.residues.size(), 3u);
    EXPECT_EQ(apart.residues[2].number, 3);
}

TEST(GromacsTopology, OneOfEachTypeWithoutNumbers) {
    const Molecule one = readMolecule("a.itp", kIon + "[ moleculetype ]\nW 1\n[ atoms ]\n1 P4 1 W W 1 0\n");
    EXPECT_EQ(one.atoms.size(), 2u);
    EXPECT_FLOAT_EQ(one.masses[1], 0);  // not stated
}

TEST(GromacsTopology, VirtualSitesHaveNoElement) {
    const Molecule site = read(kTypes + "[ moleculetype ]\nM 1\n[ atoms ]\n1 MW 1 SOL MW 1 -1\n2 HC 1 SOL HW 1\n");
    EXPECT_EQ(site.atoms[0].element, 0);
    EXPECT_EQ(site.atoms[1].element, 1);
}

TEST(GromacsTopology, Conditions) {
    const std::string bonds = "[ bonds ]\n1 2\n#ifdef LONG\n1 3\n#ifdef NEVER\n2 3\n#endif\n#else\n2 3\n#endif\n";
    const std::string head = "[ moleculetype ]\nM 1\n[ atoms ]\n1 C 1 M C 1\n2 C 1 M D 1\n3 C 1 M E 1\n";
    const auto last = [&](const std::string& defines) { return read(defines + head + bonds).bonds.back(); };
    EXPECT_EQ(last("").a, 1u);
    EXPECT_EQ(last("#define LONG\n").a, 0u);
    EXPECT_EQ(last("#define LONG\n#undef LONG\n").a, 1u);
    EXPECT_EQ(read("#define LONG\n" + head + bonds).bonds.size(), 2u);
}

TEST(GromacsTopology, Faults) {
    test::expectError(
        "a.top", "#include \"amber.ff/forcefield.itp\"\n" + kIon + "[ molecules ]\nNA 1\nSOL 9\n",
        {"(line 8)", "it does not define molecule type 'SOL'", "includes 'amber.ff/forcefield.itp'", "gmx grompp -pp"});
    test::expectError("a.top", "#include \"a.itp\"\n[ system ]\nx\n", {"(line 1)", "it has no [ moleculetype ]"});
    test::expectError("a.top", kIon + "[ molecules ]\nNA 99999999999\n", {"more than 50000000 atoms"});
    test::expectError("a.top", kIon + "[ molecules ]\nNA 30000000\nNA 30000000\n", {"more than 50000000 atoms"});
    test::expectError("a.top", kIon + "[ molecules ]\nNA -1\n",
                      {"(line 6)", "expected a number of molecules after 'NA'"});
    test::expectError("a.top", kIon + kIon, {"(line 6)", "molecule type 'NA' is defined twice"});
    test::expectError("a.top", kIon + "3 Na+ 1 NA NA 1 1.0 22.99\n", {"(line 5)", "expected atom 2, not '3'"});
    test::expectError("a.top", kIon + "2 Na+ 1 NA NA 1 plus\n", {"(line 5)", "charge and mass, not 'plus'"});
    test::expectError("a.top", kIon + "#ifdef X\n", {"it ends within #ifdef"});
    test::expectError("a.top", kIon + "#endif\n", {"(line 5)", "#endif has no #ifdef"});
    std::string manyBonds = kIon + "2 Na+ 1 NA NB 1\n[ bonds ]\n";
    for (int i = 0; i < 100; ++i) manyBonds += "1 2\n1 9\n";
    EXPECT_EQ(read(manyBonds + "[ molecules ]\nNA 1000\n").bonds.size(), 1000u);
    test::expectLeftOut("a.top", kIon + "[ bonds ]\n1 1\n[ molecules ]\nNA 9\n",
                        "left out 1 bond, line 6: of an atom to itself");
    test::expectLeftOut("a.top", kIon + "[ bonds ]\n1 7\n", "left out 1 bond, line 6: of atoms that are not there");
}

}  // namespace
}  // namespace nacre
