// Antialiasing as it is by default: what a picture of 8 x 8 samples a pixel shows, nearly, by one frame of the `tiles`
// path and by 4 x 4 samples on the others, where colours change.

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/frame/finer_places.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

/// Peak signal-to-noise ratio in dB, of sRGB-coded colour and of coverage.
double likeness(const Picture& a, const Picture& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        const double d = i % 4 == 3 ? a.rgba[i] - b.rgba[i] : coded(a.rgba[i]) - coded(b.rgba[i]);
        sum += d * d;
    }
    return 10 * std::log10(static_cast<double>(a.rgba.size()) / sum);
}

/// Whether compute adds samples at edges to the pictures of other paths, and not blocks of finer frames: on CPUs.
/// SwiftShader's texel buffers are too small for it.
bool addsByCompute() { return isSoftwareDevice() && testedDevice().driver.find("SwiftShader") == std::string::npos; }

struct Case {
    const char* file;
    Style style;
    Projection projection;
    double contours = 0;
    bool clip = false;
    double shadow = 0;
    double halos = 0;
    int weights = 1;  // of contours
    bool rims() const { return halos > 0 || weights == 3; }
};
void PrintTo(const Case& c, std::ostream* out) {
    *out << c.file << " style " << static_cast<int>(c.style) << " projection " << static_cast<int>(c.projection)
         << (c.contours > 0 ? " contours" : "") << (c.clip ? " clip" : "") << (c.shadow > 0 ? " shadow" : "")
         << (c.rims() ? " rims" : "");
}

class Edges : public SharedRenderers<Case> {
protected:
    static RenderSettings wanted(const Representation& r, std::uint32_t size) {
        const Case& c = GetParam();
        RenderSettings s = settings(r, size, c.projection, {75, -40, 120});
        s.background = {0, 0, 0, 0};
        s.effects.contours.width = c.contours;
        s.effects.contours.weights = c.weights;
        s.effects.halos.width = c.halos;
        s.effects.shadow.strength = c.shadow;
        if (c.clip) s.effects.clip.near = 0, s.effects.clip.cap = Clip::Cap::hatched;
        return s;
    }
};

TEST_P(Edges, LookAsIfEveryPixelHadManySamples) {
    NACRE_NEEDS_DATA(GetParam().file);
    const Representation r = scene(GetParam().file, GetParam().style);
    RenderSettings s = wanted(r, 160);
    for (const Visibility path : {Visibility::tiles, Visibility::fragdepth}) {
        SCOPED_TRACE(static_cast<int>(path));
        ValidatedRenderer& renderer = sharedRenderer(path, r);
        s.supersample = 8;
        const Picture truth = renderer->render(s);
        s.supersample = 1;
        EXPECT_LT(likeness(renderer->render(s), truth), 33);
        EXPECT_EQ(renderer->stats().samples, 1u);
        s.supersample = RenderSettings::kEdges;
        const Picture picture = renderer->render(s);
        EXPECT_GT(likeness(picture, truth), GetParam().halos > 0 && GetParam().weights == 1 ? 42 : 38);
        EXPECT_EQ(renderer->stats().samples, 16u);
        EXPECT_LE(renderer->stats().frames, 2u);  // one sample per pixel, then more where colours change
        if (GetParam().weights == 3) {
            EXPECT_EQ(renderer->stats().frames, 2u);
        }
        float worst = 0;  // of coverage
        for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
            worst = std::max(worst, std::abs(picture.rgba[i] - truth.rgba[i]));
        EXPECT_LT(worst, 0.2f);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Edges,
                         testing::Values(Case{"sample:dna", Style::spacefill, Projection::orthographic},
                                         Case{"sample:dna", Style::spacefill, Projection::perspective, 0, false, 1},
                                         Case{"sample:dna", Style::licorice, Projection::perspective},
                                         Case{"sample:glucose", Style::ballAndStick, Projection::orthographic},
                                         Case{"sample:dna", Style::ballAndStick, Projection::perspective, 3},
                                         Case{"sample:glucose", Style::spacefill, Projection::perspective, 2, true},
                                         Case{"1bna.pdb", Style::spacefill, Projection::orthographic},
                                         Case{"1crn.pdb", Style::licorice, Projection::orthographic},
                                         Case{"4hhb.pdb", Style::spacefill, Projection::orthographic},
                                         Case{"4hhb.pdb", Style::spacefill, Projection::orthographic, 0, false, 0, 6},
                                         Case{"4hhb.pdb", Style::spacefill, Projection::perspective, 2, false, 0, 6, 3},
                                         Case{"1crn.pdb", Style::cartoon, Projection::perspective},
                                         Case{"1crn.pdb", Style::cartoon, Projection::perspective, 0, false, 0, 6}),
                         [](const auto& test) { return testName(test.param.file) + "_" + std::to_string(test.index); });

/// Where sticks are thinner than a pixel, no pixel beside one need have it in its middle.
TEST(EdgesOf, SticksThinnerThanAPixel) {
    const Representation r = scene("sample:dna", Style::licorice);
    ValidatedRenderer renderer(Visibility::tiles, r);
    RenderSettings s = settings(r, 48, Projection::orthographic);
    s.supersample = 8;
    const Picture truth = renderer->render(s);
    s.supersample = RenderSettings::kEdges;
    EXPECT_GT(likeness(renderer->render(s), truth), 36);
}

/// Only the bins of a thin stick have samples in all of their pixels.
TEST(EdgesOf, SticksThinnerThanAPixelBesideOthers) {
    Representation r;
    r.spheres = {{{0, 0, 0}, 8}};
    r.sphereLooks = {{0xff4060c0u, 1}};
    r.radius = 12;
    RenderSettings s = settings(r, 192, Projection::orthographic);
    s.tuning.countFragments = true;
    s.supersample = RenderSettings::kEdges;
    const auto edges = [&] {
        ValidatedRenderer renderer(Visibility::tiles, r);
        renderer->render(s);
        for (const PassCount& count : renderer->stats().passes)
            if (count.name == "edge samples") return count.shadedFragments;
        return std::uint64_t{0};
    };
    const std::uint64_t alone = edges();
    r.cylinders = {{{9, 9, 0}, 0.03f, {7, 9, 0}, 0}};
    r.cylinderLooks = {{0xffc06040u, 0xffc06040u, 2, 2}};
    const std::uint64_t beside = edges();
    EXPECT_GT(beside, alone + 10);
    EXPECT_LT(beside, alone + 500);
}

/// Samples of a small picture search no long lists: the host finds the triangle of each.
TEST(EdgesOf, FineMeshesInSmallPictures) {
    NACRE_NEEDS_DATA("1crn.pdb");
    const Representation r = scene("1crn.pdb", Style::cartoon);
    ValidatedRenderer renderer(Visibility::tiles, r);
    for (const auto& [size, blocks] : {std::pair(96u, true), std::pair(400u, false)}) {
        SCOPED_TRACE(size);
        RenderSettings s = settings(r, size, Projection::orthographic);
        s.supersample = 8;
        const Picture truth = renderer->render(s);
        s.supersample = RenderSettings::kEdges;
        EXPECT_GT(likeness(renderer->render(s), truth), 38);
        EXPECT_EQ(renderer->planText().find("edge samples") == std::string::npos, blocks);
        EXPECT_EQ(renderer->stats().samples, 16u);
    }
}

/// Samples that go into another path's picture. By compute, spheres need no other pixel shaded, unless something cuts
/// them.
TEST(EdgesOf, PicturesByOtherPaths) {
    const Representation r = scene("sample:dna", Style::spacefill);
    ValidatedRenderer renderer(Visibility::encoded, r);
    for (const bool cut : {false, true}) {
        SCOPED_TRACE(cut);
        RenderSettings s = settings(r, 128, Projection::orthographic);
        if (cut) s.effects.clip.near = -0.2 * r.radius;
        s.supersample = 8;
        const Picture truth = renderer->render(s);
        s.supersample = RenderSettings::kEdges;
        EXPECT_GT(likeness(renderer->render(s), truth), 38);
        const std::vector<Decision> decisions = renderer->decisions();
        const auto samples = std::ranges::find(decisions, "samples", &Decision::what);
        ASSERT_NE(samples, decisions.end());
        EXPECT_EQ(samples->how, addsByCompute() ? "1 per pixel, then 16 at edges"
                                                : "1 per pixel, then 16 in blocks where colours change");
        const auto draws = [&](const char* pass) { return renderer->planText().find(pass) != std::string::npos; };
        EXPECT_EQ(draws("edge samples"), addsByCompute());
        EXPECT_EQ(draws("nearest primitive, shaded"), addsByCompute() && cut);
    }
}

/// Whose sides are no whole tiles.
TEST(EdgesOf, OddPictures) {
    const Representation r = scene("sample:dna", Style::spacefill);
    ValidatedRenderer renderer(Visibility::tiles, r);
    RenderSettings s = settings(r, 64, Projection::orthographic);
    s.view = makeView(Camera{.pan = {1.3, -0.7}}, r.radius, 131, 77);
    s.supersample = 8;
    const Picture truth = renderer->render(s);
    s.supersample = RenderSettings::kEdges;
    EXPECT_GT(likeness(renderer->render(s), truth), 38);
}

TEST(EdgesOf, ListsThatAreTooLongHaveSamplesEverywhere) {
    Representation r;
    for (int i = 0; i < 7000; ++i) {
        r.spheres.push_back({{0, 0, 0.001f * static_cast<float>(i)}, 1});
        r.sphereLooks.push_back({0xff4060c0u, static_cast<std::uint32_t>(i + 1)});
    }
    r.radius = 9;
    ValidatedRenderer renderer(Visibility::tiles, r);
    RenderSettings s = settings(r, 48, Projection::orthographic);
    s.supersample = 4;
    const Picture truth = renderer->render(s);
    s.supersample = RenderSettings::kEdges;
    EXPECT_GT(likeness(renderer->render(s), truth), 45);
    EXPECT_EQ(renderer->stats().frames, 2u);
    EXPECT_EQ(renderer->stats().samples, 16u);
}

/// So many small spheres that nearly every pixel has an edge, in several blocks of which parts are empty.
TEST(EdgesOf, CrowdsHaveSamplesEverywhere) {
    Representation r;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-1, 1);
    while (r.spheres.size() < 100'000) {
        const glm::vec3 p(place(random), place(random), place(random));
        if (glm::length(p) > 1) continue;
        r.spheres.push_back({p * 60.0f, 1});
        const auto color = static_cast<std::uint32_t>(0xff000000u | random() % 0x1000000u);
        r.sphereLooks.push_back({color, static_cast<std::uint32_t>(r.spheres.size())});
    }
    r.radius = 61;
    ValidatedRenderer renderer(Visibility::tiles, r);
    RenderSettings s = settings(r, 64, Projection::orthographic);
    s.view = makeView(Camera{.pan = {-2.5, 0.2}}, r.radius, 500, 120);
    s.supersample = 4;
    const Picture truth = renderer->render(s);
    s.supersample = RenderSettings::kEdges;
    // Shaded once per sphere and pixel; else in blocks where colours change.
    EXPECT_GT(likeness(renderer->render(s), truth), addsByCompute() ? 43 : 35);
    EXPECT_EQ(renderer->stats().samples, 16u);
    if (!addsByCompute()) return;
    EXPECT_EQ(renderer->stats().frames, 2u);
    EXPECT_EQ(renderer->planText().find("edge samples"), std::string::npos);
}

/// Each sphere of a pixel is shaded once, and looks like all its samples.
TEST(EdgesOf, CrowdsLookLikeTheirSamples) {
    if (!addsByCompute()) return;
    Molecule m = molecule("sample:dna");
    std::vector<glm::vec3> places;
    for (int i = 0; i < 240; ++i) places.emplace_back(i % 8 * 26, i / 8 % 5 * 40, i / 40 * 26);
    addCopies(m, places);
    RepresentationOptions options{.style = Style::spacefill, .color = ColorScheme::element, .assembly = "1"};
    const Representation r = represent(m, drawnAtoms(m), options);
    ValidatedRenderer renderer(Visibility::tiles, r);
    for (const bool metal : {false, true})
        for (const bool effects : {false, true}) {
            RenderSettings s = settings(r, 64, Projection::orthographic, {10, 30, 0});
            s.view.width = 161, s.view.height = 119;
            s.background = {0, 0, 0, 0};
            if (metal) s.effects.light.material = Material::metal;
            if (effects) s.effects.fog.range = Fog::Range::automatic, s.effects.shadow.strength = 0.6;
            s.supersample = 4;
            const Picture truth = renderer->render(s);
            s.supersample = RenderSettings::kEdges;
            const Picture picture = renderer->render(s);
            EXPECT_GT(likeness(picture, truth), 38) << metal << effects;
            EXPECT_EQ(renderer->planText().find("edge samples"), std::string::npos);
            EXPECT_NE(renderer->planText().find("picture, shaded"), std::string::npos);
            double bias = 0, covered = 0;
            for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
                const bool alpha = i % 4 == 3;
                bias += alpha ? 0 : coded(picture.rgba[i]) - coded(truth.rgba[i]);
                covered += alpha ? 3 * truth.rgba[i] : 0;
                ASSERT_NEAR(picture.rgba[i], truth.rgba[i], alpha ? 1e-2 : 1);
            }
            EXPECT_LT(std::abs(bias / covered), 0.01) << metal << effects;
            const Picture part = renderer->renderPart(s, {32, 48, 64, 32});
            for (std::size_t row = 0; row < 32; ++row)
                ASSERT_TRUE(std::equal(part.rgba.begin() + 4 * 64 * row, part.rgba.begin() + 4 * 64 * (row + 1),
                                       picture.rgba.begin() + 4 * (161 * (48 + row) + 32)));
        }
}

/// Halos wider than a bin, over the borders of blocks and of parts.
TEST(EdgesOf, HalosHaveNoSeams) {
    const Representation r = scene("sample:dna", Style::spacefill);
    ValidatedRenderer renderer(Visibility::tiles, r);
    RenderSettings s = settings(r, 64, Projection::orthographic);
    s.view = makeView(Camera{.zoom = 8}, r.radius, 432, 48);
    s.effects.halos.width = 24;
    s.background = {0, 0, 0, 0};
    s.supersample = 8;
    const Picture many = renderer->render(s);
    s.supersample = RenderSettings::kEdges;
    const Picture truth = renderer->render(s);
    EXPECT_GT(likeness(truth, many), 40);
    const auto isCovered = [&](std::size_t pixel) { return truth.rgba[4 * pixel + 3] > 0; };
    std::uint64_t covered = 0;
    for (std::size_t i = 0; i < truth.rgba.size() / 4; ++i) covered += isCovered(i) ? 1 : 0;
    EXPECT_EQ(renderer->stats().coveredPixels, covered);
    EXPECT_GE(renderer->stats().frames, 2u);
    const Picture part = renderer->renderPart(s, {352, 0, 64, 48});
    for (std::uint32_t row = 0; row < 48; ++row)
        ASSERT_TRUE(std::equal(part.rgba.begin() + 4 * 64 * row, part.rgba.begin() + 4 * 64 * (row + 1),
                               truth.rgba.begin() + 4 * (432 * row + 352)))
            << row;
}

/// The paths leave pixels alone whose neighbours have nearly the same colour, and bring others close to many samples.
TEST(EdgesOf, SamplesAreWhereColorsChange) {
    const Representation r = scene("sample:dna", Style::spacefill);
    RenderSettings s = settings(r, 192, Projection::orthographic, {20, 0, 0}, 4);
    s.background = {0, 0, 0, 0};
    const auto stepsApart = [](const Picture& p, std::size_t a, std::size_t b) {
        float most = 0;
        for (std::size_t c = 0; c < 4; ++c)
            most = std::max(most, std::abs(std::sqrt(p.rgba[4 * a + c]) - std::sqrt(p.rgba[4 * b + c])));
        return 255 * most;
    };
    for (const Visibility path : {Visibility::encoded, Visibility::fragdepth, Visibility::deferred, Visibility::tiles})
        for (const bool rims : {true, false}) {
            if (path == Visibility::tiles && !rims) continue;  // one frame draws its edges
            SCOPED_TRACE(std::string(visibilityName(path)) + (rims ? ", halos" : ""));
            ValidatedRenderer renderer(path, r);
            s.effects.halos.width = rims ? 4 : 0;
            s.supersample = 8;
            const Picture truth = renderer->render(s);
            s.supersample = 1;
            const Picture one = renderer->render(s);
            s.supersample = RenderSettings::kEdges;
            const Picture picture = renderer->render(s);
            EXPECT_GT(likeness(picture, truth), 40);
            const auto stepsOff = [&](std::size_t at, const Picture& p) {
                float most = 0;
                for (std::size_t c = 0; c < 4; ++c)
                    most = std::max(most, std::abs(std::sqrt(p.rgba[4 * at + c]) - std::sqrt(truth.rgba[4 * at + c])));
                return 255 * most;
            };
            std::size_t alone = 0, wrong = 0, finer = 0, closer = 0;
            for (std::size_t y = 1; y + 1 < 192; ++y)
                for (std::size_t x = 1; x + 1 < 192; ++x) {
                    const std::size_t here = 192 * y + x;
                    float most = 0;
                    for (const std::size_t there : {here - 1, here + 1, here - 192, here + 192})
                        most = std::max(most, stepsApart(one, here, there));
                    if (most > 14 && most < 18) continue;  // rounding
                    alone += most < 16 ? 1 : 0;
                    if (most >= 16) {  // tiles add samples, on a grid of their own
                        closer += stepsOff(here, picture) <= stepsOff(here, one) + 4 ? 1 : 0;
                        ++finer;
                        continue;
                    }
                    wrong += std::equal(&one.rgba[4 * here], &one.rgba[4 * here] + 4, &picture.rgba[4 * here]) ? 0 : 1;
                }
            EXPECT_EQ(wrong, 0u);
            EXPECT_GT(alone, 192u * 192u / 2);
            EXPECT_GT(finer, 500u);
            EXPECT_GT(closer, finer * 97 / 100);
        }
}

TEST(EdgesOf, PlacesAskForTheTilesAroundThem) {
    constexpr std::uint32_t kAcross = 64, kDown = 48;
    std::vector<std::uint32_t> seen(std::size_t{kAcross} * kDown, 0xff000000);
    for (std::uint32_t y = 0; y < kDown; ++y)
        for (std::uint32_t x = 32; x < kAcross; ++x) seen[y * kAcross + x] = 0xff0000ff;
    const FinerPlaces places(seen.data(), kAcross, {kAcross, kDown});
    const auto [edges, mask] = places.findEdges({16, 8, 40, 32}, {20, 12, 32, 20});
    ASSERT_EQ(edges.across, 40u);
    for (std::uint32_t y = 0; y < 32; ++y)
        for (std::uint32_t x = 0; x < 40; ++x) {
            const bool edge = (x == 15 || x == 16) && y >= 4 && y < 24;
            EXPECT_EQ(edges.pixels[y * 40 + x] != 0, edge) << x << ", " << y;
            // Those beside an edge are in the tiles beside it.
            EXPECT_EQ(mask.wants(x / 4, y / 4), (x / 4 == 3 || x / 4 == 4) && y < 28) << x << ", " << y;
        }
}

TEST(EdgesOf, ContrastSetsTheNumberOfSamples) {
    constexpr std::uint32_t kAcross = 7, kDown = 5;
    std::vector<std::uint32_t> seen;
    for (std::uint32_t i = 0; i < kAcross * kDown; ++i) {
        const std::uint32_t x = i % kAcross;
        seen.push_back(0xff000000 | (x < 1 ? 15u : x < 3 ? 30u : x < 5 ? 50u : 120u) << 8);
    }
    FinerPlaces places(seen.data(), kAcross, {kAcross, kDown});
    const std::uint8_t few = FinerPlaces::kFew - 1, many = FinerPlaces::kMany - 1;
    const std::vector<std::uint8_t> row = {0, 0, few, few, many, many, 0};
    for (std::uint32_t y = 0; y < kDown; ++y)
        for (std::uint32_t x = 0; x < kAcross; ++x)
            EXPECT_EQ(places.bytes()[y * kAcross + x], row[x]) << x << ", " << y;
    const PictureRect whole{0, 0, kAcross, kDown};
    const TileMask two = places.findTiles(whole, whole, FinerPlaces::kFew);
    const TileMask four = places.findTiles(whole, whole, FinerPlaces::kMany);
    ASSERT_EQ(two.across, (kAcross + 1) / 2);
    ASSERT_EQ(four.across, kAcross);
    for (std::uint32_t x = 0; x < kAcross; ++x) {
        EXPECT_EQ(two.wants(x / 2, (kDown - 1) / 2), x / 2 == 1) << x;
        EXPECT_EQ(four.wants(x, kDown - 1), row[x] == many) << x;
    }
    EXPECT_EQ(places.boundsIn(whole, FinerPlaces::kFew).width, 4u);
    EXPECT_EQ(places.boundsIn(whole, FinerPlaces::kMany).width, 6u);
    places.takeMany();
    EXPECT_EQ(places.boundsIn(whole, FinerPlaces::kFew).width, 0u);
}

TEST(EdgesOf, PicturesAreCounted) {
    const Representation r = scene("sample:dna", Style::spacefill);
    RenderSettings s = settings(r, 96, Projection::orthographic);
    s.supersample = RenderSettings::kEdges;
    s.tuning.countFragments = true;
    const auto countTriangles = [&](Visibility path, const std::string& pass) {
        ValidatedRenderer renderer(path, r);
        renderer->render(s);
        for (const PassCount& count : renderer->stats().passes)
            if (count.name == pass) return count.shadedFragments;
        return std::uint64_t{0};
    };
    const std::uint64_t covered = countTriangles(Visibility::tiles, "impostor colour");
    const std::uint64_t edges = countTriangles(Visibility::tiles, "edge samples");
    EXPECT_GT(covered, 2000u);
    EXPECT_GT(edges, covered / 4);
    EXPECT_LT(edges, covered * 3);
    // One sample per pixel, and once more where tiles add samples; or 16 in blocks where colours change.
    s = settings(r, 96, Projection::orthographic, {20, 0, 0}, 6);
    s.supersample = RenderSettings::kEdges;
    s.tuning.countFragments = true;
    const std::uint64_t near = countTriangles(Visibility::tiles, "impostor colour");
    const std::uint64_t deferred = countTriangles(Visibility::deferred, "impostor colour");
    EXPECT_GE(deferred, near * 2);
    EXPECT_LT(deferred, near * (addsByCompute() ? 3 : 17));
    EXPECT_EQ(countTriangles(Visibility::deferred, "edge samples") > near / 4, addsByCompute());
}

}  // namespace
}  // namespace nacre::test
