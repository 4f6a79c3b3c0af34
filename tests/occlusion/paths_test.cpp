// What the occlusion of a scene must not depend on: the path of the depth maps, and how the work is cut.

#include <chrono>
#include <thread>

#include "engine/occlusion/bake.h"
#include "tests/occlusion/scenes.h"
#include "tests/support/error_text.h"

namespace nacre::test {
namespace {

constexpr OcclusionScene kScenes[] = {{"sample:dna", "sample:dna", Style::spacefill},
                                      {"glucose", "sample:glucose", Style::ballAndStick}};

class OcclusionOfScene : public testing::TestWithParam<OcclusionScene> {
protected:
    Representation scene_ = makeScene(GetParam());
    RenderSettings settings_ = [this] {
        RenderSettings s = settings(scene_, 200, Projection::orthographic);
        s.occlusion.directions = 38;  // no multiple of a batch
        return s;
    }();
    std::vector<float> baked(OcclusionMaps maps, ValidatedRenderer::Age age = ValidatedRenderer::any) {
        ValidatedRenderer renderer(Visibility::automatic, age);
        renderer->setScene(scene_);
        settings_.occlusion.maps = maps;
        return renderer->layers(settings_).occlusion;
    }
    /// By compute, an invocation per primitive: as on GPUs.
    std::vector<float> byCompute() {
        setenv("NACRE_DEVICE_LISTS", "1", 1);
        std::vector<float> occlusion = baked(OcclusionMaps::tiles, ValidatedRenderer::fresh);
        unsetenv("NACRE_DEVICE_LISTS");
        return occlusion;
    }
    /// As on drivers that load uniforms for every invocation.
    std::vector<float> byPairs() {
        setenv("NACRE_BAKE_BY_PAIRS", "1", 1);
        std::vector<float> occlusion = baked(OcclusionMaps::fragdepth, ValidatedRenderer::fresh);
        unsetenv("NACRE_BAKE_BY_PAIRS");
        return occlusion;
    }
};

TEST_P(OcclusionOfScene, IsTheSameByEveryPathOfTheDepthMaps) {
    for (const std::uint64_t bytes : {OcclusionSettings::kUsualBytes, std::uint64_t{300} << 10}) {
        settings_.occlusion.bytes = bytes;
        const std::vector<float> tiles = baked(OcclusionMaps::tiles), fragdepth = baked(OcclusionMaps::fragdepth),
                                 encoded = baked(OcclusionMaps::encoded);
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            ASSERT_NEAR(tiles[i], fragdepth[i], 1.01 / 255) << i;
            ASSERT_NEAR(tiles[i], encoded[i], 1.01 / 255) << i;
        }
        const std::vector<float> compute = byCompute();
        for (std::size_t i = 0; i < compute.size(); ++i) ASSERT_NEAR(compute[i], fragdepth[i], 1.01 / 255) << i;
        // With directions of fewer words, a row is found out by the shader.
        const std::vector<float> pairs = byPairs();
        for (std::size_t i = 0; i < pairs.size(); ++i) ASSERT_NEAR(pairs[i], fragdepth[i], 1.01 / 255) << i;
    }
}

TEST_P(OcclusionOfScene, OfMirroredCopiesIsTheSameByPairs) {
    Molecule m = molecule(GetParam().file);
    addCopies(m, {glm::vec3(24, 0, 0), glm::vec3(3, 20, 4), glm::vec3(-20, 11, 7)});
    m.assemblies[0].parts[0].transforms[1][0].x = m.assemblies[0].parts[0].transforms[3][0].x = -1;
    RepresentationOptions options{.style = GetParam().style, .color = ColorScheme::element, .assembly = "1"};
    scene_ = represent(m, drawnAtoms(m), options);
    EXPECT_EQ(byPairs(), baked(OcclusionMaps::fragdepth));
}

/// At once, a GPU takes the atlas with the last batch.
TEST_P(OcclusionOfScene, IsTheSameHoweverTheWorkIsCut) {
    for (const int directions : {38, 32, 5}) {  // 32: deep texels are dropped after the last one
        settings_.occlusion.directions = directions;
        const std::vector<float> atOnce = baked(OcclusionMaps::automatic);
        ValidatedRenderer renderer(Visibility::automatic, scene_);
        double share = 0;
        for (int frame = 0; share < 1 && frame < 200; ++frame) {
            const double next = renderer->advanceOcclusion(settings_, frame % 3 == 0 ? 0.0 : 5.0);
            ASSERT_GT(next, share);
            share = next;
        }
        EXPECT_EQ(share, 1);
        EXPECT_EQ(renderer->layers(settings_).occlusion, atOnce) << directions;
        settings_.occlusion.bytes = 300 << 10;
    }
}

/// Depth maps of nothing.
TEST(OcclusionOfTranslucentShapes, IsOpenHoweverTheWorkIsCut) {
    Representation r = scene("sample:dna", Style::ballAndStick);
    const auto fade = [](std::uint32_t& color) { color = (color & 0xffffffu) | 0xc0000000u; };
    for (SphereLook& look : r.sphereLooks) fade(look.color);
    for (CylinderLook& look : r.cylinderLooks) fade(look.colorA), fade(look.colorB);
    RenderSettings s = settings(r, 96, Projection::orthographic);
    s.occlusion.directions = 5;
    for (const OcclusionMaps maps : {OcclusionMaps::fragdepth, OcclusionMaps::encoded, OcclusionMaps::automatic}) {
        s.occlusion.maps = maps;
        ValidatedRenderer renderer(Visibility::automatic, r);
        int slices = 0;
        while (renderer->advanceOcclusion(s, 0.0) < 1) ASSERT_LT(++slices, 1000);
        const LayerPicture seen = renderer->layers(s);
        EXPECT_EQ(std::ranges::count_if(seen.occlusion, [](float open) { return open < 0.99f; }), 0);
        EXPECT_GT(std::ranges::count_if(seen.id, [](std::uint32_t id) { return id != 0; }), 500);
    }
}

/// Every atom a little farther from the middle.
Representation swollen(Representation scene) {
    for (Sphere& s : scene.spheres) s.center *= 1.1f;
    for (Cylinder& c : scene.cylinders) c.a *= 1.1f, c.b *= 1.1f;
    return scene;
}

TEST_P(OcclusionOfScene, OfAMovedSceneIsThatOfItsNewPlaces) {
    settings_.occlusion.directions = 8;
    const Representation moved = swollen(scene_);
    ValidatedRenderer fresh(Visibility::automatic, moved);
    const std::vector<float> expected = fresh->layers(settings_).occlusion;
    ValidatedRenderer renderer(Visibility::automatic, scene_);
    const auto advance = [&](bool moving) { return renderer->advanceOcclusion(settings_, {4, 0, moving}); };
    while (advance(false) < 1) {
    }
    ASSERT_NE(renderer->layers(settings_).occlusion, expected);
    // Beside frames: it comes by and by, of wherever the scene stands when it begins, and is right once that is at
    // rest.
    renderer->moveScene(moved);
    EXPECT_LT(advance(true), 1);
    renderer->moveScene(scene_);
    EXPECT_LT(advance(true), 1);
    renderer->moveScene(moved);
    while (advance(false) < 1) {
    }
    EXPECT_EQ(renderer->layers(settings_).occlusion, expected);
    // For a picture at once, whatever was under way.
    renderer->moveScene(scene_);
    advance(true);
    renderer->moveScene(moved);
    EXPECT_EQ(renderer->layers(settings_).occlusion, expected);
    // Coarser while it moves.
    settings_.occlusion.directions = 64;
    settings_.occlusion.moving = true;
    renderer->moveScene(scene_);
    EXPECT_LT(advance(true), 1);
    renderer->moveScene(moved);
    while (advance(false) < 1) {
    }
    EXPECT_EQ(renderer->stats().occlusion.done, GetParam().style == Style::spacefill ? 32 : 12);
    EXPECT_LE(renderer->stats().occlusion.patchTexels, 10u);
    settings_.occlusion.directions = 8;
    settings_.occlusion.moving = false;
    EXPECT_LT(advance(false), 1);
    while (advance(false) < 1) {
    }
    EXPECT_EQ(renderer->layers(settings_).occlusion, expected);
    // Other primitives are another scene.
    Representation fewer = moved;
    fewer.spheres.pop_back();
    fewer.sphereLooks.pop_back();
    fresh->setScene(fewer);
    renderer->moveScene(fewer);
    EXPECT_EQ(renderer->layers(settings_).occlusion, fresh->layers(settings_).occlusion);
}

TEST_P(OcclusionOfScene, IsTheSameBesideFramesAndInTheSmallestParts) {
    for (const OcclusionMaps maps : {OcclusionMaps::tiles, OcclusionMaps::fragdepth, OcclusionMaps::encoded}) {
        settings_.occlusion.directions = 3;
        const std::vector<float> atOnce = baked(maps);
        ValidatedRenderer renderer(Visibility::automatic, scene_);
        double share = 0;
        for (int call = 0; share < 1; ++call) {
            ASSERT_LT(call, 100'000);
            // The least that a submission takes on; each change of what is shown, or many at once.
            const double next = renderer->advanceOcclusion(settings_, OcclusionPace{0, call % 2 ? 0.0 : 1.0, false});
            ASSERT_GE(next, share);
            share = next;
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
        EXPECT_EQ(renderer->stats().occlusion.done, 3);
        EXPECT_EQ(renderer->layers(settings_).occlusion, atOnce);
    }
}

TEST(OcclusionBesideFrames, BeginsWithNothingThatDoesNotFit) {
    ValidatedRenderer renderer(Visibility::automatic);
    const Representation r = scene("sample:glucose", Style::spacefill);
    renderer->setScene(r);
    RenderSettings s = settings(r, 64, Projection::orthographic);
    s.occlusion.directions = 8;
    for (int call = 0; call < 200; ++call) {
        ASSERT_EQ(renderer->advanceOcclusion(s, OcclusionPace{1e-6, 0, true}), 0);
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    EXPECT_EQ(renderer->stats().occlusion.done, 0);
    // Whoever waits for it gets it.
    renderer->render(s);
    EXPECT_EQ(renderer->stats().occlusion.done, 8);
    EXPECT_EQ(renderer->advanceOcclusion(s, OcclusionPace{1e-6, 0, true}), 1);
}

TEST(OcclusionBesideFrames, EndsWithTheSceneWhereverItStands) {
    const Representation r = scene("sample:dna", Style::ballAndStick),
                         other = scene("sample:glucose", Style::spacefill);
    for (int calls = 0; calls < 12; ++calls) {
        ValidatedRenderer renderer(Visibility::automatic, r);
        RenderSettings s = settings(r, 64, Projection::orthographic);
        s.occlusion.directions = 4;
        for (int call = 0; call < calls; ++call) {
            renderer->advanceOcclusion(s, OcclusionPace{});
            if (call == 3) renderer->render(s);  // waits for what is in flight, and for the rest
        }
        renderer->setScene(other);
        renderer->render(settings(other, 64, Projection::orthographic));
    }
}

/// Work is counted, not timed: the primitives that the host lists for one submission.
TEST(OcclusionBesideFrames, ListsFewPrimitivesAtATimeHoweverFastTheDeviceIs) {
    constexpr std::uint64_t kMost = 65536;
    Molecule m = molecule("sample:dna");
    std::vector<glm::vec3> places;
    for (int i = 0; i < 300; ++i) places.emplace_back(i % 20 * 26, i / 20 * 40, 0);
    addCopies(m, places);
    RepresentationOptions options{.style = Style::spacefill, .color = ColorScheme::element, .assembly = "1"};
    const Representation r = represent(m, drawnAtoms(m), options);
    const gpu::Device device{DeviceOptions{}};
    gpu::Executor executor{device};
    const passes::SceneBuffers buffers = passes::makeSceneBuffers(device, r);
    const occlusion::BakeOptions baked{3, 4 << 20, OcclusionMaps::tiles, 4};
    occlusion::Bake atOnce(device, buffers, r, baked), bySlices(device, buffers, r, baked);
    ASSERT_GT(atOnce.maps().instances(0), 2 * kMost);
    while (!atOnce.complete()) atOnce.step(executor);
    // A device that would draw all in a moment; one primitive is 20 units.
    const occlusion::Allowance allowance{16, 1e9};
    for (int slices = 0; !bySlices.complete(); ++slices) {
        ASSERT_LT(slices, 100);
        const bool draws = bySlices.betweenSteps();
        graph::Graph g("slice");
        gpu::Imports imports;
        const double units = bySlices.declareSlice(g, imports, allowance);
        if (draws) {
            EXPECT_EQ(units, 20.0 * kMost);
        }
        executor.run(g, imports);
        bySlices.sliceDone();
    }
    atOnce.finish(executor);
    bySlices.finish(executor);
    EXPECT_EQ(bySlices.atlasTexels(), atOnce.atlasTexels());
}

INSTANTIATE_TEST_SUITE_P(Scenes, OcclusionOfScene, testing::ValuesIn(kScenes),
                         [](const auto& test) { return testName(test.param.name); });

TEST(OcclusionBudget, HoldsWithCoarserPatchesAndSmallerMaps) {
    const Representation r = scene("sample:dna", Style::spacefill);
    std::uint32_t patch = 1000;
    for (const std::uint64_t budget : {64u << 20, 4u << 20, 1u << 20, 300u << 10, 60u << 10}) {
        ValidatedRenderer renderer(Visibility::automatic, r);
        RenderSettings s = settings(r, 64, Projection::orthographic);
        s.occlusion.directions = 16;
        s.occlusion.bytes = budget;
        renderer->layers(s);
        const OcclusionStats stats = renderer->stats().occlusion;
        constexpr std::uint64_t kMapsOfGpu = 256u << 20;  // of a batch, beside the budget
        EXPECT_LE(stats.bytes, budget + (isSoftwareDevice() ? 0 : kMapsOfGpu));
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
    expectThrows([&] { renderer.layers(s); }, "--occlusion-memory");
}

}  // namespace
}  // namespace nacre::test
