// Density maps as volumes: one picture on every path, that of a ray marcher over the map's own formula.

#include "engine/scene/build/volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "engine/frame/picture.h"
#include "engine/scene/color/colors.h"
#include "engine/volume/read_map.h"
#include "tests/reference/ray_caster.h"
#include "tests/renderer/meshes.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

constexpr int kNodes = 49;
constexpr double kSide = 12, kSpread = 2.5;  // Å
const glm::dvec3 kMiddle(0.4, -0.3, 0.5);

double blobAt(const glm::dvec3& p) {
    const glm::dvec3 off = (p - kMiddle) / glm::dvec3(1, 1.2, 0.8);
    return std::exp(-glm::dot(off, off) / (2 * kSpread * kSpread));
}

/// The blob in a cube about the origin.
const DensityMap& blob() {
    static const DensityMap map = [] {
        const double step = kSide / (kNodes - 1);
        std::vector<float> values;
        for (int z = 0; z < kNodes; ++z)
            for (int y = 0; y < kNodes; ++y)
                for (int x = 0; x < kNodes; ++x)
                    values.push_back(static_cast<float>(blobAt(glm::dvec3(x, y, z) * step - kSide / 2)));
        UnitCell cell{.lengths = glm::dvec3(kNodes * step)};
        return mapOfValues("blob", glm::ivec3(kNodes), cell, glm::dvec3(-kSide / 2), false, values);
    }();
    return map;
}

const std::vector<VolumeLevel> kLevels{
    {0.9, {1, 1, 0.9f}, 0.5}, {0.2, {0.1f, 0.3f, 0.9f}, 0}, {0.6, {0.9f, 0.3f, 0.1f}, 0.2}};  // in any order

std::shared_ptr<const Volume> blobVolume(int brickCells = kBrickCells) {
    static const MapRegion region(blob(), glm::ivec3(0), blob().size - 1);
    return makeVolume(region, kLevels, glm::dvec3(0), brickCells);
}

/// A ball within the blob, and one behind it.
Representation withBalls() {
    Representation r;
    r.spheres = {{{1, 0.5f, 0.8f}, 1.5f}, {{-2, -1, -3}, 2.0f}};
    r.sphereLooks = {testLook(1), testLook(2)};
    r.radius = 10;
    r.drawnAtoms = 2;
    r.volume = blobVolume();
    return r;
}

using Color = std::array<double, 4>;  // linear, premultiplied

/// Colour and opacity over 1 Å of a value: the transfer function, written out.
Color seenAt(double value) {
    struct Level {
        double value, opacity;
        std::array<double, 3> color;
    };
    std::vector<Level> levels;
    for (const VolumeLevel& l : kLevels) {
        const glm::vec4 c = linearColor(l.color, 1);
        levels.push_back({l.value, l.opacity, {c.r, c.g, c.b}});
    }
    std::ranges::sort(levels, {}, &Level::value);
    if (value <= levels.front().value) return {0, 0, 0, levels.front().opacity};
    std::size_t i = 1;
    while (i + 1 < levels.size() && levels[i].value < value) ++i;
    const double t = std::clamp((value - levels[i - 1].value) / (levels[i].value - levels[i - 1].value), 0.0, 1.0);
    Color seen{};
    for (std::size_t c = 0; c < 3; ++c) seen[c] = std::lerp(levels[i - 1].color[c], levels[i].color[c], t);
    seen[3] = std::lerp(levels[i - 1].opacity, levels[i].opacity, t);
    return seen;
}

/// Marches in small steps over the formula. @param from, to  Z, Å
void march(const View& view, const reference::Line& ray, double from, double to, Color& sum) {
    constexpr double kStep = 0.01;
    const glm::dvec3 perZ = ray.direction / -ray.direction.z;
    const double angstroms = glm::length(perZ);
    for (double Z = from; Z < to; Z += kStep) {
        const double length = std::min(kStep, to - Z);
        const glm::dvec3 p = glm::transpose(view.rotation) * (ray.origin + perZ * (Z + length / 2));
        if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > kSide / 2) continue;
        const Color seen = seenAt(blobAt(p));
        const double hides = 1 - std::pow(1 - seen[3], length * angstroms), through = 1 - sum[3];
        for (std::size_t c = 0; c < 3; ++c) sum[c] += through * hides * seen[c];
        sum[3] += through * hides;
    }
}

Color toLinear(std::uint32_t color) {
    const auto channel = [&](int shift) {
        return static_cast<double>(linearFromSrgb(static_cast<float>(color >> shift & 0xff) / 255.0f));
    };
    return {channel(0), channel(8), channel(16), 1};
}
void putBehind(const Color& behind, double opacity, Color& sum) {
    const double through = 1 - sum[3];
    for (std::size_t c = 0; c < 3; ++c) sum[c] += through * opacity * behind[c];
    sum[3] += through * opacity;
}

class Volumes : public SharedRenderers<Projection> {};

TEST_P(Volumes, AreWhatARayMarcherSees) {
    constexpr std::uint32_t kSize = 48;
    const Representation r = withBalls();
    RenderSettings s = settings(r, kSize, GetParam(), {20, 30, 10}, 1.3);
    s.lighting = false;
    s.background = {0, 0, 0, 0};
    const reference::Layers hits = reference::castRays(r, s.view);
    double hidden = 0;
    std::vector<Color> seen(hits.pixels());
    for (std::uint32_t y = 0; y < kSize; ++y)
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const std::size_t i = hits.index(x, y);
            if (hits.nearEdge[i]) continue;
            const auto Z = static_cast<double>(hits.z[i]);
            march(s.view, reference::pixelLine(s.view, x, y), 0, std::min(Z, 60.0), seen[i]);
            if (hits.id[i] == 0) continue;
            hidden += seen[i][3] > 0.05;
            putBehind(toLinear(testLook(hits.id[i] - 1).color), 1, seen[i]);
        }
    double worst = 0;
    for (const Visibility visibility : devicePaths()) {
        ValidatedRenderer& renderer = sharedRenderer(visibility, r);
        const LayerPicture picture = renderer->layers(s);
        for (std::size_t i = 0; i < seen.size(); ++i)
            for (std::size_t c = 0; c < 4 && !hits.nearEdge[i]; ++c)
                worst = std::max(worst, std::abs(static_cast<double>(picture.rgba[4 * i + c]) - seen[i][c]));
    }
    EXPECT_GT(hidden, 50);
    EXPECT_LT(worst, 0.006);  // of a grid's interpolation, and of steps of half a voxel
}

TEST_P(Volumes, AreTheSameOnEveryPath) {
    Representation r = withBalls();
    SphereLook glass = testLook(3);
    glass.color = withOpacity(glass.color, 0.4);
    for (const bool translucent : {false, true}) {
        if (translucent) {
            r.spheres.push_back({{0.5f, 0, 2}, 2.0f});
            r.sphereLooks.push_back(glass);
            appendMesh(
                icosphere({0, 0, 0}, 3.5f, 3, 4), glm::dvec3(0), [&](std::uint32_t) { return glass; }, r);
        }
        for (const std::uint32_t supersample : {1u, 2u, RenderSettings::kEdges}) {
            RenderSettings s = settings(r, 72, GetParam());
            s.supersample = supersample;
            s.occlusion.directions = 8;
            if (supersample == 2) {
                s.effects.clip = {-1.5, 4, Clip::Cap::plain};
                s.effects.fog.range = Fog::Range::automatic;
                s.effects.shadow.strength = 0.5;
            }
            std::vector<float> first;
            for (const Visibility visibility : devicePaths()) {
                ValidatedRenderer& renderer = sharedRenderer(visibility, r);
                const Picture p = renderer->render(s);
                if (first.empty()) first = p.rgba;
                EXPECT_TRUE(p.rgba == first)
                    << visibilityName(visibility) << ", " << supersample << ", " << translucent;
            }
        }
    }
}

/// Coarse encoded depth has the exact one beside it.
TEST_P(Volumes, EndWhereEncodedDepthIsCoarse) {
    const Representation r = withBalls();
    const RenderSettings s = settings(r, 72, GetParam());
    ValidatedRenderer& exact = sharedRenderer(Visibility::fragdepth, r);
    const Picture wanted = exact->render(s);
    Renderer coarse({true, "", Visibility::encoded, EncodedDepth::rgba8});
    coarse.setScene(r);
    EXPECT_TRUE(coarse.render(s).rgba == wanted.rgba);
    EXPECT_TRUE(coarse.validationMessages().empty());
}

TEST_P(Volumes, ArePartedByTranslucentAtoms) {
    constexpr std::uint32_t kSize = 48;
    Representation r;
    SphereLook glass = testLook(3);
    glass.color = withOpacity(glass.color, 0.5);
    r.spheres = {{{0, 0, 0}, 3.0f}};
    r.sphereLooks = {glass};
    r.radius = 10;
    r.drawnAtoms = 1;
    r.volume = blobVolume();
    RenderSettings s = settings(r, kSize, GetParam(), {20, 30, 10}, 1.3);
    s.lighting = false;
    s.background = {0, 0, 0, 0};
    const reference::Layers hits = reference::castRays(r, s.view);
    ValidatedRenderer& renderer = sharedRenderer(Visibility::automatic, r);
    const LayerPicture picture = renderer->layers(s);
    double worst = 0;
    for (std::uint32_t y = 0; y < kSize; ++y)
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const std::size_t i = hits.index(x, y);
            if (hits.nearEdge[i]) continue;
            const reference::Line ray = reference::pixelLine(s.view, x, y);
            Color sum{};
            const double Z = std::min(static_cast<double>(hits.z[i]), 60.0);
            march(s.view, ray, 0, Z, sum);
            if (hits.id[i] > 0) putBehind(toLinear(testLook(3).color), 0.5, sum);
            march(s.view, ray, Z, 60, sum);
            for (std::size_t c = 0; c < 4; ++c)
                worst = std::max(worst, std::abs(static_cast<double>(picture.rgba[4 * i + c]) - sum[c]));
        }
    EXPECT_LT(worst, 0.004);
}

TEST_P(Volumes, ShowNoBordersOfBricks) {
    Representation r = withBalls();
    RenderSettings s = settings(r, 64, GetParam(), {25, -35, 15});
    ValidatedRenderer& renderer = sharedRenderer(Visibility::fragdepth, r);
    const LayerPicture whole = renderer->layers(s);
    r.volume = blobVolume(16);
    ASSERT_GT(r.volume->bricks.size(), 8u);
    renderer->setScene(r);
    const LayerPicture inBricks = renderer->layers(s);
    for (std::size_t i = 0; i < whole.rgba.size(); ++i) ASSERT_NEAR(inBricks.rgba[i], whole.rgba[i], 2e-3) << i;
}

TEST_P(Volumes, AreDrawnAlone) {
    Representation r;
    r.radius = 10;
    r.volume = blobVolume();
    const RenderSettings s = settings(r, 64, GetParam());
    std::vector<float> first;
    for (const Visibility visibility : devicePaths()) {
        ValidatedRenderer& renderer = sharedRenderer(visibility, r);
        const Picture p = renderer->render(s);
        if (first.empty()) first = p.rgba;
        EXPECT_TRUE(p.rgba == first) << visibilityName(visibility);
    }
    const auto blue = std::count_if(first.begin(), first.end(), [](float v) { return v > 0 && v < 0.95f; });
    EXPECT_GT(blue, 500);
}

INSTANTIATE_TEST_SUITE_P(Views, Volumes, testing::Values(Projection::orthographic, Projection::perspective),
                         [](const auto& tested) {
                             return tested.param == Projection::perspective ? "Perspective" : "Parallel";
                         });

}  // namespace
}  // namespace nacre::test
