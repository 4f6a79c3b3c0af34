// The light of the surroundings that an atlas stores, against formulas and rays, and what it depends on.

#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <thread>

#include "engine/molecule/selection/selection.h"
#include "engine/occlusion/bounced_light.h"
#include "engine/scene/build/translucency.h"
#include "tests/reference/ambient_occlusion.h"
#include "tests/reference/random.h"
#include "tests/renderer/meshes.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

double linear(std::uint32_t byte) {
    const double c = (byte & 0xff) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
glm::dvec3 toLinear(std::uint32_t color) { return {linear(color), linear(color >> 8), linear(color >> 16)}; }

void addBall(Representation& r, const glm::vec3& center, float radius, std::uint32_t color) {
    r.spheres.push_back({center, radius});
    r.sphereLooks.push_back({color, static_cast<std::uint32_t>(r.spheres.size())});
}

OcclusionLayout layoutWith(const Representation& r, std::uint32_t edge) {
    for (const OcclusionLayout& l :
         occlusionLayouts(r.spheres.size(), r.cylinders.size(), r.meshVertices.size(), 4096, 4096))
        if (l.sphereEdge == edge) return l;
    throw std::logic_error("no such layout");
}
/// All texels are equally open.
std::vector<std::uint8_t> bounced(const Representation& r, const OcclusionLayout& l, std::uint8_t open) {
    return bouncedLight(r, l, std::vector<std::uint8_t>(std::size_t{l.width} * l.height, open));
}
glm::dvec3 surroundings(const std::vector<std::uint8_t>& texels, std::size_t texel) {
    glm::dvec3 light;
    for (int c = 0; c < 3; ++c) light[c] = std::pow(texels[4 * texel + 1 + static_cast<std::size_t>(c)] / 255.0, 2);
    return light;
}

/// Where the texel sees the sky.
glm::dvec3 leanOf(const std::vector<std::uint8_t>& texels, std::size_t texel) {
    const std::uint8_t* lower = &texels[texels.size() / 2 + 4 * texel];
    return (glm::dvec3(lower[0], lower[1], lower[2]) - 128.0) / 256.0;
}

/// Each sees the other alone, so light goes to and fro: a = B (o + (1 - o) b) and b = A (o + (1 - o) a).
TEST(BouncedAtlas, OfTwoBallsSolvesTheirEquations) {
    constexpr std::uint32_t kA = 0xff4080e0u, kB = 0xffc0e060u;
    constexpr double kOpen = 51 / 255.0;
    Representation r;
    addBall(r, {0, 0, 0}, 2, kA);
    addBall(r, {3, 0, 0}, 1.5f, kB);
    r.radius = 5;
    const OcclusionLayout l = layoutWith(r, 6);
    const std::vector<std::uint8_t> texels = bounced(r, l, 51);
    const glm::dvec3 a = toLinear(kA), b = toLinear(kB), one(1), keeps(1 - kOpen);
    const glm::dvec3 ofA = b * kOpen * (one + keeps * a) / (one - keeps * keeps * a * b);
    const glm::dvec3 ofB = a * kOpen * (one + keeps * b) / (one - keeps * keeps * a * b);
    for (std::size_t ball = 0; ball < 2; ++ball)
        for (std::size_t y = 0; y < 6; ++y)
            for (std::size_t x = 0; x < 6; ++x) {
                const std::size_t texel = y * l.width + 6 * ball + x;
                EXPECT_EQ(texels[4 * texel], 51);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(surroundings(texels, texel)[c], (ball == 0 ? ofA : ofB)[c], 0.01) << ball << " " << c;
            }
}

TEST(BouncedAtlas, OfALoneBallIsDark) {
    Representation r;
    addBall(r, {0, 0, 0}, 2, 0xffffffffu);
    r.radius = 2;
    const OcclusionLayout l = layoutWith(r, 6);
    const std::vector<std::uint8_t> texels = bounced(r, l, 255);
    for (std::size_t i = 0; i < 36; ++i) {
        EXPECT_EQ(surroundings(texels, i / 6 * l.width + i % 6), glm::dvec3(0));
        EXPECT_EQ(leanOf(texels, i / 6 * l.width + i % 6), glm::dvec3(0));
    }
}

/// With every place open, the surroundings are the mean colour of what random rays meet, and the sky is where they meet
/// nothing.
TEST(BouncedAtlas, IsWhatRandomRaysMeet) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> at(-6, 6), unit(0, 1);
    Representation r;
    for (int i = 0; i < 40; ++i)
        addBall(r, {at(random), at(random), at(random)}, 1 + unit(random),
                0xff000000u | static_cast<std::uint32_t>(random() % 0xffffffu));
    r.radius = 14;
    const OcclusionLayout l = layoutWith(r, 6);
    const std::vector<std::uint8_t> texels = bounced(r, l, 255);
    const reference::OcclusionScene truth(r);
    reference::Random rays(1);
    double squares = 0, leanSquares = 0, leanErrors = 0;
    int count = 0;
    for (std::size_t ball = 0; ball < r.spheres.size(); ++ball)
        for (const glm::ivec2 place : {glm::ivec2(0, 1), {2, 1}, {3, 4}, {2, 3}, {5, 2}}) {
            glm::dvec3 n((place.x / 5.0) * 2 - 1, (place.y / 5.0) * 2 - 1, 0);  // octahedral map
            n.z = 1 - std::abs(n.x) - std::abs(n.y);
            if (n.z < 0) {
                const glm::dvec2 p(n);
                n.x = (1 - std::abs(p.y)) * (p.x >= 0 ? 1 : -1), n.y = (1 - std::abs(p.x)) * (p.y >= 0 ? 1 : -1);
            }
            n = glm::normalize(n);
            const glm::dvec3 point =
                glm::dvec3(r.spheres[ball].center) + n * static_cast<double>(r.spheres[ball].radius);
            bool buried = false;
            for (std::size_t k = 0; k < r.spheres.size(); ++k)
                buried |= k != ball && glm::distance(point, glm::dvec3(r.spheres[k].center)) < r.spheres[k].radius;
            if (buried) continue;
            glm::dvec3 sum(0), open(0);
            int met = 0;
            for (int i = 0; i < 2000; ++i) {
                const double square = rays.unit(), turn = rays.unit();
                const glm::dvec3 direction = reference::cosineDirection(n, square, turn);
                const auto hit = truth.nearest(point + 1e-3 * n, direction);
                if (!hit) open += direction / 2000.0;
                if (hit) sum += toLinear(r.sphereLooks[hit->primitive].color), ++met;
            }
            const std::size_t texel = (ball / l.spherePatches() * 6 + static_cast<std::size_t>(place.y)) * l.width +
                                      ball % l.spherePatches() * 6 + static_cast<std::size_t>(place.x);
            const glm::dvec3 lean = 1.5 * open - (1 - met / 2000.0) * n, leanError = leanOf(texels, texel) - lean;
            leanSquares += glm::dot(lean, lean), leanErrors += glm::dot(leanError, leanError);
            if (met < 400) continue;  // few rays say little
            for (int c = 0; c < 3; ++c) {
                const double difference = surroundings(texels, texel)[c] - sum[c] / met;
                EXPECT_LT(std::abs(difference), 0.4);
                squares += difference * difference;
                ++count;
            }
        }
    EXPECT_GT(count, 150);
    EXPECT_LT(std::sqrt(squares / count), 0.05);
    EXPECT_LT(leanErrors, 0.15 * leanSquares);
}

/// Sticks and meshes take part: a stick and a mesh beside a red ball see red, and it sees them.
TEST(BouncedAtlas, HoldsSticksAndMeshes) {
    Representation r;
    addBall(r, {0, 0, 0}, 2, 0xff0000ffu);
    r.cylinders = {{{4, 0, -2}, 0.4f, {4, 0, 2}}};
    r.cylinderLooks = {{0xff00ff00u, 0xff00ff00u, 2, 2}};
    appendMesh(
        icosphere({-4, 0, 0}, 1, 1, 0), glm::dvec3(0),
        [](std::uint32_t) {
            return SphereLook{0xffff0000u, 3};
        },
        r);
    r.radius = 8;
    const OcclusionLayout l = layoutWith(r, 6);
    const std::vector<std::uint8_t> texels = bounced(r, l, 255);
    double greenest = 0, bluest = 0;
    for (std::size_t i = 0; i < 36; ++i) {
        greenest = std::max(greenest, surroundings(texels, i / 6 * l.width + i % 6).y);
        bluest = std::max(bluest, surroundings(texels, i / 6 * l.width + i % 6).z);
    }
    EXPECT_GT(greenest, 0.9);
    EXPECT_GT(bluest, 0.9);
    const std::size_t stick = std::size_t{l.sphereRows} * l.width;
    EXPECT_NEAR(surroundings(texels, stick + l.around / 2).x, 1, 0.1);
    const std::size_t vertices = std::size_t{l.sphereRows + l.cylinderRows} * l.width;
    double reddest = 0;
    for (std::size_t v = 0; v < r.meshVertices.size(); ++v)
        reddest = std::max(reddest, surroundings(texels, vertices + 2 * v).x);
    EXPECT_GT(reddest, 0.9);
}

Representation chains(Style style) {
    const Molecule m = molecule("sample:dna");
    return represent(m, drawnAtoms(m), {style, ColorScheme::chain});
}
RenderSettings bounceSettings(const Representation& r) {
    RenderSettings s = settings(r, 160, Projection::orthographic);
    s.fine = true;
    s.occlusion.directions = 16;
    s.occlusion.bounce = true;
    return s;
}

class BouncedStyles : public testing::TestWithParam<Style> {};

TEST_P(BouncedStyles, AreTheSameOnEveryPathAndAddLight) {
    const Representation r = chains(GetParam());
    RenderSettings s = bounceSettings(r);
    PathRenderers renderers;
    const std::vector<float> on = sameOnEveryPath(renderers, r, s).rgba;
    s.occlusion.bounce = false;
    EXPECT_NE(renderers[Visibility::tiles]->render(s).rgba, on);
}
INSTANTIATE_TEST_SUITE_P(Dna, BouncedStyles, testing::Values(Style::spacefill, Style::ballAndStick, Style::cartoon));

TEST(BouncedAtlas, ChangesNothingOnceItIsOff) {
    const Representation r = chains(Style::spacefill);
    RenderSettings s = bounceSettings(r);
    ValidatedRenderer renderer(Visibility::automatic, r);
    s.occlusion.bounce = false;
    const std::vector<float> before = renderer->render(s).rgba;
    s.occlusion.bounce = true;
    const LayerPicture on = renderer->layers(s);
    EXPECT_NE(renderer->render(s).rgba, before);
    s.occlusion.bounce = false;
    EXPECT_EQ(renderer->render(s).rgba, before);
    s.occlusion.directions *= 2;
    const LayerPicture off = renderer->layers(s);
    for (std::size_t i = 0; i < on.occlusion.size(); ++i) ASSERT_NEAR(off.occlusion[i], on.occlusion[i], 1e-5) << i;
}

TEST(BouncedAtlas, FollowsNewColours) {
    const Representation r = chains(Style::spacefill);
    Representation other = r;
    for (SphereLook& look : other.sphereLooks)
        look.color = look.color == r.sphereLooks[0].color ? 0xff20e020u : 0xffe02020u;
    const RenderSettings s = bounceSettings(r);
    ValidatedRenderer renderer(Visibility::automatic, r);
    renderer->render(s);
    ASSERT_TRUE(renderer->setScene(other)) << "colours alone";
    const std::vector<float> recolored = renderer->render(s).rgba;
    renderer->setScene({});
    renderer->setScene(other);
    EXPECT_EQ(renderer->render(s).rgba, recolored);
}

TEST(BouncedAtlas, ComesBesideFrames) {
    const Representation r = chains(Style::spacefill);
    const RenderSettings s = bounceSettings(r);
    ValidatedRenderer renderer(Visibility::automatic, r);
    const std::vector<float> waited = renderer->render(s).rgba;
    renderer->setScene({});
    renderer->setScene(r);
    double share = 0;
    for (int i = 0; share < 1 && i < 60'000; ++i) {
        share = renderer->advanceOcclusion(s, OcclusionPace{});
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(share, 1);
    EXPECT_GT(renderer->stats().bounceMilliseconds, 0);
    EXPECT_EQ(renderer->render(s).rgba, waited);
}

/// Its runs of translucent triangles go on into the coarser levels of the ribbon.
TEST(BouncedAtlas, OfATranslucentCartoonIsDark) {
    const Molecule dna = molecule("sample:dna");
    RepresentationOptions look{.style = Style::cartoon};
    const auto sumLight = [&](std::optional<double> opacity) {
        Rule rule;
        rule.selection = parseSelection("all");
        rule.style = Style::cartoon;
        rule.opacity = opacity;
        look.rules = {rule};
        const Representation r = represent(dna, drawnAtoms(dna), look);
        EXPECT_FALSE(r.coarseTriangles.empty());
        EXPECT_EQ(translucentParts(r).triangles.empty(), opacity == 1.0);
        const OcclusionLayout l = occlusionLayouts(0, 0, r.meshVertices.size(), 4096, 4096).front();
        const std::vector<std::uint8_t> texels = bounced(r, l, 128);
        double sum = 0;
        for (std::size_t i = 0; i < texels.size() / kBytesPerBounced; ++i) sum += surroundings(texels, i).y;
        return sum;
    };
    EXPECT_EQ(sumLight(0.25), 0);
    EXPECT_GT(sumLight(1.0), 0);
}

TEST(BouncedAtlas, KeepsWithinTheMemory) {
    const Representation r = chains(Style::spacefill);
    ValidatedRenderer renderer(Visibility::automatic, r);
    RenderSettings s = bounceSettings(r);
    for (const std::uint64_t bytes : {std::uint64_t{4} << 20, std::uint64_t{1} << 20, std::uint64_t{300} << 10}) {
        s.occlusion.bytes = bytes;
        renderer->render(s);
        EXPECT_LE(renderer->stats().occlusion.bytes, bytes);
        EXPECT_GT(renderer->stats().bounceMilliseconds, 0);
    }
}

}  // namespace
}  // namespace nacre::test
