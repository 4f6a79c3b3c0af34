// Translucent triangles, spheres and sticks over what is opaque: one picture on every path, that of a ray caster; what
// a pointer meets, and what light does.

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <random>
#include <span>
#include <vector>

#include "engine/frame/choose.h"
#include "engine/frame/picture.h"
#include "engine/scene/build/translucency.h"
#include "engine/scene/color/colors.h"
#include "tests/renderer/meshes.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

constexpr std::uint32_t kOuter = 0, kInner = 1, kBall = 2;  // atoms, from 0

SphereLook makeLook(std::uint32_t atom, double opacity) {
    SphereLook look = testLook(atom);
    look.color = withOpacity(look.color, opacity);
    return look;
}

/// A ball in a shell of triangles in a larger shell, and a stick that comes out of all of them.
Representation shells(double outer, double inner) {
    Representation r;
    const auto addShell = [&](const Mesh& mesh, double opacity) {
        const auto look = [=](std::uint32_t atom) { return makeLook(atom, opacity); };
        appendMesh(mesh, glm::dvec3(0), look, r);
    };
    addShell(icosphere({0.2f, 0, 0}, 6, 3, kOuter), outer);
    addShell(icosphere({-1, 0.5f, 0.3f}, 3.5f, 3, kInner), inner);
    r.spheres = {{{-0.5f, 0, 0}, 1.8f}};
    r.sphereLooks = {testLook(kBall)};
    r.cylinders = {{{0, -1, -1}, 0.4f, {5, 6, 5}, 0}};
    r.cylinderLooks = {{testLook(3).color, testLook(4).color, 4, 5}};
    r.radius = 9;
    r.drawnAtoms = 5;
    return r;
}

/// Overlapping translucent balls and sticks around an opaque ball and an opaque stick, and a sheet through them.
Representation balls(double near, double far) {
    Representation r;
    r.spheres = {{{0, 0, 0}, 2.0f},
                 {{0.6f, 0.4f, 2.5f}, 2.2f},
                 {{-1.5f, 0.2f, 3.0f}, 1.7f},
                 {{1, -1.5f, -3}, 2.4f},
                 {{2.5f, 2, 1}, 0.9f}};
    r.sphereLooks = {makeLook(0, 1), makeLook(1, near), makeLook(2, near), makeLook(3, far), makeLook(4, far)};
    r.cylinders = {{{-4, -3, 1}, 0.7f, {4, 3, 4}, 0}, {{-3, 3, -1}, 0.5f, {3, -3, 2}, 0}};
    r.cylinderLooks = {{makeLook(5, near).color, makeLook(6, 1).color, 6, 7},
                       {testLook(7).color, testLook(7).color, 8, 8}};
    r.radius = 6;
    r.drawnAtoms = 8;
    return r;
}

Representation ballsAndShells() {
    Representation r = balls(0.6, 0.3);
    appendMesh(
        icosphere({0.2f, 0, 0}, 4, 3, 8), glm::dvec3(0), [](std::uint32_t atom) { return makeLook(atom, 0.4); }, r);
    return r;
}

/// Many layers of spheres, sticks and triangles, of all opacities, around an opaque ball.
Representation crowd() {
    Representation r = balls(0.6, 0.3);
    std::mt19937 random(7);
    const auto within = [&](double least, double most) {
        return static_cast<float>(least + (most - least) * static_cast<double>(random()) / 4294967295.0);
    };
    const auto somewhere = [&] { return glm::vec3(within(-3, 3), within(-3, 3), within(-4, 4)); };
    for (std::uint32_t atom = 9; atom < 60; ++atom) {
        r.spheres.push_back({somewhere(), within(0.5, 1.6)});
        r.sphereLooks.push_back(makeLook(atom, within(0.05, 0.95)));
    }
    for (std::uint32_t atom = 60; atom < 80; atom += 2) {
        r.cylinders.push_back({somewhere(), within(0.2, 0.6), somewhere(), 0});
        r.cylinderLooks.push_back(
            {makeLook(atom, within(0.05, 0.95)).color, makeLook(atom + 1, 0.4).color, atom + 1, atom + 2});
    }
    for (std::uint32_t atom = 80; atom < 90; ++atom)
        appendMesh(
            icosphere(somewhere(), within(0.5, 2.5), 2, atom), glm::dvec3(0),
            [](std::uint32_t a) { return makeLook(a, a % 2 == 0 ? 0.3 : 0.7); }, r);
    r.drawnAtoms = 90;
    return r;
}

struct TranslucentCase {
    const char* name;
    Projection projection;
    bool effects = false;
    double zoom = 1;
    std::uint32_t supersample = 1, size = 128;
    Representation (*scene)() = [] { return shells(0.5, 0.25); };
};
void PrintTo(const TranslucentCase& c, std::ostream* out) { *out << c.name; }

class TranslucentPicture : public SharedRenderers<TranslucentCase> {};

TEST_P(TranslucentPicture, IsTheSameOnEveryPath) {
    const TranslucentCase& c = GetParam();
    const Representation r = c.scene();
    RenderSettings s = settings(r, c.size, c.projection, {20, 30, 10}, c.zoom);
    s.supersample = c.supersample;
    s.background = {0, 0, 0, 0};
    if (c.effects) {
        s.effects.clip = {-2, 4, Clip::Cap::hatched};
        s.effects.contours.width = 2;
        s.effects.fog.range = Fog::Range::automatic;
        s.effects.shadow.strength = 0.7;
    }
    std::vector<float> picture;
    LayerPicture layers;
    for (const Visibility visibility : devicePaths()) {
        ValidatedRenderer& renderer = sharedRenderer(visibility, r);
        for (const bool prepass : {true, false}) {
            s.tuning.plates = prepass ? PlateShape::octagon : PlateShape::none;
            const Picture p = renderer->render(s);
            const LayerPicture l = renderer->layers(s);
            if (picture.empty()) picture = p.rgba, layers = l;
            const std::string what = visibilityName(visibility) + std::string(prepass ? "" : ", no prepass");
            EXPECT_TRUE(p.rgba == picture) << what;
            EXPECT_TRUE(l.rgba == layers.rgba) << what;
            EXPECT_TRUE(l.id == layers.id && l.z == layers.z) << what;
            if (c.supersample != 1) break;
        }
    }
    const auto some = std::count_if(picture.begin(), picture.end(), [](float v) { return v > 0 && v < 1; });
    EXPECT_GT(some, static_cast<std::ptrdiff_t>(picture.size() / 8));
}

INSTANTIATE_TEST_SUITE_P(
    Views, TranslucentPicture,
    testing::Values(
        TranslucentCase{"Parallel", Projection::orthographic},
        TranslucentCase{"Perspective", Projection::perspective, false, 3},
        TranslucentCase{"Effects", Projection::perspective, true},
        TranslucentCase{"Edges", Projection::orthographic, false, 1, RenderSettings::kEdges, 48},
        TranslucentCase{"Balls", Projection::orthographic, false, 1, 1, 128, [] { return balls(0.6, 0.3); }},
        TranslucentCase{"BallsInPerspective", Projection::perspective, true, 1, 1, 128, [] { return balls(0.6, 0.3); }},
        TranslucentCase{"BallsAndShells", Projection::orthographic, true, 1, 1, 128, ballsAndShells},
        TranslucentCase{"Crowd", Projection::orthographic, false, 1, 1, 128, crowd},
        TranslucentCase{"CrowdInPerspective", Projection::perspective, true, 1, 1, 128, crowd}),
    [](const auto& tested) { return std::string(tested.param.name); });

/// Tiles that a mask leaves out, or shifts, would show.
TEST(TranslucentEdges, HaveTheColoursOfOneOrMoreSamples) {
    const Representation r = crowd();
    ValidatedRenderer renderer(Visibility::automatic, r);
    RenderSettings s = settings(r, 217, Projection::orthographic, {20, 30, 10});
    s.view.width = 333;
    std::vector<Picture> whole;
    for (s.supersample = 1; s.supersample <= FinerPlaces::kMany; s.supersample *= 2)
        whole.push_back(renderer->render(s));
    s.supersample = RenderSettings::kEdges;
    const Picture p = renderer->render(s);
    constexpr float kAlike = 2 / 255.0f;
    std::array<int, 3> seen{};  // pixels that only one of the pictures has so
    for (std::size_t i = 0; i < p.rgba.size(); i += 4) {
        std::array<float, 3> away{};
        for (std::size_t n = 0; n < whole.size(); ++n)
            for (std::size_t c = i; c < i + 4; ++c) away[n] = std::max(away[n], std::abs(p.rgba[c] - whole[n].rgba[c]));
        const auto least = std::ranges::min_element(away);
        ASSERT_LT(*least, kAlike) << i / 4 % 333 << ", " << i / 4 / 333;
        if (std::ranges::count_if(away, [](float a) { return a < kAlike; }) == 1) ++seen[least - away.begin()];
    }
    for (const int pixels : seen) EXPECT_GT(pixels, 100);
}

struct Crossing {
    double Z;
    std::uint32_t atom;
    bool sure;
};

/// Where a ray of a parallel view crosses triangles, from near to far.
std::vector<Crossing> crossings(const Representation& r, const std::vector<glm::dvec3>& vertices, const View& view,
                                const glm::dvec2& q) {
    std::vector<Crossing> found;
    for (const Triangle& t : r.triangles) {
        const glm::dvec3 &a = vertices[t.a], &b = vertices[t.b], &c = vertices[t.c];
        const auto side = [&](const glm::dvec3& from, const glm::dvec3& to) {
            return (from.x - q.x) * (to.y - q.y) - (from.y - q.y) * (to.x - q.x);
        };
        const double ofA = side(b, c), ofB = side(c, a), ofC = side(a, b), sum = ofA + ofB + ofC;
        const double least = std::min({ofA / sum, ofB / sum, ofC / sum});
        if (!(least > -1e-3)) continue;
        const double z = (ofA * a.z + ofB * b.z + ofC * c.z) / sum;
        found.push_back({view.radius - z, r.meshLooks[r.meshVertices[t.a].look].atom - 1, least > 1e-3});
    }
    std::sort(found.begin(), found.end(), [](const Crossing& x, const Crossing& y) { return x.Z < y.Z; });
    return found;
}

/// Premultiplied linear colour and alpha of a layer over what is behind it.
std::array<double, 4> over(std::uint32_t color, double opacity, const std::array<double, 4>& behind) {
    std::array<double, 4> mixed{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double own = static_cast<double>(linearFromSrgb(static_cast<float>(color >> (8 * c) & 0xff) / 255.0f));
        mixed[c] = own * opacity + behind[c] * (1 - opacity);
    }
    mixed[3] = opacity + behind[3] * (1 - opacity);
    return mixed;
}

struct Layer {
    double Z;
    std::uint32_t color;
    double opacity;
};

/// All layers over a background: the nearest in order, and the rest as one layer, whose transmittance is the product of
/// theirs, and whose colour is a mean weighted by opacity and by the light that probably reaches them.
/// @param layers  from near to far @param perLength  layers per Å, on average
std::array<double, 4> mixed(std::span<const Layer> layers, double perLength, std::array<double, 4> behind) {
    const std::size_t ordered = std::min<std::size_t>(layers.size(), kTranslucentLayers);
    if (layers.size() > ordered) {
        std::array<double, 4> sum{};
        double through = 1, weights = 0;
        for (const Layer& layer : layers.subspan(ordered)) {
            const double between = (layer.Z - layers[ordered - 1].Z) * perLength;
            const double weight = layer.opacity * std::max(std::pow(1 - layer.opacity, between), 1.0 / 256);
            const std::array<double, 4> own = over(layer.color, 1, {});
            for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * own[c];
            weights += weight;
            through *= 1 - layer.opacity;
        }
        for (std::size_t c = 0; c < 3; ++c) behind[c] = sum[c] / weights * (1 - through) + behind[c] * through;
        behind[3] = 1 - through + behind[3] * through;
    }
    for (std::size_t i = ordered; i-- > 0;) behind = over(layers[i].color, layers[i].opacity, behind);
    return behind;
}

TEST(Translucent, LayersOfTrianglesAreMixedAsAFormulaSays) {
    constexpr double kOpacity[] = {0.5, 0.25};
    Representation r = shells(kOpacity[kOuter], kOpacity[kInner]);
    r.cylinders.clear();
    r.cylinderLooks.clear();
    ValidatedRenderer renderer(Visibility::automatic, r);
    constexpr std::uint32_t kSize = 64;
    for (const bool transparent : {false, true}) {
        RenderSettings s = settings(r, kSize, Projection::orthographic, {70, -20, 200});
        s.lighting = false;
        s.background = transparent ? std::array<float, 4>{0, 0, 0, 0} : std::array<float, 4>{1, 1, 1, 1};
        const LayerPicture l = renderer->layers(s);
        const std::vector<glm::dvec3> vertices = turnedVertices(r, s.view);
        std::size_t compared = 0, behindBoth = 0, more = 0;
        double worst = 0;
        for (std::uint32_t y = 0; y < kSize; ++y)
            for (std::uint32_t x = 0; x < kSize; ++x) {
                const glm::dvec2 q((x + 0.5 - kSize / 2.0) / s.view.pixelsPerAngstrom,
                                   (kSize / 2.0 - y - 0.5) / s.view.pixelsPerAngstrom);
                std::vector<Crossing> hits = crossings(r, vertices, s.view, q);
                const glm::dvec3 ball = s.view.rotation * glm::dvec3(r.spheres[0].center);
                const double radius = static_cast<double>(r.spheres[0].radius);
                const double high = radius * radius - glm::dot(glm::dvec2(ball) - q, glm::dvec2(ball) - q);
                bool sure = std::abs(high) > 0.05;
                std::array<double, 4> expected{};
                if (!transparent) expected = {1, 1, 1, 1};
                if (high > 0) {
                    const double Z = s.view.radius - ball.z - std::sqrt(high);
                    std::erase_if(hits, [&](const Crossing& hit) { return hit.Z > Z; });
                    expected = over(testLook(kBall).color, 1, expected);
                }
                for (std::size_t i = 0; i + 1 < hits.size(); ++i) sure = sure && hits[i + 1].Z - hits[i].Z > 0.01;
                for (const Crossing& hit : hits) sure = sure && hit.sure;
                if (!sure) continue;
                std::vector<Layer> layers;
                for (const Crossing& hit : hits)
                    layers.push_back({hit.Z, testLook(hit.atom).color, kOpacity[hit.atom]});
                expected = mixed(layers, layersPerLength(r, translucentParts(r)), expected);
                ++compared;
                behindBoth += hits.size() == 2 && high > 0;
                more += hits.size() > kTranslucentLayers;
                for (std::size_t c = 0; c < 4; ++c)
                    worst =
                        std::max(worst, std::abs(static_cast<double>(l.rgba[4 * (y * kSize + x) + c]) - expected[c]));
            }
        EXPECT_GT(compared, 3000u);
        EXPECT_GT(behindBoth, 50u);
        EXPECT_GT(more, 50u);
        EXPECT_LT(worst, 2e-4);  // shaders' curves of sRGB are polynomials
    }
}

/// The balls of each pixel over an opaque one, mixed by hand.
TEST(Translucent, BallsAreMixedAsAFormulaSays) {
    Representation r = balls(0.6, 0.3);
    for (const float z : {4.5f, 5.0f, 5.5f}) {
        r.spheres.push_back({{0.3f * z - 1, 0.5f, z}, 1.5f});
        r.sphereLooks.push_back(makeLook(static_cast<std::uint32_t>(r.spheres.size()), 0.4));
    }
    r.cylinders.clear();
    r.cylinderLooks.clear();
    ValidatedRenderer renderer(Visibility::automatic, r);
    constexpr std::uint32_t kSize = 64;
    RenderSettings s = settings(r, kSize, Projection::orthographic, {30, -20, 100});
    s.lighting = false;
    s.background = {1, 1, 1, 1};
    const LayerPicture l = renderer->layers(s);
    std::size_t compared = 0, more = 0;
    double worst = 0;
    for (std::uint32_t y = 0; y < kSize; ++y)
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const glm::dvec2 q((x + 0.5 - kSize / 2.0) / s.view.pixelsPerAngstrom,
                               (kSize / 2.0 - y - 0.5) / s.view.pixelsPerAngstrom);
            struct Front {
                double z;
                std::size_t ball;
            };
            std::vector<Front> fronts;
            bool sure = true;
            for (std::size_t i = 0; i < r.spheres.size(); ++i) {
                const glm::dvec3 center = s.view.rotation * glm::dvec3(r.spheres[i].center);
                const double radius = static_cast<double>(r.spheres[i].radius);
                const double high = radius * radius - glm::dot(glm::dvec2(center) - q, glm::dvec2(center) - q);
                sure = sure && std::abs(high) > 0.05;
                if (high > 0) fronts.push_back({center.z + std::sqrt(high), i});
            }
            std::ranges::sort(fronts, std::greater(), &Front::z);
            for (std::size_t i = 0; i + 1 < fronts.size(); ++i) sure = sure && fronts[i].z - fronts[i + 1].z > 0.01;
            if (!sure) continue;
            const auto frontOpacity = [&](const Front& f) { return opacitySteps(r.sphereLooks[f.ball].color) / 128.0; };
            const auto opaque = std::ranges::find_if(fronts, [&](const Front& f) { return frontOpacity(f) == 1; });
            std::array<double, 4> expected{1, 1, 1, 1};
            if (opaque != fronts.end()) expected = over(r.sphereLooks[opaque->ball].color, 1, expected);
            fronts.erase(opaque, fronts.end());
            more += fronts.size() > kTranslucentLayers + 1;
            std::vector<Layer> layers;
            for (const Front& f : fronts) layers.push_back({-f.z, r.sphereLooks[f.ball].color, frontOpacity(f)});
            expected = mixed(layers, layersPerLength(r, translucentParts(r)), expected);
            ++compared;
            for (std::size_t c = 0; c < 4; ++c)
                worst = std::max(worst, std::abs(static_cast<double>(l.rgba[4 * (y * kSize + x) + c]) - expected[c]));
        }
    EXPECT_GT(compared, 3000u);
    EXPECT_GT(more, 50u);
    EXPECT_LT(worst, 2e-4);  // shaders' curves of sRGB are polynomials
}

/// The transmittance of many layers is the product of theirs, in any order.
TEST(Translucent, TheRestHidesExactlyWhatItsLayersHide) {
    Representation r;
    for (std::uint32_t i = 0; i < 30; ++i) {
        r.spheres.push_back({{0, 0, 0.1f * static_cast<float>(i * 17 % 30)}, 3});
        r.sphereLooks.push_back(makeLook(i, (5 + i * 29 % 40) / 128.0));
    }
    r.radius = 6;
    r.drawnAtoms = 30;
    double through = 1;
    for (const SphereLook& look : r.sphereLooks) through *= 1 - opacitySteps(look.color) / 128.0;
    ASSERT_GT(through, 1e-4);
    constexpr std::uint32_t kSize = 16;
    for (const Visibility visibility : devicePaths()) {
        ValidatedRenderer renderer(visibility, r);
        RenderSettings s = settings(r, kSize, Projection::orthographic, {0, 0, 0});
        s.background = {0, 0, 0, 0};
        const LayerPicture l = renderer->layers(s);
        EXPECT_NEAR(l.rgba[4 * (kSize / 2 * kSize + kSize / 2) + 3], 1 - through, 2e-6) << visibilityName(visibility);
        EXPECT_EQ(l.rgba[3], 0) << visibilityName(visibility);
    }
}

TEST(Translucent, BallsNeitherOccludeNorCastAShadow) {
    Representation bare = balls(1, 1);
    bare.spheres.resize(1);
    bare.sphereLooks.resize(1);
    bare.cylinders.erase(bare.cylinders.begin());
    bare.cylinderLooks.erase(bare.cylinderLooks.begin());
    RenderSettings s = settings(bare, 64, Projection::orthographic, {0, 0, 0});
    s.occlusion.directions = 32;
    s.effects.shadow.strength = 1;
    for (const OcclusionMaps maps : {OcclusionMaps::tiles, OcclusionMaps::fragdepth}) {
        s.occlusion.maps = maps;
        ValidatedRenderer renderer(Visibility::automatic, bare);
        const LayerPicture alone = renderer->layers(s);
        Representation faint = balls(0.01, 0.01);
        for (std::uint32_t* color : {&faint.cylinderLooks[0].colorA, &faint.cylinderLooks[0].colorB})
            *color = withOpacity(*color, 0.01);
        renderer->setScene(faint);
        const LayerPicture within = renderer->layers(s);
        EXPECT_TRUE(within.id == alone.id);
        double sum = 0;  // single pixels differ: the maps have other ones
        for (std::size_t i = 0; i < alone.occlusion.size(); ++i)
            sum += std::abs(static_cast<double>(within.occlusion[i] - alone.occlusion[i]));
        EXPECT_LT(sum / static_cast<double>(alone.occlusion.size()), 0.002);
        for (std::size_t i = 0; i < alone.rgba.size(); ++i) ASSERT_NEAR(within.rgba[i], alone.rgba[i], 20.0 / 128) << i;
    }
}

TEST(Translucent, APointerMeetsWhatHidesMoreThanAHalf) {
    ValidatedRenderer renderer(Visibility::automatic);
    struct Opacities {
        double outer, inner;
        std::uint32_t atom;
    };
    for (const auto& [outer, inner, atom] : {Opacities{0.6, 0.3, kOuter}, Opacities{0.5, 0.6, kInner},
                                             Opacities{0.5, 0.3, kBall}, Opacities{1, 0.3, kOuter}}) {
        const Representation r = shells(outer, inner);
        renderer->setScene(r);
        const RenderSettings s = settings(r, 64, Projection::orthographic, {0, 0, 0});
        EXPECT_EQ(renderer->atomAt(s, 30, 32, 2), atom + 1) << outer << ", " << inner;
        EXPECT_EQ(renderer->layers(s).id[32 * 64 + 30], atom + 1) << outer << ", " << inner;
    }
    const Representation r = shells(0.4, 0.4);
    renderer->setScene(r);
    EXPECT_EQ(renderer->atomAt(settings(r, 64, Projection::orthographic, {0, 0, 0}), 10, 45, 2), 0u);
}

TEST(Translucent, LightGoesThroughIt) {
    Representation bare = shells(1, 1);
    bare.triangles.clear();
    bare.meshVertices.clear();
    bare.meshLooks.clear();
    RenderSettings s = settings(bare, 64, Projection::orthographic, {0, 0, 0});
    s.occlusion.directions = 32;
    s.effects.shadow.strength = 1;
    for (const OcclusionMaps maps : {OcclusionMaps::tiles, OcclusionMaps::fragdepth}) {
        s.occlusion.maps = maps;
        ValidatedRenderer renderer(Visibility::automatic, bare);
        const LayerPicture alone = renderer->layers(s);
        renderer->setScene(shells(0.01, 0.01));
        const LayerPicture within = renderer->layers(s);
        EXPECT_TRUE(within.id == alone.id);
        // A patch lies elsewhere in a larger atlas, where filters of devices round in their own way.
        for (std::size_t i = 0; i < alone.occlusion.size(); ++i)
            ASSERT_NEAR(within.occlusion[i], alone.occlusion[i], 2.0 / 255) << i;
        for (std::size_t i = 0; i < alone.rgba.size(); ++i) ASSERT_NEAR(within.rgba[i], alone.rgba[i], 21.0 / 128) << i;
    }
}

}  // namespace
}  // namespace nacre::test
