#include <gtest/gtest.h>

#include "tests/molecule/expect_error.h"

namespace nacre {
namespace {

const std::string kAtom = "    1THR     CA    1   1.705  -1.410   0.363  0.1000 -0.2000  0.3000\n";

std::string frame(const std::string& atoms, int count, const std::string& box = "   1.00000   2.00000   3.00000\n") {
    return "title\n" + std::to_string(count) + "\n" + atoms + box;
}

TEST(ReadGro, NanometresBecomeAngstrom) {
    const Molecule molecule = readMolecule("a", frame(kAtom, 1));
    EXPECT_EQ(molecule.atoms[0].position, glm::vec3(17.05f, -14.1f, 3.63f));
    EXPECT_EQ(molecule.atoms[0].name.view(), "CA");
    EXPECT_EQ(molecule.atoms[0].element, 6);
    EXPECT_EQ(molecule.residues[0].name.view(), "THR");
    EXPECT_EQ(molecule.file.title, "title");
    ASSERT_TRUE(molecule.file.box);
    EXPECT_EQ((*molecule.file.box)[1], glm::vec3(0, 20, 0));
}

TEST(ReadGro, MoreDigits) {
    const Molecule molecule = readMolecule("a.gro", frame("    1THR     CA    1   1.70512  -1.41034   0.36356\n", 1));
    EXPECT_EQ(molecule.atoms[0].position, glm::vec3(17.0512f, -14.1034f, 3.6356f));
}

TEST(ReadGro, SlantedBoxAndNone) {
    const Molecule slanted = readMolecule("a", frame(kAtom, 1, "1 2 3 .1 .2 .3 .4 .5 .6\n"));
    ASSERT_TRUE(slanted.file.box);
    const auto& box = *slanted.file.box;
    EXPECT_EQ(box[0], glm::vec3(10, 1, 2));
    EXPECT_EQ(box[1], glm::vec3(3, 20, 4));
    EXPECT_EQ(box[2], glm::vec3(5, 6, 30));
    EXPECT_FALSE(readMolecule("a", frame(kAtom, 1, "0 0 0\n")).file.box);
    const Molecule without = readMolecule("a", frame(kAtom, 1, ""));
    EXPECT_FALSE(without.file.box);
    ASSERT_EQ(without.warnings.size(), 1u);
}

TEST(ReadGro, NumbersWrap) {
    std::string atoms;
    for (const char* number : {"99998", "99999", "    0", "    1"})
        atoms += std::string(number) + "SOL     OW99999   1.000   2.000   3.000\n";
    const Molecule molecule = readMolecule("a", frame(atoms, 4));
    ASSERT_EQ(molecule.residues.size(), 4u);
    EXPECT_EQ(molecule.residues[1].number, 99999);
    EXPECT_EQ(molecule.residues[2].number, 100000);
    EXPECT_EQ(molecule.residues[3].number, 100001);
    // A second chain that starts again is no wrap.
    const std::string again = "   46ASN      N    1   1.0     2.0     3.0\n";
    EXPECT_EQ(readMolecule("a", frame(again + kAtom, 2)).residues[1].number, 1);
}

TEST(ReadGro, ElementsOfNames) {
    struct Case {
        const char *residue, *name;
        int element;
    };
    const Case cases[] = {{"SOL", "OW", 8},   {"SOL", "HW1", 1},  {"CL", "CL", 17},   {"NA", "NA", 11},
                          {"NA+", "NA+", 11}, {"CLA", "CLA", 17}, {"SOD", "SOD", 11}, {"POPC", "C12", 6},
                          {"CA", "CA", 20},   {"HEM", "NA", 7},   {"HEM", "FE", 26},  {"LIG", "CL1", 17},
                          {"LIG", "HO12", 1}, {"SOL", "MW", 0},   {"ZN2", "ZN", 30}};
    for (const Case& given : cases) {
        char line[64];
        std::snprintf(line, sizeof line, "    1%-5s%5s    1   1.000   2.000   3.000\n", given.residue, given.name);
        EXPECT_EQ(readMolecule("a", frame(line, 1)).atoms[0].element, given.element) << line;
    }
}

TEST(ReadGro, Frames) {
    const std::string text = frame(kAtom, 1) + frame(kAtom + kAtom, 2) + "\n\n";
    ReadOptions options{.model = 2};
    const Molecule second = readMolecule("a", text, options);
    EXPECT_EQ(second.atoms.size(), 2u);
    EXPECT_EQ(second.file.models, 2);
    EXPECT_EQ(second.file.totalAtomsAllModels, 3);
    options.model = 3;
    test::expectError("a", text, {"there is no frame 3; the file has 2"}, options);
    // A first frame that is whole is read, with a word about what follows it.
    const Molecule first = readMolecule("a", frame(kAtom, 1) + "cut\n2\n" + kAtom);
    EXPECT_EQ(first.file.models, 1);
    EXPECT_EQ(first.warnings.size(), 1u);
}

TEST(ReadGro, Faults) {
    test::expectError("a.gro", "title\nx\n" + kAtom, {"(line 2)", "a number of atoms"});
    test::expectError("a", frame(kAtom, 1000), {"(line 2)", "states 1000 atoms, but does not have as many"});
    test::expectError("a", "title\n99999999999999999999\n" + kAtom, {"(line 2)", "but does not have as many"});
    test::expectLeftOut("a", frame(kAtom + "    1THR     CA    1   1.705     nan   0.363\n", 2),
                        "left out 1 atom, line 4: no usable coordinates");
    test::expectLeftOut("a", frame(kAtom + kAtom, 3), "left out 1 atom, line 5: no usable coordinates");
    test::expectError("a.gro", "title\n0\n1 1 1\n", {"it has no atoms"});
}

}  // namespace
}  // namespace nacre
