// PQR and PDBQT: PDB lines with charges, made for electrostatics and for docking.
#include <gtest/gtest.h>

#include "tests/molecule/expect_error.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

TEST(ReadPqr, WordsInEveryArrangement) {
    struct Case {
        const char* line;
        const char* chain;
        int number;
        char insertionCode;
    };
    const Case cases[] = {
        {"ATOM      1  CA  MET    12     -68.369 -25.337  40.428 -0.3200 2.0000\n", "", 12, '\0'},
        {"ATOM      1  CA  MET A  12     -68.369 -25.337  40.428 -0.3200 2.0000\n", "A", 12, '\0'},
        {"ATOM      1  CA  MET A  12B    -68.369 -25.337  40.428 -0.3200 2.0000\n", "A", 12, 'B'},
        {"ATOM      1  CA  MET A1012     -68.369 -25.337  40.428 -0.3200 2.0000\n", "A", 1012, '\0'},
        {"ATOM 1 CA MET A 12 -68.369 -25.337 40.428 -0.32 2.0\n", "A", 12, '\0'},
        {"ATOM      1  CA  MET A -12     -68.369 -25.337  40.428 -0.3200 2.0000\n", "A", -12, '\0'},
        {"HETATM    1  CA  MET    12    -68.369-25.337   40.428 -0.3200 2.0000\n", "", 12, '\0'},
        // Coordinates that touch are told apart by their columns.
        {"ATOM      1  CA  MET A  12     -68.369 -25.337-140.428 -0.3200 2.0000\n", "A", 12, '\0'},
    };
    for (const Case& given : cases) {
        SCOPED_TRACE(given.line);
        const Molecule molecule = readMolecule("a.pqr", given.line);
        EXPECT_EQ(molecule.file.format, "pqr");
        EXPECT_FLOAT_EQ(molecule.atoms[0].position.x, -68.369f);
        EXPECT_FLOAT_EQ(std::abs(std::abs(molecule.atoms[0].position.z) - 90.428f), 50.0f);
        EXPECT_EQ(molecule.atoms[0].element, 6);
        EXPECT_EQ(molecule.partialCharges, std::vector<float>{-0.32f});
        EXPECT_EQ(molecule.radii, std::vector<float>{2.0f});
        EXPECT_EQ(molecule.chains[0].name, given.chain);
        EXPECT_EQ(molecule.residues[0].number, given.number);
        EXPECT_EQ(molecule.residues[0].insertionCode, given.insertionCode);
    }
}

TEST(ReadPqr, Elements) {
    const auto element = [](const std::string& line) { return readMolecule("a.pqr", line).atoms[0].element; };
    EXPECT_EQ(element("ATOM      1 NA    NA     1       1.000   1.000   1.000  1.0000 1.8680\n"), 11);
    EXPECT_EQ(element("ATOM 1 NA NA 1 1.0 1.0 1.0 1.0 1.8\n"), 11);
    EXPECT_EQ(element("ATOM 1 CL1 LIG 1 1.0 1.0 1.0 1.0 1.8\n"), 17);
    EXPECT_EQ(element("ATOM      1 HH11 ARG     1       1.000   1.000   1.000  1.0000 0.8680\n"), 1);
    EXPECT_EQ(element("ATOM      1  NA  HEM     1       1.000   1.000   1.000  1.0000 1.8680\n"), 7);
}

TEST(ReadPqr, ConectInsideAModelIsThatModelsAlone) {
    const std::string a = "ATOM 1 CA LIG A 12 0 0 0 0.1 2.0\n", b = "ATOM 2 CB LIG A 12 9 0 0 0.1 2.0\n",
                      c = "ATOM 3 CG LIG A 12 18 0 0 0.1 2.0\n";
    const std::string text =
        "MODEL 1\n" + a + b + c + "CONECT    1    2\nENDMDL\nMODEL 2\n" + a + b + c + "CONECT    2    3\nENDMDL\n";
    for (const auto& [options, first] : {std::pair(ReadOptions(), 0u), std::pair(ReadOptions{.model = 2}, 1u)}) {
        const Molecule molecule = readMolecule("a.pqr", text, options);
        ASSERT_EQ(molecule.bonds.size(), 1u);
        EXPECT_EQ(molecule.bonds[0].a, first);
        EXPECT_EQ(molecule.file.conectUniquePairs, 1);
        // After the models they are everyone's.
        EXPECT_EQ(readMolecule("a.pqr", text + "CONECT    1    3\n", options).bonds.size(), 2u);
    }
}

TEST(ReadPqr, ModelsConectAndFaults) {
    const std::string atom = "ATOM      1  CA  LIG A  12     -68.369 -25.337  40.428 -0.3200 2.0000\n";
    const std::string other = "ATOM      2  CB  LIG A  12     -67.369 -25.337  40.428  0.3200 2.0000\n";
    const Molecule molecule =
        readMolecule("a", "MODEL 1\n" + atom + other + "ENDMDL\nMODEL 2\n" + atom + "ENDMDL\nCONECT    1    2\n");
    EXPECT_EQ(molecule.file.models, 2);
    EXPECT_EQ(molecule.file.totalAtomsAllModels, 3);
    EXPECT_EQ(molecule.file.conectUniquePairs, 1);
    test::expectLeftOut("a.pqr", atom + "ATOM 2 CB LIG A 12 nan 0 0 0 1\n",
                        "left out 1 atom, line 2: no usable coordinates");
    test::expectLeftOut("a.pqr", atom + "ATOM 2 CB LIG A 12 0 0 0 inf 1\n",
                        "left out 1 charge, line 2: not usable numbers, read as 0");
    test::expectLeftOut("a.pqr", atom + "ATOM 2 CB LIG A 12 0 0 0 1 -1\n",
                        "left out 1 radius, line 2: not usable numbers, read as 0");
    test::expectError("a.pqr", "REMARK nothing\n", {"no ATOM or HETATM"});
}

TEST(ReadPdbqt, TypesAndCharges) {
    struct Case {
        const char *name, *type;
        int element;
    };
    const Case cases[] = {{" C1 ", "A ", 6},  {" N1 ", "NA", 7},  {" O1 ", "OA", 8},
                          {" H1 ", "HD", 1},  {" S1 ", "SA", 16}, {"CL1 ", "Cl", 17},
                          {"CL1 ", "CL", 17}, {"ZN  ", "Zn", 30}, {"NA  ", "Na", 11}};
    for (const Case& given : cases) {
        const std::string line = "ATOM      1 " + std::string(given.name) +
                                 " DXC     1       2.952   1.919   1.076  1.00  0.00    -0.118 " + given.type + "\n";
        const Molecule molecule = readMolecule("a", line);
        EXPECT_EQ(molecule.file.format, "pdbqt");
        EXPECT_EQ(molecule.atoms[0].element, given.element) << line;
        EXPECT_EQ(molecule.partialCharges, std::vector<float>{-0.118f});
        EXPECT_EQ(molecule.atoms[0].charge, 0);
    }
}

TEST(ReadPdbqt, PosesByModel) {
    NACRE_NEEDS_DATA();
    ReadOptions options{.model = 2};
    const Molecule pose = readMoleculeFile(test::dataFile("small/dxc.pdbqt"), options);
    EXPECT_EQ(pose.atoms.size(), 30u);
    EXPECT_EQ(pose.partialCharges.size(), 30u);
    EXPECT_EQ(pose.atoms[0].position, glm::vec3(0.836f, 1.258f, -3.074f));
    // Deoxycholate: 24 carbons, 4 oxygens and the two hydrogens on oxygen.
    int carbons = 0;
    for (const Atom& atom : pose.atoms) carbons += atom.element == 6;
    EXPECT_EQ(carbons, 24);
    options.model = 10;
    EXPECT_THROW(readMoleculeFile(test::dataFile("small/dxc.pdbqt"), options), Error);
}

}  // namespace
}  // namespace nacre
