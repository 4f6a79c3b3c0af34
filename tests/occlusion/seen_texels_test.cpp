// A bake for one picture alone: the same picture, for fewer questions.

#include "engine/occlusion/seen_texels.h"

#include <gtest/gtest.h>

#include <random>
#include <string_view>
#include <utility>

#include "engine/occlusion/open_texels.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

struct Case {
    const char* name;
    Style style;
    std::uint32_t detail;
    double most;                     ///< of all questions
    double mostOfRasterised = most;  ///< with maps by triangles, which tell of no hidden triangles
};

class Once : public testing::TestWithParam<Case> {};

TEST_P(Once, DrawsTheSamePictureForFewerQuestions) {
    const Representation r = scene("sample:dna", GetParam().style);
    RenderSettings s = settings(r, 200, Projection::orthographic);
    s.occlusion.directions = 48;
    s.occlusion.detail = GetParam().detail;
    Renderer renderer{DeviceOptions{}};
    for (const glm::dvec3 turn : {glm::dvec3(0), glm::dvec3(35, 110, -20)}) {
        s.view.rotation = rotationMatrix(turn);
        renderer.setScene({});  // which forgets the bake
        renderer.setScene(r);
        s.occlusion.once = false;
        const Picture whole = renderer.render(s);
        const std::uint64_t asked = renderer.stats().occlusion.asked;
        s.occlusion.once = true;
        const Picture once = renderer.render(s);
        EXPECT_EQ(once.rgba, whole.rgba);
        const OcclusionStats& bake = renderer.stats().occlusion;
        const bool byTiles = std::string_view(bake.maps) == "tiles";
        EXPECT_LT(static_cast<double>(bake.asked),
                  (byTiles ? GetParam().most : GetParam().mostOfRasterised) * static_cast<double>(asked));
        EXPECT_GT(renderer.stats().occlusion.asked, 0u);
        // Another view needs other texels.
        s.view.rotation = rotationMatrix(turn + glm::dvec3(0, 180, 0));
        const Picture behind = renderer.render(s);
        s.occlusion.once = false;
        EXPECT_EQ(renderer.render(s).rgba, behind.rgba);
    }
}

/// Spheres that others hide have no texels, in scenes that are not searched whole for an estimate.
TEST(OnceOfMany, DrawsTheSamePictureWithoutHiddenSpheres) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-14, 14);
    Representation r;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        r.spheres.push_back({{place(random), place(random), place(random)}, 1.7f});
        r.sphereLooks.push_back({0xff4060c0u, i + 1});
    }
    r.radius = 26;
    ASSERT_FALSE(samplesAll(r));
    RenderSettings s = settings(r, 160, Projection::orthographic, {20, 35, 0});
    s.occlusion.directions = 32;
    s.occlusion.detail = 8;
    const auto draw = [&](bool once) {
        Renderer renderer{DeviceOptions{}};
        renderer.setScene(r);
        s.occlusion.once = once;
        Picture picture = renderer.render(s);
        return std::pair(picture.rgba, renderer.stats().occlusion.asked);
    };
    const auto [whole, asked] = draw(false);
    const auto [seen, fewer] = draw(true);
    EXPECT_EQ(seen, whole);
    EXPECT_GT(fewer, 0u);
    EXPECT_LT(static_cast<double>(fewer), 0.5 * static_cast<double>(asked));
}

INSTANTIATE_TEST_SUITE_P(
    Styles, Once,
    testing::Values(Case{"spacefill", Style::spacefill, 12, 0.92}, Case{"odd", Style::spacefill, 14, 0.92},
                    Case{"fine", Style::spacefill, 32, 0.75}, Case{"sticks", Style::ballAndStick, 16, 0.95},
                    Case{"cartoon", Style::cartoon, 16, 0.75}, Case{"surface", Style::surface, 16, 0.55, 0.75}),
    [](const auto& test) { return std::string(test.param.name); });

// Where a picture may show any side, or the bake is kept for others.
TEST(OnlyViewDirection, IsNoneWhereOtherSidesMayShow) {
    RenderSettings s;
    EXPECT_FALSE(onlyViewDirection(s));
    s.occlusion.once = true;
    ASSERT_TRUE(onlyViewDirection(s));
    EXPECT_EQ(onlyViewDirection(s)->towards, glm::dvec3(0, 0, 1));
    RenderSettings cut = s, kept = s, near = s, debug = s;
    cut.effects.clip.near = -3;
    kept.occlusion.cache = "/somewhere";
    near.view.projection = Projection::perspective;
    debug.debug = DebugView::depth;
    for (const RenderSettings& other : {cut, kept, near, debug}) EXPECT_FALSE(onlyViewDirection(other));
}

}  // namespace
}  // namespace nacre::test
