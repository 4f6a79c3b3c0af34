#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/molecule/expect_error.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

std::string mol2(const std::string& counts, const std::string& atoms, const std::string& bonds,
                 const std::string& more = "") {
    return "@<TRIPOS>MOLECULE\nname\n" + counts + "\nSMALL\nNO_CHARGES\n\n@<TRIPOS>ATOM\n" + atoms + "@<TRIPOS>BOND\n" +
           bonds + more;
}

const std::string kTwo = "1 C1 0 0 0 C.ar 1 LIG1 -0.25\n2 O1 1.2 0 0 O.2 1 LIG1 0.5\n";

TEST(ReadMol2, BondTypes) {
    const std::string atoms =
        "1 C1 0 0 0 C.2\n2 C2 1 0 0 C.ar\n3 N 2 0 0 N.am\n4 C4 3 0 0 C.1\n5 O 4 0 0 O.3\n6 X 5 0 0 Du\n";
    const Molecule molecule =
        readMolecule("a", mol2("6 6", atoms, "1 1 2 ar\n2 2 3 am\n3 3 4 2\n4 4 5 3\n5 5 6 un\n6 1 6 nc\n"));
    ASSERT_EQ(molecule.bonds.size(), 5u);  // "nc" says that there is none
    const int orders[] = {4, 1, 2, 3, 1};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(molecule.bonds[i].order, orders[i]) << i;
    EXPECT_EQ(molecule.file.bonds, 6);
    EXPECT_EQ(molecule.atoms[5].element, 0);
}

TEST(ReadMol2, AtomsAreNamedByTheirIds) {
    const Molecule molecule = readMolecule("a", mol2("2 1", "70 C1 0 0 0 C.3\n30 O1 1.2 0 0 O.3\n", "1 30 70 1\n"));
    ASSERT_EQ(molecule.bonds.size(), 1u);
    // Where ids repeat, the place in the list is meant.
    const Molecule repeated =
        readMolecule("a", mol2("3 1", "1 C1 0 0 0 C.3\n1 O1 1.2 0 0 O.3\n1 H 2 0 0 H\n", "1 2 3 1\n"));
    ASSERT_EQ(repeated.bonds.size(), 1u);
    EXPECT_EQ(repeated.bonds[0].a, 1u);
    EXPECT_EQ(repeated.bonds[0].b, 2u);
}

TEST(ReadMol2, ElementsOfTypes) {
    const std::string atoms =
        "1 A 0 0 0 C.cat\n2 B 3 0 0 Cl\n3 C 6 0 0 LP\n4 D 9 0 0 ca\n5 E 12 0 0 cl\n6 F 15 0 0 Ca\n7 G 18 0 0 hn\n"
        "8 H 21 0 0 Co.oh\n";
    const Molecule molecule = readMolecule("a", mol2("8 0", atoms, ""));
    const int expected[] = {6, 17, 0, 6, 17, 20, 1, 27};
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(molecule.atoms[i].element, expected[i]) << i;
    ASSERT_EQ(molecule.warnings.size(), 1u);
    EXPECT_NE(molecule.warnings[0].find("'LP' in line 10"), std::string::npos) << molecule.warnings[0];
}

// AMBER's parm99: CA is an aromatic carbon, OS an ether's oxygen, NB and N* nitrogen. CHARMM: NH1 a peptide's nitrogen,
// SM the sulphur of a disulphide.
TEST(ReadMol2, TypesOfForceFields) {
    const Molecule molecule = readMolecule(
        "a", mol2("8 0",
                  "1 C6 0 0 0 CA 1 LIG\n2 O4' 3 0 0 OS 1 LIG\n3 N7 6 0 0 NB 1 LIG\n4 N9 9 0 0 N* 1 LIG\n"
                  "5 N 12 0 0 NH1 2 ALA\n6 SG 15 0 0 SM 3 CYS\n7 CL1 18 0 0 CL 1 LIG\n8 H5T 21 0 0 HO 1 LIG\n",
                  ""));
    const int expected[] = {6, 8, 7, 7, 7, 16, 17, 1};
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(molecule.atoms[i].element, expected[i]) << i;
    EXPECT_TRUE(molecule.warnings.empty());
}

// Tripos' format: ROOT and LEAF are a substructure's status; LEaP writes them in the column of its type.
TEST(ReadMol2, TheStatusOfASubstructureIsNoName) {
    const Molecule molecule = readMolecule(
        "a", mol2("1 0", "1 CA 0 0 0 C.3 1 LYS\n", "", "@<TRIPOS>SUBSTRUCTURE\n1 LYS 1 RESIDUE 0 **** ROOT 1\n"));
    EXPECT_EQ(molecule.residues[0].name.view(), "LYS");
}

TEST(ReadMol2, EndsOfStrandsKeepTheirNames) {
    const Molecule strand =
        readMolecule("a", mol2("3 0", "1 P 0 0 0 P 1 DA5\n2 P 9 0 0 P 2 DC\n3 P 18 0 0 P 3 DG3\n", ""));
    ASSERT_EQ(strand.residues.size(), 3u);
    EXPECT_EQ(strand.residues[0].name.view(), "DA5");
    EXPECT_EQ(strand.residues[0].number, 1);
    const Molecule numbered = readMolecule("a", mol2("1 0", "1 P 0 0 0 P 5 DA5\n", ""));
    EXPECT_EQ(numbered.residues[0].name.view(), "DA");
    EXPECT_EQ(numbered.residues[0].number, 5);
}

TEST(ReadMol2, ChargesResiduesAndChains) {
    const Molecule plain = readMolecule("a", mol2("2 1", kTwo, "1 1 2 2\n"));
    EXPECT_EQ(plain.partialCharges, (std::vector<float>{-0.25f, 0.5f}));
    EXPECT_EQ(plain.residues[0].name.view(), "LIG1");
    EXPECT_EQ(plain.residues[0].number, 1);
    const std::string atoms = "1 CA 0 0 0 C.3 1 GLY402\n2 CA 3 0 0 C.3 2 ALA403\n3 O 6 0 0 O.3 3 HOH7\n";
    const Molecule named =
        readMolecule("a", mol2("3 0", atoms, "", "@<TRIPOS>SUBSTRUCTURE\n 2 ALA403 2 RESIDUE 4 B ALA 1 **** x\n"));
    ASSERT_EQ(named.residues.size(), 3u);
    EXPECT_EQ(named.residues[0].name.view(), "GLY");
    EXPECT_EQ(named.residues[0].number, 402);
    EXPECT_EQ(named.residues[1].name.view(), "ALA");
    EXPECT_EQ(named.residues[1].number, 403);
    EXPECT_EQ(named.chains[named.residues[1].chain].name, "B");
    EXPECT_EQ(named.residues[2].name.view(), "HOH");
}

TEST(ReadMol2, CommentsBlankLinesAndContinuations) {
    const Molecule molecule =
        readMolecule("a", mol2("2 1", "# first\n1 C1 0 0 0 \\\n  C.3\n\n2 O1 1.2 0 0 O.3\n", "1 1 \\\n2 \\\n 2\n"));
    EXPECT_EQ(molecule.atoms.size(), 2u);
    ASSERT_EQ(molecule.bonds.size(), 1u);
    EXPECT_EQ(molecule.bonds[0].order, 2);
    EXPECT_TRUE(molecule.warnings.empty());
}

TEST(ReadMol2, Faults) {
    test::expectLeftOut("a", mol2("2 1", kTwo, "1 1 3 1\n"), "left out 1 bond, line 11: of atoms that are not there");
    test::expectLeftOut("a", mol2("2 1", kTwo, "1 1 1 1\n"), "left out 1 bond, line 11: of an atom to itself");
    test::expectError("a", mol2("2 1", kTwo, "1 1 2\n"), {"(line 11)", "a bond line needs"});
    test::expectError("a", mol2("3 1", kTwo, "1 1 2 1\n"), {"(line 3)", "states 3 atoms and has 2"});
    test::expectError("a", mol2("x", kTwo, "1 1 2 1\n"), {"(line 3)", "a number of atoms"});
    test::expectError("a", mol2("1 0", "1 C 0 nan 0 C.3\n", ""), {"(line 8)", "invalid y coordinate"});
    test::expectError("a", mol2("1 0", "1 C 0 0\n", ""), {"(line 8)", "an atom line needs"});
    const Molecule fewer = readMolecule("a", mol2("2 4", kTwo, "1 1 2 1\n"));
    ASSERT_EQ(fewer.warnings.size(), 1u);
    EXPECT_NE(fewer.warnings[0].find("4 bonds, and has 2 and 1"), std::string::npos) << fewer.warnings[0];
}

/// What the bonds join, each end by element and place to the nearest 0.1 Å, in an order of its own.
std::vector<std::array<long, 8>> ends(const Molecule& molecule) {
    std::vector<std::array<long, 8>> all;
    for (const Bond& bond : molecule.bonds) {
        std::array<std::array<long, 4>, 2> pair{};
        for (std::size_t end = 0; end < 2; ++end) {
            const Atom& atom = molecule.atoms[end == 0 ? bond.a : bond.b];
            for (int axis = 0; axis < 3; ++axis)
                pair[end][static_cast<std::size_t>(axis)] = std::lround(std::round(atom.position[axis] * 1000) / 100);
            pair[end][3] = atom.element;
        }
        std::sort(pair.begin(), pair.end());
        std::array<long, 8> flat{};
        std::copy(pair[0].begin(), pair[0].end(), flat.begin());
        std::copy(pair[1].begin(), pair[1].end(), flat.begin() + 4);
        all.push_back(flat);
    }
    std::sort(all.begin(), all.end());
    return all;
}

TEST(ReadMol2, EachRecordByItsNumber) {
    NACRE_NEEDS_DATA();
    const std::string path = test::dataFile("small/ligs3d-multi.mol2");
    // The same ten ligands as SDF, from the same source.
    const std::string twin = test::dataFile("small/ligs3d-multi.sdf");
    for (int record = 1; record <= 10; ++record) {
        ReadOptions options{.model = record};
        const Molecule molecule = readMoleculeFile(path, options), same = readMoleculeFile(twin, options);
        ASSERT_EQ(molecule.atoms.size(), same.atoms.size()) << record;
        ASSERT_EQ(molecule.bonds.size(), same.bonds.size()) << record;
        // The atoms stand in another order, so that the ends of the bonds are compared as places.
        EXPECT_EQ(ends(molecule), ends(same)) << record;
    }
    EXPECT_THROW(readMoleculeFile(path, {.model = 11}), Error);
}

}  // namespace
}  // namespace nacre
