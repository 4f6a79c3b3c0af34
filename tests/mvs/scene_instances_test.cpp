// Copies that selectors name by their ids, and components that move in all copies.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "engine/molecule/crystal.h"
#include "tests/mvs/small_scene.h"
#include "tests/support/error_text.h"

namespace nacre::app::mvs {
namespace {

/// Chain A with one atom at (1, 2, 3), in an assembly of two copies: 100 Å along y, and 10 Å along x from there.
const std::string kAssembly = R"(data_TEST
loop_
_pdbx_struct_assembly.id
_pdbx_struct_assembly.details
1 complete
loop_
_pdbx_struct_assembly_gen.assembly_id
_pdbx_struct_assembly_gen.oper_expression
_pdbx_struct_assembly_gen.asym_id_list
1 (X0)(1-2) A
loop_
_pdbx_struct_oper_list.id
_pdbx_struct_oper_list.matrix[1][1]
_pdbx_struct_oper_list.matrix[1][2]
_pdbx_struct_oper_list.matrix[1][3]
_pdbx_struct_oper_list.vector[1]
_pdbx_struct_oper_list.matrix[2][1]
_pdbx_struct_oper_list.matrix[2][2]
_pdbx_struct_oper_list.matrix[2][3]
_pdbx_struct_oper_list.vector[2]
_pdbx_struct_oper_list.matrix[3][1]
_pdbx_struct_oper_list.matrix[3][2]
_pdbx_struct_oper_list.matrix[3][3]
_pdbx_struct_oper_list.vector[3]
X0 1 0 0 0 0 1 0 100 0 0 1 0
1 1 0 0 0 0 1 0 0 0 0 1 0
2 1 0 0 10 0 1 0 0 0 0 1 0
)" + kAtomColumns + R"(ATOM 7 C CA ALA A 1 1 101 A 1 2 3
)",
                  kPdb = R"(REMARK 350 BIOMOLECULE: 1
REMARK 350 APPLY THE FOLLOWING TO CHAINS: A
REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000
REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000      100.00000
REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000
REMARK 350   BIOMT1   2  1.000000  0.000000  0.000000       10.00000
REMARK 350   BIOMT2   2  0.000000  1.000000  0.000000      100.00000
REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000        0.00000
ATOM      7  CA  ALA A 101       1.000   2.000   3.000  1.00  0.00           C
)";

Molecule builtFrom(const std::string& file, const std::string& json, const std::string& annotations = "") {
    SceneSources sources;
    sources.fetch = [&](const std::string& uri) { return uri == "b.json" ? annotations : file; };
    return buildScene(parseScene(json, "scene.mvsj"), 0, "scene.mvsj", sources);
}

/// Where a layer's first atoms are drawn, in all copies, with their colours.
struct Place {
    glm::ivec3 at;
    std::uint32_t color;
    bool operator==(const Place&) const = default;
};
std::vector<Place> placesOf(const Molecule& molecule, std::size_t which = 0) {
    const SceneGuide& guide = *molecule.guide;
    const SceneLayer& layer = guide.layers.at(which);
    std::vector<Place> places;
    for (std::size_t i = 0; i < layer.atoms.size(); ++i) {
        const Atom& atom = molecule.atoms[layer.atoms[i]];
        const glm::dvec4 own(glm::dvec3(atom.position), 1.0);
        if (guide.transforms.empty()) places.push_back({glm::ivec3(glm::round(own)), layer.colors[i]});
        if (guide.transforms.empty()) continue;
        for (const std::uint32_t copy : guide.lists[guide.listOfResidue[atom.residue]])
            places.push_back({glm::ivec3(glm::round(guide.transforms[copy] * own)), layer.colors[i]});
    }
    return places;
}

constexpr std::uint32_t kWhiteCopy = 0xffffffffu, kRedCopy = 0xff0000ffu;
const std::string kWhole = R"("assembly")", kCell = R"("symmetry", "ijk_min": [0,0,0], "ijk_max": [0,0,0])";

TEST(SceneInstances, AreNamedByTheOperatorsOfAnAssembly) {
    const auto shown = [](const std::string& id, const std::string& file) {
        return placesOf(builtFrom(
            file, scene(component(R"([{"instance_id": ")" + id + R"(", "auth_seq_id": 101}])", balls()), "", kWhole)));
    };
    const std::vector<Place> first{{{1, 102, 3}, kWhiteCopy}}, second{{{11, 102, 3}, kWhiteCopy}};
    EXPECT_EQ(shown("ASM-X0-1", kAssembly), first);
    EXPECT_EQ(shown("ASM-X0-2", kAssembly), second);
    EXPECT_EQ(shown("ASM-2", kPdb), second);
    const Molecule none = builtFrom(
        kAssembly,
        scene(component(R"("all")", balls()) + "," + component(R"({"instance_id": "1_555"})", balls()), "", kWhole));
    ASSERT_EQ(none.guide->warnings.size(), 1u);
    EXPECT_NE(none.guide->warnings[0].find("it matches no atoms"), std::string::npos);
    EXPECT_EQ(none.atoms.size(), 1u);  // both copies share them
}

TEST(SceneInstances, AreThoseOfTheStructuresType) {
    for (const char* id : {"1_555", "ASM-1", "ASM-X0-1,2", "ASM-", "2_5", "ASM-X0-3"}) {
        const Molecule drawn =
            builtFrom(kAssembly, scene(component(R"("all")", balls()) + "," +
                                           component(R"({"instance_id": ")" + std::string(id) + "\"}", balls()),
                                       "", kWhole));
        ASSERT_EQ(drawn.guide->layers.size(), 1u) << id;
        EXPECT_EQ(placesOf(drawn).size(), 2u) << id;
    }
}

TEST(SceneInstances, HaveColoursAndLabelsOfTheirOwn) {
    const std::string color = R"({"kind": "color_from_uri", "params": {"uri": "b.json", "format": "json",
        "schema": "all_atomic", "field_remapping": {"instance_id": "copy"}}})",
                      label = R"({"kind": "label_from_uri", "params": {"uri": "b.json", "format": "json",
        "schema": "all_atomic", "field_name": "color", "field_remapping": {"instance_id": "copy"}}})";
    const Molecule drawn = builtFrom(kAssembly, scene(component(R"("all")", balls(color)) + "," + label, "", kWhole),
                                     R"([{"copy": "ASM-X0-2", "color": "#ff0000"}])");
    EXPECT_TRUE(drawn.guide->warnings.empty());
    const std::vector<Place> both{{{1, 102, 3}, kWhiteCopy}, {{11, 102, 3}, kRedCopy}}, places = placesOf(drawn);
    EXPECT_TRUE(std::is_permutation(both.begin(), both.end(), places.begin(), places.end()));
    ASSERT_EQ(drawn.guide->primitives.labels.size(), 1u);
    EXPECT_NEAR(glm::distance(drawn.guide->primitives.labels[0].at, glm::dvec3(11, 102, 3)), 0, 1e-4);
    EXPECT_EQ(drawn.guide->primitives.labels[0].color, kRedCopy);
}

TEST(SceneInstances, GivePlacesToPrimitives) {
    const std::string tube = R"(,{"kind": "primitives", "children": [{"kind": "primitive", "params": {"kind": "tube",
        "start": {"instance_id": "ASM-X0-1"}, "end": {"instance_id": "ASM-X0-2"}}}]})";
    const Molecule drawn = builtFrom(kAssembly, scene(component(R"("all")", balls()), tube, kWhole));
    const Primitives::Line line = drawn.guide->primitives.lines.at(0);
    EXPECT_NEAR(glm::distance(line.a, glm::dvec3(1, 102, 3)), 0, 1e-4);
    EXPECT_NEAR(glm::distance(line.b, glm::dvec3(11, 102, 3)), 0, 1e-4);
}

TEST(SceneInstances, AreAtMostAThousand) {
    std::string ids;
    for (int i = 0; i < 1001; ++i) ids += R"(,{"instance_id": "ASM-)" + std::to_string(i) + "\"}";
    const auto show = [&](const std::string& list) {
        return builtFrom(kAssembly, scene(component("[" + list.substr(1) + "]", balls()), "", kWhole));
    };
    const std::string why = test::errorText([&] { show(ids); });
    EXPECT_NE(why.find("component 1: selectors name more than 1000 instances"), std::string::npos) << why;
    const std::string longOne = "ASM-X0-1" + std::string(200, ' ');  // else a thousand of them are large
    EXPECT_EQ(show(R"(,{"instance_id": ")" + longOne + "\"}").atoms.size(), 1u);
}

TEST(SceneInstances, AreNoNamesOfColumns) {
    const std::string node = R"({"kind": "color_from_uri", "params": {"uri": "b.json", "format": "json",
        "schema": "all_atomic", "field_remapping": {"instance_id": "ASM-X0-1"}}})";
    const std::string json = scene(component(R"("all")", balls(node)), "", kWhole);
    EXPECT_EQ(builtFrom(kAssembly, json, R"([{"color": "red"}])").atoms.size(), 1u);
}

TEST(SceneInstances, AreNotSoughtFurtherWhereAFileIsMissing) {
    const auto node = [](const std::string& uri) {
        return R"({"kind": "color_from_uri", "params": {"format": "json", "schema": "all_atomic", "uri": ")" + uri +
               "\"}}";
    };
    std::string asked;
    SceneSources sources;
    sources.fetch = [&](const std::string& uri) {
        asked += uri + " ";
        if (uri != "a.cif") throw Error("cannot fetch", uri, "there is none");
        return kAssembly;
    };
    const std::string json = scene(component(R"("all")", balls(node("one") + "," + node("two"))), "", kWhole);
    EXPECT_THROW(buildScene(parseScene(json, "scene.mvsj"), 0, "scene.mvsj", sources), Error);
    EXPECT_EQ(asked, "one a.cif ");
}

TEST(SceneInstances, AloneKeepTheModelOfTheirFile) {
    const std::string model = kPdb.substr(kPdb.find("ATOM")),
                      file = "MODEL        1\n" + model + "ENDMDL\nMODEL        2\n" + model + "ENDMDL\n";
    const auto modelOf = [&](const std::string& more) {
        const std::string type = R"("model", "model_index": 1)";
        return builtFrom(file, scene(component(more, balls()), "", type)).chains.at(0).model;
    };
    EXPECT_EQ(modelOf(R"("all")"), 2);
    EXPECT_EQ(modelOf(R"({"instance_id": "1_555"})"), 2);
}

// Of the second operation of P 21 21 21, 1/2 - x, -y, 1/2 + z, in a cell of 30, 40 and 50 Å.
TEST(SceneInstances, AreNamedByTheOperationsOfACrystal) {
    const auto shown = [](const std::string& id, const std::string& type) {
        return placesOf(built(scene(component(R"({"atom_id": 11, "instance_id": ")" + id + "\"}", balls()), "", type)));
    };
    EXPECT_EQ(shown("2_565", kCell), (std::vector<Place>{{{14, 38, 28}, kWhiteCopy}}));
    EXPECT_EQ(shown("1_555", kCell), (std::vector<Place>{{{1, 2, 3}, kWhiteCopy}}));
    EXPECT_EQ(shown("1_55(4)", R"("symmetry")"), (std::vector<Place>{{{1, 2, -47}, kWhiteCopy}}));
    EXPECT_EQ(shown("1_555", R"("model")"), (std::vector<Place>{{{1, 2, 3}, kWhiteCopy}}));
}

/// Where an operation moves the point (x, y, z) = (0.1, 0.2, 0.3) of a cubic or hexagonal cell.
glm::dvec3 moved(const std::string& group, std::size_t operation) {
    Molecule m;
    m.file.cell = {{10, 10, 10, 90, 90, group[2] == '6' ? 120.0 : 90.0}};
    m.file.spaceGroup = group;
    m.atoms.resize(1);
    const auto edges = cellEdges(m.file).value();
    const glm::dmat3 cell(edges[0], edges[1], edges[2]);
    return glm::inverse(cell) *
           (crystalMotion(m, operation, {}).value() * glm::dvec4(cell * glm::dvec3(.1, .2, .3), 1));
}

// As REMARK 290 of PDB files numbers them.
TEST(CrystalMotions, AreInTheOrderOfTheInternationalTables) {
    const auto isAt = [](const glm::dvec3& found, const glm::dvec3& expected) {
        EXPECT_NEAR(glm::distance(found, expected), 0, 1e-6) << found.x << ' ' << found.y << ' ' << found.z;
    };
    isAt(moved("P 43 21 2", 3), {.5 - .2, .5 + .1, .75 + .3});  // 1/2-y, 1/2+x, 3/4+z
    isAt(moved("P 43 21 2", 8), {-.2, -.1, .5 - .3});           // -y, -x, 1/2-z
    isAt(moved("C 2 2 21", 3), {-.1, .2, .5 - .3});             // -x, y, 1/2-z
    isAt(moved("C 2 2 21", 5), {.6, .7, .3});                   // 1/2+x, 1/2+y, z
    isAt(moved("P 61", 2), {-.2, -.1, 1 / 3.0 + .3});           // -y, x-y, 1/3+z
    isAt(moved("P 61", 4), {-.1, -.2, .5 + .3});                // -x, -y, 1/2+z
    isAt(moved("P 2 3", 5), {.3, .1, .2});                      // z, x, y
    isAt(moved("P 1 21 1", 2), {-.1, .7, -.3});                 // -x, 1/2+y, -z
    Molecule m;
    m.file.cell = {{10, 10, 10, 90, 90, 90}};
    m.file.spaceGroup = "P 1";
    m.atoms.resize(1);
    EXPECT_FALSE(crystalMotion(m, 2, {}));
}

TEST(SceneInstances, ComponentsMoveInAllOfThem) {
    const std::string twice = R"({"kind": "instance", "params": {"translation": [0,0,50]}},
        {"kind": "instance", "params": {"translation": [0,0,70]}},)",
                      up = R"({"kind": "transform", "params": {"translation": [0,5,0]}},)";
    const Molecule drawn = builtFrom(kAssembly, scene(twice + component(R"("all")", up + balls()), "", kWhole));
    EXPECT_TRUE(drawn.guide->warnings.empty());
    const std::vector<Place> expected{{{1, 107, 53}, kWhiteCopy},
                                      {{1, 107, 73}, kWhiteCopy},
                                      {{11, 107, 53}, kWhiteCopy},
                                      {{11, 107, 73}, kWhiteCopy}};
    const std::vector<Place> places = placesOf(drawn);
    ASSERT_EQ(places.size(), expected.size());
    EXPECT_TRUE(std::is_permutation(expected.begin(), expected.end(), places.begin()));
}

}  // namespace
}  // namespace nacre::app::mvs
