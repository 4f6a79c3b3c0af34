// Planes, spheres and boxes that cut parts of a scene away.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "tests/mvs/small_scene.h"
#include "tests/support/error_text.h"

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
    EXPECT_TRUE(slice.guide->volumes.at(0).cuts({1.5, 0, 0}));
    EXPECT_FALSE(slice.guide->volumes.at(0).cuts({0.5, 0, 0}));
    EXPECT_TRUE(slice.guide->warnings.empty());
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
}

/// How often each atom is drawn, and where, to the Å: in all copies, by layers.
std::multiset<std::array<int, 4>> drawnPlaces(const Molecule& molecule) {
    const SceneGuide& guide = *molecule.guide;
    std::multiset<std::array<int, 4>> places;
    for (const SceneLayer& layer : guide.layers)
        for (const std::uint32_t index : layer.atoms) {
            const Atom& atom = molecule.atoms[index];
            for (const std::uint32_t copy : guide.lists[guide.listOfResidue[atom.residue]]) {
                const glm::dvec3 at = guide.transforms[copy] * glm::dvec4(glm::dvec3(atom.position), 1.0);
                places.insert({static_cast<int>(index % 9) + 11, int(std::lround(at.x)), int(std::lround(at.y)),
                               int(std::lround(at.z))});
            }
        }
    return places;
}

// Four copies in the cell: what is left of each is what is left of the places of all atoms.
TEST(SceneClips, CutEachCopyWhereItIs) {
    const std::string cell = R"("symmetry", "ijk_min": [0,0,0], "ijk_max": [0,0,0])",
                      instances = R"({"kind": "instance", "params": {"translation": [0,0,0]}},
        {"kind": "instance", "params": {"translation": [0,0,100]}},)";
    for (const std::string& before : {std::string(), instances})
        for (const char* plane : {R"({"type": "plane", "normal": [1,0,0], "point": [10.5,0,0]})",
                                  R"({"type": "plane", "normal": [1,0,0], "point": [10.5,0,0], "invert": true})",
                                  R"({"type": "sphere", "center": [14,38,28], "radius": 3.2})"}) {
            const Molecule whole = built(scene(before + component(R"("all")", balls()), "", cell));
            const Molecule cut = built(scene(before + R"({"kind": "tooltip", "params": {"text": "all"}},)" +
                                                 component(R"("all")", balls(clip(plane))),
                                             "", cell));
            EXPECT_TRUE(cut.guide->warnings.empty());
            std::multiset<std::array<int, 4>> left;
            const std::string text(plane);
            for (const auto& place : drawnPlaces(whole)) {
                const glm::dvec3 at(place[1], place[2], place[3]);
                const bool isCut = text.find("sphere") != std::string::npos
                                       ? glm::distance(at, glm::dvec3(14, 38, 28)) <= 3.2
                                       : (at.x >= 10.5) != (text.find("invert") != std::string::npos);
                if (!isCut) left.insert(place);
            }
            EXPECT_LT(left.size(), drawnPlaces(whole).size()) << plane;
            EXPECT_EQ(drawnPlaces(cut), left) << plane;
            std::vector<bool> told(cut.atoms.size());
            for (const SceneNote& tip : cut.guide->tooltips)
                for (const std::uint32_t atom : tip.atoms) told[atom] = true;
            for (const std::uint32_t atom : cut.guide->layers.at(0).atoms) EXPECT_TRUE(told[atom]);
            EXPECT_NEAR(glm::distance(cut.guide->camera->target, whole.guide->camera->target), 0, 1e-9);
        }
}

TEST(SceneClips, TooltipsOfCutCopiesTakeNoMoreThanTheLimit) {
    std::string tips;  // 9 atoms each, in three groups of copies
    for (int i = 0; i < 14; ++i) tips += R"({"kind": "tooltip", "params": {"text": "all"}},)";
    const std::string ball = clip(R"({"type": "sphere", "radius": 0.5, "center": [1,9,3]})"),
                      json = scene(tips + component(R"("all")", balls(ball)), "", R"("symmetry")");
    SceneSources sources;
    sources.fetch = [](const std::string&) { return kStructure; };
    sources.reading.maxAtoms = 27;
    const std::string why =
        test::errorText([&] { buildScene(parseScene(json, "scene.mvsj"), 0, "scene.mvsj", sources); });
    EXPECT_NE(why.find("tooltips have more than 432 atoms together"), std::string::npos) << why;
}

TEST(SceneClips, ShareTheAtomsOfCopiesThatStayWhole) {
    const auto atoms = [](const char* center) {
        const std::string ball = clip(R"({"type": "sphere", "radius": 0.5, "center": )" + std::string(center) + "}");
        return built(scene(component(R"("all")", balls(ball)), "", R"("symmetry")")).atoms.size();
    };
    EXPECT_EQ(atoms("[-900,0,0]"), 9u);   // cuts none of 108
    EXPECT_EQ(atoms("[1,9,3]"), 3 * 9u);  // one copy, and all others, beside the structure itself
    const std::string all = clip(R"({"type": "sphere", "radius": 900, "center": [0,0,0]})");
    const Molecule none = built(scene(component(R"("all")", balls(all)), "", R"("symmetry")"));
    EXPECT_EQ(none.atoms.size(), 9u);
    EXPECT_TRUE(none.guide->layers.empty());
}

}  // namespace
}  // namespace nacre::app::mvs
