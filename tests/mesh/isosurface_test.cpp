// Isosurfaces beside functions whose surfaces are known, and beside counts of our own.
#include "engine/mesh/isosurface.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <numbers>

#include "engine/error.h"
#include "engine/mesh/mesh_measures.h"
#include "engine/threads.h"
#include "tests/mesh/mesh_checks.h"

namespace nacre::test {
namespace {

constexpr double kWidth = 2.5;  // Å, of Gaussians
const glm::dvec3 kMiddle{6, 7, 8};

/// exp(-d^2 / (2 w^2)) about a place and all its images, in a triclinic cell.
DensityMap blobs(const glm::ivec3& size, bool periodic) {
    DensityMap map;
    map.name = "blobs";
    map.cell = {{18, 20, 22}, {75, 95, 110}};
    map.periodic = periodic;
    map.size = size;
    const glm::dmat3 edges = map.cell.edges();
    for (int i = 0; i < 3; ++i) map.step[i] = edges[i] / static_cast<double>(size[i]);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                double sum = 0;
                for (int image = 0; image < 27; ++image) {
                    const glm::dvec3 shift(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1);
                    if (!periodic && image != 13) continue;
                    const glm::dvec3 off = map.place({x, y, z}) - kMiddle - edges * shift;
                    sum += std::exp(-glm::dot(off, off) / (2 * kWidth * kWidth));
                }
                map.values.change().push_back(static_cast<float>(sum));
            }
    map.statistics = computeStatistics(map.values);
    return map;
}
double radiusAt(double level) { return kWidth * std::sqrt(-2 * std::log(level)); }

Mesh toMesh(const Isosurface& surface) {
    return {surface.positions, surface.normals, std::vector<std::uint32_t>(surface.positions.size(), 0),
            surface.triangles};
}

TEST(Isosurface, LiesWhereTheFunctionHasTheLevel) {
    const DensityMap map = blobs({36, 40, 44}, true);
    const std::vector<glm::dvec3> places{kMiddle};
    const MapRegion region(map, places, 6);
    for (const double level : {0.25, 0.4, 0.7}) {
        const Isosurface surface = region.at(level, true, IsosurfaceParts::triangles, kMiddle);
        ASSERT_GT(surface.positions.size(), 100u);
        const double radius = radiusAt(level);
        for (std::size_t i = 0; i < surface.positions.size(); ++i) {
            const glm::dvec3 at(surface.positions[i]);
            EXPECT_NEAR(glm::length(at), radius, 0.05) << level;  // a tenth of a step of half an Å
            EXPECT_GT(glm::dot(glm::dvec3(surface.normals[i]), glm::normalize(at)), 0.99);
        }
        const Mesh mesh = toMesh(surface);
        EXPECT_EQ(openEdges(mesh), 0u);
        const MeshMeasures measures = measure(mesh);
        EXPECT_NEAR(measures.area / (4 * std::numbers::pi * radius * radius), 1, 0.02);
        EXPECT_NEAR(measures.volume / (4.0 / 3 * std::numbers::pi * radius * radius * radius), 1, 0.04);  // inscribed
    }
}

TEST(Isosurface, OfACrystalGoesOnBeyondItsCell) {
    const DensityMap map = blobs({36, 40, 44}, true);
    // The image two cells away has the very same surface.
    const glm::dvec3 away = map.cell.edges() * glm::dvec3(2, -1, 1);
    const std::vector<glm::dvec3> here{kMiddle}, there{kMiddle + away};
    const Isosurface a = MapRegion(map, here, 6).at(0.4, true, IsosurfaceParts::lines, kMiddle),
                     b = MapRegion(map, there, 6).at(0.4, true, IsosurfaceParts::lines, kMiddle + away);
    ASSERT_EQ(a.positions.size(), b.positions.size());
    EXPECT_EQ(a.lines, b.lines);
    for (std::size_t i = 0; i < a.positions.size(); ++i)
        EXPECT_LT(glm::distance(a.positions[i], b.positions[i]), 1e-4f);
}

TEST(Isosurface, IsTheSameWhateverTheThreads) {
    const DensityMap map = blobs({36, 40, 44}, false);
    const MapRegion region(map, glm::ivec3(0), map.size - 1);
    setThreadsPerTask(1);
    const Isosurface one = region.at(0.3, true, IsosurfaceParts::triangles, {});
    setThreadsPerTask(3);
    const Isosurface three = region.at(0.3, true, IsosurfaceParts::triangles, {});
    setThreadsPerTask(0);
    EXPECT_EQ(one.positions, three.positions);
    EXPECT_EQ(one.triangles, three.triangles);
    ASSERT_FALSE(one.triangles.empty());
}

TEST(Isosurface, LinesLieInThePlanesOfTheGrid) {
    const DensityMap map = blobs({36, 40, 44}, false);
    const Isosurface surface = MapRegion(map, glm::ivec3(0), map.size - 1).at(0.3, true, IsosurfaceParts::lines, {});
    ASSERT_GT(surface.lines.size(), 500u);
    const auto isWhole = [](double v) { return std::abs(v - std::round(v)) < 1e-3; };
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> count;
    for (const glm::uvec2& line : surface.lines) {
        const glm::dvec3 a = map.nodeAt(glm::dvec3(surface.positions[line.x])),
                         b = map.nodeAt(glm::dvec3(surface.positions[line.y]));
        bool together = false;
        for (int axis = 0; axis < 3; ++axis) together |= isWhole(a[axis]) && std::abs(a[axis] - b[axis]) < 1e-3;
        EXPECT_TRUE(together);
        EXPECT_EQ(++count[std::minmax(line.x, line.y)], 1) << "drawn twice";
    }
    // A closed surface: each of its vertices has an edge of the grid, around which four cells meet in four faces.
    std::vector<int> ends(surface.positions.size(), 0);
    for (const glm::uvec2& line : surface.lines) ++ends[line.x], ++ends[line.y];
    for (const int n : ends) EXPECT_EQ(n, 4);
}

TEST(Isosurface, EnclosesWhatIsLowerToo) {
    DensityMap map = blobs({36, 40, 44}, false);
    const Isosurface high = MapRegion(map, glm::ivec3(0), map.size - 1).at(0.3, true, IsosurfaceParts::triangles, {});
    for (float& v : map.values.change()) v = -v;
    const Isosurface low = MapRegion(map, glm::ivec3(0), map.size - 1).at(-0.3, false, IsosurfaceParts::triangles, {});
    EXPECT_EQ(high.positions, low.positions);
    EXPECT_EQ(high.triangles, low.triangles);
    for (std::size_t i = 0; i < high.normals.size(); ++i) EXPECT_EQ(high.normals[i], low.normals[i]);
}

TEST(Isosurface, IsCutWhereNothingIsKnown) {
    DensityMap map = blobs({36, 40, 44}, false);
    const int cut = 12;
    for (std::size_t i = 0; i < map.values.size(); ++i)
        if (static_cast<int>(i % 36) > cut) map.values.change()[i] = kUnknownDensity;
    const Isosurface surface =
        MapRegion(map, glm::ivec3(0), map.size - 1).at(0.3, true, IsosurfaceParts::triangles, {});
    ASSERT_FALSE(surface.triangles.empty());
    for (const glm::vec3& p : surface.positions) EXPECT_LE(map.nodeAt(glm::dvec3(p)).x, cut + 1e-3);
}

TEST(Isosurface, CarvesAroundPlaces) {
    const DensityMap map = blobs({36, 40, 44}, false);
    const std::vector<glm::dvec3> places{kMiddle + glm::dvec3(radiusAt(0.3), 0, 0)};
    const Isosurface surface = MapRegion(map, places, 1.5).at(0.3, true, IsosurfaceParts::triangles, {});
    ASSERT_FALSE(surface.triangles.empty());
    for (const glm::vec3& p : surface.positions) EXPECT_LE(glm::distance(glm::dvec3(p), places[0]), 1.5 + 1e-3);
    EXPECT_TRUE(MapRegion(map, {}, 1).empty());
    const std::vector<glm::dvec3> outside{{500, 500, 500}};
    EXPECT_TRUE(MapRegion(map, outside, 1).at(0.3, true, IsosurfaceParts::triangles, {}).positions.empty());
}

TEST(Isosurface, AsManyCrossedCellsAsACountOfOurOwn) {
    const DensityMap map = blobs({37, 41, 43}, false);  // no multiples of the blocks
    const Isosurface surface =
        MapRegion(map, glm::ivec3(0), map.size - 1).at(0.2, true, IsosurfaceParts::triangles, {});
    std::size_t crossings = 0;
    for (int z = 0; z < map.size.z; ++z)
        for (int y = 0; y < map.size.y; ++y)
            for (int x = 0; x < map.size.x; ++x) {
                const auto high = [&](int i, int j, int k) { return map.values[map.index({i, j, k})] > 0.2f; };
                crossings += x + 1 < map.size.x && high(x, y, z) != high(x + 1, y, z);
                crossings += y + 1 < map.size.y && high(x, y, z) != high(x, y + 1, z);
                crossings += z + 1 < map.size.z && high(x, y, z) != high(x, y, z + 1);
            }
    EXPECT_EQ(surface.positions.size(), crossings);
}

TEST(DensityMap, ValuesBetweenNodesAndLevels) {
    const DensityMap map = blobs({36, 40, 44}, true);
    EXPECT_NEAR(valueAt(map, kMiddle), 1, 0.02);
    EXPECT_NEAR(valueAt(map, kMiddle + map.cell.edges() * glm::dvec3(-3, 1, 2)), valueAt(map, kMiddle), 1e-6);
    const double level = levelOfTopShare(map, 0.01);
    std::size_t above = 0;
    for (const float v : map.values) above += static_cast<double>(v) > level;
    EXPECT_NEAR(static_cast<double>(above) / static_cast<double>(map.values.size()), 0.01, 1e-4);
    const DensityMap box = blobs({36, 40, 44}, false);
    EXPECT_TRUE(std::isnan(valueAt(box, {-500, 0, 0})));
}

}  // namespace
}  // namespace nacre::test
