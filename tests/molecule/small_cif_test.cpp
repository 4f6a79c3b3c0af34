// Small-molecule CIF.
#include <gtest/gtest.h>

#include <algorithm>
#include <gemmi/cif.hpp>
#include <gemmi/numb.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <map>

#include "tests/molecule/expect_error.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

const std::string kCell =
    "_cell_length_a 10.0(2)\n_cell_length_b 20\n_chemical_formula_sum 'C'\n_cell_length_c 30\n_cell_angle_alpha 90\n"
    "_cell_angle_beta 90\n_cell_angle_gamma 90\n";
const std::string kAtoms =
    "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n"
    "_atom_site_U_iso_or_equiv\n_atom_site_occupancy\n_atom_site_disorder_group\n"
    "C1 0.1(3) 0.25 -0.5 0.0100(2) 1 .\nCl2 0.5 0.5 0.5 . 0.5 2\nH3 ? ? ? . . .\n";

std::string file(const std::string& symmetry, const std::string& cell = kCell, const std::string& atoms = kAtoms) {
    return "data_x\n_chemical_name_common 'some thing'\n" + cell + symmetry + atoms;
}

TEST(SmallCif, Fields) {
    const Molecule m = readMolecule("a.cif", file(""));
    ASSERT_EQ(m.atoms.size(), 2u);
    EXPECT_EQ(m.file.format, "cif-core");
    EXPECT_EQ(m.file.title, "some thing");
    EXPECT_LT(glm::distance(m.atoms[0].position, glm::vec3(1, 5, -15)), 1e-5f);
    EXPECT_EQ(m.atoms[0].element, 6);
    EXPECT_EQ(m.atoms[1].element, 17);
    EXPECT_NEAR(m.atoms[0].temperatureFactor, 0.789568f, 1e-5f);  // 8 pi^2 U
    EXPECT_EQ(m.atoms[0].alternate, '\0');
    EXPECT_EQ(m.atoms[1].alternate, 'B');
    EXPECT_EQ(m.atoms[1].occupancy, 0.5f);
    ASSERT_EQ(m.warnings.size(), 1u);
    EXPECT_EQ(m.warnings[0], "left out 1 atom, line 20: no usable coordinates");
    EXPECT_TRUE(m.assemblies.empty());
}

TEST(SmallCif, LabelsNameNoElementsThatCrystalsLack) {
    const std::string labels =
        "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n"
        "NH1 0 0 0\nCn1 0.2 0 0\nD1 0.4 0 0\nNb1 0.6 0 0\n";
    const Molecule m = readMolecule("a.cif", file("", kCell, labels));
    ASSERT_EQ(m.atoms.size(), 4u);
    EXPECT_EQ(m.atoms[0].element, 7) << "no nihonium";
    EXPECT_EQ(m.atoms[1].element, 6) << "no copernicium";
    EXPECT_EQ(m.atoms[2].element, 119) << "deuterium";
    EXPECT_EQ(m.atoms[3].element, 41);
}

TEST(SmallCif, SymmetryMakesTheUnitCell) {
    // The centre of the two atoms is (0.3, 0.375, 0).
    const Molecule m = readMolecule("a.cif", file("loop_\n_symmetry_equiv_pos_as_xyz\n'x,y,z'\n'-x, -y+1/2, -z'\n"));
    ASSERT_EQ(m.assemblies.size(), 1u);
    EXPECT_EQ(m.assemblies[0].id, "unit-cell");
    const auto& transforms = m.assemblies[0].parts.at(0).transforms;
    ASSERT_EQ(transforms.size(), 2u);
    EXPECT_LT(glm::distance(transforms[0] * glm::vec4(1, 5, -15, 1), glm::vec3(1, 5, -15)), 1e-4f);
    // (0.1, 0.25, -0.5) goes to (-0.1, 0.25, 0.5); the centre to (-0.3, 0.125, 0), which is one cell too low in x.
    EXPECT_LT(glm::distance(transforms[1] * glm::vec4(1, 5, -15, 1), glm::vec3(9, 5, 15)), 1e-4f);
    const Molecule named = readMolecule("a.cif", file("_space_group_symop_operation_xyz 'x,y,z'\n"));
    EXPECT_EQ(named.assemblies.at(0).parts.at(0).transforms.size(), 1u);
    std::string sum;
    for (int i = 0; i < 100'000; ++i) sum += "+999*x";
    for (const std::string& odd :
         {std::string("x,y,q"), std::string("x,y+") + std::string(40, '1') + "/2,z", sum + ",y,z"}) {
        const Molecule as = readMolecule("a.cif", file(("_symmetry_equiv_pos_as_xyz '" + odd + "'\n").c_str()));
        EXPECT_TRUE(as.assemblies.empty());
        EXPECT_NE(as.warnings.front().find("is not a symmetry operation"), std::string::npos);
    }
}

TEST(SmallCif, ANameOfASpaceGroupMakesTheUnitCell) {
    const std::string general =
        "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\nC1 0.05 0.13 0.21\n";
    // Rock salt as gemmi 0.5.7 has its group: 192 operations.
    for (const char* name : {"_symmetry_space_group_name_H-M 'F m -3 m'\n", "_space_group_name_H-M_alt 'F m 3 m'\n",
                             "_symmetry_space_group_name_H-M Fm-3m\n"}) {
        const Molecule m = readMolecule("a.cif", file(name, kCell, general));
        ASSERT_EQ(m.assemblies.size(), 1u) << name;
        EXPECT_EQ(m.assemblies[0].parts.at(0).transforms.size(), 192u) << name;
        EXPECT_FALSE(m.file.spaceGroup.empty());
    }
    const Molecule none = readMolecule("a.cif", file("_symmetry_space_group_name_H-M 'Q 7'\n"));
    EXPECT_TRUE(none.assemblies.empty());
    EXPECT_NE(none.warnings.front().find("no space group 'Q 7'"), std::string::npos);
}

std::size_t atomsInCell(const Molecule& m) {
    std::size_t count = 0;
    for (const AssemblyPart& part : m.assemblies.at(0).parts)
        for (const Residue& residue : m.residues)
            if (std::find(part.subchains.begin(), part.subchains.end(), residue.subchain) != part.subchains.end())
                count += residue.atomCount * part.transforms.size();
    return count;
}

TEST(SmallCif, AtomsOnSpecialPositionsStandInTheCellOnce) {
    // Low quartz, three formula units of SiO2: silicon lies on a twofold axis (Levien et al. 1980).
    const std::string quartz =
        "data_quartz\n_cell_length_a 4.916\n_cell_length_b 4.916\n_cell_length_c 5.4054\n_cell_angle_alpha 90\n"
        "_cell_angle_beta 90\n_cell_angle_gamma 120\n_symmetry_space_group_name_H-M 'P 32 2 1'\n"
        "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n"
        "Si 0.4697 0.0000 0.16667\nO 0.4135 0.2669 0.2858\n";
    EXPECT_EQ(atomsInCell(readMolecule("a.cif", quartz)), 9u);
    // Rock salt, four of NaCl, by its old name.
    const std::string salt =
        "data_salt\n_cell_length_a 5.64\n_cell_length_b 5.64\n_cell_length_c 5.64\n_cell_angle_alpha 90\n"
        "_cell_angle_beta 90\n_cell_angle_gamma 90\n_symmetry_space_group_name_H-M 'F m 3 m'\n"
        "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n"
        "Na 0 0 0\nCl 0.5 0.5 0.5\n";
    EXPECT_EQ(atomsInCell(readMolecule("a.cif", salt)), 8u);
}

TEST(SmallCif, WhatIsWrong) {
    test::expectError("a.cif", file("", ""), {"_cell_length_a is missing"});
    const auto cell = [](const std::string& from, const std::string& to) {
        std::string text = kCell;
        return file("", text.replace(text.find(from), from.size(), to));
    };
    test::expectError("a.cif", cell("length_b 20", "length_b -20"), {"_cell_length_b is missing or impossible"});
    test::expectError("a.cif", cell("length_b 20", "length_b nan"), {"_cell_length_b is missing or impossible"});
    test::expectError("a.cif", cell("gamma 90", "gamma 180"), {"_cell_angle_gamma is missing or impossible"});
    test::expectError("a.cif",
                      cell("alpha 90\n_cell_angle_beta 90\n_cell_angle_gamma 90",
                           "alpha 10\n_cell_angle_beta 90\n_cell_angle_gamma 150"),
                      {"no volume"});
    std::string atoms = kAtoms;
    atoms.replace(atoms.find("0.25"), 4, "1e99");
    test::expectLeftOut("a.cif", file("", kCell, atoms),
                        "left out 2 atoms, the first on line 18: no usable coordinates");
    ReadOptions options;
    options.model = 2;
    test::expectError("a.cif", file(""), {"only model 1"}, options);
}

TEST(SmallCif, TheUnitCellHoldsTheFormula) {
    NACRE_NEEDS_DATA();
    const Molecule m = readMoleculeFile(test::dataFile("small/core-867861.cif"));
    ASSERT_EQ(m.assemblies.size(), 1u);
    const auto copies = static_cast<float>(m.assemblies[0].parts.at(0).transforms.size());
    std::map<int, float> contents;
    for (const Atom& atom : m.atoms) contents[atom.element] += copies * atom.occupancy;
    // _chemical_formula_sum: C92 H102 F12 N14 O22, and _cell_formula_units_Z: 1
    const std::map<int, float> formula = {{6, 92}, {1, 102}, {9, 12}, {7, 14}, {8, 22}};
    ASSERT_EQ(contents.size(), formula.size());
    for (const auto& [element, count] : formula) EXPECT_NEAR(contents[element], count, 0.01f) << element;
}

TEST(SmallCif, DistancesAreThoseThatTheFileStates) {
    NACRE_NEEDS_DATA();
    const std::string path = test::dataFile("small/core-867861.cif");
    const Molecule m = readMoleculeFile(path);
    std::map<std::string, glm::vec3> at;
    for (const Atom& atom : m.atoms) at[std::string(atom.name.view())] = atom.position;
    gemmi::cif::Document document = gemmi::cif::read_file(path);
    gemmi::cif::Table bonds = document.blocks.at(0).find(
        "_geom_bond_", {"atom_site_label_1", "atom_site_label_2", "distance", "site_symmetry_2"});
    int compared = 0;
    for (const auto row : bonds) {
        if (row[3] != ".") continue;
        const float distance = glm::distance(at.at(row.str(0)), at.at(row.str(1)));
        EXPECT_NEAR(distance, gemmi::cif::as_number(row[2]), 0.006) << row[0] << ' ' << row[1];
        ++compared;
    }
    EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace nacre
