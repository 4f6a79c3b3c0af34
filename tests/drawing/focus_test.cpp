// Where a camera looks, and maps that are drawn about there.
#include "app/drawing/focus.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <set>

#include "app/drawing/map_layers.h"
#include "app/input/map_input.h"
#include "app/picture/options.h"
#include "engine/molecule/read.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

namespace nacre::app {
namespace {

const glm::dvec3 kCenter{1, 2, 3};

/// Atoms about the centre: two behind each other, and one at the right.
Molecule threeAtoms() { return readMolecule("three.xyz", "3\nthree\nC 1 2 8\nN 1 2 -2\nO 11 2 4\n", {}); }

class FocusTest : public testing::Test {
protected:
    void set(std::string_view key, const std::string& value) { setOption(option(key), value, picture); }
    void expectFocus(const glm::dvec3& wanted, double radius = 12) const {
        const glm::dvec3 focus = findFocus(molecule, picture, {picture.camera, radius}, kCenter);
        EXPECT_LT(glm::distance(focus, wanted), 1e-9) << focus.x << " " << focus.y << " " << focus.z;
    }
    const Molecule molecule = threeAtoms();
    PictureDescription picture;
};

TEST_F(FocusTest, IsTheFirstAtomInThePicturesMiddle) {
    expectFocus({1, 2, 8});
    set("clip", "0");
    expectFocus({1, 2, -2});
    set("clip", "off");
    set("rotate", "0,180,0");
    expectFocus({1, 2, -2});
    set("rotate", "0,-90,0");  // what was at the right comes to the front
    expectFocus({11, 2, 3});
}

TEST_F(FocusTest, GoesWithTheCamera) {
    set("pan", "-10,0");
    expectFocus({11, 2, 4});
    set("pan", "-4,0");
    expectFocus({5, 2, 8});  // beside the closest atom
    // From the eye through the middle of the picture, which moves nearer to the axis of the eye towards it.
    set("pan", "-10,0");
    set("projection", "perspective");
    const double eye = makeView(picture.camera, 12, 256, 256).eyeDistance;
    expectFocus({1 + 10 * (eye - 1) / eye, 2, 4});
}

TEST_F(FocusTest, IsWhereALensIsSharp) {
    const auto depth = [&] {
        RenderSettings settings{.view = makeView(picture.camera, 12, 256, 256), .effects = picture.effects};
        focusLens(molecule, picture, kCenter, settings);
        return settings.effects.depthOfField.focus;
    };
    EXPECT_EQ(depth(), std::nullopt);  // there is no lens
    set("depth-of-field", "5");
    EXPECT_NEAR(depth().value(), -5, 1e-9);
    set("rotate", "0,180,0");  // about the centre: the other one is in front
    EXPECT_NEAR(depth().value(), -5, 1e-9);
    set("zoom-to", "element C");
    EXPECT_NEAR(depth().value(), 5, 1e-9);
    set("focus-depth", "2.5");
    EXPECT_EQ(depth(), 2.5);
    set("focus-depth", "auto");
    set("zoom-to", "element O");
    picture.aim.turns = true;
    EXPECT_NEAR(depth().value(), 1, 1e-9);
    picture.aim.zoomTo.reset();
    EXPECT_EQ(depth(), std::nullopt);  // a movie from all sides: the centre, in every frame
}

TEST_F(FocusTest, HasTheDepthOfWhatIsZoomedTo) {
    set("zoom-to", "element N");
    expectFocus({1, 2, -2});
    set("zoom-to", "element N or element C");
    expectFocus({1, 2, 3});
}

TEST_F(FocusTest, MapsAreDrawnAboutIt) {
    constexpr int kNodes = 41;
    std::vector<float> values;
    for (int i = 0; i < kNodes * kNodes * kNodes; ++i) values.push_back(static_cast<float>(i % 2));  // crossed anywhere
    keepMap("chess", std::make_shared<const DensityMap>(mapOfValues("chess", glm::ivec3(kNodes),
                                                                    {glm::dvec3(kNodes), glm::dvec3(90)},
                                                                    glm::dvec3(-20), false, std::move(values))));
    set("map", "chess");
    set("map-style", "mesh");
    set("map-level", "0.5");
    for (const auto& [around, reach] : {std::pair{"focus,6", 6.0}, {"focus", kMapReachOfFocus}}) {
        set("map-around", around);
        const MapLayers maps = buildMapLayers(molecule, picture, kCenter, {picture.camera, 12});
        ASSERT_TRUE(maps.focus);
        const glm::dvec3 focus = *maps.focus - kCenter;
        EXPECT_LT(glm::distance(focus, {0, 0, 5}), 1e-9);
        double farthest = 0;
        for (const Cylinder& wire : maps.shown.wires)
            farthest = std::max(farthest, glm::distance(glm::dvec3(wire.a), focus));
        EXPECT_LE(farthest, reach);
        EXPECT_GT(farthest, reach - 1.5);
        EXPECT_EQ(maps.frame, 0) << "the camera does not go by them";
    }
}

TEST_F(FocusTest, OrbitalsHaveTheirNegativeContourAtTheNegativeLevel) {
    constexpr int kNodes = 21;
    std::vector<float> values;  // -0.5 to 1.5 along x: the mean is not 0
    for (int i = 0; i < kNodes * kNodes * kNodes; ++i) values.push_back(0.1f * static_cast<float>(i % kNodes) - 0.5f);
    DensityMap orbital = mapOfValues("orbital", glm::ivec3(kNodes), {glm::dvec3(kNodes), glm::dvec3(90)},
                                     glm::dvec3(-10), false, std::move(values));
    orbital.difference = true;
    keepMap("orbital", std::make_shared<const DensityMap>(std::move(orbital)));
    set("map", "orbital");
    set("map-style", "mesh");
    set("map-level", "0.3");
    const MapLayers maps = buildMapLayers(molecule, picture, kCenter, {picture.camera, 12});
    ASSERT_FALSE(maps.shown.wires.empty());
    std::set<int> places;
    for (const Cylinder& wire : maps.shown.wires)
        places.insert(static_cast<int>(std::lround(10 * (static_cast<double>(wire.a.x) + kCenter.x))));
    EXPECT_EQ(places, (std::set<int>{-80, -20}));  // 0.1 x = 0.3 + 0.5 - 1, and -0.3 + 0.5 - 1
    const std::vector<SceneVolume> volumes = sceneVolumes(picture);
    ASSERT_EQ(volumes.size(), 2u);
    EXPECT_NEAR(volumes[0].level, 0.3, 1e-6);
    EXPECT_NEAR(volumes[1].level, -0.3, 1e-6);
}

/// A p orbital as programs write it that do not mark orbitals: the number of atoms is positive.
std::string unmarkedOrbital() {
    constexpr int kNodes = 12;
    std::string text = "Orbital value in real space\nwithout a mark\n1 -5.5 -5.5 -5.5\n";
    for (const char* step : {"12 1 0 0\n", "12 0 1 0\n", "12 0 0 1\n"}) text += step;
    text += "6 6.0 0.0 0.0 0.0\n";
    for (int x = 0; x < kNodes; ++x)
        for (int y = 0; y < kNodes; ++y)
            for (int z = 0; z < kNodes; ++z) {
                const glm::dvec3 at = glm::dvec3(x, y, z) - 5.5;
                text += std::to_string(at.z * std::exp(-glm::length(at))) + "\n";
            }
    return text;
}

TEST_F(FocusTest, UnmarkedOrbitalsHaveBothLobes) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "p.cube") << unmarkedOrbital();
    std::vector<std::string> files{folder / "p.cube"};
    if (test::dataFolder()) files.push_back(test::dataFile("reports/t07_pyscf.cube"));
    for (const std::string& file : files) {
        SCOPED_TRACE(file);
        picture.maps.files.clear();
        set("map", file);
        set("map-style", "mesh");
        const MapLayers maps = buildMapLayers(molecule, picture, {}, {picture.camera, 12});
        std::array<std::size_t, 2> wires{};  // below and above the plane of the nodes
        std::array<std::set<std::uint32_t>, 2> colors;
        for (std::size_t i = 0; i < maps.shown.wires.size(); ++i) {
            const std::size_t above = maps.shown.wires[i].a.z > 0;
            ++wires[above];
            colors[above].insert(maps.shown.wireLooks[i].colorA);
        }
        EXPECT_GT(wires[0], 10u);
        EXPECT_EQ(wires[0], wires[1]) << "the lobes are alike";
        EXPECT_EQ(colors[0].size() + colors[1].size(), 2u);
        EXPECT_NE(colors[0], colors[1]);
        const std::vector<SceneVolume> volumes = sceneVolumes(picture);
        ASSERT_EQ(volumes.size(), 2u);
        EXPECT_DOUBLE_EQ(volumes[1].level, -volumes[0].level);
    }
}

}  // namespace
}  // namespace nacre::app
