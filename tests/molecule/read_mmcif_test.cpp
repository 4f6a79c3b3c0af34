#include <gtest/gtest.h>

#include <gemmi/cif.hpp>
#include <sstream>

#include "engine/molecule/element.h"
#include "tests/molecule/expect_error.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

/// A file with these columns of _atom_site and rows.
std::string atomSite(const std::string& columns, const std::string& rows) {
    std::string text = "data_TEST\nloop_\n";
    std::istringstream names(columns);
    for (std::string name; names >> name;) text += "_atom_site." + name + "\n";
    return text + rows;
}

const std::string kColumns =
    "group_PDB id type_symbol label_atom_id label_alt_id label_comp_id label_asym_id label_seq_id pdbx_PDB_ins_code "
    "Cartn_x Cartn_y Cartn_z occupancy B_iso_or_equiv pdbx_formal_charge auth_seq_id auth_asym_id pdbx_PDB_model_num";
const std::string kRows =
    "ATOM 1 N N . ALA A 1 ? 1.0 2.0 3.0 1.00 20.5 ? 10 X 1\n"
    "ATOM 2 S SG A CYS A 2 B 4.0 5.0(3) 6.0 0.60 ? 1- -11 X 1\n"
    "ATOM 3 S SG B CYS A 2 B 4.5 5.0 6.0 0.40 ? ? -11 X 1\n"
    "HETATM 4 FE FE . HEM B . ? 9.0 5.0 6.0 ? ? 2 201 X 1\n"
    "ATOM 5 N N . ALA A 1 ? 1.5 2.0 3.0 1.00 20.5 ? 10 X 7\n";

TEST(ReadMmcif, FieldsOfAtoms) {
    const Molecule molecule = readMolecule("a.cif", atomSite(kColumns, kRows));
    ASSERT_EQ(molecule.atoms.size(), 4u);
    ASSERT_EQ(molecule.residues.size(), 3u);
    const Atom& sulfur = molecule.atoms[1];
    EXPECT_EQ(elementSymbol(sulfur.element), "S");
    EXPECT_TRUE(sulfur.name == Name("SG"));
    EXPECT_EQ(sulfur.alternate, 'A');
    EXPECT_EQ(sulfur.charge, 0);  // "1-" is the PDB's way, not CIF's
    EXPECT_FLOAT_EQ(sulfur.occupancy, 0.6f);
    EXPECT_FLOAT_EQ(sulfur.position.y, 5);
    EXPECT_EQ(molecule.residues[1].number, -11);
    EXPECT_EQ(molecule.residues[1].insertionCode, 'B');
    EXPECT_EQ(molecule.residues[1].atomCount, 2u);
    EXPECT_EQ(molecule.chains.at(0).name, "X");
    EXPECT_FLOAT_EQ(molecule.atoms[0].temperatureFactor, 20.5f);
    EXPECT_TRUE(molecule.atoms[3].hetero);
    EXPECT_EQ(molecule.atoms[3].charge, 2);
    EXPECT_FLOAT_EQ(molecule.atoms[3].occupancy, 1);
    EXPECT_EQ(molecule.file.models, 2);
    EXPECT_EQ(molecule.file.totalAtomsAllModels, 5);
    EXPECT_EQ(molecule.file.chainsAuth, 1);
    EXPECT_EQ(molecule.file.chainsLabel, 2);
}

TEST(ReadMmcif, CountsTheChainThatHasNoName) {
    const std::string columns = "label_atom_id label_asym_id auth_asym_id Cartn_x Cartn_y Cartn_z";
    const Molecule nameless = readMolecule("a.cif", atomSite(columns, "C . . 0 0 0\nC . . 9 0 0\n"));
    EXPECT_EQ(nameless.chains.size(), 1u);
    EXPECT_EQ(nameless.file.chainsAuth, 1);
    EXPECT_EQ(nameless.file.chainsLabel, 1);
    EXPECT_EQ(readMolecule("a.cif", atomSite(columns, "C A . 0 0 0\nC B . 9 0 0\n")).file.chainsAuth, 2);
}

TEST(ReadMmcif, ModelsByPositionNotNumber) {
    ReadOptions options;
    options.model = 2;
    const Molecule molecule = readMolecule("a.cif", atomSite(kColumns, kRows), options);
    ASSERT_EQ(molecule.atoms.size(), 1u);
    EXPECT_FLOAT_EQ(molecule.atoms[0].position.x, 1.5f);
    options.model = 3;
    test::expectError("a.cif", atomSite(kColumns, kRows), {"no model 3; the file has 2"}, options);
}

TEST(ReadMmcif, FewestColumns) {
    const Molecule molecule = readMolecule("a.cif", atomSite("Cartn_z CARTN_X cartn_y", "3 1 2\n6 4 5\n"));
    ASSERT_EQ(molecule.atoms.size(), 2u);
    EXPECT_FLOAT_EQ(molecule.atoms[1].position.x, 4);
    const Molecule named =
        readMolecule("a.cif", atomSite("label_atom_id label_comp_id Cartn_x Cartn_y Cartn_z",
                                       "CA ALA 0 0 0\nCA CA 9 0 0\n\"HO5'\" DA 18 0 0\n1HB ALA 27 0 0\n"));
    const char* const expected[] = {"C", "Ca", "H", "H"};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(elementSymbol(named.atoms[i].element), expected[i]);
    EXPECT_TRUE(named.atoms[2].name == Name("HO5'"));
    // One atom may stand in pairs of tag and value.
    EXPECT_EQ(readMolecule("a.cif", "data_x\n_atom_site.Cartn_x 1\n_atom_site.Cartn_y 2\n_atom_site.Cartn_z 3\n")
                  .atoms.size(),
              1u);
}

TEST(ReadMmcif, QuotesTextsCommentsAndFrames) {
    const std::string text = "data_a\n_struct.title\n;TWO\nLINES\n;\nsave_f\n_atom_site.Cartn_x 5\nsave_\n# note\n" +
                             atomSite("Cartn_x Cartn_y Cartn_z auth_asym_id", "1 2 3 'a b'\n4 5 6 \"?\"\n").substr(10);
    const Molecule molecule = readMolecule("a.cif", text);
    EXPECT_EQ(molecule.file.title, "TWO LINES");
    ASSERT_EQ(molecule.chains.size(), 2u);
    EXPECT_EQ(molecule.chains[0].name, "a b");
    EXPECT_EQ(molecule.chains[1].name, "?");
}

TEST(ReadMmcif, TheFirstBlockWithAtomsIsRead) {
    const std::string second = atomSite("Cartn_x Cartn_y Cartn_z", "1 2 3\n");
    EXPECT_EQ(readMolecule("a.cif", "data_none\n_entry.id x\n" + second + second).atoms.size(), 1u);
}

TEST(ReadMmcif, ConnectionsThatAreBonds) {
    const std::string columns =
        "conn_type_id ptnr1_auth_asym_id ptnr1_auth_seq_id pdbx_ptnr1_PDB_ins_code ptnr1_label_comp_id "
        "ptnr1_label_atom_id pdbx_ptnr1_label_alt_id ptnr1_symmetry ptnr2_auth_asym_id ptnr2_auth_seq_id "
        "ptnr2_label_comp_id ptnr2_label_atom_id ptnr2_symmetry pdbx_value_order";
    std::string text = atomSite(kColumns, kRows) + "loop_\n";
    std::istringstream names(columns);
    for (std::string name; names >> name;) text += "_struct_conn." + name + "\n";
    const std::string rows[] = {
        "covale X -11 B CYS SG A 1_555 X 10 ALA N 1_555 doub\n", "covale X -11 B CYS SG ? 1_555 X 10 ALA N 1_555 ?\n",
        "metalc X -11 B CYS SG ? 1_555 X 201 HEM FE 1_555 ?\n",  "covale X -11 B CYS SG A 1_555 X 201 HEM FE 2_655 ?\n",
        "hydrog X -11 B CYS SG ? 1_555 X 201 HEM FE 1_555 ?\n",  "metalc X -11 B CYS SG A 1_555 X 201 HEM FE 2_655 ?\n",
        "disulf X -11 B CYS SG A 1_555 X 999 CYS SG 1_555 ?\n"};
    const std::size_t bonds[] = {1, 2, 2, 0, 0, 0, 0};
    for (std::size_t i = 0; i < std::size(rows); ++i) {
        std::size_t stated = 0;
        for (const Bond& bond : readMolecule("a.cif", text + rows[i]).bonds) stated += bond.source == BondSource::file;
        EXPECT_EQ(stated, bonds[i]) << rows[i];
    }
    EXPECT_EQ(readMolecule("a.cif", text + rows[0]).bonds.at(0).order, 2);
    EXPECT_EQ(readMolecule("a.cif", text + rows[6]).warnings.size(), 2u) << "of the connection and a charge";
}

TEST(ReadMmcif, LettersOfOtherEncodingsAndZeros) {
    std::string atoms = atomSite(kColumns, kRows);
    atoms.replace(atoms.find("1-"), 2, "? ");
    const std::size_t count = readMolecule("a.cif", atoms).atoms.size();
    const Molecule quoted = readMolecule("a.cif", atoms + "_struct.title '\xce\xb1 helix'\n");
    EXPECT_EQ(quoted.file.title, "\xce\xb1 helix");
    EXPECT_TRUE(quoted.warnings.empty());
    const Molecule bare = readMolecule("a.cif", atoms + "_struct.title M\xfcller" + '\0' + "\n");
    EXPECT_EQ(bare.atoms.size(), count);
    EXPECT_EQ(bare.file.title, "M?ller?");
    ASSERT_EQ(bare.warnings.size(), 1u);
    EXPECT_EQ(bare.warnings[0], "bytes that CIF does not allow, read as '?': 2");
    test::expectError("a.cif", atoms + "_struct.title M\xfcller\n_x.y 'never closed\n", {"not valid CIF", "line"});
}

TEST(ReadMmcif, ConnectionsToEachAtomOfAHugeResidueAreAllBonds) {
    constexpr int kAtoms = 100'000;
    std::string text =
        "data_x\nloop_\n_atom_site.label_atom_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
    const auto name = [](int i) { return "C" + std::to_string(i); };
    for (int i = 0; i < kAtoms; ++i) text += name(i) + " " + std::to_string(9 * i) + " 0 0\n";
    text +=
        "loop_\n_struct_conn.conn_type_id\n_struct_conn.ptnr1_label_seq_id\n_struct_conn.ptnr1_label_atom_id\n"
        "_struct_conn.ptnr2_label_seq_id\n_struct_conn.ptnr2_label_atom_id\n";
    for (int i = 1; i < kAtoms; ++i) text += "covale 0 " + name(i - 1) + " 0 " + name(i) + "\n";
    const Molecule molecule = readMolecule("a.cif", text);
    ASSERT_EQ(molecule.bonds.size(), kAtoms - 1u);
    for (std::uint32_t i = 0; i + 1 < kAtoms; ++i)
        ASSERT_EQ(std::pair(molecule.bonds[i].a, molecule.bonds[i].b), std::pair(i, i + 1));
    EXPECT_TRUE(molecule.warnings.empty());
}

TEST(ReadMmcif, AConnectionToAnyAlternateHasAtMost16OfThem) {
    std::string text =
        "data_x\nloop_\n_atom_site.label_atom_id\n_atom_site.label_alt_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
        "_atom_site.Cartn_z\n";
    for (int i = 0; i < 26; ++i) text += std::string("C1 ") + static_cast<char>('A' + i) + " 0 0 0\n";
    text +=
        "O1 . 9 0 0\nloop_\n_struct_conn.conn_type_id\n_struct_conn.ptnr1_label_seq_id\n"
        "_struct_conn.ptnr1_label_atom_id\n_struct_conn.pdbx_ptnr1_label_alt_id\n_struct_conn.ptnr2_label_seq_id\n"
        "_struct_conn.ptnr2_label_atom_id\n";
    const auto count = [&](const std::string& row) {
        std::size_t stated = 0;
        for (const Bond& bond : readMolecule("a.cif", text + row).bonds) stated += bond.source == BondSource::file;
        return stated;
    };
    EXPECT_EQ(count("covale 0 C1 ? 0 O1\n"), 16u);
    EXPECT_EQ(count("covale 0 C1 Z 0 O1\n"), 1u);
    EXPECT_EQ(count("covale 0 C1 a 0 O1\n"), 0u);
}

TEST(ReadMmcif, ComponentsTakeIdealElseModelCoordinates) {
    const std::string head =
        "data_C\nloop_\n_chem_comp_atom.atom_id\n_chem_comp_atom.type_symbol\n_chem_comp_atom.charge\n"
        "_chem_comp_atom.model_Cartn_x\n_chem_comp_atom.model_Cartn_y\n_chem_comp_atom.model_Cartn_z\n"
        "_chem_comp_atom.pdbx_model_Cartn_x_ideal\n_chem_comp_atom.pdbx_model_Cartn_y_ideal\n"
        "_chem_comp_atom.pdbx_model_Cartn_z_ideal\n";
    const std::string bond =
        "_chem_comp_bond.atom_id_1 C1\n_chem_comp_bond.atom_id_2 O1\n_chem_comp_bond.value_order DOUB\n";
    const std::string first = "C1 C 0 1 0 0 11 0 0\n";
    const Molecule ideal = readMolecule("a.cif", head + first + "O1 O -1 2.2 0 0 12.2 0 0\n" + bond);
    EXPECT_FLOAT_EQ(ideal.atoms.at(1).position.x, 12.2f);
    EXPECT_EQ(ideal.atoms[1].charge, -1);
    ASSERT_EQ(ideal.bonds.size(), 1u);
    EXPECT_EQ(ideal.bonds[0].order, 2);
    const Molecule model = readMolecule("a.cif", head + first + "O1 O 0 2.2 0 0 ? 0 0\n" + bond);
    EXPECT_FLOAT_EQ(model.atoms.at(1).position.x, 2.2f);
    test::expectError("a.cif", head + first + "O1 O 0 ? 0 0 ? 0 0\n" + bond, {"no coordinates"});
    test::expectLeftOut("a.cif", head + first + "O2 O 0 2.2 0 0 12.2 0 0\n" + bond,
                        "left out 1 bond, line 14: _chem_comp_bond names absent atoms");
}

TEST(ReadMmcif, WhatIsWrongIsSaidWithItsLine) {
    const std::string xyz = "Cartn_x Cartn_y Cartn_z";
    for (const char* number : {"nan", "inf", "1e99", "?", ".", "x", "''"})
        test::expectLeftOut("a.cif", atomSite(xyz, std::string("1 2 3\n1 ") + number + " 3\n"),
                            "left out 1 atom, line 7: no usable coordinates");
    test::expectError("a.cif", atomSite(xyz, "1 nan 3\n"), {"a.cif (line 6)", "Cartn_y of row 1"});
    test::expectError("a.cif", atomSite("Cartn_x Cartn_y", "1 2\n"), {"_atom_site.Cartn_z is missing"});
    test::expectError("a.cif", atomSite(xyz, "1 2 3\n4 5\n"), {"(line 7)", "2 values instead of 3"});
    test::expectError("a.cif", atomSite(xyz, ""), {"no atoms"});
    test::expectError("a.cif", "data_x\n_entry.id x\n", {"no atoms"});
    test::expectError("a.cif", "data_x\n_entry.title\n;text\n", {"(line 3)", "never closed"});
    test::expectError("a.cif", "data_x\n_entry.title 'text\n", {"(line 2)", "unterminated"});
    test::expectError("a.cif", atomSite(xyz, "1 2 3\n") + "loop_\n_atom_site.Cartn_x\n1\n",
                      {"_atom_site occurs twice"});
    test::expectError("a.cif", "data_x\n_cell_length_a 5\nloop_\n_atom_site_label\n_atom_site_fract_x\nC 0\n",
                      {"_cell_length_b is missing"});
    std::string tags = "data_x\nloop_\n";
    for (int i = 0; i < 5000; ++i) tags += "_a.b" + std::to_string(i) + "\n";
    test::expectError("a.cif", tags, {"too many tags"});
}

TEST(ReadMmjson, SameAsMmcif) {
    NACRE_NEEDS_DATA();
    const Molecule cif = readMoleculeFile(test::dataFile("1pfe.cif.gz"));
    const Molecule json = readMoleculeFile(test::dataFile("1pfe.mmjson.json"));
    ASSERT_EQ(cif.atoms.size(), json.atoms.size());
    for (std::size_t i = 0; i < cif.atoms.size(); ++i) {
        const Atom &a = cif.atoms[i], &b = json.atoms[i];
        EXPECT_TRUE(a.position == b.position && a.name == b.name && a.element == b.element && a.residue == b.residue &&
                    a.alternate == b.alternate && a.hetero == b.hetero && a.occupancy == b.occupancy &&
                    a.temperatureFactor == b.temperatureFactor && a.charge == b.charge)
            << i;
    }
    ASSERT_EQ(cif.residues.size(), json.residues.size());
    for (std::size_t i = 0; i < cif.residues.size(); ++i) {
        EXPECT_TRUE(cif.residues[i].name == json.residues[i].name);
        EXPECT_EQ(cif.residues[i].number, json.residues[i].number);
        EXPECT_EQ(cif.residues[i].chain, json.residues[i].chain);
    }
    ASSERT_EQ(cif.bonds.size(), json.bonds.size());
    for (std::size_t i = 0; i < cif.bonds.size(); ++i)
        EXPECT_TRUE(cif.bonds[i].a == json.bonds[i].a && cif.bonds[i].b == json.bonds[i].b);
    EXPECT_EQ(cif.file.title, json.file.title);
}

TEST(ReadMmjson, WhatIsWrong) {
    test::expectError("a.json", "{", {"not valid JSON"});
    test::expectError("a.json", "[1, 2]", {"not mmJSON"});
    test::expectError("a.json", "{\"a\":1}", {"not mmJSON"});
    test::expectError("a.json", "{\"data_x\":[]}", {"not mmJSON"});
    test::expectError("a.json", "{\"data_x\":{}}", {"no atoms"});
    test::expectError("a.json", "{\"data_x\":{\"a\":5}}", {"not an object"});
    test::expectError("a.json", "{\"data_x\":{\"a\":{\"b\":[1],\"c\":[1,2]}}}", {"not arrays of one length"});
    const std::string atoms = "{\"data_x\":{\"atom_site\":{\"Cartn_x\":[1],\"Cartn_y\":[2],\"Cartn_z\":";
    EXPECT_EQ(readMolecule("a.json", atoms + "[3]}}}").atoms.size(), 1u);
    test::expectError("a.json", atoms + "[null]}}}", {"Cartn_z of row 1"});
    test::expectError("a.json", atoms + "[[3]]}}}", {"neither text nor number"});
    test::expectError("a.json", std::string(1 << 20, '['), {"not valid JSON"});
}

TEST(ReadMmcif, CoordinatesAreGemmisOwn) {
    NACRE_NEEDS_DATA();
    const std::string path = test::dataFile("1crn.cif");
    gemmi::cif::Document document = gemmi::cif::read_file(path);
    gemmi::cif::Block& block = document.blocks.at(0);
    const Molecule molecule = readMoleculeFile(path);
    const char* const axes[] = {"_atom_site.Cartn_x", "_atom_site.Cartn_y", "_atom_site.Cartn_z"};
    for (int axis = 0; axis < 3; ++axis) {
        gemmi::cif::Column column = block.find_values(axes[axis]);
        ASSERT_EQ(static_cast<std::size_t>(column.length()), molecule.atoms.size());
        for (int i = 0; i < column.length(); ++i)
            EXPECT_EQ(molecule.atoms[static_cast<std::size_t>(i)].position[axis], std::stof(column.at(i)));
    }
    gemmi::cif::Column names = block.find_values("_atom_site.auth_atom_id");
    for (int i = 0; i < names.length(); ++i)
        EXPECT_TRUE(molecule.atoms[static_cast<std::size_t>(i)].name == Name(names.str(i)));
}

}  // namespace
}  // namespace nacre
