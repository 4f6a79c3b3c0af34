#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <set>

#include "engine/occlusion/bounced_light.h"
#include "engine/occlusion/cache.h"
#include "tests/support/temporary_folder.h"

namespace nacre {
namespace {

using test::TemporaryFolder;

Representation twoSpheresAndABond() {
    Representation r;
    r.spheres = {{{0, 0, 0}, 1.5f}, {{1, 2, 3}, 1.2f}};
    r.sphereLooks = {{0xff0000ff, 1}, {0xff00ff00, 2}};
    r.cylinders = {{{0, 0, 0}, 0.2f, {1, 2, 3}}};
    r.cylinderLooks = {{0xff0000ff, 0xff00ff00, 1, 2}};
    return r;
}

FinishedOcclusion someBake() {
    FinishedOcclusion finished;
    finished.layout = {4, 8, 3, 16, 7, 4, 3, 2, 1, 0};
    for (int i = 0; i < 16 * 7; ++i) finished.atlas.push_back(static_cast<std::uint8_t>(i * 37));
    finished.seenSpheres = {true, false};
    finished.openTexels = 51;
    return finished;
}

TEST(OcclusionCacheName, IsOfShapesAndWaysNotOfColours) {
    const Representation r = twoSpheresAndABond();
    std::set<std::string> names{occlusionCacheName(r, "128 directions")};
    Representation same = r;
    same.sphereLooks[0] = {0xffffffff, 7};
    same.cylinderLooks[0].colorA = 0;
    same.center = {5, 5, 5};
    EXPECT_TRUE(names.contains(occlusionCacheName(same, "128 directions")));
    const std::function<void(Representation&)> changes[] = {
        [](Representation& x) { x.spheres[1].center.z += 1e-6f * 3; },
        [](Representation& x) { x.spheres[0].radius = 1; },
        [](Representation& x) { std::swap(x.spheres[0], x.spheres[1]); },
        [](Representation& x) { x.spheres.pop_back(); },
        [](Representation& x) { x.cylinders[0].radius = 1; },
        [](Representation& x) { x.cylinders[0].b.x = 0; },
        [](Representation& x) { x.cylinders.clear(); },
        [](Representation& x) {
            x.meshVertices.resize(3), x.triangles = {{0, 1, 2, 1.0f}};
        },
        [](Representation& x) {
            x.meshVertices.resize(3), x.triangles = {{0, 2, 1, 1.0f}};
        },
        [](Representation& x) {
            x.meshVertices = {{1, 0, 0, 0}, {}, {}}, x.triangles = {{0, 1, 2, 1.0f}};
        }};
    for (const auto& change : changes) {
        Representation other = r;
        change(other);
        EXPECT_TRUE(names.insert(occlusionCacheName(other, "128 directions")).second);
    }
    EXPECT_TRUE(names.insert(occlusionCacheName(r, "64 directions")).second);
}

TEST(OcclusionCacheName, OfBouncedLightIsOfColoursToo) {
    Representation r = twoSpheresAndABond();
    r.meshVertices.resize(3);
    r.meshLooks = {{0xff0000ff, 1}, {0xffff0000, 1}};
    std::set<std::string> names{bouncedCacheName(r, "a bake"), occlusionCacheName(r, "a bake")};
    EXPECT_EQ(names.size(), 2u);
    EXPECT_TRUE(names.insert(bouncedCacheName(r, "another bake")).second);
    const std::function<void(Representation&)> changes[] = {
        [](Representation& x) { x.sphereLooks[1].color = 0; }, [](Representation& x) { x.cylinderLooks[0].colorB = 0; },
        [](Representation& x) { x.meshLooks[0].color = 0; }, [](Representation& x) { x.meshVertices[2].look = 1; }};
    for (const auto& change : changes) {
        Representation other = r;
        change(other);
        EXPECT_TRUE(names.insert(bouncedCacheName(other, "a bake")).second);
    }
    Representation same = r;
    same.sphereLooks[0].atom = 7;
    EXPECT_TRUE(names.contains(bouncedCacheName(same, "a bake")));
}

TEST(OcclusionCache, GivesBackBouncedLight) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path(), kOcclusionCacheBytes, {"name"});
    const Representation r = twoSpheresAndABond();
    FinishedOcclusion bake = someBake();
    bake.bounced = true;
    ASSERT_TRUE(writeOcclusion(cache, "name", bake));
    EXPECT_FALSE(readOcclusion(cache, "name", r)) << "one byte per texel";
    bake.atlas.resize(kBytesPerBounced * bake.atlas.size(), 9);
    ASSERT_TRUE(writeOcclusion(cache, "name", bake));
    const auto read = readOcclusion(cache, "name", r);
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->bounced);
    EXPECT_EQ(read->atlas, bake.atlas);
}

TEST(OcclusionCache, GivesBackEveryBit) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path(), kOcclusionCacheBytes, {"name", "other"});
    const Representation r = twoSpheresAndABond();
    EXPECT_FALSE(readOcclusion(cache, "name", r));
    const FinishedOcclusion bake = someBake();
    ASSERT_TRUE(writeOcclusion(cache, "name", bake));
    const auto read = readOcclusion(cache, "name", r);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->atlas, bake.atlas);
    EXPECT_EQ(read->seenSpheres, bake.seenSpheres);
    EXPECT_EQ(read->openTexels, bake.openTexels);
    EXPECT_EQ(read->layout.sphereEdge, 4u);
    EXPECT_EQ(read->layout.around, 8u);
    EXPECT_EQ(read->layout.along, 3u);
    EXPECT_EQ(read->layout.sphereRows, 4u);
}

TEST(OcclusionCache, EveryTruncationAndEveryFlippedBitIsFound) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path(), kOcclusionCacheBytes, {"name", "other"});
    const Representation r = twoSpheresAndABond();
    ASSERT_TRUE(writeOcclusion(cache, "name", someBake()));
    const std::string whole = test::readContents(cache.entryPath("name"));
    const auto reads = [&](const std::string& content) {
        std::ofstream(cache.entryPath("name"), std::ios::binary | std::ios::trunc) << content;
        return readOcclusion(cache, "name", r).has_value();
    };
    ASSERT_TRUE(reads(whole));
    for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_FALSE(reads(whole.substr(0, size))) << size;
    EXPECT_FALSE(reads(whole + '\0'));
    for (std::size_t bit = 0; bit < whole.size() * 8; ++bit) {
        std::string flipped = whole;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ 1 << bit % 8);
        EXPECT_FALSE(reads(flipped)) << bit;
    }
}

TEST(OcclusionCache, AForgedFileIsAMiss) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path(), kOcclusionCacheBytes, {"name"});
    const Representation r = twoSpheresAndABond();
    const std::function<void(FinishedOcclusion&)> forgeries[] = {
        [](FinishedOcclusion& f) { f.layout.sphereEdge = 0; },
        [](FinishedOcclusion& f) { f.layout.around = 0; },
        [](FinishedOcclusion& f) { f.layout.along = 0; },
        [](FinishedOcclusion& f) { f.layout.sphereEdge = 0xffffffff; },
        [](FinishedOcclusion& f) { f.layout.sphereEdge = 16; },  // two rows of it do not fit
        [](FinishedOcclusion& f) { f.layout.around = 20; },      // wider than the atlas
        [](FinishedOcclusion& f) { f.layout.sphereRows = 5; },
        [](FinishedOcclusion& f) { f.layout.sphereRows = 0xffffffff; },
        [](FinishedOcclusion& f) { f.openTexels = 57; },
        [](FinishedOcclusion& f) {
            f.layout.width = f.layout.height = 0;
            f.atlas.clear();
        },
        [](FinishedOcclusion& f) {
            f.layout.width = 0x80000000;  // times two it is nothing in 32 bits
            f.layout.height = 2;
            f.atlas.clear();
        }};
    for (const auto& forge : forgeries) {
        FinishedOcclusion bake = someBake();
        forge(bake);
        ASSERT_TRUE(writeOcclusion(cache, "name", bake));
        EXPECT_FALSE(readOcclusion(cache, "name", r)) << (&forge - forgeries);
    }
}

TEST(OcclusionCache, AFileUnderAnothersNameIsFound) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path(), kOcclusionCacheBytes, {"name", "other"});
    ASSERT_TRUE(writeOcclusion(cache, "name", someBake()));
    std::filesystem::rename(cache.entryPath("name"), cache.entryPath("other"));
    EXPECT_FALSE(readOcclusion(cache, "other", twoSpheresAndABond()));
}

TEST(OcclusionCache, WhatDoesNotFitTheSceneIsNotTaken) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path(), kOcclusionCacheBytes, {"name", "other"});
    ASSERT_TRUE(writeOcclusion(cache, "name", someBake()));
    Representation other = twoSpheresAndABond();
    other.spheres.push_back({{9, 9, 9}, 1});
    EXPECT_FALSE(readOcclusion(cache, "name", other));
    FinishedOcclusion small = someBake();
    small.atlas.pop_back();
    ASSERT_TRUE(writeOcclusion(cache, "name", small));
    EXPECT_FALSE(readOcclusion(cache, "name", twoSpheresAndABond()));
}

}  // namespace
}  // namespace nacre
