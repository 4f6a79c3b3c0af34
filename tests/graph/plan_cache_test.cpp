#include "engine/graph/plan_cache.h"

#include <gtest/gtest.h>

#include "engine/frame/screen.h"
#include "engine/graph/capability_sets.h"

namespace nacre::graph {
namespace {

/// A frame for a window, with something of the application's drawn on top.
ScreenFrame windowFrame(Visibility visibility, Extent extent, Clear clear = Clear{1.0f}) {
    const ScreenTarget target{"window", VK_FORMAT_B8G8R8A8_SRGB, passes::Output::color, "impostor colour", clear, true};
    ScreenOptions options;
    options.extent = extent;
    options.visibility = visibility;
    options.encoded = graph::encodedFormats()[0];
    options.targets = {&target, 1};
    ScreenFrame frame = screenFrame(options);
    frame.graph.graphics("overlay").color(frame.targets[0]);
    return frame;
}

TEST(PlanCache, AnEqualGraphGetsTheSamePlan) {
    PlanCache cache;
    const PlanCaps caps = capabilitySet("mali").plan;
    const ScreenFrame a = windowFrame(Visibility::encoded, {64, 48});
    const Plan* plan = &cache.planOf(a.graph, caps);
    EXPECT_EQ(*plan, compile(a.graph, caps));
    for (int i = 0; i < 10; ++i) EXPECT_EQ(&cache.planOf(windowFrame(Visibility::encoded, {64, 48}).graph, caps), plan);
    EXPECT_EQ(cache.size(), 1u);
}

TEST(PlanCache, WhateverDiffersGetsItsOwn) {
    PlanCache cache;
    PlanCaps caps = capabilitySet("mali").plan;
    const auto expectNew = [&](const Graph& graph) {
        const std::size_t before = cache.size();
        EXPECT_EQ(cache.planOf(graph, caps), compile(graph, caps));
        EXPECT_EQ(cache.size(), before + 1);
    };
    expectNew(windowFrame(Visibility::encoded, {64, 48}).graph);
    expectNew(windowFrame(Visibility::encoded, {64, 49}).graph);
    expectNew(windowFrame(Visibility::fragdepth, {64, 48}).graph);
    expectNew(windowFrame(Visibility::encoded, {64, 48}, Clear{0.5f}).graph);
    ScreenFrame output = windowFrame(Visibility::encoded, {64, 48});
    output.graph.output(output.depth);
    expectNew(output.graph);
    caps.merge = false;
    expectNew(windowFrame(Visibility::encoded, {64, 48}).graph);
}

TEST(PlanCache, HoldsABoundedNumberOfPlans) {
    PlanCache cache;
    const PlanCaps caps = capabilitySet("desktop").plan;
    for (std::uint32_t width = 1; width < 200; ++width)
        cache.planOf(windowFrame(Visibility::fragdepth, {width, 48}).graph, caps);
    EXPECT_LE(cache.size(), 16u);
}

TEST(WindowFrame, TheOverlayIsDrawnInTheFinalSubpassAndTheDisplayGetsTheImage) {
    for (const char* set : {"mali", "adreno", "powervr"}) {
        const ScreenFrame frame = windowFrame(Visibility::encoded, {64, 48});
        const Plan plan = compile(frame.graph, capabilitySet(set).plan);
        ASSERT_EQ(plan.steps.size(), 1u) << set;
        const RenderPassPlan& pass = plan.steps[0].renderPass;
        ASSERT_EQ(pass.subpasses.size(), 3u) << set;
        EXPECT_EQ(pass.subpasses[2].passes.size(), 2u) << set;
        EXPECT_EQ(frame.graph.passes()[pass.subpasses[2].passes[1]].name, "overlay");
        for (const Attachment& a : pass.attachments) {
            const bool window = a.image == frame.targets[0].index;
            EXPECT_EQ(a.store, window ? Store::store : Store::dontCare) << set;
            EXPECT_EQ(a.load, Load::clear) << set;
            if (window) {
                EXPECT_EQ(a.initialLayout, VK_IMAGE_LAYOUT_UNDEFINED);
                EXPECT_EQ(a.finalLayout, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR);
            }
        }
        EXPECT_TRUE(plan.after.empty()) << set;  // the render pass itself leaves the image as the display wants it
    }
}

}  // namespace
}  // namespace nacre::graph
