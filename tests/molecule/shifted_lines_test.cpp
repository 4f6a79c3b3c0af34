// Atom lines of PDB and GRO files whose fields are not in their columns.
#include <gtest/gtest.h>

#include <string>

#include "engine/molecule/molecule.h"
#include "engine/molecule/read.h"
#include "engine/molecule/text.h"

namespace nacre {
namespace {

Molecule readLine(const std::string& line) { return readMolecule("a.pdb", line + "\n"); }

TEST(ShiftedLines, AreReadByTheirWords) {
    for (const char* line : {
             "ATOM   1234  CA  ALA A 123      11.104 -22.134  33.504  0.50  9.50           C",
             "ATOM  1234  CA  ALA A 123      11.104 -22.134  33.504  0.50  9.50           C",  // a blank is lost
             "ATOM   1234  CA ALA A 123      11.104 -22.134  33.504  0.50  9.50           C",
             "ATOM   1234  CA  ALAA 123      11.104 -22.134  33.504  0.50  9.50           C",
             "ATOM   1234  CA  ALA A 123    11.104 -22.134  33.504  0.50  9.50           C",
             "ATOM    1234  CA  ALA A 123      11.104 -22.134  33.504  0.50  9.50           C",  // one too many
             "ATOM   1234  CA   ALA A 123      11.104 -22.134  33.504  0.50  9.50           C",
             "ATOM   1234  CA  ALA A  123      11.104 -22.134  33.504  0.50  9.50           C",
             "ATOM   1234  CA  ALA AA 123      11.104 -22.134  33.504  0.50  9.50           C",
             "ATOM 1234 CA ALA A 123 11.104 -22.134 33.504 0.50 9.50 C",
             "ATOM\t1234\tCA\tALA\tA\t123\t11.104\t-22.134\t33.504\t0.50\t9.50\tC",
         }) {
        SCOPED_TRACE(line);
        const Molecule read = readLine(line);
        ASSERT_EQ(read.atoms.size(), 1u);
        const Atom& atom = read.atoms[0];
        EXPECT_EQ(atom.position, glm::vec3(11.104f, -22.134f, 33.504f));
        EXPECT_EQ(atom.name.view(), "CA");
        EXPECT_EQ(atom.element, 6);
        EXPECT_FLOAT_EQ(atom.occupancy, 0.5f);
        EXPECT_FLOAT_EQ(atom.temperatureFactor, 9.5f);
        EXPECT_EQ(read.residues[0].name.view(), "ALA");
        EXPECT_EQ(read.residues[0].number, 123);
        EXPECT_EQ(read.chains[0].name, "A");
        EXPECT_TRUE(read.warnings.empty());
    }
}

TEST(ShiftedLines, KeepElementsOfTwoLetters) {
    const Molecule zinc = readLine("HETATM  123 ZN    ZN A 301      11.104  22.134  33.504  1.00  9.50          ZN");
    const Molecule lost = readLine("HETATM  123 ZN   ZN A 301      11.104  22.134  33.504  1.00  9.50          ZN");
    EXPECT_EQ(zinc.atoms[0].element, 30);
    EXPECT_EQ(lost.atoms[0].element, 30) << "no nitrogen";
    EXPECT_EQ(lost.residues[0].name.view(), "ZN");
    EXPECT_EQ(lost.residues[0].number, 301);
    const Molecule early = readLine("HETATM  12 SOD  SOD A 12345     1.104   2.134   3.504  1.00  9.50           S");
    EXPECT_EQ(early.atoms[0].name.view(), "SOD");
    EXPECT_EQ(early.atoms[0].element, 11);
    EXPECT_EQ(early.residues[0].number, 12345);
}

TEST(ShiftedLines, NamesOfMoreLettersThanTheirColumns) {
    const Molecule atom = readLine("ATOM   1234  CA10 ALA A 123      11.104  22.134  33.504  1.00  9.50           C");
    EXPECT_EQ(atom.atoms[0].name.view(), "CA10");
    EXPECT_EQ(atom.residues[0].number, 123);
    const Molecule residue =
        readLine("ATOM   1234  CA  NALA A 123      11.104  22.134  33.504  1.00  9.50           C");
    EXPECT_EQ(residue.residues[0].name.view(), "NALA");
    EXPECT_EQ(residue.residues[0].number, 123);
    EXPECT_EQ(residue.chains[0].name, "A");
    const Molecule number = readLine("ATOM   1234  CA  ALA A123456    11.104  22.134  33.504  1.00  9.50           C");
    EXPECT_EQ(number.residues[0].number, 123456);
}

// As Python's ('%8.3f' % 22222.134)[:8] writes it, which OpenMM does.
TEST(ShiftedLines, NumbersCutAfterEightCharactersKeepTheColumns) {
    const Molecule cut = readLine("ATOM   1234  CA  ALA A 123    11111.1022222.1333333.50  1.00  9.50           C");
    EXPECT_EQ(cut.atoms[0].position, glm::vec3(11111.10f, 22222.13f, 33333.50f));
    const Molecule wide = readLine("ATOM   1234  CA  ALA A 123    11111.10422222.13433333.504  1.00  9.50           C");
    EXPECT_EQ(wide.atoms[0].position, glm::vec3(11111.104f, 22222.134f, 33333.504f));
}

TEST(ShiftedLines, ResiduesWithStarsForNumbers) {
    std::string text;
    for (int i = 0; i < 9; ++i)
        text += "ATOM  *****  " +
                std::string(i % 3 == 0   ? "OW "
                            : i % 3 == 1 ? "HW1"
                                         : "HW2") +
                " SOL A****      11.104  22.134  33.504  1.00  9.50\n";
    EXPECT_EQ(readMolecule("a.pdb", text).residues.size(), 3u);
}

// VMD writes numbers beyond 9999 with "%4x".
TEST(ShiftedLines, NumbersInBaseSixteen) {
    std::string text;
    for (int number = 9995; number < 10020; ++number) {
        text += formatted(number > 9999 ? "ATOM  %5d  OH2 TIP3W%4x    %8.3f   0.000   0.000\n"
                                        : "ATOM  %5d  OH2 TIP3W%4d    %8.3f   0.000   0.000\n",
                          number, number, 3.0 * number);
    }
    const Molecule waters = readMolecule("a.pdb", text);
    ASSERT_EQ(waters.residues.size(), 25u);
    for (std::size_t i = 0; i < waters.residues.size(); ++i)
        EXPECT_EQ(waters.residues[i].number, 9995 + static_cast<int>(i));
}

TEST(ShiftedLines, IonsWithoutNumbersOfTheirOwn) {
    std::string text;
    for (int i = 0; i < 6; ++i)
        text += "HETATM    1 " + std::string(i < 3 ? " SOD SOD" : " CLA CLA") +
                " A   1      11.104  22.134  33.504  1.00  9.50\n";
    const Molecule ions = readMolecule("a.pdb", text);
    ASSERT_EQ(ions.residues.size(), 2u);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(ions.atoms[i].element, i < 3 ? 11 : 17);
}

TEST(ShiftedLines, OfGroThatLostABlank) {
    const Molecule water = readMolecule("a.gro",
                                        "water\n    3\n"
                                        "    1SOL     OW    1   0.100   0.500   0.500\n"
                                        "   1SOL    HW1    2   0.195   0.500   0.500\n"
                                        "    1SOL    HW2    3   0.060   0.590   0.500\n"
                                        "   3.0 3.0 3.0\n");
    ASSERT_EQ(water.atoms.size(), 3u);
    EXPECT_EQ(water.residues.size(), 1u);
    EXPECT_EQ(water.atoms[1].name.view(), "HW1");
    EXPECT_NEAR(water.atoms[1].position.x, 1.95, 1e-5);
}

}  // namespace
}  // namespace nacre
