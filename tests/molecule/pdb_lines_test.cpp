#include <gtest/gtest.h>

#include <string>

#include "engine/error.h"
#include "engine/molecule/element.h"
#include "engine/molecule/formats/format_table.h"
#include "engine/molecule/formats/pdb_fields.h"
#include "tests/support/error_text.h"

namespace nacre {
namespace {

Molecule readText(const std::string& text, int model = 1) {
    return formatRow(Format::pdb).read("x.pdb", text, {.model = model});
}

const std::string kCarbon = "HETATM    1  C1  LIG A   1       1.000   2.000   3.000  1.00 10.00           C  \n";
const std::string kOxygen = "HETATM    2  O1  LIG A   1       2.200   2.000   3.000  0.50 20.00           O1-\n";

std::string errorOfLines(const std::string& text, int model = 1) {
    return test::errorText([&] { readText(text, model); });
}

std::string readElement(const std::string& name, const std::string& residue) {
    const std::string line = "HETATM    1 " + name + " " + residue + " A   1       1.000   2.000   3.000";
    return std::string(elementSymbol(readText(line).atoms.at(0).element));
}

TEST(PdbLines, FieldsStandInTheirColumns) {
    const Molecule m = readText(
        "TITLE     ONE HALF\nTITLE    2 AND \xff OTHER\n"
        "ATOM     12  CB ASER B -12C     11.123 -22.456  33.789  0.25 -1.50           C2+\n");
    ASSERT_EQ(m.atoms.size(), 1u);
    const Atom& atom = m.atoms[0];
    EXPECT_EQ(m.file.title, "ONE HALF AND ? OTHER");
    EXPECT_FLOAT_EQ(atom.position.x, 11.123f);
    EXPECT_FLOAT_EQ(atom.position.y, -22.456f);
    EXPECT_FLOAT_EQ(atom.position.z, 33.789f);
    EXPECT_FLOAT_EQ(atom.occupancy, 0.25f);
    EXPECT_FLOAT_EQ(atom.temperatureFactor, -1.5f);
    EXPECT_EQ(atom.name.view(), "CB");
    EXPECT_EQ(atom.alternate, 'A');
    EXPECT_EQ(atom.charge, 2);
    EXPECT_FALSE(atom.hetero);
    EXPECT_EQ(m.residues[0].name.view(), "SER");
    EXPECT_EQ(m.residues[0].number, -12);
    EXPECT_EQ(m.residues[0].insertionCode, 'C');
    EXPECT_EQ(m.chains[0].name, "B");
    EXPECT_EQ(readText(kCarbon + kOxygen).atoms[1].charge, -1);
}

TEST(PdbLines, NumbersMayBeHybrid36) {
    EXPECT_EQ(pdb::integer("99999", 5), 99999);
    EXPECT_EQ(pdb::integer("A0000", 5), 100000);
    EXPECT_EQ(pdb::integer("A0001", 5), 100001);
    EXPECT_EQ(pdb::integer("ZZZZZ", 5), 43770015);
    EXPECT_EQ(pdb::integer("a0000", 5), 43770016);
    EXPECT_EQ(pdb::integer("A000", 4), 10000);
    EXPECT_EQ(pdb::integer("-999", 4), -999);
    for (const char* bad : {"", "     ", "*****", "A00", "A00a0", "1A000", "+-1"})
        EXPECT_FALSE(pdb::integer(bad, 5)) << bad;
}

TEST(PdbLines, WideSerialsAreUnderstood) {
    EXPECT_EQ(pdb::serial("ATOM   1234  CA"), 1234);
    EXPECT_EQ(pdb::serial("ATOM  100000 CA"), 100000);
    EXPECT_EQ(pdb::serial("HETATM123456 CA"), 123456);
    EXPECT_FALSE(pdb::serial("ATOM  *****  CA"));
}

TEST(PdbLines, ElementsComeFromTheName) {
    EXPECT_EQ(readElement(" CA ", "ALA"), "C");
    EXPECT_EQ(readElement("CA  ", "ALA"), "C");  // shifted, yet no calcium in alanine
    EXPECT_EQ(readElement("CA  ", " CA"), "Ca");
    EXPECT_EQ(readElement("HG  ", "SER"), "H");
    EXPECT_EQ(readElement("HG  ", " HG"), "Hg");
    EXPECT_EQ(readElement("HE21", "GLN"), "H");
    EXPECT_EQ(readElement("HE21", "LIG"), "H");
    EXPECT_EQ(readElement("1HB ", "ALA"), "H");
    EXPECT_EQ(readElement("1H5'", "LIG"), "H");
    EXPECT_EQ(readElement("SE  ", "MSE"), "Se");
    EXPECT_EQ(readElement("FE  ", "HEM"), "Fe");
    EXPECT_EQ(readElement(" NA ", "HEM"), "N");
    EXPECT_EQ(readElement("CL1 ", "LIG"), "Cl");
    EXPECT_EQ(readElement("CL11", "LIG"), "Cl");
    EXPECT_EQ(readElement("NAC1", "LIG"), "N");
    EXPECT_EQ(readElement("Si  ", "LIG"), "Si");
    EXPECT_EQ(readElement(" SI ", "FIN"), "Si");
    EXPECT_EQ(readElement(" XX ", "LIG"), "X");
}

TEST(PdbLines, OldColumnsAreNoElements) {
    const Molecule m = readText("ATOM      1  CA  ALA A   1       1.000   2.000   3.000  1.00 10.00      1HPV  68\n");
    EXPECT_EQ(m.atoms[0].element, 6);
    EXPECT_EQ(m.atoms[0].charge, 0);
}

TEST(PdbLines, CoordinatesThatAreNoneAreErrorsWithTheirLine) {
    const std::string head = "cannot read molecule: x.pdb (line 2): ";
    const auto withX = [](const std::string& x) {
        return "REMARK\nHETATM    2  O1  LIG A   1    " + x + "   2.000   3.000\n";
    };
    EXPECT_EQ(errorOfLines(withX("     nan")), head + "invalid x coordinate 'nan'");
    EXPECT_EQ(errorOfLines(withX("    -inf")), head + "invalid x coordinate '-inf'");
    EXPECT_EQ(errorOfLines(withX("********")), head + "invalid x coordinate '********'");
    EXPECT_EQ(errorOfLines(withX("  1.0 2 ")), head + "invalid x coordinate '1.0 2'");
    EXPECT_EQ(errorOfLines(withX("   1e999")), head + "invalid x coordinate '1e999'");
    EXPECT_EQ(errorOfLines(withX("        ")), head + "missing x coordinate");
    EXPECT_EQ(errorOfLines("REMARK\nHETATM    2  O1  LIG A   1       1.000   2.000\n"), head + "missing z coordinate");
    EXPECT_EQ(errorOfLines(withX("   1.5e1")), "");
}

TEST(PdbLines, EveryLineEndWillDo) {
    for (const char* end : {"\n", "\r\n", "\r"}) {
        std::string text = kCarbon + kOxygen;
        for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += std::string(end).size())
            text.replace(at, 1, end);
        EXPECT_EQ(readMolecule("x.pdb", text).atoms.size(), 2u);
    }
    EXPECT_EQ(readText(kCarbon + kOxygen.substr(0, 54)).atoms.size(), 2u);  // cut after the last coordinate
    std::string nul = kCarbon;
    nul[16] = '\0';
    EXPECT_EQ(readText(nul).atoms[0].alternate, '\0');
}

TEST(PdbLines, ModelsAreCountedAndChosen) {
    const std::string two =
        "MODEL        1\n" + kCarbon + "ENDMDL\nMODEL        2\n" + kCarbon + kOxygen + "ENDMDL\nEND\n";
    EXPECT_EQ(readText(two).atoms.size(), 1u);
    EXPECT_EQ(readText(two, 2).atoms.size(), 2u);
    EXPECT_EQ(readText(two).file.models, 2);
    EXPECT_EQ(readText(two).file.totalAtomsAllModels, 3);
    EXPECT_EQ(errorOfLines(two, 3), "cannot read molecule: x.pdb: no model 3: there are 2 models");
    EXPECT_EQ(errorOfLines(kCarbon, 2), "cannot read molecule: x.pdb: no model 2: there is 1 model");
    EXPECT_EQ(errorOfLines(kCarbon, 0), "cannot read molecule: x.pdb: models count from 1");
    EXPECT_EQ(readText(kCarbon + "END\n" + kCarbon + kOxygen + "END\n", 2).atoms.size(), 2u);
}

TEST(PdbLines, ConectStatesBondsAndOrders) {
    const auto bonds = [](const std::string& conect) { return readText(kCarbon + kOxygen + conect).bonds; };
    ASSERT_EQ(bonds("CONECT    1    2\nCONECT    2    1\n").size(), 1u);
    EXPECT_EQ(bonds("CONECT    1    2\nCONECT    2    1\n")[0].order, 1);
    EXPECT_EQ(bonds("CONECT    1    2    2\n").at(0).order, 2);
    EXPECT_EQ(bonds("CONECT    1    2    0    0    0\n").size(), 1u);
    EXPECT_EQ(bonds("CONECT    1    1\n").size(), 0u);
    EXPECT_EQ(bonds("CONECT    1                             2\n").size(), 0u);  // an old hydrogen bond
}

TEST(PdbLines, ConectInsideAModelIsThatModelsAlone) {
    const std::string first = "MODEL        1\n" + kCarbon + kOxygen + "ENDMDL\n";
    const std::string second = "MODEL        2\n" + kCarbon + kOxygen + "CONECT    1    2    2\nENDMDL\n";
    EXPECT_EQ(readText(first + second).bonds.size(), 0u);
    EXPECT_EQ(readText(second + first).bonds.size(), 1u);
    // After all models it is everyone's, and so where the last model has no end.
    EXPECT_EQ(readText(first + first + "CONECT    1    2\n").bonds.size(), 1u);
    EXPECT_EQ(readText(first + "MODEL        2\n" + kCarbon + kOxygen + "CONECT    1    2\n").bonds.size(), 1u);
}

TEST(PdbLines, ConectBetweenTwoEndsIsThatStructuresAlone) {
    // Files of several structures in a row, each numbered from 1.
    const std::string one = kCarbon + kOxygen + "CONECT    1    2    2\nEND\n", two = kCarbon + kOxygen + "END\n";
    ReadOptions second{.model = 2};
    EXPECT_EQ(readMolecule("m.pdb", one + two).file.conectUniquePairs, 1);
    EXPECT_EQ(readMolecule("m.pdb", one + two, second).file.conectUniquePairs, 0);
    EXPECT_EQ(readMolecule("m.pdb", two + one).file.conectUniquePairs, 0);
    EXPECT_EQ(readMolecule("m.pdb", two + one, second).file.conectUniquePairs, 1);
}

TEST(PdbLines, ConectThatLeadsNowhereIsOneWarning) {
    std::string text = kCarbon + kOxygen;
    for (int i = 0; i < 1000; ++i) text += "CONECT    1  999\nCONECT   xx    1\n";
    const Molecule m = readText(text);
    ASSERT_EQ(m.notes.size(), 2u);
    EXPECT_EQ(describeNote(m.notes[0]), "left out 1000 bonds, the first on line 3: CONECT of atoms that are not there");
    EXPECT_EQ(readText(kCarbon + kCarbon + kOxygen + "CONECT    1    2\n").bonds.size(), 0u);  // which atom 1?
    // Serial numbers far apart: hybrid-36, whose zzzzz is 87440031.
    const auto numbered = [](std::string line, const std::string& serial) { return line.replace(6, 5, serial); };
    const std::string far = numbered(kCarbon, "zzzzy") + numbered(kOxygen, "zzzzz") + kCarbon;
    EXPECT_EQ(readText(far + "CONECTzzzzzzzzzy\nCONECT    1zzzzz\n").bonds.size(), 2u);
    EXPECT_EQ(readText(far + "CONECTzzzzzzzzzx\n").bonds.size(), 0u);
    EXPECT_EQ(readText(far + kOxygen + kCarbon + "CONECTzzzzz    1\n").bonds.size(), 0u);
}

TEST(PdbLines, APredictionSaysSo) {
    const std::string atom = "ATOM      1  CA  ALA A   1       0.000   0.000   0.000  1.00 90.00           C\n";
    const auto confident = [&](const std::string& head) { return readMolecule("a.pdb", head + atom).file.confidence; };
    EXPECT_TRUE(confident("TITLE     ALPHAFOLD MONOMER V2.0 PREDICTION FOR HEMOGLOBIN SUBUNIT BETA (P68871)\n"));
    EXPECT_FALSE(confident("TITLE     CRYSTAL STRUCTURE SOLVED WITH AN ALPHAFOLD PREDICTION\n"));
    EXPECT_FALSE(confident(""));
    const auto confidentCif = [](const std::string& metric) {
        return readMolecule("a.cif", "data_a\n" + metric +
                                         "loop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
                                         "_atom_site.Cartn_z\n0 0 0\n")
            .file.confidence;
    };
    EXPECT_TRUE(confidentCif("loop_\n_ma_qa_metric.id\n_ma_qa_metric.name\n_ma_qa_metric.type\n1 confidence pLDDT\n"));
    EXPECT_FALSE(confidentCif("loop_\n_ma_qa_metric.id\n_ma_qa_metric.name\n_ma_qa_metric.type\n1 energy zscore\n"));
    EXPECT_FALSE(confidentCif(""));
}

}  // namespace
}  // namespace nacre
