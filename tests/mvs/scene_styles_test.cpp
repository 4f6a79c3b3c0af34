// Sizes and colours of a scene's representations, and scenes with faults that draw what is left.

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <glm/geometric.hpp>

#include "app/mvs/molstar_radii.h"
#include "engine/error.h"
#include "engine/molecule/residue_facts.h"
#include "engine/molecule/text.h"
#include "engine/scene/build/mesh_scene.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/build/scene_layers.h"
#include "engine/scene/view/scene_camera.h"
#include "tests/mesh/cartoon_makers.h"
#include "tests/mvs/small_scene.h"
#include "tests/support/error_text.h"

namespace nacre::app::mvs {
namespace {

std::string drawn(const std::string& params, const std::string& children = "") {
    return R"({"kind": "representation", "params": )" + params + R"(, "children": [)" + children + "]}";
}

SceneLayer buildLayer(const std::string& params, const std::string& selector = R"("all")") {
    return built(scene(component(selector, drawn(params)))).guide->layers.at(0);
}

/// What a scene becomes for the renderer.
Representation represented(const Molecule& molecule) {
    const ResidueFacts facts(molecule);
    const RepresentationOptions options;
    GuidedLayers guided;
    guided.layers = molecule.guide->layers;
    return representLayers(facts, guided, options, computeBounds(molecule, guided.layers));
}

/// The largest distance of a mesh's vertex from the centre of an only atom.
double meshRadius(const std::string& params) {
    return meshReach(represented(built(scene(component(R"({"atom_id": 17})", drawn(params))))));
}

std::vector<std::string> collectWarnings(const std::string& json) { return built(json).guide->warnings; }

bool anyHas(const std::vector<std::string>& texts, const std::string& part) {
    return std::any_of(texts.begin(), texts.end(),
                       [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

TEST(SceneSizes, FactorsScaleEveryStyle) {
    EXPECT_NEAR(buildLayer(R"({"type": "cartoon", "size_factor": 2})").cartoon.scale,
                2 * buildLayer(R"({"type": "cartoon"})").cartoon.scale, 1e-6);
    EXPECT_NEAR(meshRadius(R"({"type": "surface"})"), 1.7, 0.1);
    EXPECT_NEAR(meshRadius(R"({"type": "surface", "size_factor": 2})"), 3.4, 0.1);
    EXPECT_NEAR(meshRadius(R"({"type": "surface", "surface_type": "gaussian", "size_factor": 2})"), 3.4, 0.1);
    for (const char* type : {"ball_and_stick", "spacefill", "carbohydrate"})
        EXPECT_EQ(buildLayer(std::string(R"({"type": ")") + type + R"(", "size_factor": 3})", R"("all")").atomScale, 3)
            << type;
    EXPECT_FLOAT_EQ(buildLayer(R"({"type": "backbone", "size_factor": 3})").bondScale, 2);  // 0.6 Å instead of 0.3
    EXPECT_FLOAT_EQ(buildLayer(R"({"type": "line", "size_factor": 3})").atomScale, 4);      // 6 pixels instead of 1.5
}

TEST(SceneSizes, SurfacesHaveALargest) {
    const Molecule molecule = built(scene(component(R"("all")", drawn(R"({"type": "surface", "size_factor": 100})"))));
    EXPECT_EQ(molecule.guide->layers.at(0).surface.scale, 4);
    EXPECT_TRUE(anyHas(molecule.guide->warnings, "representation 1: surfaces have a size_factor of 4 at most"));
}

TEST(SceneSizes, PuttyIsATubeOfTheFactorOrOfTheTemperatures) {
    EXPECT_EQ(buildLayer(R"({"type": "putty"})").cartoon.tube, 1);
    // Mol*'s size theme: 0.2 Å and a tenth of the B factor.
    const CartoonOptions warm = buildLayer(R"({"type": "putty", "size_theme": "uncertainty"})").cartoon;
    EXPECT_EQ(warm.tube, 0.2);
    EXPECT_EQ(warm.tubePerTemperature, 0.1);
    const CartoonOptions wide = buildLayer(R"({"type": "putty", "size_factor": 2})").cartoon;
    EXPECT_NEAR(wide.tube * wide.scale, 4, 1e-9);  // Å: Mol* applies the factor twice
}

TEST(SceneSizes, AtomsHaveTheRadiiOfMolstar) {
    EXPECT_FLOAT_EQ(molstarRadius(Element{1}), 1.1f);
    EXPECT_FLOAT_EQ(molstarRadius(Element{30}), 2.1f);  // zinc
    EXPECT_FLOAT_EQ(molstarRadius(Element{0}), 1.7f);
    EXPECT_EQ(buildLayer(R"({"type": "spacefill"})").radius(Element{30}), 2.1f);
    EXPECT_EQ(buildLayer(R"({"type": "surface"})").surface.radius(Element{30}), 2.1f);
}

TEST(SceneSizes, CartoonsOfScenesHaveNoDisulphides) {
    EXPECT_FALSE(buildLayer(R"({"type": "cartoon"})").cartoon.disulfides);
}

TEST(SceneSizes, ManyCopiesAreCoarserTogether) {
    Molecule molecule = test::zigzag(100);
    SceneGuide guide;
    guide.layers.emplace_back().atoms = drawnAtoms(molecule);
    guide.layers[0].colors.assign(100, 0xffffffffu);
    const auto triangles = [&](int copies) {
        guide.transforms.clear();
        guide.lists.assign(1, {});
        for (int i = 0; i < copies; ++i) {
            guide.transforms.emplace_back(1.0);
            guide.transforms.back()[3] = glm::dvec3(10.0 * i, 0, 0);
            guide.lists[0].push_back(static_cast<std::uint32_t>(i));
        }
        guide.listOfResidue.assign(100, 0);
        molecule.guide = std::make_shared<SceneGuide>(guide);
        return represented(molecule).triangles.size();
    };
    const std::size_t few = triangles(2);
    EXPECT_EQ(triangles(200), few);  // 20,000 residues
    EXPECT_LT(triangles(201), few);
    EXPECT_LT(2 * triangles(601), few);  // 60,100
}

TEST(SceneColors, SymbolsOfSugarsTakeAColorNode) {
    const std::string type = R"({"type": "carbohydrate"})";
    const auto own = [&](const std::string& children) {
        return built(scene(component(R"("all")", drawn(type, children)))).guide->layers.at(0).ownColors;
    };
    EXPECT_FALSE(own(""));
    EXPECT_FALSE(own(R"({"kind": "opacity", "params": {"opacity": 0.5}})"));
    EXPECT_TRUE(own(R"({"kind": "color", "params": {"color": "red"}})"));
}

TEST(SceneTransforms, RotationsHaveACentre) {
    const auto placed = [](const std::string& center) {
        const Molecule molecule = built(scene(R"({"kind": "transform", "params": {"rotation": [-1,0,0,0,-1,0,0,0,1],
            "translation": [0, 0, 5], "rotation_center": )" +
                                              center + "}}," + component(R"("all")", balls())));
        return molecule.atoms[0].position;
    };
    // The first atom is at (1, 2, 3); all lie between x = 1 and 10, y = 2 and 9.
    EXPECT_NEAR(glm::distance(placed("null"), glm::vec3(-1, -2, 8)), 0, 1e-5);
    EXPECT_NEAR(glm::distance(placed("[10, 2, 0]"), glm::vec3(19, 2, 8)), 0, 1e-5);
    const glm::vec3 turned = placed(R"("centroid")");
    EXPECT_NEAR(turned.x, 10, 3);
    EXPECT_NEAR(turned.y, 7, 2);
    EXPECT_NEAR(turned.z, 8, 1e-5);
}

TEST(SceneTransforms, ACentreIsThatOfAllCopies) {
    const std::string cell = R"("symmetry", "ijk_min": [0,0,0], "ijk_max": [0,0,0])",
                      all = component(R"("all")", balls());
    const std::string turn = R"({"kind": "transform", "params": {"rotation": [-1,0,0,0,-1,0,0,0,1],
        "rotation_center": "centroid"}},)";
    const auto collectPlaces = [](const Molecule& molecule) {
        std::vector<glm::dvec4> places;
        for (const Atom& atom : molecule.atoms)
            for (const std::uint32_t copy : molecule.guide->lists[molecule.guide->listOfResidue[atom.residue]])
                places.emplace_back(molecule.guide->transforms[copy] * glm::dvec4(glm::dvec3(atom.position), 1.0), 0.0);
        return places;
    };
    const std::vector<glm::dvec4> still = collectPlaces(built(scene(all, "", cell))),
                                  turned = collectPlaces(built(scene(turn + all, "", cell)));
    ASSERT_EQ(still.size(), 36u);
    ASSERT_EQ(turned.size(), still.size());
    const glm::dvec3 center = extremeSphere(still).center;
    for (std::size_t i = 0; i < still.size(); ++i) {
        EXPECT_NEAR(still[i].x + turned[i].x, 2 * center.x, 1e-4);
        EXPECT_NEAR(still[i].y + turned[i].y, 2 * center.y, 1e-4);
    }
}

TEST(SceneTransforms, ComponentsMoveByThemselves) {
    const std::string moved = R"({"kind": "transform", "params": {"translation": [0,0,10]}},)",
                      whole = R"({"kind": "transform", "params": {"translation": [100,0,0]}},)";
    const Molecule molecule =
        built(scene(whole + component(R"("polymer")", balls()) + "," + component(R"("ligand")", moved + balls())));
    EXPECT_TRUE(molecule.guide->warnings.empty());
    ASSERT_EQ(molecule.guide->layers.size(), 2u);
    const auto first = [&](std::size_t layer) {
        return molecule.atoms[molecule.guide->layers[layer].atoms.at(0)].position;
    };
    EXPECT_NEAR(glm::distance(first(0), glm::vec3(101, 2, 3)), 0, 1e-4);
    EXPECT_NEAR(glm::distance(first(1), glm::vec3(109, 2, 13)), 0, 1e-4);
    const std::string twice = R"({"kind": "instance", "params": {"translation": [0,0,10]}},
        {"kind": "instance", "params": {"rotation": [-1,0,0,0,-1,0,0,0,1], "rotation_center": "centroid"}},)";
    const Molecule copies =
        built(scene(component(R"("polymer")", balls()) + "," + component(R"("ligand")", twice + balls())));
    const SceneGuide& guide = *copies.guide;
    const Atom& atom = copies.atoms[guide.layers.at(1).atoms.at(0)];
    const std::vector<std::uint32_t>& list = guide.lists[guide.listOfResidue[atom.residue]];
    ASSERT_EQ(list.size(), 2u);
    const glm::dvec3 turned = guide.transforms[list[1]] * glm::dvec4(glm::dvec3(atom.position), 1.0);
    EXPECT_NEAR(glm::distance(turned, glm::dvec3(10, 2, 3)), 0, 0.2);  // where the ligand's other atom was
    EXPECT_EQ(guide.lists[guide.listOfResidue[0]].size(), 1u);
}

// Some 20 s, were it found anew for each.
TEST(SceneTransforms, ACentreIsFoundOnceForAllInstances) {
    const std::string instance = R"({"kind": "instance", "params": {"rotation": [0,1,0,-1,0,0,0,0,1],
        "rotation_center": "centroid"}},)";
    std::string instances, pdb;
    for (int i = 0; i < 5000; ++i) instances += instance;
    for (int i = 0; i < 60'000; ++i) {
        pdb += formatted("HETATM%5d  O   HOH A%4d    %8.3f%8.3f%8.3f  1.00  0.00           O\n", i % 99999, i % 9999,
                         i % 97 * 3.0, i % 89 * 3.0, i % 83 * 3.0);
    }
    const SceneTree tree =
        parseScene(scene(instances + component(R"("all")", drawn(R"({"type": "spacefill"})"))), "a.mvsj");
    SceneSources sources;
    sources.fetch = [&](const std::string&) { return pdb; };
    const std::clock_t begin = std::clock();
    const Molecule molecule = buildScene(tree, 0, "a.mvsj", sources);
    EXPECT_LT(std::clock() - begin, 10 * CLOCKS_PER_SEC);
    EXPECT_EQ(molecule.guide->transforms.size(), 1u);
}

TEST(SceneFaults, NodesInTheWrongPlaceAreWarnings) {
    const auto warnings = collectWarnings(scene(
        component(R"("all")", balls(R"({"kind": "transform", "params": {}})") + R"(,{"kind": "camera", "params": {}})"),
        R"(,{"kind": "structure", "params": {"type": "model"}})"));
    EXPECT_TRUE(anyHas(warnings, "transform 1: it is not drawn below a representation node"));
    EXPECT_TRUE(anyHas(warnings, "camera 2: it is not drawn below a component node"));
    EXPECT_TRUE(anyHas(warnings, "root/structure 2: it is not drawn below a root node"));
    const std::string group = R"({"kind": ")" + std::string(100'000, 'x') + R"(", "children": [{"kind": "focus"}]})";
    const auto named =
        built(scene(component(R"("all")", balls()), R"(,{"kind": "primitives_from_uri", "params": {"uri": "b.json"}})"),
              group)
            .guide->warnings;
    ASSERT_TRUE(anyHas(named, "focus 1: it is not drawn below a xxx"));
    for (const std::string& warning : named) EXPECT_LT(warning.size(), 200u);  // one for each of many children
}

TEST(SceneFaults, WhatIsNoNodeIsLeftOut) {
    const auto warnings = collectWarnings(scene(
        component(R"("all")", balls()),
        R"(,{"kind": null}, 7, {"kind": "focus", "params": [1]}, {"kind": "download", "children": 1}, {"a": "b"})"));
    EXPECT_TRUE(anyHas(warnings, "root/node 2: it has no \"kind\""));
    EXPECT_TRUE(anyHas(warnings, "root/node 3: it is no object"));
    EXPECT_TRUE(anyHas(warnings, "root/focus 4: its \"params\" are no object"));
    EXPECT_TRUE(anyHas(warnings, "root/download 5: its \"children\" are no list"));
    EXPECT_TRUE(anyHas(warnings, "root/node 6: it has no \"kind\""));
    EXPECT_THROW(parseScene(R"({"root": {"kind": null}})", "a"), Error);
    EXPECT_THROW(parseScene(R"({"root": {"kind": "root", "children": 3}})", "a"), Error);
}

TEST(SceneFaults, TheReasonForNothingIsTold) {
    test::expectThrows([&] { built(R"({"root": {"kind": "root", "children": [{"params": {"url": "m.cif"}}]}})"); },
                       "it shows nothing: root/node 1: it has no \"kind\"");
}

TEST(SceneFaults, CamerasAndFocusesWithFaultsAreLeftOut) {
    const std::string all = component(R"("all")", balls());
    const Molecule molecule =
        built(scene(all, R"(,{"kind": "camera", "params": {"target": ["0",0,0], "position": [0,0,1e300]}},
                       {"kind": "focus", "params": {"direction": [1e9, 0, 0]}})"));
    EXPECT_TRUE(anyHas(molecule.guide->warnings, "camera 2: target is no list of three numbers within 1e6"));
    EXPECT_TRUE(anyHas(molecule.guide->warnings, "focus 3: direction is no list of three numbers within 1e6"));
    const Molecule plain = built(scene(all));
    ASSERT_TRUE(molecule.guide->camera && plain.guide->camera);
    EXPECT_EQ(molecule.guide->camera->radius, plain.guide->camera->radius);
}

TEST(SceneCamera, TheNearPlaneIsAsFarAsTheNodeSays) {
    const auto cutAt = [](const std::string& near) {
        const SceneCamera camera =
            built(scene(component(R"("all")", balls()),
                        R"(,{"kind": "camera", "params": {"target": [0,0,0], "position": [0,0,80])" + near + "}}"))
                .guide->camera.value();
        return makeView(camera, {}, false, 200, 100, 100);
    };
    const SceneView usual = cutAt(""), farther = cutAt(R"(, "near": 90)");
    EXPECT_NEAR(usual.clip.near, -40, 1e-9);
    EXPECT_NEAR(farther.clip.near, -(farther.view.eyeDistance - 90), 1e-9);
}

TEST(SceneFaults, PrimitivesWithFaultsAreLeftOut) {
    const std::string tube = R"({"kind": "primitive", "params": {"kind": "tube", "start": [0,0,0], "end": [1,0,0]}})";
    const std::string faults =
        R"({"kind": "primitive", "params": {"kind": "tube", "start": {"structure_ref": "none"}, "end": [1,0,0]}},
           {"kind": "primitive", "params": {"kind": "tube", "start": ["0",0,0], "end": [1,0,0]}},
           {"kind": "primitive", "params": {"kind": "mesh", "vertices": [0,0,0], "indices": [0,1,2]}},)";
    const Molecule molecule = built(
        scene(component(R"("all")", balls()), R"(,{"kind": "primitives", "children": [)" + faults + tube +
                                                  R"(]}, {"kind": "primitives", "params": {"instances": [[1, 2]]}})"));
    EXPECT_EQ(molecule.guide->primitives.lines.size(), 1u);
    EXPECT_TRUE(anyHas(molecule.guide->warnings, "primitive 1: there is no structure 'none': it is left out"));
    EXPECT_TRUE(anyHas(molecule.guide->warnings, "primitive 2: start has a value that is no number"));
    EXPECT_TRUE(anyHas(molecule.guide->warnings, "primitive 3: an index names a vertex that is not there"));
    EXPECT_TRUE(anyHas(molecule.guide->warnings, "primitives 3: an instance is no list of 16 numbers"));
}

TEST(SceneNodes, LabelsAndLinesHaveTheSizesOfMolstar) {
    const Molecule molecule = built(scene("", R"(,{"kind": "primitives", "children": [
        {"kind": "primitive", "params": {"kind": "label", "position": [0,0,0], "text": "a", "label_size": 2}},
        {"kind": "primitive", "params": {"kind": "distance_measurement", "start": [0,0,0], "end": [10,0,0],
                                         "label_size": 1.5}},
        {"kind": "primitive", "params": {"kind": "lines", "vertices": [0,0,0,1,0,0], "indices": [0,1], "width": 3}}]})"));
    const Primitives& primitives = molecule.guide->primitives;
    ASSERT_EQ(primitives.labels.size(), 2u);
    EXPECT_NEAR(primitives.labels[0].size, 1.2, 1e-9);
    EXPECT_NEAR(primitives.labels[1].size, 0.9, 1e-9);
    ASSERT_EQ(primitives.lines.size(), 2u);
    EXPECT_EQ(primitives.lines[1].width, 6);
}

TEST(SceneNodes, HeadsOfAnArrowHaveSizesOfTheirOwn) {
    const Molecule molecule = built(scene("", R"(,{"kind": "primitives", "children": [{"kind": "primitive", "params":
        {"kind": "arrow", "start": [0,0,0], "end": [10,0,0], "show_start_cap": true, "start_cap_length": 1,
         "start_cap_radius": 0.5, "show_end_cap": true, "end_cap_length": 2, "end_cap_radius": 0.7}}]})"));
    const std::vector<Primitives::Arrow>& arrows = molecule.guide->primitives.arrows;
    ASSERT_EQ(arrows.size(), 2u);
    EXPECT_TRUE(arrows[0].headAtFrom && !arrows[0].headAtTo && !arrows[1].headAtFrom && arrows[1].headAtTo);
    EXPECT_EQ(arrows[0].headRadius, 0.5);
    EXPECT_EQ(arrows[1].headRadius, 0.7);
    EXPECT_EQ(arrows[0].radius, 0);
    EXPECT_EQ(arrows[1].from, glm::dvec3(1, 0, 0));
}

TEST(SceneNodes, LabelOffsetsAreKnown) {
    const auto warnings = collectWarnings(
        scene(component(R"("all")", balls()), R"(,{"kind": "primitives", "children": [{"kind": "primitive", "params":
            {"kind": "label", "position": [0,0,0], "text": "a", "label_offset": 2}}]})"));
    EXPECT_TRUE(warnings.empty());
}

}  // namespace
}  // namespace nacre::app::mvs
