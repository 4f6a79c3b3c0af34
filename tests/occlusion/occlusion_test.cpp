// Baked occlusion against ray-traced, cosine-weighted occlusion.

#include <map>

#include "tests/occlusion/scenes.h"
#include "tests/occlusion/traced_points.h"

namespace nacre::test {
namespace {

Representation loneSphere() {
    Representation r;
    r.spheres = {{{0, 0, 0}, 1.7f}};
    r.sphereLooks = {{0xffffffff, 1}};
    r.radius = 1.7;
    r.drawnAtoms = 1;
    return r;
}

TEST(Occlusion, OfALoneSphereIsOneEverywhere) {
    const Representation r = loneSphere();
    for (const Visibility visibility : {Visibility::encoded, Visibility::fragdepth}) {
        ValidatedRenderer renderer(visibility, r);
        RenderSettings s = settings(r, 128, Projection::orthographic);
        for (const int directions : {1, 8, 128}) {
            s.occlusion.directions = directions;
            float least = 2;
            for (const float value : renderer->layers(s).occlusion) least = std::min(least, value);
            // With one direction the hemisphere behind it gets no light at all.
            if (directions > 1) {
                EXPECT_GE(least, 1 - 1.0f / 255) << directions << " directions";
            }
        }
    }
}

class OcclusionOf : public testing::TestWithParam<OcclusionScene> {};

TEST_P(OcclusionOf, MoleculeIsNearTheRayTraced) {
    NACRE_NEEDS_DATA(GetParam().file);
    expectNearRays(makeScene(GetParam()), 0.035);
}

std::string sceneName(const testing::TestParamInfo<OcclusionScene>& test) { return testName(test.param.name); }
INSTANTIATE_TEST_SUITE_P(Molecules, OcclusionOf, testing::ValuesIn(kSmallOcclusionScenes), sceneName);
INSTANTIATE_TEST_SUITE_P(Large, OcclusionOf, testing::ValuesIn(kLargeOcclusionScenes), sceneName);  // on one driver

TEST(Occlusion, OfMoreAtomsThanPatchesFitIsOneValueAnAtom) {
    const Representation r = scene("sample:dna", Style::spacefill);
    ValidatedRenderer renderer(Visibility::encoded, r);
    RenderSettings s = settings(r, 200, Projection::orthographic);
    s.occlusion.directions = 64;
    const LayerPicture fine = renderer->layers(s);
    s.occlusion.bytes = 60'000;  // half for depth maps; the rest holds one texel an atom, not sixteen
    const LayerPicture coarse = renderer->layers(s);
    EXPECT_EQ(renderer->stats().occlusion.patchTexels, 1u);
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

TEST(Occlusion, OfLinesAloneHasNoAtlas) {
    const Representation r = scene("sample:glucose", Style::line);
    ValidatedRenderer renderer(Visibility::encoded, r, ValidatedRenderer::fresh);
    RenderSettings s = settings(r, 64, Projection::orthographic);
    s.occlusion.directions = 0;
    const Picture off = renderer->render(s);
    s.occlusion.directions = 16;
    const Picture on = renderer->render(s);
    EXPECT_EQ(on.rgba, off.rgba);
    EXPECT_EQ(renderer->stats().occlusion.directions, 0);
    EXPECT_EQ(renderer->advanceOcclusion(s, 1), 1);
}

TEST(Occlusion, OnAndOffDrawTheSameSurface) {
    const Representation r = scene("sample:dna", Style::spacefill);
    ValidatedRenderer renderer(Visibility::encoded, r);
    RenderSettings s = settings(r, 128, Projection::orthographic);
    const LayerPicture off = renderer->layers(s);
    s.occlusion.directions = 16;
    const LayerPicture on = renderer->layers(s);
    EXPECT_EQ(off.id, on.id);
    EXPECT_EQ(off.z, on.z);
    EXPECT_NE(off.occlusion, on.occlusion);
}

}  // namespace
}  // namespace nacre::test
