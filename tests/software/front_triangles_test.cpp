// The triangle that the host says a pixel begins with, against what shaders find that round each number up or down as
// they like: Vulkan asks of a sum or a product no more than that it is one of the two neighbours of the exact one, of a
// quotient that it is within 2.5 steps.

#include "engine/software/front_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <random>
#include <utility>

#include "engine/scene/build/representation.h"
#include "engine/software/tile_lists.h"

namespace nacre::test {
namespace {

constexpr std::uint32_t kSide = 128;
constexpr double kBallRadius = 24;

class Dice {
public:
    explicit Dice(std::uint32_t seed) : engine_(seed) {}
    double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    double spread(double low, double high) { return std::exp((*this)(std::log(low), std::log(high))); }

    /// One of the two numbers that a shader may have for an exact one.
    float rounded(double exact) {
        const float nearest = static_cast<float>(exact);
        if (static_cast<double>(nearest) == exact) return nearest;
        const float other = std::nextafter(nearest, static_cast<double>(nearest) < exact ? INFINITY : -INFINITY);
        if (mood_ == 0) return engine_() % 2 == 0 ? nearest : other;
        return mood_ > 0 ? std::max(nearest, other) : std::min(nearest, other);
    }
    /// From here on numbers are rounded at random, or all of them up, or down.
    void changeMood() { mood_ = static_cast<int>(engine_() % 3) - 1; }

    float quotient(float a, float b) {
        float q = rounded(static_cast<double>(a) / static_cast<double>(b));
        for (auto i = engine_() % 3; i > 1; --i) q = std::nextafter(q, engine_() % 2 ? INFINITY : -INFINITY);
        return q;
    }
    float sum(float a, float b) { return rounded(static_cast<double>(a) + static_cast<double>(b)); }
    float product(float a, float b) { return rounded(static_cast<double>(a) * static_cast<double>(b)); }

private:
    std::mt19937 engine_;
    int mood_ = 0;
};

/// A view of triangles of which many have an edge through a pixel's centre, as near as vertices are stored, with others
/// beside that edge and just before or behind them.
struct AimedScene {
    Representation mesh;
    glm::vec4 rows[3];
    TileView view;
    std::vector<glm::uvec2> aims;  // pixels

    /// @param flat  triangles as good as parallel to the picture, so near one another in depth as numbers tell apart
    AimedScene(Dice& dice, bool perspective, bool flat = false) {
        view.width = view.height = kSide;
        view.axis = glm::vec2(kSide) * 0.5f;
        view.centers = true;
        view.perspective = perspective;
        view.pixels = static_cast<float>(dice.spread(0.5, 30));
        view.origin = static_cast<float>(kBallRadius * (perspective ? 3 : 1));
        view.nearest = view.origin - static_cast<float>(kBallRadius) - 1;
        view.range = 2 * static_cast<float>(kBallRadius + 1);
        const glm::dmat3 turn =
            glm::mat3_cast(glm::normalize(flat ? glm::dquat(1, dice.spread(1e-9, 1e-6), dice.spread(1e-9, 1e-6), 0)
                                               : glm::dquat(dice(-1, 1), dice(-1, 1), dice(-1, 1), dice(-1, 1))));
        for (int i = 0; i < 3; ++i) rows[i] = glm::vec4(turn[0][i], turn[1][i], turn[2][i], dice(-0.01, 0.01));
        Mesh made;
        const auto add = [&](glm::dvec3 p) {  // view space
            for (int i = 0; i < 3; ++i) p[i] -= static_cast<double>(rows[i].w);
            made.positions.emplace_back(p * turn);
            made.normals.emplace_back(0, 0, 1);
            made.atoms.push_back(0);
            return static_cast<std::uint32_t>(made.positions.size() - 1);
        };
        for (int i = 0; i < 8; ++i) flat ? aimFlat(dice, made, add) : aim(dice, made, add);
        appendMesh(
            made, glm::dvec3(0), [](std::uint32_t) { return SphereLook{}; }, mesh);
    }

private:
    /// A pixel more. @returns what its centre looks through
    glm::dvec2 aimed(Dice& dice) {
        const double reach = 0.4 * kBallRadius * static_cast<double>(view.pixels);
        const auto pixel = [&] {
            return static_cast<std::uint32_t>(std::clamp(kSide / 2 + dice(-reach, reach), 1.0, kSide - 2.0));
        };
        aims.emplace_back(pixel(), pixel());
        const glm::dvec2 off = glm::dvec2(aims.back()) + 0.5 - glm::dvec2(view.axis);
        return glm::dvec2(off.x, -off.y) / static_cast<double>(view.pixels);
    }

    template <typename Add>
    void aimFlat(Dice& dice, Mesh& made, const Add& add) {
        const glm::dvec2 q = aimed(dice);
        const double height = dice(-8, 8), E = static_cast<double>(view.origin);
        const glm::dvec2 middle = view.perspective ? q * ((E - height) / E) : q;
        for (int i = 0; i < 4; ++i) {
            const double angle = dice(0, 6.2832);
            std::uint32_t corners[3];
            for (int k = 0; k < 3; ++k) {
                const double turned = angle + k * 2.0944 + dice(-0.4, 0.4), away = dice.spread(1, 6);
                corners[k] = add(glm::dvec3(middle + away * glm::dvec2(std::cos(turned), std::sin(turned)), height));
            }
            made.triangles.emplace_back(corners[0], corners[1], corners[2]);
        }
    }

    template <typename Add>
    void aim(Dice& dice, Mesh& made, const Add& add) {
        const glm::dvec2 q = aimed(dice);
        const double angle = dice(0, 6.2832), z = dice(-8, 8);
        const glm::dvec2 way(std::cos(angle), std::sin(angle)), beside(-way.y, way.x);
        // Where a ray meets a depth.
        const auto at = [&](const glm::dvec2& p, double height) {
            const double E = static_cast<double>(view.origin);
            return glm::dvec3(view.perspective ? p * ((E - height) / E) : p, height);
        };
        const auto depth = [&] { return z + dice(-2, 2); };
        const glm::dvec3 a = at(q + way * dice.spread(0.02, 8), depth()),
                         b = at(q - way * dice.spread(0.02, 8), depth());
        const glm::dvec3 c = at(q + beside * dice.spread(0.02, 8) + way * dice(-1, 1), depth());
        const glm::dvec3 d = at(q - beside * dice.spread(0.02, 8) + way * dice(-1, 1), depth());
        const std::uint32_t first = add(a), second = add(b), third = add(c), fourth = add(d);
        made.triangles.emplace_back(first, second, third);
        made.triangles.emplace_back(second, first, fourth);
        const glm::dvec3 nearer(0, 0, dice.spread(1e-5, 1e-2) * (dice(0, 1) < 0.5 ? -1 : 1));
        const std::uint32_t e = add(a + nearer), f = add(b + nearer), g = add(c + nearer);
        made.triangles.emplace_back(e, f, g);
    }
};

/// As shaders/common/hit.glsl and view.glsl have it.
struct ShaderHit {
    bool inside = false;
    float depth = 0;

    ShaderHit(Dice& r, const AimedScene& s, const Triangle& t, glm::uvec2 pixel) {
        const float perPixel = 1.0f / s.view.pixels;
        const float qx = r.product(r.sum(static_cast<float>(pixel.x) + 0.5f, -s.view.axis.x), perPixel);
        const float qy = -r.product(r.sum(static_cast<float>(pixel.y) + 0.5f, -s.view.axis.y), perPixel);
        float x[3], y[3], z[3];
        const std::uint32_t vertices[] = {t.a, t.b, t.c};
        for (int i = 0; i < 3; ++i) {
            const glm::vec3 p = decodePosition(s.mesh.meshVertices[vertices[i]], t.step());
            const auto along = [&](const glm::vec4& row) {
                float sum = row.w;
                for (const int k : {2, 1, 0})
                    sum = r.rounded(static_cast<double>(row[k]) * static_cast<double>(p[k]) + static_cast<double>(sum));
                return sum;
            };
            x[i] = along(s.rows[0]);
            y[i] = along(s.rows[1]);
            z[i] = r.sum(s.view.origin, -along(s.rows[2]));
            if (!s.view.perspective) continue;
            z[i] = r.quotient(1, z[i]);
            const float scale = r.product(s.view.origin, z[i]);
            x[i] = r.product(x[i], scale);
            y[i] = r.product(y[i], scale);
        }
        for (int i = 0; i < 3; ++i) x[i] = r.sum(x[i], -qx), y[i] = r.sum(y[i], -qy);
        const auto side = [&](int from, int to) {
            return r.sum(r.product(x[from], y[to]), -r.product(y[from], x[to]));
        };
        const float of[] = {side(1, 2), side(2, 0), side(0, 1)};
        const float sum = r.sum(r.sum(of[0], of[1]), of[2]);
        inside = sum != 0 && (std::min({of[0], of[1], of[2]}) >= 0 || std::max({of[0], of[1], of[2]}) <= 0);
        if (s.view.frontsOnly) inside = inside && sum > 0;
        if (!inside) return;
        const float unit = r.quotient(1, sum);
        float mean = 0;
        for (int i = 0; i < 3; ++i) mean = r.sum(mean, r.product(r.product(of[i], unit), z[i]));
        const float Z = s.view.perspective ? r.quotient(1, mean) : mean, perRange = 1 / s.view.range;
        depth = r.rounded(static_cast<double>(Z) * static_cast<double>(perRange) -
                          static_cast<double>(r.product(s.view.nearest, perRange)));
    }
};

class FrontTrianglesTest : public testing::TestWithParam<bool> {};

struct Judged {
    std::size_t certain = 0, wrong = 0, listed = 0;
};
Judged judged(Dice& dice, bool perspective, bool flat, bool frontsOnly = false) {
    std::size_t certain = 0, wrong = 0, inLists = 0;
    for (int scene = 0; scene < 600; ++scene) {
        AimedScene s(dice, perspective, flat);
        s.view.frontsOnly = frontsOnly;
        if (scene % 2 == 1)  // they are wound clockwise
            for (Triangle& t : s.mesh.triangles) std::swap(t.b, t.c);
        const TileCall call{s.rows, 0, static_cast<std::uint32_t>(s.mesh.triangles.size()), 1};
        const std::span<const TriangleLanes> ways = triangleLanes();  // in turn
        TileLists lists(ways[static_cast<std::size_t>(scene / 2) % ways.size()]);
        lists.build(s.view, {{}, {}, {}, {}, {}, s.mesh.triangles, s.mesh.meshVertices, {&call, 1}});
        std::vector<std::uint32_t> words(lists.words());
        lists.write(words.data());
        inLists += lists.kept();
        const auto listed = words.end() - static_cast<std::ptrdiff_t>(lists.entries());
        for (const glm::uvec2 aim : s.aims) {
            std::uint32_t seed = 0;
            lists.writeSeeds(aim.x, aim.y, 1, &seed);
            const std::size_t bin = aim.y / TileLists::kBinPixels * lists.across() + aim.x / TileLists::kBinPixels;
            const auto first = listed + lists.offsets()[bin], end = listed + lists.offsets()[bin + 1];
            certain += seed != 0;
            for (int round = 0; round < 4; ++round) {
                dice.changeMood();
                float depth = std::numeric_limits<float>::infinity();
                if (seed != 0) {
                    const ShaderHit hit(dice, s, s.mesh.triangles[seed - 1], aim);
                    wrong += !hit.inside;
                    depth = hit.depth;
                }
                for (std::uint32_t number = 1; number <= s.mesh.triangles.size(); ++number) {
                    if (number == seed || std::find(first, end, number) != end) continue;
                    const ShaderHit hit(dice, s, s.mesh.triangles[number - 1], aim);
                    wrong += hit.inside && hit.depth <= depth;
                }
            }
        }
    }
    return {certain, wrong, inLists};
}

TEST_P(FrontTrianglesTest, WhatIsCertainIsWhatAnyShaderFinds) {
    Dice dice(GetParam() ? 2 : 1);
    const Judged judgement = judged(dice, GetParam(), false);
    EXPECT_EQ(judgement.wrong, 0u);
    EXPECT_GT(judgement.certain, 300u);
}

TEST_P(FrontTrianglesTest, BacksAreNeitherCertainNorListed) {
    Dice dice(GetParam() ? 7 : 6), again(GetParam() ? 7 : 6);
    const Judged fronts = judged(dice, GetParam(), false, true), all = judged(again, GetParam(), false);
    EXPECT_EQ(fronts.wrong, 0u);
    EXPECT_GT(fronts.certain, 100u);
    EXPECT_LT(fronts.certain, 3 * all.certain / 4);
    EXPECT_LT(fronts.listed, 3 * all.listed / 4);
}

/// There nothing but what rounding does to Z tells which is nearer.
TEST_P(FrontTrianglesTest, NothingIsCertainOfDepthsThatRoundingMayExchange) {
    Dice dice(GetParam() ? 4 : 3);
    const Judged judgement = judged(dice, GetParam(), true);
    EXPECT_EQ(judgement.wrong, 0u);
    EXPECT_GT(judgement.certain, 300u);
}

/// The sums that TriangleLens and TriangleShapes state. Roundings never all do their worst at once, so that the shaders
/// of the other test are content with an eighth.
TEST(TriangleShapes, LeaveWhatAllRoundingsAddUpTo) {
    constexpr double u = 0x1p-24, kPicture = 1000, kRange = 50;
    for (const double ofPicture : {0.01, 0.3, 4.0}) {
        TileView view;
        view.width = view.height = static_cast<std::uint32_t>(kPicture);
        view.axis = glm::vec2(kPicture / 2);
        view.range = view.origin = static_cast<float>(kRange);
        view.pixels = static_cast<float>(ofPicture * kPicture / kRange);
        TriangleLens lens(view);
        const double inPixels = ofPicture * kPicture, corner = (2.5 + 2) * u * inPixels + u * kPicture;
        EXPECT_GE(static_cast<double>(lens.error), corner) << ofPicture;
        // One as far from the axis as they are. An edge function is off by what both its corners are.
        const auto far = static_cast<float>(kPicture / 2 + inPixels / 2), side = static_cast<float>(inPixels / 4);
        const glm::vec4 corners[] = {{far, far, 40, 0}, {far - side, far, 40, 0}, {far, far - side, 40, 0}};
        const Triangle triangle{0, 1, 2, 1};
        const double off = corner + (4 + 8) * u * inPixels / 2;
        for (const TriangleLanes& lanes : triangleLanes()) {
            TriangleShapes shapes;
            lens.width = lens.height = static_cast<std::uint32_t>(far) + 1;                // so that it is in view
            std::vector<float> behind(lens.width + TriangleBand::kRoom), before = behind;  // all rows are one
            std::vector<std::uint32_t> index(behind.size()), ambiguous;
            std::vector<std::uint8_t> rows(lens.height);
            const TriangleBand band{&lens,
                                    0,
                                    static_cast<std::int32_t>(lens.height),
                                    0,
                                    behind.data(),
                                    before.data(),
                                    index.data(),
                                    rows.data(),
                                    &ambiguous};
            lanes.draw(band, shapes, &triangle, 1, corners, 0);
            // What is added to an edge's plane is half of where inside begins.
            EXPECT_GE(
                static_cast<double>(std::min({shapes.inside[0][0], shapes.inside[1][0], shapes.inside[2][0]})) / 2,
                2 * off * static_cast<double>(side))
                << ofPicture << ", " << lanes.lanes << " lanes";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Projections, FrontTrianglesTest, testing::Bool(),
                         [](const auto& tested) { return tested.param ? "Perspective" : "Parallel"; });

}  // namespace
}  // namespace nacre::test
