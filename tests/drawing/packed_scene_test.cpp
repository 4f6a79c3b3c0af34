// Packed scenes open as their assembly, in the colours of their compartments.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "app/drawing/scenes.h"
#include "app/picture/options.h"
#include "engine/molecule/read.h"
#include "engine/scene/color/colors.h"
#include "engine/scene/color/palettes.h"
#include "engine/scene/instances/sphere_levels.h"

namespace nacre::app {
namespace {

/// Three ingredients of equal numbers of atoms, two of them in the membrane; copies of each.
std::string packedCell(int atoms, int copies) {
    std::string text =
        "data_cell\nloop_\n_entity.id\n_entity.type\n_entity.pdbx_description\n"
        "1 polymer cell.membrane.spike\n2 polymer cell.membrane.pore\n3 polymer cell.interior.enzyme\n"
        "loop_\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_asym_id\n_atom_site.label_entity_id\n"
        "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
    for (int entity = 0; entity < 3; ++entity)
        for (int i = 0; i < atoms; ++i)
            text += std::to_string(entity * atoms + i + 1) + " C " + "ABC"[entity] + " " + std::to_string(entity + 1) +
                    " " + std::to_string(i % 20 * 2) + " " + std::to_string(i / 20 % 20 * 2) + " " +
                    std::to_string(i / 400 * 2) + "\n";
    text +=
        "loop_\n_pdbx_struct_assembly.id\n_pdbx_struct_assembly.details\n_pdbx_struct_assembly.method_details\n"
        "1 scene cellPACK\n"
        "loop_\n_pdbx_struct_assembly_gen.assembly_id\n_pdbx_struct_assembly_gen.oper_expression\n"
        "_pdbx_struct_assembly_gen.asym_id_list\n1 1-" +
        std::to_string(copies) + " A,B,C\nloop_\n_pdbx_struct_oper_list.id\n";
    for (const char* column :
         {"matrix[1][1]", "matrix[1][2]", "matrix[1][3]", "vector[1]", "matrix[2][1]", "matrix[2][2]", "matrix[2][3]",
          "vector[2]", "matrix[3][1]", "matrix[3][2]", "matrix[3][3]", "vector[3]"})
        text += std::string("_pdbx_struct_oper_list.") + column + "\n";
    for (int i = 0; i < copies; ++i)
        text += std::to_string(i + 1) + " 1 0 0 " + std::to_string(i % 40 * 50) + " 0 1 0 " +
                std::to_string(i / 40 % 40 * 50) + " 0 0 1 " + std::to_string(i / 1600 * 50) + "\n";
    return text;
}

TEST(PackedScene, HasAColourForEachCompartmentAndShadesForEntities) {
    const Molecule cell = readMolecule("cell.cif", packedCell(1, 4));
    const Representation scene = buildScene(ResidueFacts(cell), PictureDescription());
    EXPECT_EQ(spheresInCopies(scene), 12u);
    std::array<std::uint32_t, 3> colors{};
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        colors.at(scene.sphereLooks[i].atom - 1) = scene.sphereLooks[i].color;
    EXPECT_EQ(colors[0], tintedColor(kindColor(0, Palette::okabeIto), copyTint(0, 2)));
    EXPECT_EQ(colors[1], tintedColor(kindColor(0, Palette::okabeIto), copyTint(1, 2)));
    EXPECT_NE(colors[0], colors[1]);
    EXPECT_EQ(colors[2], tintedColor(kindColor(1, Palette::okabeIto), copyTint(0, 1)));
    ASSERT_EQ(scene.legends.size(), 1u);
    ASSERT_EQ(scene.legends[0].entries.size(), 3u);
    EXPECT_EQ(scene.legends[0].entries[1].label, "cell.membrane.pore");
}

TEST(PackedScene, OptionsOverrideIt) {
    const Molecule cell = readMolecule("cell.cif", packedCell(1, 4));
    PictureDescription picture;
    setOption(option("assembly"), "none", picture);
    setOption(option("color"), "#ff0000", picture);
    const Representation scene = buildScene(ResidueFacts(cell), picture);
    EXPECT_EQ(scene.spheres.size(), 3u);
    EXPECT_TRUE(scene.copies.transforms.empty());
    EXPECT_EQ(scene.sphereLooks[0].color, scene.sphereLooks[2].color);
    PictureDescription hidden;
    setOption(option("hide"), "not entity *.membrane.*", hidden);
    EXPECT_EQ(spheresInCopies(buildScene(ResidueFacts(cell), hidden)), 8u);
}

TEST(PackedScene, OfABillionAtomsHasLevelsAndNoOcclusion) {
    const Molecule cell = readMolecule("cell.cif", packedCell(7000, 50'000));
    ASSERT_EQ(cell.atoms.size(), 21'000u);
    const Representation scene = buildScene(ResidueFacts(cell), PictureDescription());
    EXPECT_EQ(spheresInCopies(scene), 1'050'000'000u);
    EXPECT_EQ(scene.spheres.size(), 21'000u) << "of one copy";
    EXPECT_TRUE(tooManyToOcclude(scene, cell));
    EXPECT_TRUE(canHaveLevels(scene));
    ASSERT_FALSE(scene.warnings.empty());
    EXPECT_EQ(scene.warnings.back(), "no ambient occlusion: the scene has 1050000000 spheres");
    const Molecule small = readMolecule("cell.cif", packedCell(10, 100));
    EXPECT_FALSE(tooManyToOcclude(buildScene(ResidueFacts(small), PictureDescription()), small));
}

}  // namespace
}  // namespace nacre::app
