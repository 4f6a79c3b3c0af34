// Surfaces of maps end at their distance exactly, wherever the grid's cells do.

#include "engine/mesh/carve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace nacre {
namespace {

/// A map that is the distance from a plane: its surface at 0 is the plane z = 0.
DensityMap planeMap(double step) {
    DensityMap map;
    map.name = "plane";
    const int n = static_cast<int>(std::lround(16 / step)) + 1;
    map.size = glm::ivec3(n);
    map.origin = glm::dvec3(-8);
    map.step = glm::dmat3(step);
    std::vector<float> values;
    for (int z = 0; z < n; ++z)
        for (int i = 0; i < n * n; ++i) values.push_back(static_cast<float>(8 - z * step));
    map.values = MapValues(std::move(values));
    map.boxSize = map.size;
    return map;
}

double measureArea(const Isosurface& surface) {
    double area = 0;
    for (const glm::uvec3& t : surface.triangles) {
        const glm::vec3 a = surface.positions[t.x], b = surface.positions[t.y], c = surface.positions[t.z];
        area += static_cast<double>(glm::length(glm::cross(b - a, c - a))) / 2;
    }
    return area;
}

TEST(Carve, APlaneBecomesADisc) {
    constexpr double kReach = 3.3, kAbove = 1.2, kPi = 3.14159265358979;
    const glm::dvec3 places[] = {{0.13, -0.21, kAbove}};
    const double radius = std::sqrt(kReach * kReach - kAbove * kAbove);
    for (const double step : {0.5, 1.0}) {
        const DensityMap map = planeMap(step);
        const Isosurface disc = MapRegion(map, places, kReach).at(0, true, IsosurfaceParts::triangles, {});
        // The rim's chords are a little shorter than its arcs.
        EXPECT_NEAR(measureArea(disc), kPi * radius * radius, 0.01 * step * kPi * radius * radius) << step;
        double farthest = 0;
        for (const glm::vec3& p : disc.positions)
            farthest = std::max(farthest, glm::distance(glm::dvec3(p), places[0]));
        EXPECT_NEAR(farthest, kReach, 1e-3) << step;
        const Isosurface lines = MapRegion(map, places, kReach).at(0, true, IsosurfaceParts::lines, {});
        ASSERT_FALSE(lines.lines.empty());
        for (const glm::vec3& p : lines.positions) EXPECT_LE(glm::distance(glm::dvec3(p), places[0]), kReach + 1e-3);
    }
}

TEST(Carve, WhatIsNearIsWhole) {
    const DensityMap map = planeMap(1);
    const glm::dvec3 places[] = {{0, 0, 0}, {2, 1, 0}};
    const Isosurface whole = MapRegion(map, glm::ivec3(0), map.size - 1).at(0, true, IsosurfaceParts::triangles, {});
    Isosurface carved = whole;
    carve(carved, places, 100);
    EXPECT_EQ(carved.triangles.size(), whole.triangles.size());
    carve(carved, std::vector<glm::dvec3>{{0, 0, 50}}, 3);
    EXPECT_TRUE(carved.triangles.empty());
    EXPECT_TRUE(carved.positions.empty());
}

}  // namespace
}  // namespace nacre
