// MolViewSpec scenes without a device: trees, selectors, annotations, archives, and what a scene becomes.

#include <gtest/gtest.h>
#include <zip.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/mvs/annotations.h"
#include "app/mvs/node_table.h"
#include "app/mvs/scene_file.h"
#include "engine/error.h"
#include "engine/scene/build/scene_guide.h"
#include "engine/scene/build/scene_layers.h"
#include "engine/scene/color/colors.h"
#include "engine/scene/view/scene_camera.h"
#include "tests/mvs/small_scene.h"
#include "tests/support/temporary_folder.h"

namespace nacre::app::mvs {
namespace {

std::vector<std::uint32_t> selectedAtoms(const std::string& selector) {
    const Molecule molecule = built(scene(component(selector, balls())));
    return molecule.guide->layers.empty() ? std::vector<std::uint32_t>() : molecule.guide->layers.front().atoms;
}

using Atoms = std::vector<std::uint32_t>;

TEST(SceneSelectors, StaticNamesFollowEntities) {
    EXPECT_EQ(selectedAtoms(R"("polymer")"), (Atoms{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(selectedAtoms(R"("protein")"), (Atoms{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(selectedAtoms(R"("ligand")"), (Atoms{6, 7}));
    EXPECT_EQ(selectedAtoms(R"("water")"), (Atoms{8}));
    EXPECT_EQ(selectedAtoms(R"("nucleic")"), Atoms());
    EXPECT_EQ(selectedAtoms(R"("all")").size(), 9u);
}

/// Atoms of a named selector, with changes of the structure's text.
Atoms selectedIn(const std::string& name, const std::vector<std::pair<std::string, std::string>>& changes) {
    std::string structure = kStructure;
    for (const auto& [from, to] : changes) structure.replace(structure.find(from), from.size(), to);
    SceneSources sources;
    sources.fetch = [&](const std::string&) { return structure; };
    const Molecule molecule =
        buildScene(parseScene(scene(component('"' + name + '"', balls())), "a.mvsj"), 0, "a.mvsj", sources);
    return molecule.guide->layers.at(0).atoms;
}

TEST(SceneSelectors, LigandsAndSugarsHaveTheResiduesThatAreBondedToThem) {
    const std::pair<std::string, std::string> near{"200 X 9 2 3", "200 X 6.5 2 3"},
        sugar{"2 non-polymer", "2 branched"}, iron{"17 C C1 LIG B 2 . 200 X 9 2 3", "17 FE C1 LIG B 2 . 200 X 3 5.1 3"};
    EXPECT_EQ(selectedIn("ligand", {near}), (Atoms{4, 5, 6, 7}));
    EXPECT_EQ(selectedIn("branched", {near, sugar}), (Atoms{4, 5, 6, 7}));
    EXPECT_EQ(selectedIn("ligand", {iron}), (Atoms{0, 1, 2, 3, 6, 7}));  // near an oxygen
    EXPECT_EQ(selectedIn("branched", {iron, sugar}), (Atoms{6, 7}));
    EXPECT_EQ(selectedIn("polymer", {near}), (Atoms{0, 1, 2, 3, 4, 5}));
    // A file without branched entities.
    const std::pair<std::string, std::string> first{"O1 LIG B", "O1 NAG B"}, second{"C1 LIG B", "C1 NAG B"};
    EXPECT_EQ(selectedIn("branched", {first, second}), (Atoms{6, 7}));
}

TEST(SceneSelectors, ExpressionsTakeEveryField) {
    EXPECT_EQ(selectedAtoms(R"({"label_asym_id": "B"})"), (Atoms{6, 7}));
    EXPECT_EQ(selectedAtoms(R"({"auth_asym_id": "X", "auth_seq_id": 102})"), (Atoms{4, 5}));
    EXPECT_EQ(selectedAtoms(R"({"label_asym_id": "A", "label_seq_id": 1})"), (Atoms{0, 1, 2, 3}));
    EXPECT_EQ(selectedAtoms(R"({"beg_label_seq_id": 2, "end_label_seq_id": 9})"), (Atoms{4, 5}));
    EXPECT_EQ(selectedAtoms(R"({"beg_auth_seq_id": 102, "end_auth_seq_id": 200})"), (Atoms{4, 5, 6, 7}));
    EXPECT_EQ(selectedAtoms(R"({"label_entity_id": "2"})"), (Atoms{6, 7}));
    EXPECT_EQ(selectedAtoms(R"({"label_atom_id": "CA"})"), (Atoms{1, 5}));
    EXPECT_EQ(selectedAtoms(R"({"type_symbol": "O"})"), (Atoms{3, 7, 8}));
    EXPECT_EQ(selectedAtoms(R"({"atom_id": 12})"), (Atoms{1}));
    EXPECT_EQ(selectedAtoms(R"({"atom_index": 2})"), (Atoms{2}));
    EXPECT_EQ(selectedAtoms(R"({"residue_index": 1})"), (Atoms{4, 5}));
    EXPECT_EQ(selectedAtoms(R"([{"atom_id": 12}, {"label_asym_id": "B"}])"), (Atoms{1, 6, 7}));
}

TEST(SceneColors, LaterNodesOverrideEarlierOnes) {
    const Molecule molecule =
        built(scene(component(R"("polymer")", balls(R"({"kind": "color", "params": {"color": "green"}},
                                 {"kind": "color", "params": {"selector": {"label_seq_id": 2}, "color": "#6688ff"}})"))));
    const SceneLayer& layer = molecule.guide->layers.at(0);
    EXPECT_EQ(layer.colors[0], 0xff008000u);
    EXPECT_EQ(layer.colors[5], 0xffff8866u);
}

TEST(SceneColors, WithoutAColourANodeKeepsThoseOfElements) {
    const Molecule molecule =
        built(scene(component(R"("polymer")", balls(R"({"kind": "color", "params": {"color": "green"}},
                                 {"kind": "color", "params": {"selector": {"label_seq_id": 2}}})"))));
    const SceneLayer& layer = molecule.guide->layers.at(0);
    EXPECT_EQ(layer.colors[0], 0xff008000u);
    EXPECT_EQ(layer.colors[4], elementColor(7));
    EXPECT_EQ(layer.colors[5], elementColor(6));
}

TEST(SceneColors, WithoutANodeTheyAreWhiteAndAnnotationsMayBeRowsOrColumns) {
    EXPECT_EQ(built(scene(component(R"("polymer")", balls()))).guide->layers.at(0).colors[0], 0xffffffffu);
    const std::string node = R"({"kind": "color_from_uri", "params":
        {"uri": "b.json", "format": "json", "schema": "residue_range"}})";
    for (const char* annotations :
         {R"([{"label_asym_id": "A", "beg_label_seq_id": 2, "end_label_seq_id": 2, "color": "red"}])",
          R"({"label_asym_id": ["A"], "beg_label_seq_id": [2], "end_label_seq_id": [2], "color": ["red"]})",
          "loop_\n_t.label_asym_id\n_t.beg_label_seq_id\n_t.end_label_seq_id\n_t.color\nA 2 2 red\n"}) {
        const Molecule molecule = built(scene(component(R"("polymer")", balls(node))), annotations);
        EXPECT_EQ(molecule.guide->layers.at(0).colors[0], 0xffffffffu);
        EXPECT_EQ(molecule.guide->layers.at(0).colors[4], 0xff0000ffu) << annotations;
    }
}

TEST(SceneStructures, TransformsMoveAtomsAndSymmetryMakesCopies) {
    const Molecule moved = built(scene(R"({"kind": "transform", "params": {"rotation": [0,1,0,-1,0,0,0,0,1],
        "translation": [10, 0, 0]}},)" +
                                       component(R"("all")", balls())));
    EXPECT_NEAR(glm::distance(moved.atoms[0].position, glm::vec3(8, 1, 3)), 0, 1e-5);  // (1, 2, 3) turned, then shifted
    const Molecule crystal =
        built(scene(component(R"("all")", balls()), "", R"("symmetry", "ijk_min": [0,0,0], "ijk_max": [0,0,0])"));
    EXPECT_EQ(crystal.guide->transforms.size(), 4u);  // of P 21 21 21
    EXPECT_EQ(built(scene(component(R"("all")", balls()), "", R"("symmetry")")).guide->transforms.size(), 108u);
}

TEST(SceneCamera, PositionIsThatOfACameraToWhichHalfItsDistanceFillsThePicture) {
    const Molecule molecule =
        built(scene(component(R"("all")", balls()),
                    R"(,{"kind": "camera", "params": {"target": [0,0,0], "position": [0,0,20], "up": [0,1,0]}})"));
    ASSERT_TRUE(molecule.guide->camera);
    EXPECT_NEAR(molecule.guide->camera->distance, 10 / std::sin(std::numbers::pi / 8), 1e-9);
    EXPECT_NEAR(molecule.guide->camera->radius, 10, 1e-12);
}

TEST(SceneCamera, FocusHoldsTheSpheresOfAtoms) {
    const Molecule molecule = built(scene(component(R"({"label_asym_id": "B"})", balls() + R"(,{"kind": "focus"})")));
    ASSERT_TRUE(molecule.guide->camera);
    // A carbon of 1.7 Å at x = 9, and an oxygen of 1.52 Å at 10.
    EXPECT_NEAR(molecule.guide->camera->radius, (11.52 - 7.3) / 2, 0.1);
    EXPECT_NEAR(glm::distance(molecule.guide->camera->target, glm::dvec3((11.52 + 7.3) / 2, 2, 3)), 0, 0.1);
}

TEST(SceneCamera, CartoonsOfAllHoldNoLigands) {
    const Molecule cartoon =
        built(scene(component(R"("all")", R"({"kind": "representation", "params": {"type": "cartoon"}})")));
    const Molecule ballsOfAll = built(scene(component(R"("all")", balls())));
    ASSERT_TRUE(cartoon.guide->camera && ballsOfAll.guide->camera);
    EXPECT_LT(cartoon.guide->camera->radius + 1, ballsOfAll.guide->camera->radius);
}

TEST(SceneCamera, BallsTakeUpRoomTwice) {
    const auto radius = [](const std::string& type) {
        const std::string drawn = R"({"kind": "representation", "params": {"type": ")" + type + R"("}})";
        return built(scene(component(R"("ligand")", drawn))).guide->camera->radius;
    };
    EXPECT_GT(radius("spacefill") - radius("surface"), 1.7);
    EXPECT_NEAR(radius("surface") - radius("ball_and_stick"), 0.8, 0.2);
}

TEST(SceneCamera, LabelsTakeUpRoom) {
    const std::string word = R"({"kind": "label", "params": {"text": ")";
    const Molecule wide = built(scene(component(R"("all")", balls() + "," + word + std::string(200, 'x') + "\"}}")));
    const Molecule narrow = built(scene(component(R"("all")", balls() + "," + word + "x\"}}")));
    EXPECT_GT(wide.guide->camera->radius, 2 * narrow.guide->camera->radius);
}

TEST(SceneTooltips, AllThatNameAnAtomAreSaidOfIt) {
    const std::string tip = R"({"kind": "tooltip", "params": {"text": ")";
    const Molecule molecule = built(scene(component(R"("all")", tip + "whole\"}}") + "," +
                                          component(R"({"label_asym_id": "B"})", tip + "ligand\"}}")));
    EXPECT_EQ(joinTooltips(*molecule.guide, 0), "whole");
    EXPECT_EQ(joinTooltips(*molecule.guide, 6), "whole; ligand");
    EXPECT_EQ(joinTooltips(*molecule.guide, 100), "");
}

TEST(ScenePrimitives, InstancesAreCopies) {
    const Molecule molecule = built(R"({"root": {"kind": "root", "children": [{"kind": "primitives", "params":
        {"instances": [[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], [0,1,0,0, -1,0,0,0, 0,0,1,0, 10,0,0,1]]}, "children": [
        {"kind": "primitive", "params": {"kind": "tube", "start": [1, 0, 0], "end": [2, 0, 0]}}]}]}})");
    const auto& lines = molecule.guide->primitives.lines;
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_LT(glm::distance(lines[0].b, glm::dvec3(2, 0, 0)), 1e-9);
    EXPECT_LT(glm::distance(lines[1].a, glm::dvec3(10, 1, 0)), 1e-9);
    EXPECT_LT(glm::distance(lines[1].b, glm::dvec3(10, 2, 0)), 1e-9);
}

// Mol* 5.11's pictures: dashes are twice as long as dash_length says, and oblique axes are made upright.
TEST(ScenePrimitives, DashesAndAxesAreThoseOfMolstar) {
    const auto primitives = [](const std::string& params) {
        return built(R"({"root": {"kind": "root", "children": [{"kind": "primitives", "children": [
            {"kind": "primitive", "params": {)" +
                     params + "}}]}]}}")
            .guide->primitives;
    };
    EXPECT_EQ(
        primitives(R"("kind": "tube", "start": [0,0,0], "end": [9,0,0], "dash_length": 0.5)").lines.at(0).dashes.dash,
        1);
    const auto ellipse =
        primitives(R"("kind": "ellipse", "center": [0,0,0], "major_axis": [3,0,0], "minor_axis": [1,1,0])")
            .ellipses.at(0);
    EXPECT_LT(glm::distance(ellipse.major, glm::dvec3(3, 0, 0)), 1e-9);
    EXPECT_LT(glm::distance(ellipse.minor, glm::dvec3(0, std::numbers::sqrt2, 0)), 1e-9);
    const auto axes =
        primitives(R"("kind": "ellipsoid", "center": [0,0,0], "major_axis": [1,0,0], "minor_axis": [0,2,2],
        "radius": [3,2,1])")
            .ellipsoids.at(0)
            .axes;
    EXPECT_LT(glm::distance(axes[0], glm::dvec3(3, 0, 0)), 1e-9);
    EXPECT_LT(glm::distance(axes[1], glm::dvec3(0, std::numbers::sqrt2, std::numbers::sqrt2)), 1e-9);
    const auto turned = primitives(R"("kind": "ellipsoid", "center": [0,0,0], "major_axis": [1,1,0],
        "minor_axis": [0,1,0], "radius": [3,2,1])")
                            .ellipsoids.at(0)
                            .axes;
    EXPECT_LT(glm::distance(turned[0], glm::dvec3(3, 0, 0)), 1e-9);  // the minor axis stays
    EXPECT_THROW(primitives(R"("kind": "ellipse", "center": [0,0,0], "major_axis": [3,0,0], "minor_axis": [1,0,0])"),
                 Error);  // it shows nothing
}

TEST(ScenePrimitives, WiresHaveTheColoursOfTheirTriangles) {
    const auto mesh = [](const std::string& more) {
        return built(R"({"root": {"kind": "root", "children": [{"kind": "primitives", "children": [{"kind": "primitive",
            "params": {"kind": "mesh", "vertices": [0,0,0, 1,0,0, 1,1,0, 0,1,0], "indices": [0,1,2,0,2,3],
            "show_wireframe": true, "color": "lime", "group_colors": {"1": "red"})" +
                     more + "}}]}]}}")
            .guide->primitives;
    };
    const Primitives own = mesh("");
    ASSERT_EQ(own.lines.size(), 5u);
    EXPECT_EQ(own.lines[2].look.color, packedColor(0x00ff00));  // which both have
    EXPECT_EQ(own.lines[4].look.color, packedColor(0xff0000));
    EXPECT_FALSE(own.meshes.at(0).wires);
    const Primitives named = mesh(R"(, "wireframe_color": "blue")");
    EXPECT_TRUE(named.lines.empty());
    EXPECT_EQ(named.meshes.at(0).wires->color, packedColor(0x0000ff));
}

TEST(ScenePrimitives, AtomsOfAllCopiesGiveTheirPlace) {
    const std::string cell = R"("symmetry", "ijk_min": [0,0,0], "ijk_max": [0,0,0])";
    const Molecule molecule =
        built(scene(component(R"({"atom_id": 12})", R"({"kind": "label", "params": {"text": "a"}})") + "," +
                        component(R"("all")", balls()) +
                        R"(,{"kind": "primitives", "children": [{"kind": "primitive", "params":
        {"kind": "label", "position": {"atom_id": 12}, "text": "b"}}]})",
                    "", cell));
    const SceneGuide& guide = *molecule.guide;
    ASSERT_EQ(guide.transforms.size(), 4u);
    std::vector<glm::dvec4> places;
    for (const glm::dmat4x3& copy : guide.transforms)
        places.emplace_back(copy * glm::dvec4(glm::dvec3(molecule.atoms[1].position), 1.0), 0.0);
    ASSERT_EQ(guide.primitives.labels.size(), 2u);
    for (const Primitives::Label& label : guide.primitives.labels)
        EXPECT_LT(glm::distance(label.at, extremeSphere(places).center), 0.5) << label.text;
}

TEST(ScenePrimitives, LabelsHavePlates) {
    const auto group = [](const std::string& params) {
        return built(R"({"root": {"kind": "root", "children": [{"kind": "primitives", "params": {)" + params +
                     R"(}, "children": [{"kind": "primitive", "params":
        {"kind": "label", "position": [0, 0, 0], "text": "a"}}]}]}})");
    };
    const auto plate = [&](const std::string& params) { return group(params).guide->primitives.labels.at(0).plate; };
    EXPECT_FALSE(plate("").background);
    EXPECT_EQ(plate(R"("label_tether_length": 2)"), plate("")) << "without a tether";
    const Primitives::LabelPlate full = plate(R"("label_attachment": "bottom-left", "label_show_tether": true,
        "label_tether_length": 3, "label_background_color": "blue")");
    EXPECT_EQ(full.side, glm::ivec2(1, 1)) << "the text lies to the right of its point, and above";
    EXPECT_NEAR(full.tether, 5, 1e-9);  // em
    EXPECT_TRUE(full.background);
    EXPECT_EQ(full.color, packedColor(0x0000ff));
    EXPECT_EQ(plate(R"("label_attachment": "top-right")").side, glm::ivec2(-1, -1));
    EXPECT_EQ(plate(R"("label_attachment": "middle-center")").side, glm::ivec2(0, 0));
    const Molecule odd = group(R"("label_attachment": "left", "label_background_color": "none")");
    EXPECT_EQ(odd.guide->warnings.size(), 2u);
    EXPECT_EQ(odd.guide->primitives.labels.at(0).plate, plate(""));
}

TEST(ScenePrimitives, DistancesAreRoundedAndBoxesHaveRoom) {
    const Molecule molecule = built(R"({"root": {"kind": "root", "children": [{"kind": "primitives", "children": [
        {"kind": "primitive", "params": {"kind": "distance_measurement", "start": [0, 0, 0], "end": [3.5, 0, 0]}},
        {"kind": "primitive", "params": {"kind": "box", "center": [0, 0, 0]}}]}]}})");
    ASSERT_EQ(molecule.guide->primitives.labels.size(), 1u);
    EXPECT_EQ(molecule.guide->primitives.labels.front().text, "3.5 Å");
    EXPECT_TRUE(molecule.guide->primitives.boxes.empty());
    EXPECT_EQ(molecule.guide->warnings.size(), 1u);
}

TEST(SceneVolumes, ContoursHaveTheirLevelColourAndPlace) {
    const Molecule molecule = built(volume(
        R"({"type": "isosurface", "relative_isovalue": 2, "show_wireframe": true})",
        R"({"kind": "color", "params": {"color": "#0000ff"}}, {"kind": "opacity", "params": {"opacity": 0.25}})"));
    ASSERT_EQ(molecule.guide->volumes.size(), 1u);
    const SceneVolume& shown = molecule.guide->volumes.front();
    const double mean = 1 / 27.0, sigma = std::sqrt(mean - mean * mean);
    EXPECT_NEAR(shown.level, mean + 2 * sigma, 1e-9);
    EXPECT_TRUE(shown.wires && shown.faces);
    EXPECT_EQ(shown.color, 0xffff0000u);
    EXPECT_EQ(shown.opacity, 0.25);
    EXPECT_LT(glm::distance(shown.ball.center, glm::dvec3(1)), 1e-9);
    EXPECT_NEAR(shown.ball.radius, std::sqrt(3.0), 1e-9);
    EXPECT_TRUE(molecule.guide->warnings.empty());
    ASSERT_TRUE(molecule.guide->camera);
    EXPECT_NEAR(molecule.guide->camera->radius, std::sqrt(3.0), 0.01);
}

TEST(SceneVolumes, AbsoluteValuesWinAndTransformsMoveMaps) {
    const Molecule molecule =
        built(volume(R"({"type": "isosurface", "relative_isovalue": 2, "absolute_isovalue": 0.5})", "",
                     R"({"kind": "transform", "params": {"translation": [10, 0, 0]}},)"));
    ASSERT_EQ(molecule.guide->volumes.size(), 1u);
    EXPECT_EQ(molecule.guide->volumes.front().level, 0.5);
    EXPECT_LT(glm::distance(molecule.guide->volumes.front().ball.center, glm::dvec3(11, 1, 1)), 1e-9);
}

TEST(SceneVolumes, InstancesShareTheirValues) {
    const Molecule molecule = built(volume(R"({"type": "isosurface", "absolute_isovalue": 0.5})", "",
                                           R"({"kind": "instance", "params": {"translation": [10, 0, 0]}},
                                              {"kind": "instance", "params": {"translation": [20, 0, 0]}},)"));
    ASSERT_EQ(molecule.guide->volumes.size(), 2u);
    const DensityMap &first = *molecule.guide->volumes[0].map, &second = *molecule.guide->volumes[1].map;
    EXPECT_EQ(second.origin.x - first.origin.x, 10);
    EXPECT_EQ(first.values.data(), second.values.data());
}

TEST(SceneVolumes, SlicesLieAtTheirNode) {
    const Molecule half = built(volume(R"({"type": "grid_slice", "dimension": "y", "relative_index": 0.4})"));
    ASSERT_EQ(half.guide->volumes.size(), 1u);
    EXPECT_EQ(half.guide->volumes.front().axis, 1);
    EXPECT_EQ(half.guide->volumes.front().place, 0.5);  // node 1 of 0 to 2
    const Molecule last = built(volume(R"({"type": "grid_slice", "dimension": "x", "absolute_index": 2})"));
    EXPECT_EQ(last.guide->volumes.front().place, 1.0);
    EXPECT_NEAR(last.guide->volumes.front().least.value(), 1 / 27.0, 1e-6);  // the mean
}

TEST(SceneVolumes, SlicesHaveALeastValue) {
    const auto least = [](const std::string& level) {
        return built(volume(R"({"type": "grid_slice", "dimension": "x", )" + level + "}")).guide->volumes.at(0).least;
    };
    EXPECT_EQ(least(R"("absolute_isovalue": 0.4, "relative_isovalue": 1)"), 0.4);
    // One value in 27 is 1: the mean is 1/27, the deviation the square root of 26 of that.
    EXPECT_NEAR(least(R"("relative_isovalue": 2)").value(), (1 + 2 * std::sqrt(26.0)) / 27, 1e-6);
}

TEST(SceneVolumes, UnknownTypesAndUnreachedLevelsAreWarnings) {
    const std::string structure = component(R"("all")", balls());
    const auto with = [&](const std::string& params) {
        return built(scene(structure, R"(,{"kind": "download", "params": {"url": "m.dx"}, "children": [
            {"kind": "parse", "params": {"format": "dx"}, "children": [{"kind": "volume", "children": [
            {"kind": "volume_representation", "params": )" +
                                          params + "}]}]}]}"));
    };
    for (const char* params : {R"({"type": "cloud"})", R"({"type": "isosurface", "absolute_isovalue": 7})",
                               R"({"type": "grid_slice", "dimension": "w"})"}) {
        const Molecule molecule = with(params);
        EXPECT_TRUE(molecule.guide->volumes.empty()) << params;
        EXPECT_EQ(molecule.guide->warnings.size(), 1u) << params;
    }
}

TEST(SceneWarning, UnknownThingsNameTheirPlace) {
    const Molecule molecule =
        built(scene(component(R"("all")", R"({"kind": "hologram"},)" +
                                              balls(R"({"kind": "color", "params": {"color": "red", "mood": 1}})"))));
    const std::vector<std::string>& warnings = molecule.guide->warnings;
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_EQ(warnings[0],
              "root/download 1/parse 1/structure 1/component 1/hologram 1: nodes of this kind are not drawn");
    EXPECT_EQ(warnings[1],
              "root/download 1/parse 1/structure 1/component 1/representation 2/color 1: its parameter 'mood' is not "
              "used");
}

TEST(SceneRefusals, OneLineEach) {
    const auto refused = [](const std::string& json) {
        try {
            built(json);
        } catch (const Error& error) {
            return std::string(error.what()).find('\n') == std::string::npos;
        }
        return false;
    };
    EXPECT_TRUE(refused("{"));
    EXPECT_TRUE(refused(R"({"root": {"kind": "download"}})"));
    EXPECT_TRUE(refused(std::string(200, '[')));
    EXPECT_TRUE(refused(
        scene(R"({"kind": "transform", "params": {"translation": [1e300, 0, 0]}},)" + component(R"("all")", balls()))));
    EXPECT_TRUE(refused(scene(R"({"kind": "transform", "params": {"rotation": [2,0,0,0,1,0,0,0,1]}},)" +
                              component(R"("all")", balls()))));
    EXPECT_TRUE(refused(scene(component(R"("all")", balls()), "",
                              R"("symmetry", "ijk_min": [-900,-900,-900], "ijk_max": [900,900,900])")));
}

std::string makeZip(const std::vector<std::pair<std::string, std::string>>& entries) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* out = zip_source_buffer_create(nullptr, 0, 0, &error);
    zip_source_keep(out);
    zip_t* archive = zip_open_from_source(out, ZIP_TRUNCATE, &error);
    for (const auto& [name, bytes] : entries)
        zip_file_add(archive, name.c_str(), zip_source_buffer(archive, bytes.data(), bytes.size(), 0), 0);
    EXPECT_EQ(zip_close(archive), 0);
    zip_source_open(out);
    zip_stat_t facts;
    zip_source_stat(out, &facts);
    std::string bytes(facts.size, '\0');
    zip_source_read(out, bytes.data(), bytes.size());
    zip_source_close(out);
    zip_source_free(out);
    return bytes;
}

TEST(SceneFiles, AreKnownByWordsThatComeLate) {
    const test::TemporaryFolder folder;
    const std::string text = R"({"metadata": {"description": ")" + std::string(100'000, 'x') + R"("}, )";
    std::ofstream(folder / "a") << text << R"("root": {"kind": "root"}})";
    EXPECT_TRUE(isSceneFile(folder / "a"));
    EXPECT_EQ(readScene(folder / "a")->size(), std::filesystem::file_size(std::string(folder / "a")));
    std::ofstream(folder / "c") << R"({"data_1ABC": {"root": {"kind": "root"}}})";
    EXPECT_FALSE(isSceneFile(folder / "c"));
    EXPECT_FALSE(readScene(folder / "none"));
}

TEST(SceneArchives, HoldTheirFilesAndNothingElse) {
    const std::string index = scene(component(R"("all")", balls()));
    const SceneFile file("a.mvsx", makeZip({{"index.mvsj", index}, {"a.cif", kStructure}}));
    ASSERT_TRUE(file.archive);
    EXPECT_EQ(file.archive->read("a.cif"), kStructure);
    EXPECT_THROW(file.archive->read("b.cif"), Error);
    EXPECT_THROW(SceneFile("a.mvsx", makeZip({{"a.cif", kStructure}})), Error);
    EXPECT_THROW(SceneFile("a.mvsx", makeZip({{"index.mvsj", index}, {"../a.cif", kStructure}})), Error);
    EXPECT_THROW(SceneFile("a.mvsx", "PK\x03\x04 and no more"), Error);
}

TEST(SceneArchives, BombsAreRefusedByTheirStatedSizes) {
    const SceneFile file("a.mvsx", makeZip({{"index.mvsj", scene(component(R"("all")", balls()))},
                                            {"zeros", std::string(64 << 20, '\0')}}));
    EXPECT_THROW(file.archive->read("zeros"), Error);
}

TEST(SceneNodes, EveryRowIsFoundByItsKind) {
    for (const NodeRow& row : nodeRows()) EXPECT_EQ(nodeRow(row.kind), &row);
    EXPECT_TRUE(nodeRow("camera")->knows("target"));
    EXPECT_FALSE(nodeRow("camera")->knows("tar"));
}

}  // namespace
}  // namespace nacre::app::mvs
