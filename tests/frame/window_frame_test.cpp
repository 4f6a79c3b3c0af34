// The frame of a window, with something of the application's drawn on top.

#include <gtest/gtest.h>

#include "engine/graph/capability_sets.h"
#include "engine/graph/plan.h"
#include "tests/frame/shapes.h"

namespace nacre::graph {
namespace {

constexpr ScreenTarget kWindow{
    "window", VK_FORMAT_B8G8R8A8_SRGB, passes::Output::color, "impostor colour", Clear{1.0f}, &kWindowState};

Frame windowFrame(Visibility visibility, Extent extent) {
    FrameShape shape = test::makeShape(visibility, extent);
    shape.targets = {&kWindow, 1};
    Frame frame = declareFrame(shape);
    frame.graph.graphics("overlay").color(frame.targets[0]);
    return frame;
}

TEST(WindowFrame, TheOverlayIsDrawnInTheFinalSubpassAndTheDisplayGetsTheImage) {
    for (const char* set : {"mali", "adreno", "powervr"}) {
        const Frame frame = windowFrame(Visibility::encoded, {64, 48});
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

TEST(WindowFrame, WhatIsDrawnOverFourSamplesIsResolvedWithThem) {
    FrameShape shape = test::makeShape(Visibility::fragdepth, {64, 48});
    shape.targets = {&kWindow, 1};
    shape.choice.samples = {Samples::Where::resolved, kMultisamples};
    Frame frame = declareFrame(shape);
    ASSERT_TRUE(frame.samples);
    frame.graph.graphics("overlay").color(*frame.samples).resolve(frame.targets[0]);
    const Plan plan = compile(frame.graph, capabilitySet("apple-moltenvk").plan);
    ASSERT_EQ(plan.steps.size(), 1u);
    const RenderPassPlan& pass = plan.steps[0].renderPass;
    ASSERT_EQ(pass.subpasses.size(), 1u);
    EXPECT_EQ(pass.subpasses[0].passes.size(), 3u);
    for (const Attachment& a : pass.attachments) {
        if (a.image != frame.targets[0].index) continue;
        EXPECT_EQ(a.store, Store::store);
        EXPECT_EQ(a.finalLayout, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR);
    }
    EXPECT_EQ(plan.total, (Traffic{0, 64 * 48 * 4}));
}

}  // namespace
}  // namespace nacre::graph
