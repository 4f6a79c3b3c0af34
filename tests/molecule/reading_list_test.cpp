// The list of what was read names records that no picture shows.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "engine/molecule/molecule.h"
#include "engine/molecule/read.h"

namespace nacre {
namespace {

std::int64_t passedOver(const Molecule& molecule, std::string_view what) {
    std::int64_t count = 0;
    for (const ReadNote& note : molecule.notes)
        if (note.action == ReadAction::unused && note.what == what) count += note.count;
    return count;
}

std::string seedText(const char* file) {
    std::ifstream stream(std::string(NACRE_SOURCE_DIR "/tests/fuzz/seeds/") + file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
}

TEST(PassedOver, RecordsOfPdb) {
    const Molecule read = readMolecule(
        "a.pdb",
        "SEQRES   1 A    2  CYS CYS\nSSBOND   1 CYS A    1    CYS A    2                          1555   1555  2.03\n"
        "LINK         O   GLY A  49                NA    NA A6001     1555   1555  2.98\n"
        "LINK         O   ALA A  51                NA    NA A6001     1555   1555  2.72\n"
        "CISPEP   1 GLY A  116    GLY A  117          0        18.50\n"
        "ATOM      1  SG  CYS A   1       0.000   0.000   0.000  1.00  0.00           S\n");
    EXPECT_EQ(passedOver(read, "links"), 2);
    EXPECT_EQ(passedOver(read, "disulphide bridges"), 1);
    EXPECT_EQ(passedOver(read, "cis peptides"), 1);
    EXPECT_EQ(passedOver(read, "lines of sequences"), 1);
    EXPECT_TRUE(read.warnings.empty());
}

TEST(PassedOver, PropertiesOfSdf) {
    const Molecule read = readMolecule(
        "a.sdf",
        "x\n\n\n  2  1  0  0  0  0  0  0  0  0999 V2000\n    0.0000    0.0000    0.0000 C   0  0\n"
        "    1.4000    0.0000    0.0000 O   0  0\n  1  2  1  0\nM  ISO  2   1  13   2  18\nM  RAD  1   1   2\n"
        "M  CHG  1   2 999\nM  END\n> <NAME>\nx\n\n>  <MASS>\n1\n\n$$$$\n");
    EXPECT_EQ(passedOver(read, "isotopes"), 2);
    EXPECT_EQ(passedOver(read, "radicals"), 1);
    EXPECT_EQ(passedOver(read, "data items"), 2);
    ASSERT_EQ(read.warnings.size(), 1u);
    EXPECT_EQ(read.warnings[0], "left out 1 charge, line 10: not usable");
}

TEST(PassedOver, SectionsOfMol2) {
    const Molecule read = readMolecule("a.mol2",
                                       "@<TRIPOS>MOLECULE\nx\n1 0\nSMALL\nNO_CHARGES\n@<TRIPOS>ATOM\n1 C 0 0 0 C.3\n"
                                       "@<TRIPOS>CRYSIN\n5.5 6.5 7.5 90 95 100 14 1\n@<TRIPOS>SET\nA STATIC\n");
    EXPECT_EQ(passedOver(read, "further sections"), 1);
    ASSERT_TRUE(read.file.cell.has_value());
    EXPECT_EQ(*read.file.cell, (std::array<double, 6>{5.5, 6.5, 7.5, 90, 95, 100}));
}

TEST(PassedOver, ColumnsOfMae) {
    const std::string text = seedText("water.mae");
    const Molecule read = readMolecule("a.mae", replaced(text, " m_bond[2]",
                                                         " m_depend[1] {\n  i_m_x\n  :::\n  1 2\n"
                                                         "  :::\n }\n m_bond[2]"));
    EXPECT_EQ(passedOver(read, "further columns"), 1) << "i_m_mmod_type";
    EXPECT_EQ(passedOver(read, "further tables"), 1);
}

TEST(PassedOver, TermsOfTopologies) {
    const std::string none = "       2       0       0       0       0       0       0       0";
    const std::string some = "       2       0       1       2       3       4       0       0";  // angles, dihedrals
    const Molecule amber = readMolecule("a.prmtop", replaced(seedText("water.prmtop"), none, some));
    EXPECT_EQ(passedOver(amber, "angles"), 3) << "one of them with hydrogen";
    EXPECT_EQ(passedOver(amber, "dihedrals"), 7);
}

}  // namespace
}  // namespace nacre
