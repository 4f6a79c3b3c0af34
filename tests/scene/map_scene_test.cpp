// Contours, slices and surfaces in the colours of a map's values: here the map is the place along x.
#include "engine/scene/build/map_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/scene/color/colors.h"
#include "engine/scene/color/palettes.h"
#include "engine/volume/read_map.h"

namespace nacre {
namespace {

constexpr int kNodes = 25;
const glm::dvec3 kFirst{-12, -12, -12};

template <typename Function>
DensityMap makeMap(const Function& f) {
    std::vector<float> values;
    for (int z = 0; z < kNodes; ++z)
        for (int y = 0; y < kNodes; ++y)
            for (int x = 0; x < kNodes; ++x) values.push_back(static_cast<float>(f(kFirst + glm::dvec3(x, y, z))));
    return mapOfValues("map", glm::ivec3(kNodes), {glm::dvec3(kNodes), glm::dvec3(90)}, kFirst, false, values);
}
DensityMap alongX() {
    return makeMap([](const glm::dvec3& at) { return at.x; });
}
DensityMap ball() {
    return makeMap([](const glm::dvec3& at) { return 12 - glm::length(at); });
}
/// The ramp from -6 to 6.
std::uint32_t expected(double x) { return paletteColor(Palette::viridis, (x + 6) / 12) & 0xffffff; }
int apart(std::uint32_t a, std::uint32_t b) {
    int most = 0;
    for (const int shift : {0, 8, 16})
        most = std::max(most, std::abs(static_cast<int>(a >> shift & 0xff) - static_cast<int>(b >> shift & 0xff)));
    return most;
}
ValueColoring sixToSix(const DensityMap& map) { return {&map, "along x", Palette::viridis, ColorRange{-6, 6}}; }

TEST(MapScene, AContourHasTheColoursOfAnotherMap) {
    const DensityMap shape = ball(), x = alongX();
    const MapRegion region(shape, glm::ivec3(0), shape.size - 1);
    const ValueColoring values = sixToSix(x);
    MapContour contour{.level = 7, .style = MapStyle::surface, .values = &values};
    Representation scene;
    addContour(region, contour, scene);
    ASSERT_GT(scene.triangles.size(), 200u);
    EXPECT_TRUE(scene.blendsColors);
    for (const Triangle& t : scene.triangles)
        for (const std::uint32_t v : {t.a, t.b, t.c})
            EXPECT_LE(apart(scene.meshLooks[scene.meshVertices[v].look].color,
                            expected(static_cast<double>(decodePosition(scene.meshVertices[v], t.step()).x))),
                      2);
    ASSERT_EQ(scene.legends.size(), 1u);
    EXPECT_EQ(scene.legends[0].entries.front().label, "-6");
    EXPECT_EQ(scene.legends[0].stops, 5u);

    contour.style = MapStyle::mesh;
    Representation lines;
    addContour(region, contour, lines);
    ASSERT_GT(lines.wires.size(), 200u);
    for (std::size_t i = 0; i < lines.wires.size(); ++i) {
        EXPECT_LE(apart(lines.wireLooks[i].colorA, expected(static_cast<double>(lines.wires[i].a.x))), 2);
        EXPECT_LE(apart(lines.wireLooks[i].colorB, expected(static_cast<double>(lines.wires[i].b.x))), 2);
    }
}

TEST(MapScene, WhereTheOtherMapSaysNothingTheColourStays) {
    const DensityMap shape = ball();
    const DensityMap half = makeMap([](const glm::dvec3& at) { return at.x > 0 ? 1.0 : NAN; });
    const ValueColoring values{&half, "half", Palette::viridis, ColorRange{0, 2}};
    MapContour contour{.level = 7, .color = 0xff0000ffu, .values = &values};
    Representation scene;
    addContour(MapRegion(shape, glm::ivec3(0), shape.size - 1), contour, scene);
    std::set<std::uint32_t> colors;
    for (const CylinderLook& look : scene.wireLooks) colors.insert(look.colorA);
    EXPECT_EQ(colors, (std::set<std::uint32_t>{0xff0000ffu, paletteColor(Palette::viridis, 128 / 255.0)}));
}

TEST(MapScene, ASliceIsFlatAndHasItsOwnColours) {
    const DensityMap x = alongX();
    const MapRegion region(x, glm::ivec3(0), x.size - 1);
    const ValueColoring values = sixToSix(x);
    Representation scene;
    scene.center = {1, 2, 3};
    addSlice(region, {2, 0.25, 1}, values, scene);
    ASSERT_EQ(scene.triangles.size(), 2u * (kNodes - 1) * (kNodes - 1));
    for (const MeshVertex& v : scene.meshVertices) {
        const glm::dvec3 at = glm::dvec3(decodePosition(v, scene.triangles[0].step())) + scene.center;
        EXPECT_NEAR(at.z, kFirst.z + 0.25 * (kNodes - 1), 1e-4);
        EXPECT_LE(apart(scene.meshLooks[v.look].color, expected(at.x)), 2);
    }
    // Across x it is of one value.
    Representation across;
    addSlice(region, {0, 0.75, 1}, values, across);
    ASSERT_EQ(across.meshLooks.size(), 1u);
    EXPECT_LE(apart(across.meshLooks[0].color, expected(6)), 2);
    // Of what is unknown there is nothing.
    const DensityMap half = makeMap([](const glm::dvec3& at) { return at.x > -0.5 ? at.y : NAN; });
    Representation cut;
    addSlice(MapRegion(half, glm::ivec3(0), half.size - 1), {2, 0.5, 1}, {&half, "half"}, cut);
    EXPECT_EQ(cut.triangles.size(), 2u * (kNodes - 1) * (kNodes / 2));
}

TEST(MapScene, ASliceEndsWhereItsValuesAreTooLow) {
    const DensityMap x = alongX();
    MapSlice slice{.axis = 2, .place = 0.25, .opacity = 1, .least = 1.25};
    Representation scene;
    addSlice(MapRegion(x, glm::ivec3(0), x.size - 1), slice, sixToSix(x), scene);
    double least = 100;
    for (const Triangle& t : scene.triangles)
        for (const std::uint32_t v : {t.a, t.b, t.c})
            least = std::min(least, static_cast<double>(decodePosition(scene.meshVertices[v], t.step()).x));
    EXPECT_NEAR(least, 1.25, 1e-3);
    // In each row ten whole squares of two triangles; a square whose quarter is cut off has three.
    EXPECT_EQ(scene.triangles.size(), (2u * 10 + 3) * (kNodes - 1));
}

TEST(MapScene, ASliceLeavesOutWhatIsCut) {
    const DensityMap x = alongX();
    const double middle = kFirst.x + (kNodes - 1) / 2.0;  // between two nodes, or at one
    MapSlice slice{.axis = 2, .place = 0.25};
    slice.cuts = [&](const glm::dvec3& at) { return at.x > middle; };
    Representation scene;
    scene.center = {1, 2, 3};
    addSlice(MapRegion(x, glm::ivec3(0), x.size - 1), slice, sixToSix(x), scene);
    ASSERT_FALSE(scene.triangles.empty());
    EXPECT_NEAR(static_cast<double>(scene.triangles.size()), (kNodes - 1) * (kNodes - 1), kNodes);  // half of all
    for (const Triangle& t : scene.triangles)
        for (const std::uint32_t v : {t.a, t.b, t.c})
            EXPECT_LE(static_cast<double>(decodePosition(scene.meshVertices[v], t.step()).x) + 1, middle + 1);
}

TEST(MapScene, AMoleculesSurfaceHasTheColoursOfAMap) {
    const Molecule molecule = sampleMolecule("glucose");
    RepresentationOptions options{.style = Style::surface, .surfaceOpacity = 0.5};
    Representation scene = represent(molecule, drawnAtoms(molecule), options);
    ASSERT_FALSE(scene.triangles.empty());
    const glm::dvec3 center = scene.center;
    const DensityMap x = makeMap([&](const glm::dvec3& at) { return at.x - center.x; });
    ASSERT_TRUE(colorSurfaces(sixToSix(x), scene));
    EXPECT_TRUE(scene.blendsColors);
    for (const Triangle& t : scene.triangles) {
        const MeshVertex& v = scene.meshVertices[t.a];
        const SphereLook& look = scene.meshLooks[v.look];
        EXPECT_LE(apart(look.color, expected(static_cast<double>(decodePosition(v, t.step()).x))), 2);
        EXPECT_EQ(opacitySteps(look.color), kOpacitySteps / 2);
        EXPECT_FALSE(isCopyTint(look.color));
        EXPECT_GT(look.atom, 0u);
    }
    options.style = Style::cartoon;
    Representation none = represent(molecule, drawnAtoms(molecule), options);
    EXPECT_FALSE(colorSurfaces(sixToSix(x), none));
    EXPECT_FALSE(none.blendsColors);
}

TEST(MapScene, ARangeOfBothSignsIsTheSameToEitherSide) {
    std::vector<double> values(1001);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i) / 100 - 2;  // -2 to 8
    values.push_back(NAN);
    const ValueColors potential({}, values, Palette::viridis);
    EXPECT_EQ(potential.palette(), Palette::redWhiteBlue);
    EXPECT_NEAR(potential.range().last, 7.8, 1e-9);  // the 98th percentile
    EXPECT_EQ(potential.range().first, -potential.range().last);
    const ValueColors slice({}, values, Palette::grays, false);
    EXPECT_EQ(slice.palette(), Palette::grays);
    EXPECT_NEAR(slice.range().first, -1.8, 1e-9);
    for (double& v : values) v += 3;
    EXPECT_EQ(ValueColors({}, values, Palette::viridis).palette(), Palette::viridis);
    EXPECT_EQ(slice.toStep(NAN), ValueColors::kSteps);
}

}  // namespace
}  // namespace nacre
