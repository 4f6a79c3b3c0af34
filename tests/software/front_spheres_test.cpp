// Spheres that the host draws, against all of them asked at each pixel, as shaders do it and in double precision.

#include "engine/software/front_spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <random>
#include <set>
#include <tuple>

#include "engine/threads.h"

namespace nacre::test {
namespace {

class Chance {
public:
    explicit Chance(std::uint32_t seed) : engine_(seed) {}
    double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    glm::dvec3 within(double reach) { return {(*this)(-reach, reach), (*this)(-reach, reach), (*this)(-reach, reach)}; }

private:
    std::mt19937 engine_;
};

/// A crowd of spheres at the places of some copies, of which some calls have only a part.
struct Crowd {
    std::vector<Sphere> spheres;
    std::vector<glm::vec4> rows;
    std::vector<TileCall> calls;
    TileView view;

    /// @param radiusPixels  of the largest
    Crowd(std::uint32_t seed, double radiusPixels, int quarterTurns) {
        Chance chance(seed);
        constexpr std::uint32_t kSpheres = 3000, kCopies = 6;
        // Neighbours in the stream are neighbours in space.
        glm::dvec3 middle{};
        for (std::uint32_t i = 0; i < kSpheres; ++i) {
            if (i % 32 == 0) middle = chance.within(20);
            spheres.push_back({glm::vec3(middle + chance.within(3)), static_cast<float>(chance(1.2, 1.9))});
        }
        // Some stand before another by next to nothing, some at its very place.
        for (std::uint32_t i = 100; i < 600; i += 2)
            spheres[i] = {spheres[i + 1].center + glm::vec3(0, 0, i % 4 ? 1e-5f : 0.0f), spheres[i + 1].radius};
        for (std::uint32_t c = 0; c < kCopies; ++c) {
            const glm::dmat3 turn =
                glm::mat3_cast(glm::normalize(glm::dquat(chance(-1, 1), chance(-1, 1), chance(-1, 1), chance(-1, 1))));
            const glm::dvec3 shift = chance.within(30);
            for (int i = 0; i < 3; ++i) rows.emplace_back(turn[0][i], turn[1][i], turn[2][i], shift[i]);
        }
        for (std::uint32_t c = 0; c < kCopies; ++c) {
            const std::uint32_t first = c == 2 ? 700 : 0, count = c == 2 ? 1501 : kSpheres;
            calls.push_back({&rows[std::size_t{3} * c], first, count, kSpheres * c + 1});
        }
        view.width = 77;
        view.height = 113;
        view.centers = true;
        view.quarterTurns = quarterTurns;
        view.pixels = static_cast<float>(radiusPixels / 1.9);
        view.axis = {static_cast<float>(chance(20, 60)), static_cast<float>(chance(20, 90))};
        view.origin = 70;
        view.nearest = -1;
        view.range = 142;
        view.pixel = 1 / view.pixels;
        view.perRange = 1 / view.range;
    }
};

/// Boxes in an order of their own: each run from its end.
SphereBoxes ownBoxes(const std::vector<Sphere>& stream) {
    const std::vector<std::uint32_t> starts{0, 700, 2201, static_cast<std::uint32_t>(stream.size())};
    std::vector<std::uint32_t> numbers;
    for (std::size_t run = 0; run + 1 < starts.size(); ++run)
        for (std::uint32_t i = starts[run + 1]; i > starts[run]; --i) numbers.push_back(i - 1);
    std::vector<Sphere> spheres;
    for (const std::uint32_t number : numbers) spheres.push_back(stream[number]);
    SphereBoxes boxes = makeSphereBoxes(spheres);
    boxes.spheres = spheres;
    boxes.numbers = numbers;
    boxes.starts = starts;
    return boxes;
}

using Numbers = std::vector<std::uint32_t>;

/// The number of the sphere found at each pixel, row by row.
Numbers found(FrontSpheres& front, const Crowd& c, bool own = false) {
    const SphereBoxes boxes = own ? ownBoxes(c.spheres) : makeSphereBoxes(c.spheres);
    front.draw(c.view, c.spheres, boxes, c.calls);
    Numbers numbers(std::size_t{c.view.width} * c.view.height);
    for (std::uint32_t y = 0; y < c.view.height; ++y)
        front.write(0, y, c.view.width, &numbers[std::size_t{y} * c.view.width]);
    return numbers;
}

/// Where the middle of a sphere is seen, pixels, and its Z.
struct Ball {
    glm::dvec2 at;
    double Z, radius;
    std::uint32_t number;
};
std::vector<Ball> collectBalls(const Crowd& c) {
    std::vector<Ball> balls;
    for (const TileCall& call : c.calls)
        for (std::uint32_t i = call.first; i < call.first + call.count; ++i) {
            const glm::dvec4 p(c.spheres[i].center, 1.0);
            const auto along = [&](int row) { return glm::dot(glm::dvec4(call.rows[row]), p); };
            const glm::dvec2 upright(along(0), -along(1));
            const glm::dvec2 turned[] = {upright, {-upright.y, upright.x}, -upright, {upright.y, -upright.x}};
            balls.push_back({glm::dvec2(c.view.axis) + turned[c.view.quarterTurns] * static_cast<double>(c.view.pixels),
                             static_cast<double>(c.view.origin) - along(2), static_cast<double>(c.spheres[i].radius),
                             call.number + i});
        }
    return balls;
}

/// Goes through the pixels whose centres a ball may hold. @param work  gets the pixel's place in the picture, and the
/// square of how deep that lies in the ball, Å
template <typename Work>
void eachPixel(const TileView& v, const Ball& b, double room, const Work& work) {
    const double reach = (b.radius + room) * static_cast<double>(v.pixels);
    const auto from = [&](double at) { return static_cast<std::uint32_t>(std::max(at - reach - 0.5, 0.0)); };
    const auto to = [&](double at, std::uint32_t end) { return std::min(at + reach + 0.5, static_cast<double>(end)); };
    for (std::uint32_t y = from(b.at.y); y < to(b.at.y, v.height); ++y)
        for (std::uint32_t x = from(b.at.x); x < to(b.at.x, v.width); ++x) {
            const glm::dvec2 off = (glm::dvec2(x + 0.5, y + 0.5) - b.at) / static_cast<double>(v.pixels);
            work(std::size_t{y} * v.width + x, b.radius * b.radius - glm::dot(off, off));
        }
}

/// The nearest sphere of each pixel by the arithmetic of shaders/common/hit.glsl.
Numbers nearestAsShaded(const Crowd& c) {
    const TileView& v = c.view;
    std::vector<float> depths(std::size_t{v.width} * v.height, 1.0f);
    Numbers numbers(depths.size(), 0);
    const std::vector<Ball> balls = collectBalls(c);
    auto ball = balls.begin();
    for (const TileCall& call : c.calls)
        for (std::uint32_t i = call.first; i < call.first + call.count; ++i) {
            const Sphere& s = c.spheres[i];
            const auto along = [&](int row) {  // lavapipe and SwiftShader compile fma() as two operations
                const glm::vec4& r = call.rows[row];
                return r.x * s.center.x + (r.y * s.center.y + (r.z * s.center.z + r.w));
            };
            const glm::vec3 center(along(0), along(1), along(2));
            eachPixel(v, *ball++, 0.01, [&](std::size_t pixel, double) {
                const glm::vec2 off = (glm::vec2(pixel % v.width, pixel / v.width) + 0.5f - v.axis) * v.pixel;
                const glm::vec2 upright[] = {off, {off.y, -off.x}, -off, {-off.y, off.x}};
                const glm::vec2 q(upright[v.quarterTurns].x, -upright[v.quarterTurns].y);
                const glm::vec2 w = q - glm::vec2(center);
                const float h = s.radius * s.radius - (w.x * w.x + w.y * w.y);
                if (!(h > 0)) return;
                const float Z = (v.origin - center.z) - std::sqrt(h);
                const float depth = Z * v.perRange - v.nearest * v.perRange;
                if (depth > depths[pixel] || (depth == depths[pixel] && call.number + i < numbers[pixel])) return;
                depths[pixel] = depth;
                numbers[pixel] = call.number + i;
            });
        }
    return numbers;
}

/// Radii, pixels, by each of the processor's numbers of lanes, and whether boxes have an order of their own.
class FrontSpheresTest : public testing::TestWithParam<std::tuple<double, std::size_t, bool>> {};

TEST_P(FrontSpheresTest, FindWhatShadersFind) {
    const auto [radius, lanes, own] = GetParam();
    FrontSpheres front(frontLanes()[lanes]);  // used again and again, as by a renderer
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
        const Crowd c(seed, radius, static_cast<int>(seed % 4));
        const Numbers numbers = found(front, c, own);
        EXPECT_EQ(numbers, nearestAsShaded(c)) << "seed " << seed;
        std::set<std::uint32_t> shown;
        for (std::size_t pixel = 0; pixel < numbers.size(); ++pixel) {
            const auto x = static_cast<std::uint32_t>(pixel % c.view.width),
                       y = static_cast<std::uint32_t>(pixel / c.view.width);
            EXPECT_EQ(front.isSeen(x, y, x + 1, y + 1), numbers[pixel] != 0);
            if (numbers[pixel] != 0) shown.insert(numbers[pixel]);
        }
        EXPECT_GT(shown.size(), 100u);
    }
}

TEST_P(FrontSpheresTest, FindTheNearest) {
    constexpr double kRounding = 3e-5;  // Å, at this size of a scene
    const auto [radius, lanes, own] = GetParam();
    FrontSpheres front(frontLanes()[lanes]);
    std::size_t seen = 0;
    for (std::uint32_t seed = 0; seed < 8; ++seed) {
        const Crowd c(seed, radius, static_cast<int>(seed % 4));
        const Numbers numbers = found(front, c, own);
        const std::vector<Ball> balls = collectBalls(c);
        std::vector<double> least(numbers.size(), std::numeric_limits<double>::infinity());
        for (const Ball& b : balls)
            eachPixel(c.view, b, 0, [&](std::size_t pixel, double h) {
                const double certain = h - 2 * b.radius * kRounding;
                if (certain > 0) least[pixel] = std::min(least[pixel], b.Z - std::sqrt(certain) + kRounding);
            });
        std::vector<bool> right(numbers.size());
        for (std::size_t pixel = 0; pixel < right.size(); ++pixel)
            right[pixel] = numbers[pixel] == 0 && std::isinf(least[pixel]);
        for (const Ball& b : balls)
            eachPixel(c.view, b, kRounding, [&](std::size_t pixel, double h) {
                const double perhaps = h + 2 * b.radius * kRounding;
                if (b.number == numbers[pixel] && perhaps >= 0)
                    right[pixel] = b.Z - std::sqrt(perhaps) - kRounding <= least[pixel];
            });
        EXPECT_EQ(std::ranges::count(right, false), 0) << "seed " << seed;
        seen += numbers.size() - static_cast<std::size_t>(std::ranges::count(numbers, 0u));
    }
    EXPECT_GT(seen, 1000u);
}

INSTANTIATE_TEST_SUITE_P(Radii, FrontSpheresTest,
                         testing::Combine(testing::Values(0.3, 0.8, 2.0, 7.0),
                                          testing::Range(std::size_t{0}, frontLanes().size()), testing::Bool()));

// Parts of runs are drawn as whole runs, once, since what they leave out is beside the picture.
TEST(FrontSpheres, DrawRunsOnceHoweverTheyAreParted) {
    Crowd c(3, 0.8, 1);
    c.calls.erase(c.calls.begin() + 2);
    FrontSpheres front;
    const Numbers expected = found(front, c, true);
    std::vector<TileCall> parts;
    for (const TileCall& call : c.calls)
        for (std::uint32_t first = 0; first < call.count; first += 250)
            parts.push_back({call.rows, first, 250, call.number});
    c.calls = parts;
    EXPECT_EQ(found(front, c, true), expected);
}

TEST(FrontSpheres, DrawNothingOfNothing) {
    Crowd c(1, 0.8, 0);
    FrontSpheres front;
    const auto empty = static_cast<std::ptrdiff_t>(c.view.width) * c.view.height;
    EXPECT_LT(std::ranges::count(found(front, c), 0u), empty);
    c.view.axis = {-4000, -4000};
    EXPECT_EQ(std::ranges::count(found(front, c), 0u), empty);
}

// Spheres that stand in one thread's rows are asked for in another's.
TEST(FrontSpheres, AreTheSameBySeveralThreads) {
    constexpr std::uint32_t kSpheres = 300'000;  // more than are worth one thread
    Crowd c(1, 0.3, 0);
    Chance chance(7);
    c.spheres.clear();
    for (std::uint32_t i = 0; i < kSpheres; ++i) c.spheres.push_back({glm::vec3(chance.within(150)), 1.9f});
    c.calls.resize(1);
    c.calls[0] = {&c.rows[0], 0, kSpheres, 1};
    c.view.axis = {c.view.width / 2.0, c.view.height / 2.0};
    const auto byThreads = [&](unsigned threads) {
        FrontSpheres front;
        setThreadsPerTask(threads);
        const Numbers numbers = found(front, c);
        setThreadsPerTask(0);
        return numbers;
    };
    const Numbers one = byThreads(1);
    EXPECT_LT(std::ranges::count(one, 0u), static_cast<std::ptrdiff_t>(one.size()) - 10);
    EXPECT_EQ(one, byThreads(2));
}

TEST(SphereBoxes, HoldTheirSpheres) {
    const Crowd c(3, 1, 0);
    const SphereBoxes boxes = makeSphereBoxes(c.spheres);
    constexpr std::size_t kOfGroup = std::size_t{SphereBoxes::kSpheres} * SphereBoxes::kBoxes;
    ASSERT_EQ(boxes.groups.size(), (c.spheres.size() + kOfGroup - 1) / kOfGroup);
    ASSERT_EQ(boxes.boxes.size(), boxes.groups.size() * SphereBoxes::kBoxes);
    for (std::size_t i = 0; i < c.spheres.size(); ++i)
        for (const SphereBox& box : {boxes.boxes[i / SphereBoxes::kSpheres], boxes.groups[i / kOfGroup]}) {
            const glm::vec3 off = glm::abs(c.spheres[i].center - box.middle);
            EXPECT_LE(std::max({off.x - box.half.x, off.y - box.half.y, off.z - box.half.z}), 0.0f) << i;
            EXPECT_LE(glm::length(off), box.ball) << i;
            EXPECT_LE(c.spheres[i].radius, box.radius) << i;
        }
    EXPECT_GT(boxes.reach, 19.0f);
    EXPECT_LT(boxes.reach, 24.0f);
    std::vector<Sphere> broken = c.spheres;
    broken[5].center.y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(makeSphereBoxes(broken).reach, std::numeric_limits<float>::infinity());
}

}  // namespace
}  // namespace nacre::test
