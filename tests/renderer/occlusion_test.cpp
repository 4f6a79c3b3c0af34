// Baked occlusion against ray-traced, cosine-weighted occlusion.

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <random>

#include "tests/reference/ambient_occlusion.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

struct Difference {
    double rootMeanSquare = 0, mean = 0, worst = 0;
    std::size_t points = 0;
};

/// Compares at random covered pixels of random orthographic views.
Difference compareOcclusion(Renderer& renderer, const Representation& r, RenderSettings s, std::size_t points,
                            std::size_t rays) {
    const reference::OcclusionScene truth(r);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> degrees(0, 360);
    constexpr std::size_t kViews = 10;
    Difference d;
    double squares = 0, sum = 0;
    for (std::size_t v = 0; v < kViews; ++v) {
        s.view.rotation = rotationMatrix({degrees(random), degrees(random), degrees(random)});
        const LayerPicture p = renderer.layers(s);
        std::uniform_int_distribution<std::size_t> pixel(0, p.id.size() - 1);
        for (std::size_t n = 0; n < points / kViews;) {
            const std::size_t i = pixel(random);
            if (p.id[i] == 0) continue;
            ++n;
            const glm::dvec3 seen((static_cast<double>(i % p.width) + 0.5 - p.width / 2.0) / s.view.pixelsPerAngstrom,
                                  (p.height / 2.0 - static_cast<double>(i / p.width) - 0.5) / s.view.pixelsPerAngstrom,
                                  s.view.radius - p.z[i]);
            const glm::dvec3 normal(p.normal[3 * i], p.normal[3 * i + 1], p.normal[3 * i + 2]);
            const glm::dmat3 back = glm::transpose(s.view.rotation);
            const double traced = truth.occlusionAt(back * seen, glm::normalize(back * normal), rays);
            const double difference = p.occlusion[i] - traced;
            squares += difference * difference;
            sum += difference;
            d.worst = std::max(d.worst, std::abs(difference));
            ++d.points;
        }
    }
    d.rootMeanSquare = std::sqrt(squares / static_cast<double>(d.points));
    d.mean = sum / static_cast<double>(d.points);
    return d;
}

Representation loneSphere() {
    Representation r;
    r.spheres = {{{0, 0, 0}, 1.7f}};
    r.sphereLooks = {{0xffffffff, 1, 0}};
    r.radius = 1.7;
    r.drawnAtoms = 1;
    return r;
}

TEST(Occlusion, OfALoneSphereIsOneEverywhere) {
    const Representation r = loneSphere();
    for (const Visibility visibility : {Visibility::encoded, Visibility::fragdepth}) {
        ValidatedRenderer renderer(visibility);
        renderer->setScene(r);
        RenderSettings s = settings(r, 128, Projection::orthographic);
        for (const int directions : {1, 8, 128}) {
            s.occlusionDirections = directions;
            float least = 2;
            for (const float value : renderer->layers(s).occlusion) least = std::min(least, value);
            // With one direction the hemisphere behind it gets no light at all.
            if (directions > 1) {
                EXPECT_GE(least, 1 - 1.0f / 255) << directions << " directions";
            }
        }
    }
}

class OcclusionOf : public testing::TestWithParam<std::pair<const char*, Style>> {};

TEST_P(OcclusionOf, MoleculeIsNearTheRayTraced) {
    const auto [file, style] = GetParam();
    if (!std::string(file).starts_with("sample:")) NACRE_NEEDS_DATA();
    const Representation r = scene(file, style);
    ValidatedRenderer renderer(Visibility::automatic);
    renderer->setScene(r);
    RenderSettings s = settings(r, 384, Projection::orthographic);
    s.occlusionDirections = 128;
    const Difference d = compareOcclusion(*renderer.operator->(), r, s, 2000, 4096);
    std::cout << file << ": RMS " << d.rootMeanSquare << ", mean " << d.mean << ", worst " << d.worst << " over "
              << d.points << " points\n";
    EXPECT_EQ(d.points, 2000u);
    EXPECT_LE(d.rootMeanSquare, 0.05);
    EXPECT_LE(std::abs(d.mean), 0.02);
}

INSTANTIATE_TEST_SUITE_P(Molecules, OcclusionOf,
                         testing::Values(std::pair{"sample:dna", Style::spacefill},
                                         std::pair{"1bna.pdb", Style::spacefill},
                                         std::pair{"sample:glucose", Style::ballAndStick}));

TEST(Occlusion, OfMoreAtomsThanPatchesFitIsOneValueAnAtom) {
    const Representation r = scene("sample:dna", Style::spacefill);
    ValidatedRenderer renderer(Visibility::encoded);
    renderer->setScene(r);
    RenderSettings s = settings(r, 200, Projection::orthographic);
    s.occlusionDirections = 64;
    const LayerPicture fine = renderer->layers(s);
    s.occlusionBytes = 486 * 16;  // room for one texel an atom, not for sixteen
    const LayerPicture coarse = renderer->layers(s);
    EXPECT_EQ(renderer->stats().patchTexels, 1u);
    // Every pixel of an atom has its one value, and on the whole it is as light as with patches.
    std::map<std::uint32_t, float> values;
    double sumFine = 0, sumCoarse = 0;
    for (std::size_t i = 0; i < fine.id.size(); ++i) {
        if (fine.id[i] == 0) continue;
        const float value = values.emplace(fine.id[i], coarse.occlusion[i]).first->second;
        ASSERT_EQ(coarse.occlusion[i], value);
        sumFine += fine.occlusion[i];
        sumCoarse += coarse.occlusion[i];
    }
    EXPECT_GT(values.size(), 100u);
    EXPECT_NEAR(sumCoarse / sumFine, 1.0, 0.25);
}

TEST(Occlusion, OnAndOffDrawTheSameSurface) {
    const Representation r = scene("sample:dna", Style::spacefill);
    ValidatedRenderer renderer(Visibility::encoded);
    renderer->setScene(r);
    RenderSettings s = settings(r, 128, Projection::orthographic);
    const LayerPicture off = renderer->layers(s);
    s.occlusionDirections = 16;
    const LayerPicture on = renderer->layers(s);
    EXPECT_EQ(off.id, on.id);
    EXPECT_EQ(off.z, on.z);
    EXPECT_NE(off.occlusion, on.occlusion);
}

}  // namespace
}  // namespace nacre::test
