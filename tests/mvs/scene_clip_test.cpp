// Planes, spheres and boxes that cut parts of a scene away.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/mvs/small_scene.h"

namespace nacre::app::mvs {
namespace {

std::string clip(const std::string& params) { return R"({"kind": "clip", "params": )" + params + "}"; }

/// Serial numbers of the atoms that are left: 11 to 19, along x but for 14 (3, 3, 3) and 19 (1, 9, 3).
std::vector<std::uint32_t> left(const std::string& nodes, const std::string& type = "spacefill") {
    const std::string node =
        R"({"kind": "representation", "params": {"type": ")" + type + R"("}, "children": [)" + nodes + "]}";
    std::vector<std::uint32_t> atoms;
    const auto drawn = built(scene(component(R"("all")", node)));
    for (const SceneLayer& layer : drawn.guide->layers)
        for (const std::uint32_t atom : layer.atoms) atoms.push_back(atom + 11);
    return atoms;
}

using Atoms = std::vector<std::uint32_t>;

TEST(SceneClips, PlanesCutWhereTheirNormalPoints) {
    EXPECT_EQ(left(clip(R"({"type": "plane", "normal": [2,0,0], "point": [3,7,7]})")), (Atoms{11, 12, 19}));
    EXPECT_EQ(left(clip(R"({"type": "plane", "normal": [2,0,0], "point": [3,7,7], "invert": true})")),
              (Atoms{13, 14, 15, 16, 17, 18}));
    EXPECT_EQ(left(clip(R"({"type": "plane", "normal": [0,1,0], "point": [0,2.5,0]})")),
              (Atoms{11, 12, 13, 15, 16, 17, 18}));
}

TEST(SceneClips, SpheresAndBoxesCutTheirInside) {
    EXPECT_EQ(left(clip(R"({"type": "sphere", "center": [2,2,3], "radius": 1.2})")), (Atoms{14, 15, 16, 17, 18, 19}));
    EXPECT_EQ(left(clip(R"({"type": "sphere", "center": [2,2,3]})")), (Atoms{14, 15, 16, 17, 18, 19}));
    EXPECT_EQ(left(clip(R"({"type": "box", "center": [5,2,3], "size": [9,0.5,1], "invert": true})")),
              (Atoms{11, 12, 13, 15, 16, 17}));
    const std::string turned = R"({"type": "box", "center": [5,2,3], "size": [0.5,9,1],
        "rotation": [0,1,0,-1,0,0,0,0,1], "invert": true})";
    EXPECT_EQ(left(clip(turned)), (Atoms{11, 12, 13, 15, 16, 17}));
    const std::string moved = R"({"type": "sphere", "center": [102,2,3], "radius": 1.2,
        "check_transform": [1,0,0,0, 0,1,0,0, 0,0,1,0, 100,0,0,1]})";
    EXPECT_EQ(left(clip(moved)), (Atoms{14, 15, 16, 17, 18, 19}));
    EXPECT_EQ(left(clip(R"({"type": "sphere", "center": [1,2,3], "radius": 0.5})") + "," +
                   clip(R"({"type": "sphere", "center": [1,9,3], "radius": 0.5})")),
              (Atoms{12, 13, 14, 15, 16, 17, 18}));
}

TEST(SceneClips, CartoonsLoseWholeResidues) {
    // The first residue reaches from x = 1 to 3, the second from 4 to 5.
    EXPECT_EQ(left(clip(R"({"type": "plane", "normal": [1,0,0], "point": [4.2,0,0]})"), "cartoon"),
              (Atoms{11, 12, 13, 14}));
}

TEST(SceneClips, ObjectsGoByTheCentresOfChains) {
    // Those of the polymer at x = 3, of the ligand at 9.5, and of the water at 1.
    const char* plane = R"({"type": "plane", "normal": [1,0,0], "point": [4.2,0,0], "variant": "object"})";
    EXPECT_EQ(left(clip(plane)), (Atoms{11, 12, 13, 14, 15, 16, 19}));
}

TEST(SceneClips, TheCameraShowsWhatIsCutAsWell) {
    const std::string plane = clip(R"({"type": "plane", "normal": [1,0,0], "point": [3,0,0]})");
    const auto camera = [](const std::string& json) { return built(json).guide->camera.value(); };
    const std::string all = component(R"("all")", balls()),
                      faint = component(R"("all")", balls(R"({"kind": "opacity", "params": {"opacity": 0}})"));
    const SceneCamera whole = camera(scene(all));
    for (const SceneCamera& other : {camera(scene(component(R"("all")", balls(plane)))),
                                     camera(scene(component(R"("water")", balls()) + "," + faint))}) {
        EXPECT_LT(glm::distance(whole.target, other.target), 1e-9);
        EXPECT_NEAR(whole.radius, other.radius, 1e-9);
    }
    const auto tubes = [&](const std::string& more) {
        return camera(R"({"root": {"kind": "root", "children": [{"kind": "primitives", "children": [
            {"kind": "primitive", "params": {"kind": "tube", "start": [0,0,0], "end": [2,0,0]}},
            {"kind": "primitive", "params": {"kind": "tube", "start": [4,0,0], "end": [9,0,0]}})" +
                      more + "]}]}}");
    };
    EXPECT_NEAR(tubes("").radius, tubes("," + plane).radius, 1e-9);
}

TEST(SceneClips, ContoursAreCutAtPlaces) {
    const auto cuts = [](const std::string& children) {
        return built(volume(R"({"type": "isosurface", "absolute_isovalue": 0.5})", children)).guide->volumes.at(0).cuts;
    };
    EXPECT_FALSE(cuts(""));
    const auto cut = cuts(clip(R"({"type": "plane", "normal": [1,0,0], "point": [1,0,0]})"));
    EXPECT_TRUE(cut({1.5, 0, 0}));
    EXPECT_FALSE(cut({0.5, 0, 0}));
    const Molecule slice = built(volume(R"({"type": "grid_slice", "dimension": "x"})",
                                        clip(R"({"type": "plane", "normal": [1,0,0], "point": [1,0,0]})")));
    EXPECT_FALSE(slice.guide->volumes.at(0).cuts);
    ASSERT_EQ(slice.guide->warnings.size(), 1u);
    EXPECT_NE(slice.guide->warnings[0].find("not clipped"), std::string::npos) << slice.guide->warnings[0];
}

TEST(SceneClips, PointsAreThoseOfTheMovedStructure) {
    const std::string node = R"({"kind": "representation", "params": {"type": "spacefill"}, "children": [)" +
                             clip(R"({"type": "plane", "normal": [1,0,0], "point": [102.5,0,0]})") + "]}";
    const std::string transform = R"({"kind": "transform", "params": {"translation": [100,0,0]}},)";
    EXPECT_EQ(built(scene(transform + component(R"("polymer")", node))).guide->layers.at(0).atoms.size(), 2u);
}

TEST(SceneClips, PrimitivesGoByTheirCentres) {
    const auto group = [](const std::string& more) {
        return scene(component(R"("all")", balls()), R"(,{"kind": "primitives", "children": [
            {"kind": "primitive", "params": {"kind": "tube", "start": [0,0,0], "end": [2,0,0]}},
            {"kind": "primitive", "params": {"kind": "tube", "start": [4,0,0], "end": [8,0,0]}},
            {"kind": "primitive", "params": {"kind": "mesh", "vertices": [0,0,0, 1,0,0, 0,1,0, 9,0,0, 8,0,0, 9,1,0],
             "indices": [0,1,2,3,4,5]}})" + more + "]}");
    };
    EXPECT_EQ(built(group("")).guide->primitives.lines.size(), 2u);
    const auto cut = built(group("," + clip(R"({"type": "plane", "normal": [1,0,0], "point": [5,0,0]})")));
    EXPECT_TRUE(cut.guide->warnings.empty());
    ASSERT_EQ(cut.guide->primitives.lines.size(), 1u);
    EXPECT_EQ(cut.guide->primitives.lines[0].b.x, 2);
    ASSERT_EQ(cut.guide->primitives.meshes.size(), 1u);
    EXPECT_EQ(cut.guide->primitives.meshes[0].triangles.size(), 1u);
}

TEST(SceneClips, FaultsAreTold) {
    const std::string faults = clip(R"({"type": "cone"})") + "," +
                               clip(R"({"type": "plane", "normal": [0,0,0], "point": [0,0,0]})") + "," +
                               clip(R"({"type": "sphere", "center": [0,0,0], "radius": -1})") + "," +
                               clip(R"({"type": "box", "center": [0,0,0], "rotation": [2,0,0,0,1,0,0,0,1]})") + "," +
                               clip(R"({"type": "plane", "point": [0,0,0]})");
    const Molecule molecule = built(scene(component(R"("all")", balls(faults))));
    EXPECT_EQ(molecule.guide->warnings.size(), 5u);
    EXPECT_EQ(molecule.guide->layers.at(0).atoms.size(), 9u);
    const auto copies = built(
        scene(component(R"("all")", balls(clip(R"({"type": "sphere", "center": [0,0,0]})"))), "", R"("symmetry")"));
    ASSERT_EQ(copies.guide->warnings.size(), 1u);
    EXPECT_NE(copies.guide->warnings[0].find("a structure with copies is not clipped"), std::string::npos);
}

}  // namespace
}  // namespace nacre::app::mvs
