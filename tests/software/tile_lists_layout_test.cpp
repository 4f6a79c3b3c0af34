// How lists of what may show in a part of the picture are laid out: tiles, rows of bins, words.

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "engine/software/tile_lists.h"
#include "tests/software/listed_scene.h"

namespace nacre::test {
namespace {

TEST(TileListsLayout, TilesAndSpansAreThoseOfBinsThatAreNotEmpty) {
    for (std::uint32_t seed = 200; seed < 230; ++seed) {
        const ListedScene s = randomListedScene(seed, false, 0);
        TileLists lists;
        lists.build(s.view, s.scenery());
        std::set<std::pair<std::uint32_t, std::uint32_t>> bins, inSpans;
        for (std::uint32_t y = 0; y < lists.down(); ++y)
            for (std::uint32_t x = 0; x < lists.across(); ++x)
                if (const std::size_t bin = y * lists.across() + x;
                    lists.holds(bin) || lists.offsets()[bin] < lists.offsets()[bin + 1])
                    bins.emplace(x, y);
        // Those of a bin stand together: what looks for edges takes them at once (shaders/tile_edge_pixels.comp).
        constexpr std::uint32_t kPerBin = TileLists::kTilesInBin;
        std::set<std::pair<std::uint32_t, std::uint32_t>> tiles;
        for (std::size_t i = 0; i < lists.tiles().size(); ++i) {
            const TileLists::Tile& tile = lists.tiles()[i];
            const TileLists::Tile& first = lists.tiles()[i / (kPerBin * kPerBin) * (kPerBin * kPerBin)];
            EXPECT_TRUE(tiles.emplace(tile.x, tile.y).second);
            EXPECT_TRUE(bins.contains({tile.x / kPerBin, tile.y / kPerBin}));
            EXPECT_EQ(tile.x / kPerBin, first.x / kPerBin);
            EXPECT_EQ(tile.y / kPerBin, first.y / kPerBin);
        }
        EXPECT_EQ(tiles.size(), bins.size() * kPerBin * kPerBin);
        for (const TileLists::Span& span : lists.spans())
            for (std::uint32_t x = span.x; x < span.endX; ++x) EXPECT_TRUE(inSpans.emplace(x, span.y).second);
        EXPECT_EQ(inSpans, bins);
    }
}

/// Where a primitive may lie between the centres of pixels, all of its bins' pixels are edges.
TEST(TileListsLayout, TilesTellWhereSmallPrimitivesMayBe) {
    const std::vector<Sphere> spheres = {{{-24, 24, 0}, 3}, {{-8, 24, 0}, 0.5f}};
    const std::vector<Cylinder> cylinders = {{{8, 24, 0}, 2, {8, 20, 0}, 0}, {{24, 24, 0}, 0.2f, {24, 6, 0}, 0}};
    const TileCall balls{kUnturned, 0, 2, 1}, sticks{kUnturned, 0, 2, 3};
    TileView view = smallView();
    view.width = view.height = 64;
    view.axis = {32, 32};
    const auto small = [&](float limit) {
        view.small = limit;
        TileLists lists;
        lists.build(view, {spheres, {&balls, 1}, cylinders, {&sticks, 1}});
        std::vector<std::uint32_t> words(lists.words());
        lists.write(words.data());
        std::set<std::pair<std::uint32_t, std::uint32_t>> bins;
        for (std::size_t i = 0; i < lists.tiles().size(); ++i) {
            const std::uint32_t x = words[i] & 0xfff, y = words[i] >> 16 & 0xfff;
            EXPECT_EQ(x, lists.tiles()[i].x);
            EXPECT_EQ(y, lists.tiles()[i].y);
            const bool told = words[i] >> 31 != 0;
            EXPECT_EQ(told, lists.showsSmall(x / TileLists::kTilesInBin, y / TileLists::kTilesInBin));
            if (told) bins.emplace(x / TileLists::kTilesInBin, y / TileLists::kTilesInBin);
        }
        return bins;
    };
    using Bins = std::set<std::pair<std::uint32_t, std::uint32_t>>;
    EXPECT_EQ(small(0), Bins{});
    EXPECT_EQ(small(0.3f), (Bins{{3, 0}, {3, 1}}));
    EXPECT_EQ(small(0.75f), (Bins{{1, 0}, {3, 0}, {3, 1}}));
}

/// Shaders read the word before a list that is empty as if it were the list's: it has to be a number of a primitive.
TEST(TileListsLayout, TheWordBeforeAListIsTheNumberOfAPrimitive) {
    Representation sheet;  // far wider than the picture: the host knows all that its pixels show
    Mesh mesh;
    mesh.positions = {{-90, -90, 0}, {90, -90, 0}, {0, 180, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.atoms.assign(3, 0);
    mesh.triangles = {{0, 1, 2}};
    appendMesh(
        mesh, glm::dvec3(0), [](std::uint32_t) { return SphereLook{}; }, sheet);
    const std::vector<Sphere> spheres = {{{20, 20, 5}, 1}};
    const std::vector<glm::vec4> rows = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    const TileCall ball{rows.data(), 0, 1, 1}, triangle{rows.data(), 0, 1, 2};
    TileView view;
    view.width = view.height = 64;
    view.axis = {32, 32};
    view.origin = 200;
    view.range = 400;
    view.centers = true;
    for (const bool balls : {false, true}) {
        const std::span<const TileCall> calls(&ball, balls ? 1 : 0);
        TileLists lists;
        lists.build(view, {spheres, calls, {}, {}, {}, sheet.triangles, sheet.meshVertices, {&triangle, 1}});
        ASSERT_EQ(lists.tiles().size(), 64u);
        std::vector<std::uint32_t> words(lists.words(), 0xdeadbeefu);
        lists.write(words.data());
        const std::uint32_t* offsets = &words[lists.tiles().size()];
        std::size_t empty = 0;
        for (std::size_t bin = 0; bin < std::size_t{lists.across()} * lists.down(); ++bin) {
            empty += offsets[bin] == offsets[bin + 1];
            ASSERT_LE(offsets[bin + 1], words.size());
            for (std::uint32_t at = offsets[bin] - 1; at < offsets[bin + 1]; ++at) EXPECT_EQ(words[at], 1u) << bin;
        }
        EXPECT_EQ(empty, balls ? 15u : 16u);
    }
}

TEST(TileListsLayout, WhatIsOutsideThePictureIsNotKept) {
    const std::vector<Sphere> spheres = {{{0, 0, 0}, 1}, {{100, 0, 0}, 1}, {{0, -100, 0}, 1}, {{-100, 100, 0}, 1}};
    const std::vector<glm::vec4> rows = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    const TileCall call{rows.data(), 0, 4, 1};
    TileView view;
    view.width = view.height = 64;
    view.axis = {32, 32};
    view.origin = 120;
    view.range = 240;
    TileLists lists;
    lists.build(view, {spheres, {&call, 1}, {}, {}});
    EXPECT_EQ(lists.kept(), 1u);
    EXPECT_EQ(writeLists(lists), std::vector<std::uint32_t>(4, 1));  // about the corner of four bins
    lists.build(view, {});
    EXPECT_EQ(lists.kept(), 0u);
    EXPECT_TRUE(lists.tiles().empty());
    EXPECT_TRUE(lists.spans().empty());
}

}  // namespace
}  // namespace nacre::test
