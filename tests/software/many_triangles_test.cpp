// Triangles that threads share, in groups from near to far.

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "engine/software/front_triangles.h"
#include "tests/software/listed_scene.h"

namespace nacre::test {
namespace {

constexpr std::uint32_t kPicture = 128;  // side

/// Triangles in the picture, 32 beside each other, and the balls of those.
struct ManyTriangles {
    std::vector<glm::vec4> corners;
    std::vector<Triangle> triangles;
    std::vector<Chunk> chunks;
    glm::vec4 rows[3] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    TileView view;

    ManyTriangles() {
        view.width = view.height = kPicture;
        view.axis = glm::vec2(kPicture / 2);
        view.range = view.origin = 40;
        view.pixels = 3;
    }
    void add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        const auto first = static_cast<std::uint32_t>(corners.size());
        triangles.push_back({first, first + 1, first + 2, 1});
        for (const glm::vec3& corner : {a, b, c}) corners.emplace_back(corner, 0);
    }
    void addChunks() {
        const auto planePoint = [&](const glm::vec4& corner) {
            const glm::vec2 off = (glm::vec2(corner) - view.axis) / view.pixels;
            return glm::vec3(off.x, -off.y, view.origin - corner.z);
        };
        constexpr std::size_t kCorners = std::size_t{3} * Chunk::kPrimitives;
        for (std::size_t first = 0; first < corners.size(); first += kCorners) {
            Chunk chunk{planePoint(corners[first]), 0};
            for (std::size_t i = first; i < std::min(first + kCorners, corners.size()); ++i)
                chunk.radius = std::max(chunk.radius, glm::distance(chunk.center, planePoint(corners[i])) * 1.0001f);
            chunks.push_back(chunk);
        }
    }
    /// @param first  triangle that is drawn
    void draw(FrontTriangles& front, bool withChunks, std::uint32_t first = 0) const {
        front.begin(view);
        FrontTriangles::Run run{std::span(triangles).subspan(first), rows, 1 + first};
        if (withChunks) run.chunks = std::span(chunks).subspan(first / 32), run.first = first % 32;
        front.draw({&run, 1}, corners);
        front.end();
    }
};

class ManyTrianglesTest : public testing::TestWithParam<bool> {};

/// So many that threads share them, and each once more with nothing between: of both one is in doubt, whoever drew
/// them.
TEST_P(ManyTrianglesTest, TheNearestAreCertainOrInDoubt) {
    constexpr std::uint32_t kMany = 24'000, kBegin = 5;
    RandomNumbers dice(5);
    ManyTriangles many;
    glm::dvec3 place{};
    for (std::uint32_t i = 0; i < kMany; ++i) {
        if (i % 32 == 0) place = {dice(0, kPicture), dice(0, kPicture), dice(4, 36)};
        if (i % 4 == 3 || (i % 4 == 1 && i >= kMany / 2)) {
            const glm::vec4* twin = &many.corners[3 * std::size_t{i % 4 == 3 ? i - 1 : i - kMany / 2}];
            many.add(glm::vec3(twin[0]), glm::vec3(twin[1]), glm::vec3(twin[2]));
            continue;
        }
        const glm::dvec3 middle = place + glm::dvec3(dice(-8, 8), dice(-8, 8), dice(-3, 3));
        const auto corner = [&] { return glm::vec3(middle + glm::dvec3(dice(-3, 3), dice(-3, 3), 0)); };
        const glm::vec3 a = corner(), b = corner();
        many.add(a, b, corner());
    }
    many.addChunks();
    const std::vector<glm::vec4>& corners = many.corners;
    std::vector<std::vector<std::pair<double, std::uint32_t>>> seen(kPicture * kPicture);  // depth and number
    for (std::uint32_t i = kBegin; i < kMany; ++i) {
        const glm::dvec3 a(corners[3 * i]), b(corners[3 * i + 1]), c(corners[3 * i + 2]);
        const auto clamped = [](double at) { return static_cast<std::uint32_t>(std::clamp<double>(at, 0, kPicture)); };
        for (std::uint32_t y = clamped(std::min({a.y, b.y, c.y})); y < clamped(std::max({a.y, b.y, c.y}) + 1); ++y)
            for (std::uint32_t x = clamped(std::min({a.x, b.x, c.x})); x < clamped(std::max({a.x, b.x, c.x}) + 1);
                 ++x) {
                const auto side = [&](const glm::dvec3& from, const glm::dvec3& to) {
                    return (from.x - x - 0.5) * (to.y - y - 0.5) - (from.y - y - 0.5) * (to.x - x - 0.5);
                };
                const double ab = side(a, b), bc = side(b, c), ca = side(c, a);
                if (std::min({ab, bc, ca}) > 0 || std::max({ab, bc, ca}) < 0)
                    seen[y * kPicture + x].emplace_back(a.z, i + 1);
            }
    }
    for (auto& there : seen) std::sort(there.begin(), there.end());
    for (const TriangleLanes& lanes : triangleLanes()) {
        SCOPED_TRACE(lanes.lanes);
        FrontTriangles front(lanes);
        many.draw(front, GetParam(), kBegin);
        std::vector<bool> doubtful(kMany + 1);
        for (std::size_t i = 0; i < front.ambiguous(); ++i) {
            const glm::vec4* rows = nullptr;
            std::uint32_t number = 0;
            front.doubt(i, rows, number);
            doubtful[number] = true;
        }
        std::size_t certain = 0, wrong = 0, twins = 0;
        for (std::uint32_t pixel = 0; pixel < kPicture * kPicture; ++pixel) {
            const std::vector<std::pair<double, std::uint32_t>>& there = seen[pixel];
            std::uint32_t seed = 0;
            front.write(pixel % kPicture, pixel / kPicture, 1, &seed);
            certain += seed != 0;
            for (const auto& [depth, number] : there) {
                if (depth > there[0].first) break;
                wrong += number != seed && !doubtful[number];
                twins += number != there[0].second;
            }
        }
        EXPECT_EQ(wrong, 0u);
        EXPECT_GT(certain, kPicture * kPicture / 2);
        EXPECT_GT(twins, 1000u);
    }
}

/// Pairs in one place are in doubt, unless what is before them was drawn before.
TEST_P(ManyTrianglesTest, ThoseBehindOthersAreInNoDoubt) {
    ManyTriangles many;
    const auto addTwins = [&](float Z) {
        for (int i = 0; i < 32; ++i) many.add({20, 20, Z}, {40, 20, Z}, {20, 40, Z});
    };
    addTwins(30);
    for (float Z = 32; Z > 0; --Z) many.add({-9, -9, Z / 4}, {400, -9, Z / 4}, {-9, 400, Z / 4});
    addTwins(20);
    many.addChunks();
    for (const TriangleLanes& lanes : triangleLanes())
        for (const bool edges : {false, true}) {
            many.view.edges = edges;
            FrontTriangles front(lanes);
            many.draw(front, GetParam());
            std::uint32_t number = 0;
            front.write(25, 25, 1, &number);
            EXPECT_EQ(number, 64u);
            const glm::vec4* rows = nullptr;
            bool any = false;
            for (std::size_t i = 0; i < front.ambiguous(); ++i) {
                front.doubt(i, rows, number);
                any = any || number <= 32 || number > 64;
            }
            EXPECT_EQ(any, !GetParam()) << edges;
        }
}

INSTANTIATE_TEST_SUITE_P(Chunks, ManyTrianglesTest, testing::Bool(),
                         [](const auto& tested) { return tested.param ? "Known" : "Unknown"; });

}  // namespace
}  // namespace nacre::test
