// Widths of patches and depth maps: of the scene and the memory alone.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/occlusion/bake_preparation.h"

namespace nacre::test {
namespace {

using occlusion::BakePreparation;

/// Atoms as dense as in a protein, in a ball.
Representation ball(std::size_t atoms) {
    constexpr double kApart = 2.6;
    Representation r;
    const double radius = kApart * std::cbrt(static_cast<double>(atoms) * 0.75 / 3.14159265);
    const int side = static_cast<int>(radius / kApart) + 1;
    std::uint32_t random = 1;
    const auto jitter = [&] {
        random = random * 1664525 + 1013904223;
        return static_cast<float>(random >> 8) / (1 << 24) - 0.5f;
    };
    for (int z = -side; z <= side; ++z)
        for (int y = -side; y <= side; ++y)
            for (int x = -side; x <= side; ++x)
                if (kApart * std::sqrt(x * x + y * y + z * z) <= radius)
                    r.spheres.push_back(
                        {glm::vec3(x, y, z) * static_cast<float>(kApart) + glm::vec3(jitter(), jitter(), jitter()),
                         1.7f});
    r.sphereLooks.resize(r.spheres.size());
    r.radius = radius + 2.5;
    return r;
}

BakePreparation prepared(const Representation& r, std::uint64_t megabytes, OcclusionMaps path,
                         const gpu::Caps& caps = {}) {
    return occlusion::prepareBake(caps, r, occlusion::BakeOptions{.budgetBytes = megabytes << 20, .path = path});
}

TEST(PatchSizes, FallInStepsOfAtMostOneAndAHalf) {
    const auto layouts = occlusionLayouts(1000, 1000, 0, 16384, 16384);
    ASSERT_EQ(layouts.front().sphereEdge, 32u);
    ASSERT_EQ(layouts.back().sphereEdge, 1u);
    for (std::size_t i = 1; i < layouts.size(); ++i) {
        const OcclusionLayout &finer = layouts[i - 1], &coarser = layouts[i];
        EXPECT_LE(2 * finer.around * finer.along, 3 * coarser.around * coarser.along) << i;
        EXPECT_TRUE(holdsItsPatches(coarser, 16384)) << i;
        EXPECT_EQ(coarser.width % 4, 0u) << i;
        if (coarser.sphereEdge > 1) {
            EXPECT_LE(2 * finer.sphereEdge, 3 * coarser.sphereEdge) << i;
        }
        if (coarser.sphereEdge > 4) {
            EXPECT_LE(2 * finer.sphereEdge * finer.sphereEdge, 3 * coarser.sphereEdge * coarser.sphereEdge) << i;
        }
    }
}

TEST(PatchSizes, FollowFromTheSceneAndTheMemory) {
    struct Row {
        std::size_t atoms;
        std::uint64_t megabytes;
        std::uint32_t edge, mapPixels;
    };
    const Row rows[] = {
        {500, 64, 32, 128},   {500, 4, 20, 128},   {500, 1, 10, 128},     {5'000, 64, 20, 128},
        {5'000, 16, 14, 128}, {5'000, 4, 7, 88},   {5'000, 1, 4, 48},     {50'000, 64, 10, 200},
        {50'000, 16, 5, 104}, {50'000, 4, 3, 104}, {300'000, 64, 4, 176}, {300'000, 32, 3, 176},
    };
    for (const Row& row : rows) {
        const Representation r = ball(row.atoms);
        const BakePreparation p = prepared(r, row.megabytes, OcclusionMaps::fragdepth);
        EXPECT_EQ(p.layout.sphereEdge, row.edge) << row.atoms << " atoms, " << row.megabytes << " MB";
        EXPECT_EQ(p.maps.pixels, row.mapPixels) << row.atoms << " atoms, " << row.megabytes << " MB";
        EXPECT_LE(occlusion::bakeBytes(p.layout, p.open.texels.size(), p.open.words.size()) + p.maps.bytes,
                  row.megabytes << 20);
    }
}

/// Values of the atoms take most of the memory, and the map what is left.
TEST(PatchSizes, LeaveAMapTheRestBeforeABakeFails) {
    const Representation r = ball(40'000);
    occlusion::BakeOptions options{.budgetBytes = 900 << 10};
    const BakePreparation p = occlusion::prepareBake({}, r, options);
    EXPECT_EQ(p.layout.sphereEdge, 1u);
    EXPECT_EQ(p.maps.perBatch, 1u);
    const std::uint64_t patches = occlusion::bakeBytes(p.layout, p.open.texels.size(), p.open.words.size());
    EXPECT_GT(patches, options.budgetBytes / 2);
    EXPECT_LE(patches + occlusion::DepthMapSizes::mostBytes(p.maps.pixels), options.budgetBytes);
    EXPECT_GT(patches + occlusion::DepthMapSizes::mostBytes(p.maps.pixels + 8), options.budgetBytes);
}

/// An atlas with bounced light has a second half below the first.
TEST(PatchSizes, FitTheDevicesImages) {
    const Representation r = ball(4000);
    gpu::Caps caps;
    caps.maxImageSize = 128;
    occlusion::BakeOptions options{.budgetBytes = 64 << 20};
    for (const bool bounce : {false, true}) {
        options.bounce = bounce;
        const OcclusionLayout layout = occlusion::prepareBake(caps, r, options).layout;
        EXPECT_GE(layout.sphereEdge, 1u);
        EXPECT_LE(layout.width, caps.maxImageSize);
        EXPECT_LE(layout.height * (options.bounce ? 2 : 1), caps.maxImageSize);
    }
    caps.maxImageSize = 64;  // 4096 texels
    options.bounce = false;
    EXPECT_NO_THROW(occlusion::prepareBake(caps, r, options));
    options.bounce = true;
    EXPECT_THROW(occlusion::prepareBake(caps, r, options), Error);
}

/// Paths and devices may draw fewer maps at a time.
TEST(PatchSizes, AreTheSameOnEveryPathAndDevice) {
    const Representation r = ball(2000);
    for (const std::uint64_t megabytes : {1, 4, 64}) {
        const BakePreparation expected = prepared(r, megabytes, OcclusionMaps::fragdepth);
        const auto expectSame = [&](OcclusionMaps path, const gpu::Caps& caps) {
            const BakePreparation p = prepared(r, megabytes, path, caps);
            EXPECT_EQ(p.layout.sphereEdge, expected.layout.sphereEdge);
            EXPECT_EQ(p.layout.width, expected.layout.width);
            EXPECT_EQ(p.maps.pixels, expected.maps.pixels);
            EXPECT_EQ(p.open.texels, expected.open.texels);
            EXPECT_LE(p.maps.perBatch, expected.maps.perBatch);
            EXPECT_LE(p.maps.bytes, occlusion::DepthMapSizes::mostBytes(p.maps.pixels) * p.maps.perBatch);
        };
        gpu::Caps caps;
        expectSame(OcclusionMaps::tiles, caps);
        for (const graph::EncodedFormat& format : graph::encodedFormats()) {
            caps.encodedMaps = format;
            expectSame(OcclusionMaps::encoded, caps);
        }
        caps.maxImageSize = 16384;
        expectSame(OcclusionMaps::fragdepth, caps);
    }
}

}  // namespace
}  // namespace nacre::test
