// Parts of a picture are the picture: no seam, whatever the path, the samples and the effects.

#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

struct PartCase {
    const char* name;
    const char* sample;
    Style style;
    Projection projection;
    std::uint32_t supersample;
    bool fine;
    double lens = 0;
};
void PrintTo(const PartCase& c, std::ostream* out) { *out << c.name; }

class Parts : public SharedRenderers<PartCase> {};

TEST_P(Parts, AreThePictureToTheBit) {
    const Representation r = scene(GetParam().sample, GetParam().style);
    Camera camera;
    camera.projection = GetParam().projection;
    camera.rotationDegrees = {20, 30, 10};
    camera.zoom = 1.6;
    camera.pan = {0.71, -1.3};
    RenderSettings s;
    s.view = makeView(camera, r.radius, 147, 101);
    s.supersample = GetParam().supersample;
    s.fine = GetParam().fine;
    s.background = {0.2f, 0.3f, 0.9f, 0.5f};
    s.occlusion.directions = 0;
    s.effects.contours.width = 2.5;
    s.effects.depthOfField.strength = GetParam().lens;
    s.effects.shadow.strength = 0.7;
    s.effects.fog.range = Fog::Range::automatic;
    s.effects.clip = {-0.4 * r.radius, 0.7 * r.radius, Clip::Cap::hatched};
    for (const Visibility path : {Visibility::tiles, Visibility::encoded}) {
        SCOPED_TRACE(static_cast<int>(path));
        ValidatedRenderer& renderer = sharedRenderer(path, r);
        const Picture whole = renderer->render(s);
        const std::uint64_t covered = renderer->stats().coveredPixels;
        std::size_t differing = 0, inked = 0;
        std::uint64_t coveredByParts = 0;
        constexpr std::uint32_t kSide = 64;
        for (std::uint32_t top = 0; top < whole.height; top += kSide)
            for (std::uint32_t left = 0; left < whole.width; left += kSide) {
                const PictureRect rect{left, top, std::min(kSide, whole.width - left),
                                       std::min(kSide, whole.height - top)};
                const Picture part = renderer->renderPart(s, rect);
                ASSERT_EQ(part.rgba.size(), std::size_t{4} * rect.width * rect.height);
                coveredByParts += renderer->stats().coveredPixels;
                for (std::size_t y = 0; y < rect.height; ++y)
                    for (std::size_t x = 0; x < 4 * rect.width; ++x) {
                        const float a = whole.rgba[4 * ((top + y) * whole.width + left) + x];
                        differing += a != part.rgba[4 * y * rect.width + x];
                        inked += x % 4 == 3 && a > 0.6f;
                    }
            }
        EXPECT_EQ(differing, 0u);
        EXPECT_EQ(coveredByParts, covered);
        EXPECT_GT(inked, 3000u);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Pictures, Parts,
    testing::Values(
        PartCase{"edges", "sample:dna", Style::spacefill, Projection::orthographic, RenderSettings::kEdges, false},
        PartCase{"edges_of_sticks_in_perspective", "sample:glucose", Style::ballAndStick, Projection::perspective,
                 RenderSettings::kEdges, false},
        PartCase{"fine", "sample:glucose", Style::licorice, Projection::orthographic, RenderSettings::kEdges, true},
        PartCase{"through_a_lens", "sample:dna", Style::spacefill, Projection::perspective, RenderSettings::kEdges,
                 true, 0.2},
        PartCase{"nine_samples", "sample:dna", Style::spacefill, Projection::perspective, 3, false}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Picture, WhatIsFineHasMoreThan256Levels) {
    const Representation r = scene("sample:dna", Style::spacefill);
    RenderSettings s = settings(r, 96, Projection::orthographic);
    ValidatedRenderer renderer(Visibility::tiles, r);
    const Picture coarse = renderer->render(s);
    s.fine = true;
    const Picture fine = renderer->render(s);
    std::set<float> levels;
    double worst = 0;
    for (std::size_t i = 0; i < fine.rgba.size(); ++i) {
        levels.insert(fine.rgba[i]);
        worst = std::max(worst, std::abs(double{fine.rgba[i]} - double{coarse.rgba[i]}));
    }
    EXPECT_GT(levels.size(), 2000u);
    EXPECT_LT(worst, 0.006);  // half a step of sRGB at its steepest, and the rounding of its codes
}

}  // namespace
}  // namespace nacre::test
