// Pictures as MolViewSpec scenes: read back, they say the same.
#include "app/mvs/write_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "app/mvs/build_scene.h"
#include "app/mvs/scene_tree.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/scene/build/scene_layers.h"
#include "engine/volume/read_map.h"
#include "tests/support/temporary_folder.h"

namespace nacre::app::mvs {
namespace {

using nlohmann::json;

constexpr const char* kTwoResidues = R"(ATOM      1  N   ALA A   1       1.000   2.000   3.000  1.00  0.00           N
ATOM      2  CA  ALA A   1       2.400   2.000   3.000  1.00  0.00           C
ATOM      3  C   ALA A   1       3.000   3.300   3.000  1.00  0.00           C
ATOM      4  O   ALA A   1       2.400   4.300   3.000  1.00  0.00           O
HETATM    5 ZN    ZN B   2       8.000   2.000   3.000  1.00  0.00          ZN
)";

PictureDescription picture() {
    PictureDescription d;
    d.input.path = "m.pdb";
    d.look.style = Style::ballAndStick;
    d.look.rules = {};
    d.background = {0, 0, 1, 1};
    d.words.title = "Two residues";
    return d;
}

SceneCamera camera() {
    SceneCamera camera{.target = {4, 2, 3}, .direction = {1, 0, 0}, .up = {0, 0, 1}, .radius = 9};
    return camera;
}

Molecule molecule() { return readMolecule("m.pdb", kTwoResidues); }

Molecule readBack(const WrittenScene& written, const std::string& structure = kTwoResidues) {
    const SceneTree tree = parseScene(written.json, "out.mvsj");
    SceneSources sources;
    sources.fetch = [&](const std::string&) { return structure; };
    return buildScene(tree, 0, "out.mvsj", sources);
}

TEST(WrittenScenes, ReadBackAreTheSame) {
    const Molecule m = molecule();
    PictureDescription d = picture();
    d.words.labels = {{parseSelection("resn ZN"), "zinc"}};
    const WrittenScene written = writeScene(m, d, {}, camera(), "out.mvsj");
    EXPECT_TRUE(written.notes.empty()) << written.notes.front();
    const Molecule again = readBack(written);
    const SceneGuide& guide = *again.guide;
    EXPECT_TRUE(guide.warnings.empty()) << guide.warnings.front();
    const ResidueFacts facts(m);
    const std::vector<SceneLayer> layers = splitLayers(makeAppearance(facts, drawnAtoms(m), d.look), d.look);
    ASSERT_EQ(guide.layers.size(), layers.size());
    for (std::size_t i = 0; i < layers.size(); ++i) {
        EXPECT_EQ(guide.layers[i].style, layers[i].style);
        EXPECT_EQ(guide.layers[i].atoms, layers[i].atoms);
        EXPECT_EQ(guide.layers[i].colors, layers[i].colors);
    }
    EXPECT_EQ(*guide.background, d.background);
    EXPECT_EQ(guide.title, "Two residues");
    ASSERT_EQ(guide.primitives.labels.size(), 1u);
    EXPECT_EQ(guide.primitives.labels[0].text, "zinc");
    ASSERT_TRUE(guide.camera);
    EXPECT_LT(glm::distance(guide.camera->target, camera().target), 1e-6);
    EXPECT_LT(glm::distance(glm::normalize(guide.camera->direction), camera().direction), 1e-6);
    EXPECT_NEAR(guide.camera->radius, camera().radius, 1e-6);
}

TEST(WrittenScenes, KeepTheWidthsOfCartoons) {
    const Molecule m = molecule();
    PictureDescription d = picture();
    d.look.style = Style::cartoon;
    const Molecule again = readBack(writeScene(m, d, {}, camera(), "out.mvsj"));
    const auto cartoon = std::find_if(again.guide->layers.begin(), again.guide->layers.end(),
                                      [](const SceneLayer& layer) { return layer.style == Style::cartoon; });
    ASSERT_NE(cartoon, again.guide->layers.end());
    EXPECT_NEAR(cartoon->cartoon.scale, 1, 1e-3);
    d.look.cartoon.putty = true;
    const WrittenScene written = writeScene(m, d, {}, camera(), "out.mvsj");
    ASSERT_EQ(written.notes.size(), 1u);
    EXPECT_NE(written.notes[0].find("the widths of --putty"), std::string::npos);
    const Molecule putty = readBack(written);
    EXPECT_TRUE(std::ranges::any_of(putty.guide->layers, [](const SceneLayer& layer) {
        return layer.cartoon.putty && layer.cartoon.tubePerTemperature > 0;
    }));
}

TEST(WrittenScenes, HaveMeasurementsAndTellOfTorsions) {
    PictureDescription d = picture();
    const auto points = [](std::initializer_list<const char*> names) {
        std::vector<Selection> list;
        for (const char* name : names) list.push_back(parseSelection(std::string("name ") + name));
        return list;
    };
    d.words.measures = {{points({"N", "ZN"}), ""}, {points({"N", "CA", "C"}), ""}, {points({"N", "CA", "C", "O"}), ""}};
    const WrittenScene written = writeScene(molecule(), d, {}, camera(), "out.mvsj");
    ASSERT_EQ(written.notes.size(), 1u);
    EXPECT_NE(written.notes[0].find("torsion"), std::string::npos);
    const Primitives& p = readBack(written).guide->primitives;
    ASSERT_EQ(p.labels.size(), 2u);
    EXPECT_EQ(p.labels[0].text, "7 Å");
    EXPECT_LT(glm::distance(p.lines[0].b, glm::dvec3(8, 2, 3)), 1e-4);
}

TEST(WrittenScenes, HaveVolumes) {
    SceneVolume volume;
    DensityMap map = mapOfValues("maps/a.mrc", glm::ivec3(3), {glm::dvec3(3), glm::dvec3(90)}, {}, false,
                                 std::vector<float>(27, 1.0f));
    map.format = "ccp4";
    volume.map = std::make_shared<const DensityMap>(std::move(map));
    volume.level = 0.5;
    volume.color = 0xff0000ffu;
    volume.opacity = 0.25;
    SceneVolume slice = volume;
    slice.axis = 1;
    slice.place = 0.5;
    const WrittenScene written = writeScene(molecule(), picture(), std::vector{volume, slice}, camera(), "out.mvsj");
    const json nodes = json::parse(written.json)["root"]["children"];
    ASSERT_EQ(nodes.size(), 5u);
    EXPECT_EQ(nodes[1]["params"]["url"], "maps/a.mrc");
    const json& parse = nodes[1]["children"][0];
    EXPECT_EQ(parse["params"]["format"], "map");
    const json& shown = parse["children"][0]["children"][0];
    EXPECT_EQ(shown["params"]["absolute_isovalue"], 0.5);
    EXPECT_EQ(shown["children"][0]["params"]["color"], "#ff0000");
    EXPECT_EQ(shown["children"][1]["params"]["opacity"], 0.25);
    const json& cut = nodes[2]["children"][0]["children"][0]["children"][0]["params"];
    EXPECT_EQ(cut["dimension"], "y");
    EXPECT_EQ(cut["relative_index"], 0.5);
    EXPECT_EQ(cut["absolute_isovalue"], 1);  // the least value: Mol* would leave out what is below the mean
}

TEST(WrittenScenes, NameFilesFromTheirFolder) {
    const test::TemporaryFolder folder;
    std::vector<std::string> outside;
    EXPECT_EQ(sceneAddress(folder / "a/m.pdb", folder / "out.mvsj", outside), "a/m.pdb");
    EXPECT_EQ(sceneAddress("pdb:1CRN", folder / "out.mvsj", outside), "https://files.wwpdb.org/download/1crn.cif");
    EXPECT_TRUE(outside.empty());
    EXPECT_EQ(sceneAddress(folder / "m.pdb", folder / "a/out.mvsj", outside), "m.pdb");
    EXPECT_EQ(outside, std::vector<std::string>{folder / "m.pdb"});
}

TEST(WrittenScenes, OfASceneAreThatSceneFromAnotherPlace) {
    const test::TemporaryFolder folder;
    const WrittenScene first = writeScene(molecule(), picture(), {}, camera(), "out.mvsj");
    std::ofstream(folder / "s.mvsj") << first.json;
    PictureDescription d = picture();
    d.input.path = folder / "s.mvsj";
    d.look.style.reset();
    d.background = {1, 0, 0, 1};
    SceneCamera elsewhere = camera();
    elsewhere.radius = 4;
    const WrittenScene written = writeScene(readBack(first), d, {}, elsewhere, folder / "t.mvsj");
    EXPECT_TRUE(written.notes.empty());
    const json before = json::parse(first.json)["root"]["children"],
               after = json::parse(written.json)["root"]["children"];
    ASSERT_EQ(after.size(), before.size());
    EXPECT_EQ(after[0], before[0]);
    EXPECT_EQ(after[1]["params"]["background_color"], "#ff0000");
    EXPECT_NE(after[2], before[2]);
    EXPECT_EQ(readBack(written).guide->camera->radius, 4);
}

}  // namespace
}  // namespace nacre::app::mvs
