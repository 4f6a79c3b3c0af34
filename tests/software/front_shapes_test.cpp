// Spheres and cylinders that the host draws, against all of them asked at each pixel, in double precision.

#include "engine/software/front_shapes.h"

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
        view.width = 67;
        view.height = 53;
        view.centers = true;
        view.quarterTurns = quarterTurns;
        view.pixels = static_cast<float>(pixels);
        view.axis = {30.5f, 25.25f};
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

/// What is nearest at each pixel: several numbers where shapes are equally near.
std::vector<std::set<std::uint32_t>> nearestOf(const Bonds& s) {
    const TileView& v = s.view;
    std::vector<std::set<std::uint32_t>> seen(std::size_t{v.width} * v.height);
    std::vector<double> nearest(seen.size(), -1e9);
    /// @param middle, reach  of a circle that holds a shape's picture
    const auto draw = [&](std::uint32_t number, const glm::dvec2& middle, double reach, const auto& heightAt) {
        for (std::uint32_t y = 0; y < v.height; ++y)
            for (std::uint32_t x = 0; x < v.width; ++x) {
                // As upright() turns a pixel back.
                const glm::dvec2 p = glm::dvec2(x + 0.5, y + 0.5) - glm::dvec2(v.axis);
                const glm::dvec2 turned[4] = {p, {p.y, -p.x}, -p, {-p.y, p.x}};
                const glm::dvec2 at = turned[v.quarterTurns];
                const glm::dvec2 q = glm::dvec2(at.x, -at.y) / double{v.pixels}, away = q - middle;
                if (glm::dot(away, away) > reach * reach) continue;
                const std::size_t pixel = std::size_t{y} * v.width + x;
                const std::optional<double> height = heightAt(q);
                if (!height || *height < nearest[pixel]) continue;
                if (*height > nearest[pixel]) seen[pixel].clear();
                nearest[pixel] = *height;
                seen[pixel].insert(number);
            }
    };
    for (std::size_t c = 0; c < Bonds::kCopies; ++c) {
        const glm::vec4* rows = s.balls[c].rows;
        for (std::uint32_t i = 0; i < Bonds::kAtoms; ++i) {
            const glm::dvec3 center = placeOf(rows, s.spheres[i].center);
            const double radius = s.spheres[i].radius;
            draw(s.balls[c].number + i, glm::dvec2(center), radius,
                 [&](const glm::dvec2& q) { return heightOf(center, radius, q); });
        }
        for (std::uint32_t i = 10; i < Bonds::kAtoms; ++i) {
            const glm::dvec3 a = placeOf(rows, s.cylinders[i].a), b = placeOf(rows, s.cylinders[i].b);
            const double radius = s.cylinders[i].radius;
            draw(s.sticks[c].number + i, glm::dvec2(a + b) * 0.5, glm::distance(a, b) + radius,
                 [&](const glm::dvec2& q) { return heightOf(a, b, radius, q); });
        }
    }
    return seen;
}

/// What was told of a picture's pixels.
struct ToldShapes {
    std::map<std::uint32_t, std::set<std::uint32_t>> names;  // of x | y << 16
    std::size_t doubts = 0;

    explicit ToldShapes(const FrontShapes& shapes) {
        std::vector<std::uint32_t> words(shapes.words());
        shapes.write(words.data());
        std::size_t at = FrontShapes::kHeader;
        for (const std::uint32_t kind : {0u, 1u}) {
            for (std::uint32_t i = 0; i < words[kind]; ++i) {
                const std::uint32_t number = words[at + 2 * i + 1];
                EXPECT_EQ((number - 1) % (2 * Bonds::kAtoms) >= Bonds::kAtoms, kind == 1);
                tell(words[at + 2 * i], {number});
            }
            at += 2 * std::size_t{words[kind]};
        }
        doubts = words[2];
        EXPECT_EQ(words.size() % 2, 0u);
        const std::uint32_t* pairs = words.data() + at;
        const std::uint32_t* candidates = pairs + 2 * (doubts + 1);
        for (std::size_t i = 0; i < doubts; ++i, pairs += 2)
            tell(pairs[0], std::set(candidates + pairs[1], candidates + pairs[3]));
    }

private:
    void tell(std::uint32_t pixel, const std::set<std::uint32_t>& of) {
        EXPECT_TRUE(names.emplace(pixel, of).second) << "told twice";
    }
};

class FrontShapePictures : public testing::TestWithParam<std::tuple<double, int>> {};

TEST_P(FrontShapePictures, TellEachPixelsNearestShapeOrAllThatMayBe) {
    const auto [pixels, quarterTurns] = GetParam();
    const Bonds scenes[] = {{1, pixels, quarterTurns}, {2, pixels, quarterTurns}};
    const std::vector<std::set<std::uint32_t>> nearest[] = {nearestOf(scenes[0]), nearestOf(scenes[1])};
    for (const FrontLanes& lanes : frontLanes()) {
        SCOPED_TRACE(lanes.lanes);
        FrontShapes shapes(lanes);
        for (int k = 0; k < 2; ++k) {  // what is left of one picture must not show in the next
            const Bonds& s = scenes[k];
            shapes.draw(s.view, s.spheres, s.balls, s.cylinders, s.sticks);
            const ToldShapes told(shapes);
            for (std::uint32_t y = 0; y < s.view.height; ++y)
                for (std::uint32_t x = 0; x < s.view.width; ++x) {
                    const auto there = told.names.find(x | y << 16);
                    const std::set<std::uint32_t> names =
                        there == told.names.end() ? std::set<std::uint32_t>{} : there->second;
                    const std::set<std::uint32_t>& seen = nearest[k][std::size_t{y} * s.view.width + x];
                    ASSERT_TRUE(std::includes(names.begin(), names.end(), seen.begin(), seen.end())) << x << ' ' << y;
                }
            EXPECT_GT(told.names.size(), 500u);
            // A tenth of the shapes stand where another does, or look at the eye.
            EXPECT_LT(told.doubts, told.names.size() / 3);
        }
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
