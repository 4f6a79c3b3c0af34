// Scenes of packed cells: cellPACK's entities are paths of compartments; PetWorld's models stand together, each with
// copies of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "engine/molecule/read.h"
#include "engine/molecule/selection/selection.h"
#include "tests/support/temporary_folder.h"

namespace nacre {
namespace {

/// Operators 1 to `count`, each a shift along x by 10 Å times its number.
std::string shifts(int count) {
    std::string text = "loop_\n_pdbx_struct_oper_list.id\n";
    for (const char* column :
         {"matrix[1][1]", "matrix[1][2]", "matrix[1][3]", "vector[1]", "matrix[2][1]", "matrix[2][2]", "matrix[2][3]",
          "vector[2]", "matrix[3][1]", "matrix[3][2]", "matrix[3][3]", "vector[3]"})
        text += std::string("_pdbx_struct_oper_list.") + column + "\n";
    for (int i = 1; i <= count; ++i)
        text += std::to_string(i) + " 1 0 0 " + std::to_string(10 * i) + " 0 1 0 0 0 0 1 0\n";
    return text;
}

/// Rows of an atom per chain: number, chain, entity, x, model.
std::string atomSite(const std::string& rows) {
    return "loop_\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n"
           "_atom_site.label_asym_id\n_atom_site.label_entity_id\n_atom_site.label_seq_id\n_atom_site.Cartn_x\n"
           "_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.pdbx_PDB_model_num\n" +
           rows;
}

const std::string kCellpack =
    "data_cell\nloop_\n_entity.id\n_entity.type\n_entity.pdbx_description\n"
    "1 polymer cell.membrane.spike\n2 polymer cell.membrane.pore\n3 polymer cell.interior.enzyme\n" +
    atomSite("1 C CA ALA A 1 1 0 0 0 1\n2 C CA ALA B 2 1 1 0 0 1\n3 C CA ALA C 3 1 2 0 0 1\n") +
    "loop_\n_pdbx_struct_assembly.id\n_pdbx_struct_assembly.details\n_pdbx_struct_assembly.method_details\n"
    "1 scene cellPACK\n"
    "loop_\n_pdbx_struct_assembly_gen.assembly_id\n_pdbx_struct_assembly_gen.oper_expression\n"
    "_pdbx_struct_assembly_gen.asym_id_list\n1 1,2 A\n1 3 B\n1 (4-6) C\n" +
    shifts(6);

/// The atom records come before or behind what says that models stand together.
std::string petworld(bool atomsFirst) {
    const std::string atoms =
        atomSite("1 C CA ALA A 1 1 0 0 0 1\n2 C CB ALA A 1 1 1 0 0 1\n3 C CA GLY A 1 1 5 0 0 2\n");
    const std::string scene =
        "loop_\n_pdbx_model.id\n_pdbx_model.name\n1 albumin\n2 'water channel'\n"
        "loop_\n_pdbx_struct_assembly.id\n_pdbx_struct_assembly.details\n1 world\n"
        "loop_\n_pdbx_struct_assembly_gen.assembly_id\n_pdbx_struct_assembly_gen.PDB_model_num\n"
        "_pdbx_struct_assembly_gen.oper_expression\n_pdbx_struct_assembly_gen.asym_id_list\n1 1 (1-3) A\n1 2 4 A\n" +
        shifts(4);
    return "data_world\n" + (atomsFirst ? atoms + scene : scene + atoms);
}

std::size_t chosenAtoms(const Molecule& molecule, const char* selection) {
    const std::vector<bool> chosen = selectAtoms(molecule, parseSelection(selection));
    return static_cast<std::size_t>(std::count(chosen.begin(), chosen.end(), true));
}

TEST(PackedScenes, CellPack) {
    const Molecule cell = readMolecule("a.cif", kCellpack);
    EXPECT_EQ(cell.file.packed, "1");
    EXPECT_EQ(cell.file.entityNames.at("2"), "cell.membrane.pore");
    ASSERT_EQ(cell.assemblies.size(), 1u);
    ASSERT_EQ(cell.assemblies[0].parts.size(), 3u);
    EXPECT_EQ(cell.assemblies[0].parts[2].transforms.size(), 3u);
    EXPECT_EQ(chosenAtoms(cell, "entity cell.membrane.*"), 2u);
    EXPECT_EQ(chosenAtoms(cell, "entity CELL.interior.Enzyme"), 1u) << "case does not matter";
    EXPECT_EQ(chosenAtoms(cell, "entity 1+3"), 2u);
    EXPECT_EQ(chosenAtoms(cell, "entity nucleus.*"), 0u);
}

TEST(PackedScenes, ModelsOfPetWorldStandTogether) {
    for (const bool atomsFirst : {false, true}) {
        const Molecule world = readMolecule("a.cif", petworld(atomsFirst));
        EXPECT_EQ(world.file.models, 1);
        ASSERT_EQ(world.atoms.size(), 3u);
        EXPECT_EQ(world.residues[0].entity, 1u);
        EXPECT_EQ(world.residues[1].entity, 2u);
        EXPECT_EQ(world.file.packed, "1");
        EXPECT_EQ(world.file.entityNames.at("2"), "water channel");
        EXPECT_EQ(chosenAtoms(world, "entity 'water channel'"), 1u);
        ASSERT_EQ(world.assemblies.size(), 1u);
        ASSERT_EQ(world.assemblies[0].parts.size(), 2u) << "chain A of model 1, chain A of model 2";
        EXPECT_EQ(world.assemblies[0].parts[0].transforms.size(), 3u);
        ASSERT_EQ(world.assemblies[0].parts[1].transforms.size(), 1u);
        EXPECT_FLOAT_EQ(world.assemblies[0].parts[1].transforms[0][3].x, 40);
        EXPECT_NE(world.residues[0].subchain, world.residues[1].subchain);
    }
}

TEST(PackedScenes, OnlyTheTableOfCopiesTellsThatModelsStandTogether) {
    const auto models = [](const char* categories) {
        return readMolecule("a.json", std::string(R"({"data_a": {"atom_site": {"type_symbol": ["C", "C"],
"label_asym_id": ["A", "A"], "Cartn_x": [0, 5], "Cartn_y": [0, 0], "Cartn_z": [0, 0],
"pdbx_PDB_model_num": [1, 2]}, )") + categories +
                                          "}}")
            .file.models;
    };
    EXPECT_EQ(models(R"("pdbx_struct_assembly_gen": {"assembly_id": [1, 1], "PDB_model_num": [1, 2]})"), 1);
    EXPECT_EQ(models(R"("pdbx_struct_assembly_gen": {"assembly_id": [1]},
"pdbx_validate_torsion": {"PDB_model_num": [1]})"),
              2);
    EXPECT_EQ(models(R"("pdbx_validate_torsion": {"PDB_model_num": [1]})"), 2);
}

TEST(PackedScenes, LargeTextsOfPetWorldAreNotSplitIntoModels) {
    for (const bool atomsFirst : {false, true}) {
        const test::TemporaryFolder folder;
        std::ofstream(folder / "world.cif") << petworld(atomsFirst);
        const Molecule world = readMoleculeFile(folder / "world.cif", {.heldText = 100});
        EXPECT_EQ(world.atoms.size(), 3u);
        EXPECT_EQ(world.file.models, 1);
    }
}

TEST(PackedScenes, ManyCopiesAreAScene) {
    const auto copies = [](int number) {
        return "data_a\n" + atomSite("1 C CA ALA A 1 1 0 0 0 1\n") +
               "loop_\n_pdbx_struct_assembly.id\n_pdbx_struct_assembly.details\n1 x\n"
               "loop_\n_pdbx_struct_assembly_gen.assembly_id\n_pdbx_struct_assembly_gen.oper_expression\n"
               "_pdbx_struct_assembly_gen.asym_id_list\n1 1-" +
               std::to_string(number) + " A\n" + shifts(number);
    };
    EXPECT_EQ(readMolecule("a.cif", copies(60)).file.packed, "") << "a capsid";
    EXPECT_EQ(readMolecule("a.cif", copies(1000)).file.packed, "1");
}

}  // namespace
}  // namespace nacre
