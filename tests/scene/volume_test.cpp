#include "engine/scene/build/volume.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>

#include "engine/volume/read_map.h"

namespace nacre::test {
namespace {

/// A box of 100 x 40 x 40 nodes, 0.5 Å apart, from the origin: x beyond 30 Å, else 0.
DensityMap ramp() {
    const glm::ivec3 size(100, 40, 40);
    std::vector<float> values;
    for (int i = 0; i < size.x * size.y * size.z; ++i) {
        const auto x = static_cast<float>(i % size.x) / 2;
        values.push_back(x > 30 ? x : 0);
    }
    return mapOfValues("ramp", size, UnitCell{.lengths = glm::dvec3(size) * 0.5}, {}, false, values);
}

const std::vector<VolumeLevel> kHigh{{40, {1, 1, 1}, 0.5}, {35, {1, 0, 0}, 0}};

TEST(Volume, HoldsOnlyWhatShows) {
    const DensityMap map = ramp();
    const MapRegion region(map, glm::ivec3(0), map.size - 1);
    const glm::dvec3 center(10, 0, 0);
    const auto volume = makeVolume(region, kHigh, center, 16);
    ASSERT_TRUE(volume);
    EXPECT_EQ(volume->bricks.size(), 3u * 3 * 3);
    for (const VolumeBrick& brick : volume->bricks) {
        EXPECT_GE(brick.place.x, 4);  // 35 Å is node 70, in the block from node 64
        EXPECT_FALSE(brick.masked);
        ASSERT_EQ(brick.texels.size(), static_cast<std::size_t>(brick.size.x * brick.size.y * brick.size.z));
        // The unit of the texels is that of the levels: 35 is a red of no opacity.
        const double perUnit = (volume->levels[1].value - volume->levels[0].value) / 5;
        for (int x = 0; x < brick.size.x; ++x) {
            const auto value = static_cast<double>(glm::unpackHalf1x16(brick.texels[static_cast<std::size_t>(x)]));
            const double there = 35 + (value - volume->levels[0].value) / perUnit;
            EXPECT_NEAR(there, (brick.first.x + x) / 2.0, 0.03);
        }
    }
    EXPECT_EQ(volume->levels.front().opacity, 0);
    EXPECT_NEAR(volume->step, 0.25, 1e-9);
    EXPECT_NEAR(glm::length(volume->toNode * glm::dvec4(0, 1, 2, 1) - glm::dvec3(20, 2, 4)), 0, 1e-9);
    EXPECT_NEAR(volume->radius, glm::length(glm::dvec3(39.5, 19.5, 19.5)), 1e-9);
}

TEST(Volume, IsNothingWhereNothingShows) {
    const DensityMap map = ramp();
    const MapRegion region(map, glm::ivec3(0), map.size - 1);
    EXPECT_FALSE(makeVolume(region, std::vector<VolumeLevel>{{50, {}, 0}, {60, {}, 1}}, {}));
    // A level between two values that occur shows.
    EXPECT_TRUE(makeVolume(region, std::vector<VolumeLevel>{{10, {}, 0}, {10.1, {}, 0.5}, {10.2, {}, 0}}, {}));
}

TEST(Volume, KnowsWhereNothingIsKnown) {
    DensityMap map = ramp();
    map.values.change()[map.index({80, 20, 20})] = kUnknownDensity;
    const MapRegion region(map, glm::ivec3(0), map.size - 1);
    const auto volume = makeVolume(region, kHigh, {});
    ASSERT_TRUE(volume);
    ASSERT_EQ(volume->bricks.size(), 1u);
    const VolumeBrick& brick = volume->bricks[0];
    ASSERT_TRUE(brick.masked);
    const glm::ivec3 at = glm::ivec3(80, 20, 20) - brick.first;
    const auto node = static_cast<std::size_t>((at.z * brick.size.y + at.y) * brick.size.x + at.x);
    EXPECT_LT(glm::unpackHalf1x16(brick.texels[2 * node + 1]), -100);
    EXPECT_EQ(glm::unpackHalf1x16(brick.texels[2 * node + 3]), 1);
}

TEST(Volume, FadesAtTheDistanceFromPlaces) {
    const DensityMap map = ramp();
    const glm::dvec3 place(40, 10, 10);
    constexpr double kReach = 3;
    const MapRegion region(map, std::span(&place, 1), kReach);
    const auto volume = makeVolume(region, kHigh, {});
    ASSERT_TRUE(volume);
    ASSERT_EQ(volume->bricks.size(), 1u);
    const VolumeBrick& brick = volume->bricks[0];
    ASSERT_TRUE(brick.masked);
    std::size_t i = 1, within = 0;
    for (int z = 0; z < brick.size.z; ++z)
        for (int y = 0; y < brick.size.y; ++y)
            for (int x = 0; x < brick.size.x; ++x, i += 2) {
                const glm::dvec3 p = map.place(glm::dvec3(region.first() + brick.first + glm::ivec3(x, y, z)));
                const double away = glm::length(p - place);
                const float share = glm::unpackHalf1x16(brick.texels[i]);
                if (away < kReach - 0.26) {
                    EXPECT_EQ(share, 1);
                    ++within;
                } else if (away > kReach + 0.26) {
                    EXPECT_LE(share, 0);
                }
            }
    EXPECT_GT(within, 500u);
}

}  // namespace
}  // namespace nacre::test
