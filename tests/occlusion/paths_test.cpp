// What the occlusion of a scene must not depend on: the path of the depth maps, and how the work is cut.

#include "tests/occlusion/scenes.h"

namespace nacre::test {
namespace {

constexpr OcclusionScene kScenes[] = {{"sample:dna", "sample:dna", Style::spacefill},
                                      {"glucose", "sample:glucose", Style::ballAndStick}};

class OcclusionOfScene : public testing::TestWithParam<OcclusionScene> {
protected:
    Representation scene_ = sceneOf(GetParam());
    RenderSettings settings_ = [this] {
        RenderSettings s = settings(scene_, 200, Projection::orthographic);
        s.occlusion.directions = 70;  // no multiple of a batch
        return s;
    }();
    std::vector<float> baked(OcclusionMaps maps) {
        ValidatedRenderer renderer(Visibility::automatic);
        renderer->setScene(scene_);
        settings_.occlusion.maps = maps;
        return renderer->layers(settings_).occlusion;
    }
};

TEST_P(OcclusionOfScene, IsTheSameByEveryPathOfTheDepthMaps) {
    const std::vector<float> splat = baked(OcclusionMaps::splat), fragdepth = baked(OcclusionMaps::fragdepth),
                             encoded = baked(OcclusionMaps::encoded);
    for (std::size_t i = 0; i < splat.size(); ++i) {
        ASSERT_NEAR(splat[i], fragdepth[i], 1.01 / 255) << i;
        ASSERT_NEAR(splat[i], encoded[i], 1.01 / 255) << i;
    }
}

TEST_P(OcclusionOfScene, IsTheSameHoweverTheWorkIsCut) {
    const std::vector<float> atOnce = baked(OcclusionMaps::automatic);
    ValidatedRenderer renderer(Visibility::automatic);
    renderer->setScene(scene_);
    double share = 0;
    for (int frame = 0; share < 1 && frame < 200; ++frame) {
        const double next = renderer->advanceOcclusion(settings_, frame % 3 == 0 ? 0.0 : 5.0);
        ASSERT_GT(next, share);
        share = next;
    }
    EXPECT_EQ(share, 1);
    EXPECT_EQ(renderer->layers(settings_).occlusion, atOnce);
}

INSTANTIATE_TEST_SUITE_P(Scenes, OcclusionOfScene, testing::ValuesIn(kScenes),
                         [](const auto& test) { return testName(test.param.name); });

TEST(OcclusionBudget, HoldsWithCoarserPatchesAndSmallerMaps) {
    const Representation r = scene("sample:dna", Style::spacefill);
    std::uint32_t patch = 1000;
    for (const std::uint64_t budget : {64u << 20, 4u << 20, 1u << 20, 300u << 10, 60u << 10}) {
        ValidatedRenderer renderer(Visibility::automatic);
        renderer->setScene(r);
        RenderSettings s = settings(r, 64, Projection::orthographic);
        s.occlusion.directions = 16;
        s.occlusion.bytes = budget;
        renderer->layers(s);
        const OcclusionStats stats = renderer->stats().occlusion;
        EXPECT_LE(stats.bytes, budget);
        EXPECT_LE(stats.patchTexels, patch);
        patch = stats.patchTexels;
    }
    EXPECT_EQ(patch, 1u);
}

TEST(OcclusionBudget, TooSmallIsAnErrorThatSaysWhatIsNeeded) {
    const Representation r = scene("sample:dna", Style::spacefill);
    Renderer renderer(DeviceOptions{});
    renderer.setScene(r);
    RenderSettings s = settings(r, 64, Projection::orthographic);
    s.occlusion.directions = 16;
    s.occlusion.bytes = 1000;
    try {
        renderer.layers(s);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("--occlusion-memory"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace nacre::test
