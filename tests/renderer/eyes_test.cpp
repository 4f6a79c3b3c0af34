// Two eyes in one frame: each has the very pixels, atoms and depths of a frame of its own, on every path.

#include <algorithm>

#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

/// A view of two eyes: parallel, 4 Å apart.
View makeEyes(View view) {
    constexpr double kApart = 4;
    return paired(fromAside(view, -kApart / 2, view.eyeDistance), fromAside(view, kApart / 2, view.eyeDistance));
}

std::string describeViews(const Renderer& renderer) {
    for (const Decision& decision : renderer.decisions())
        if (decision.what == "views") return decision.how + ": " + decision.why;
    return {};
}

struct EyesCase {
    const char* name;
    Style style;
};
void PrintTo(const EyesCase& c, std::ostream* out) { *out << c.name; }

/// So that lavapipe draws both eyes in one frame, too; what it clips is skipped below.
class Multiview : public testing::Environment {
public:
    void SetUp() override { setenv("NACRE_MULTIVIEW", "1", 1); }
    void TearDown() override { unsetenv("NACRE_MULTIVIEW"); }
};
testing::Environment* const multiview = testing::AddGlobalTestEnvironment(new Multiview);

class Eyes : public SharedRenderers<EyesCase> {
protected:
    /// Draws both eyes at once, and one after the other. @returns what was said of the former
    std::string compare(ValidatedRenderer& validated, RenderSettings s, const std::string& what) {
        Renderer& renderer = *validated.operator->();
        s.supersample = 2;
        const std::array<Picture, 2> pictures = renderer.renderEyes(s);
        const std::string how = describeViews(renderer);
        const std::array<LayerPicture, 2> layers = renderer.layersOfEyes(s);
        RenderSettings one = s;
        for (std::size_t i = 0; i < 2; ++i) {
            one.view = i == 0 ? s.view : otherView(s.view);
            one.view.other.reset();
            EXPECT_EQ(pictures[i].rgba, renderer.render(one).rgba) << what << ", eye " << i;
            const LayerPicture single = renderer.layers(one);
            EXPECT_GT(std::ranges::count_if(single.id, [](std::uint32_t id) { return id > 0; }), 1000) << what;
            EXPECT_EQ(layers[i].id, single.id) << what << ", eye " << i;
            EXPECT_EQ(layers[i].z, single.z) << what << ", eye " << i;
            EXPECT_EQ(layers[i].normal, single.normal) << what << ", eye " << i;
            EXPECT_EQ(layers[i].occlusion, single.occlusion) << what << ", eye " << i;
        }
        EXPECT_NE(layers[0].id, layers[1].id) << what;
        return how;
    }
};

TEST_P(Eyes, HaveThePixelsOfFramesOfTheirOwn) {
    const Representation r = scene("sample:dna", GetParam().style);
    for (const Visibility visibility : devicePaths()) {
        ValidatedRenderer& renderer = sharedRenderer(visibility, r);
        RenderSettings s = settings(r, 160, Projection::perspective, {75, -40, 120});
        s.view = makeEyes(s.view);
        for (const bool merge : {true, false}) {
            s.tuning.merge = merge;
            const std::string what = visibilityName(visibility) + std::string(merge ? "" : ", unmerged");
            const std::string how = compare(renderer, s, what);
            const bool tiles = visibility == Visibility::tiles;
            EXPECT_TRUE(how.starts_with(tiles ? "a frame for each eye: tiles" : "both eyes in one frame"))
                << what << how;
        }
        // Part of the scene is beside one eye's picture, and not beside the other's. lavapipe 22.3 draws large
        // triangles that it clips for the first view alone, so that it draws two views at once only if it is told to.
        if (GetParam().style == Style::cartoon && renderer->stats().device.driver.find("llvmpipe") != std::string::npos)
            continue;
        s.tuning.merge = true;
        s.view.pan.x += 0.4 * s.view.width / s.view.pixelsPerAngstrom;
        compare(renderer, s, visibilityName(visibility) + std::string(", aside"));
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Eyes,
                         testing::Values(EyesCase{"spheres", Style::spacefill}, EyesCase{"sticks", Style::ballAndStick},
                                         EyesCase{"triangles", Style::cartoon}),
                         [](const auto& tested) { return std::string(tested.param.name); });

class EyesOfOthers : public SharedRenderers<Visibility> {
protected:
    void SetUp() override {
        if (!isDevicePath(GetParam())) GTEST_SKIP() << testedDevice().name << " does not draw by this path";
    }
};

TEST_P(EyesOfOthers, CopiesOfAnAssembly) {
    Molecule m = molecule("sample:dna");
    addCopies(m, {{0, 0, 0}, {30, 0, 0}, {0, 5, 25}});
    RepresentationOptions look{.style = Style::spacefill, .color = ColorScheme::element, .assembly = "1"};
    const Representation r = represent(m, drawnAtoms(m), look);
    ValidatedRenderer& renderer = sharedRenderer(GetParam(), r);
    RenderSettings s = settings(r, 160, Projection::perspective, {10, 20, 30});
    s.view = makeEyes(s.view);
    const std::array<LayerPicture, 2> layers = renderer->layersOfEyes(s);
    const std::string how = describeViews(*renderer.operator->());
    EXPECT_TRUE(how.starts_with(GetParam() == Visibility::tiles ? "a frame for each eye" : "both eyes in one frame"))
        << how;
    for (std::size_t i = 0; i < 2; ++i) {
        RenderSettings one = s;
        one.view = i == 0 ? s.view : otherView(s.view);
        one.view.other.reset();
        const LayerPicture single = renderer->layers(one);
        EXPECT_EQ(layers[i].id, single.id);
        EXPECT_EQ(layers[i].z, single.z);
        EXPECT_EQ(layers[i].rgba, single.rgba);
    }
}

TEST_P(EyesOfOthers, WhatOneFrameCannotDrawIsTwoFramesAndSaidSo) {
    const Representation r = scene("sample:dna", Style::spacefill);
    ValidatedRenderer& renderer = sharedRenderer(GetParam(), r);
    RenderSettings s = settings(r, 96, Projection::perspective, {10, 20, 30});
    s.view = makeEyes(s.view);
    s.supersample = 1;
    s.effects.shadow.strength = 0.6;
    const std::array<Picture, 2> eyes = renderer->renderEyes(s);
    const std::string how = describeViews(*renderer.operator->());
    const char* why = GetParam() == Visibility::tiles ? "a frame for each eye: tiles" : "a frame for each eye: shadows";
    EXPECT_TRUE(how.starts_with(why)) << how;
    for (std::size_t i = 0; i < 2; ++i) {
        RenderSettings one = s;
        one.view = i == 0 ? s.view : otherView(s.view);
        one.view.other.reset();
        EXPECT_EQ(eyes[i].rgba, renderer->render(one).rgba);
    }
}

INSTANTIATE_TEST_SUITE_P(Paths, EyesOfOthers, testing::ValuesIn(kEveryPath),
                         [](const auto& tested) { return testName(visibilityName(tested.param)); });

}  // namespace
}  // namespace nacre::test
