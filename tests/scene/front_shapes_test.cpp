// Spheres and cylinders that the host draws, against all of them asked at each pixel, in double precision.

#include "engine/scene/front_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <tuple>

namespace nacre::test {
namespace {

/// Bonds between atoms, at the places of some copies; some twice at the same place.
struct Bonds {
    std::vector<Sphere> spheres;
    std::vector<Cylinder> cylinders;
    std::vector<glm::vec4> rows;
    std::vector<TileCall> balls, sticks;
    TileView view;
    static constexpr std::uint32_t kAtoms = 200, kCopies = 3;

    /// @param pixels  per Å
    Bonds(std::uint32_t seed, double pixels, int quarterTurns) : engine_(seed) {
        for (std::uint32_t i = 0; i < kAtoms; ++i) {
            const glm::dvec3 at = within(9);
            spheres.push_back({glm::vec3(at), i % 3 ? 0.25f : 0.5f});
            cylinders.push_back({spheres.back().center, 0.25f, glm::vec3(at + within(1.5)), 0});
        }
        for (std::uint32_t i = 0; i < 40; i += 2) spheres[i] = spheres[i + 1], cylinders[i] = cylinders[i + 1];
        // Some look at the eye, or have no ball.
        for (std::uint32_t i = 50; i < 60; ++i) cylinders[i].b = cylinders[i].a + glm::vec3(0, 0, i % 2 ? 1 : -1);
        for (std::uint32_t i = 60; i < 80; ++i) cylinders[i].a += 5.0f;
        for (std::uint32_t c = 0; c < kCopies; ++c) {
            const glm::dmat3 turn = glm::mat3_cast(
                glm::normalize(glm::dquat(within(1).x + (c == 0 ? 1e9 : 0), within(1).x, within(1).x, within(1).x)));
            const glm::dvec3 shift = within(4);
            for (int i = 0; i < 3; ++i) rows.emplace_back(turn[0][i], turn[1][i], turn[2][i], shift[i]);
        }
        for (std::uint32_t c = 0; c < kCopies; ++c) {
            const std::uint32_t base = 2 * kAtoms * c + 1;
            balls.push_back({&rows[std::size_t{3} * c], 0, kAtoms, base});
            sticks.push_back({&rows[std::size_t{3} * c], 10, kAtoms - 10, base + kAtoms});
        }
        view.width = 107;
        view.height = 83;
        view.centers = true;
        view.quarterTurns = quarterTurns;
        view.pixels = static_cast<float>(pixels);
        view.axis = {50.5f, 40.25f};
        view.origin = 30;
        view.range = 60;
    }

    glm::dvec3 within(double reach) {
        std::uniform_real_distribution<double> number(-reach, reach);
        const double x = number(engine_), y = number(engine_);
        return {x, y, number(engine_)};
    }

private:
    std::mt19937 engine_;
};

glm::dvec3 placeOf(const glm::vec4* rows, const glm::vec3& p) {
    glm::dvec3 at;
    for (int i = 0; i < 3; ++i) at[i] = glm::dot(glm::dvec4(rows[i]), glm::dvec4(glm::dvec3(p), 1));
    return at;
}

/// Height of a sphere's hit over the plane z = 0. @param q  on that plane
std::optional<double> heightOf(const glm::dvec3& center, double radius, const glm::dvec2& q) {
    const glm::dvec2 away = q - glm::dvec2(center);
    const double square = radius * radius - glm::dot(away, away);
    return square > 0 ? std::optional(center.z + std::sqrt(square)) : std::nullopt;
}

/// Likewise of a cylinder with flat ends: the quadratic of its side, and its ends' planes.
std::optional<double> heightOf(const glm::dvec3& a, const glm::dvec3& b, double radius, const glm::dvec2& q) {
    const glm::dvec3 axis = glm::normalize(b - a), ray(0, 0, 1), from = glm::dvec3(q, 0) - a;
    const double length = glm::distance(a, b);
    std::optional<double> height;
    const auto take = [&](double h) { height = std::max(height.value_or(h), h); };
    const glm::dvec3 m = from - axis * glm::dot(from, axis), n = ray - axis * axis.z;
    const double square = glm::dot(n, n), half = glm::dot(m, n), rest = glm::dot(m, m) - radius * radius;
    const double root = half * half - square * rest;
    if (square > 1e-12 && root > 0) {
        const double h = (-half + std::sqrt(root)) / square, on = glm::dot(from + ray * h, axis);
        if (on >= 0 && on <= length) take(h);
    }
    for (const glm::dvec3& end : {a, b}) {
        if (std::abs(axis.z) < 1e-12) continue;
        const double h = end.z - glm::dot(q - glm::dvec2(end), glm::dvec2(axis)) / axis.z;
        if (glm::distance(glm::dvec3(q, h), end) < radius) take(h);
    }
    return height;
}

class FrontShapePictures : public testing::TestWithParam<std::tuple<double, int>> {};

TEST_P(FrontShapePictures, TellEachPixelsNearestShapeOrAllThatMayBe) {
    const auto [pixels, quarterTurns] = GetParam();
    for (const FrontLanes& lanes : frontLanes()) {
        SCOPED_TRACE(lanes.lanes);
        FrontShapes shapes(lanes);
        std::size_t covered = 0, doubts = 0;
        for (std::uint32_t seed = 1; seed <= 3; ++seed) {  // what is left of one picture must not show in the next
            const Bonds s(seed, pixels, quarterTurns);
            shapes.draw(s.view, s.spheres, s.balls, s.cylinders, s.sticks);
            std::vector<std::uint32_t> words(shapes.words());
            shapes.write(words.data());
            std::map<std::uint32_t, std::set<std::uint32_t>> told;
            std::size_t at = FrontShapes::kHeader;
            for (const std::uint32_t kind : {0u, 1u}) {
                for (std::uint32_t i = 0; i < words[kind]; ++i) {
                    const std::uint32_t number = words[at + words[kind] + i];
                    EXPECT_EQ((number - 1) % (2 * Bonds::kAtoms) >= Bonds::kAtoms, kind == 1);
                    EXPECT_TRUE(told.emplace(words[at + i], std::set{number}).second) << "twice";
                }
                at += 2 * std::size_t{words[kind]};
            }
            covered += told.size();
            doubts += words[2];
            const std::uint32_t* begins = words.data() + at + words[2];
            const std::uint32_t* candidates = begins + words[2] + 1;
            for (std::uint32_t i = 0; i < words[2]; ++i)
                EXPECT_TRUE(
                    told.emplace(words[at + i], std::set(candidates + begins[i], candidates + begins[i + 1])).second);
            const TileView& v = s.view;
            for (std::uint32_t y = 0; y < v.height; ++y)
                for (std::uint32_t x = 0; x < v.width; ++x) {
                    // As upright() turns a pixel back.
                    const glm::dvec2 p = glm::dvec2(x + 0.5, y + 0.5) - glm::dvec2(v.axis);
                    const glm::dvec2 turned[4] = {p, {p.y, -p.x}, -p, {-p.y, p.x}};
                    const glm::dvec2 q = glm::dvec2(turned[quarterTurns].x, -turned[quarterTurns].y) / double{v.pixels};
                    double nearest = -1e9;
                    std::set<std::uint32_t> seen;
                    const auto meet = [&](std::uint32_t number, std::optional<double> height) {
                        if (!height || *height < nearest) return;
                        if (*height > nearest) seen.clear();
                        nearest = *height;
                        seen.insert(number);
                    };
                    for (std::size_t c = 0; c < Bonds::kCopies; ++c) {
                        const glm::vec4* rows = s.balls[c].rows;
                        for (std::uint32_t i = 0; i < Bonds::kAtoms; ++i)
                            meet(s.balls[c].number + i,
                                 heightOf(placeOf(rows, s.spheres[i].center), s.spheres[i].radius, q));
                        for (std::uint32_t i = 10; i < Bonds::kAtoms; ++i)
                            meet(s.sticks[c].number + i,
                                 heightOf(placeOf(rows, s.cylinders[i].a), placeOf(rows, s.cylinders[i].b),
                                          s.cylinders[i].radius, q));
                    }
                    const auto there = told.find(x | y << 16);
                    const std::set<std::uint32_t> names =
                        there == told.end() ? std::set<std::uint32_t>{} : there->second;
                    EXPECT_TRUE(std::includes(names.begin(), names.end(), seen.begin(), seen.end())) << x << ' ' << y;
                }
        }
        EXPECT_GT(covered, 3000u);
        EXPECT_LT(doubts, covered / 4);  // a tenth of the shapes stand where another does, or look at the eye
    }
}

INSTANTIATE_TEST_SUITE_P(Views, FrontShapePictures,
                         testing::Combine(testing::Values(3.0, 9.5, 24.0), testing::Values(0, 1, 2, 3)));

TEST(FrontShapes, DrawWhatPixelCentresOfPlainOrthographicViewsShow) {
    TileView v;
    v.centers = true;
    EXPECT_TRUE(FrontShapes::tells(v));
    const auto without = [&](auto change) {
        TileView other = v;
        change(other);
        return FrontShapes::tells(other);
    };
    EXPECT_FALSE(without([](TileView& o) { o.perspective = true; }));
    EXPECT_FALSE(without([](TileView& o) { o.centers = false; }));
    EXPECT_FALSE(without([](TileView& o) { o.layers = 2; }));
    EXPECT_FALSE(without([](TileView& o) { o.contour = 1; }));
    EXPECT_FALSE(without([](TileView& o) { o.clipNear = 3; }));
}

}  // namespace
}  // namespace nacre::test
