// Frames of two eyes: what stays on the tile of each, and the reasons why an eye has a frame of its own.

#include <gtest/gtest.h>

#include "engine/graph/capability_sets.h"
#include "engine/graph/plan.h"
#include "tests/frame/shapes.h"
#include "tests/support/error_text.h"

namespace nacre::graph {
namespace {

FrameShape makeEyes(Visibility path, Extent extent) {
    FrameShape shape = test::makeShape(path, extent);
    shape.choice.views = 2;
    return shape;
}

TEST(EyesPlan, StoresFourBytesPerPixelAndEyeAndLoadsNothing) {
    constexpr Extent kExtent{64, 48};
    for (const CapabilitySet& set : capabilitySets()) {
        const Visibility path = choosePath(set).visibility;
        if (path == Visibility::tiles || !set.plan.tileSubpasses) continue;
        SCOPED_TRACE(set.plan.name);
        for (const Visibility one : {path, Visibility::encoded, Visibility::fragdepth, Visibility::deferred}) {
            FrameShape shape = makeEyes(one, kExtent);
            shape.choice.encoded = set.encoded;
            if (one == Visibility::rasterOrder && set.plan.rasterOrder == graph::RasterOrder::none) continue;
            const Frame frame = test::makeFrame(shape);
            const Plan plan = compile(frame.graph, set.plan);
            ASSERT_EQ(plan.steps.size(), 1u) << visibilityName(one);
            const RenderPassPlan& pass = plan.steps[0].renderPass;
            EXPECT_EQ(pass.viewMask, 3u);
            EXPECT_EQ(pass.layers, 2u);
            EXPECT_EQ(plan.total, (Traffic{0, 2 * 4 * 64 * 48})) << visibilityName(one);
            for (const Attachment& a : pass.attachments)
                EXPECT_EQ(a.transient, set.plan.transient && a.image != frame.targets[0].index) << visibilityName(one);
            // Both eyes are on their tiles one after the other: they take no more of it than one.
            shape.choice.views = 1;
            const Frame single = test::makeFrame(shape);
            const Plan of = compile(single.graph, set.plan);
            EXPECT_EQ(tileBytesPerPixel(plan), tileBytesPerPixel(of));
            EXPECT_EQ(pass.dependencies, of.steps[0].renderPass.dependencies);
            EXPECT_EQ(of.steps[0].renderPass.viewMask, 0u);
        }
    }
}

TEST(EyesPlan, TheTextSaysHowManyViewsARenderPassDraws) {
    const Frame frame = test::makeFrame(makeEyes(Visibility::encoded, {64, 48}));
    const std::string text = describe(frame.graph, compile(frame.graph, capabilitySet("adreno").plan));
    EXPECT_TRUE(text.starts_with("render pass 64x48, 2 views\n")) << text;
}

TEST(EyesPlan, ADeviceWithoutMultiviewRefuses) {
    const Frame frame = test::makeFrame(makeEyes(Visibility::encoded, {64, 48}));
    PlanCaps caps = capabilitySet("adreno").plan;
    caps.maxViews = 1;
    test::expectThrows<GraphError>([&] { compile(frame.graph, caps); }, "does not draw 2 views at once");
}

TEST(EyesPlan, ImportedImagesKeepTheirLayers) {
    Graph g("test", 2);
    const ImageDesc desc{VK_FORMAT_R8G8B8A8_UNORM, {8, 8}};
    constexpr State kTexture{VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT,
                             VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    Image both = g.image("both", desc), window = g.importImage("window", desc, kTexture, true);
    g.graphics("draw").color(both, Clear{0.0f});
    g.graphics("show").samples(both).color(window);
    const Plan plan = compile(g, capabilitySet("adreno").plan);
    ASSERT_EQ(plan.steps.size(), 2u);
    EXPECT_EQ(plan.steps[0].renderPass.viewMask, 3u);
    EXPECT_EQ(plan.steps[1].renderPass.viewMask, 0u);
    EXPECT_EQ(plan.total, (Traffic{2 * 256, 2 * 256 + 256}));
}

/// What is said of the views of a frame that both eyes ask for.
Decision describeViews(const FrameCaps& caps, RenderSettings settings, const SceneFacts& scene = {}) {
    settings.supersample = settings.supersample == RenderSettings::kEdges ? 1 : settings.supersample;
    for (const Decision& decision : explain({settings, Part::whole, Ending::readBack, 0, false, true}, scene, caps))
        if (decision.what == "views") return decision;
    return {};
}

RenderSettings eyesSettings() {
    RenderSettings settings;
    settings.view.width = settings.view.height = 64;
    settings.view.projection = Projection::perspective;
    settings.view.other = View::OtherEye{-1, 1};
    return settings;
}

TEST(EyesPlan, OneFrameWhereItCanElseTheReason) {
    const FrameCaps caps = capabilitySet("adreno");
    const RenderSettings plain = eyesSettings();
    EXPECT_EQ(describeViews(caps, plain).how, "both eyes in one frame");
    EXPECT_TRUE(explain({plain, Part::whole, Ending::readBack}, {}, caps).back().what != "views");
    const auto refused = [&](auto change, const char* why) {
        FrameCaps device = caps;
        RenderSettings settings = plain;
        SceneFacts scene;
        change(device, settings, scene);
        const Decision views = describeViews(device, settings, scene);
        EXPECT_EQ(views.how, "a frame for each eye") << why;
        EXPECT_NE(views.why.find(why), std::string::npos) << views.why;
    };
    refused([](auto& d, auto&, auto&) { d.plan.maxViews = 1; }, "multiview");
    refused([](auto&, auto& s, auto&) { s.effects.shadow.strength = 0.5; }, "shadow");
    refused([](auto&, auto& s, auto&) { s.effects.contours.width = 2; }, "outlines");
    refused([](auto&, auto& s, auto&) { s.effects.halos.width = 2; }, "halos");
    refused([](auto&, auto& s, auto&) { s.effects.depthOfField.strength = 0.1; }, "lens");
    refused([](auto&, auto& s, auto&) { s.debug = DebugView::normals; }, "debug");
    refused([](auto&, auto&, auto& f) { f.hasTranslucent = true; }, "translucent");
    refused([](auto&, auto&, auto& f) { f.leveled = true; }, "levels");
    // Edges of a picture are found in frames of one sample per pixel, of each eye.
    RenderSettings edges = plain;
    const Decision said = explain({edges, Part::whole, Ending::readBack, 0, false, true}, {}, caps).back();
    EXPECT_EQ(said.what, "views");
    EXPECT_NE(said.why.find("samples at edges"), std::string::npos) << said.why;
}

}  // namespace
}  // namespace nacre::graph
