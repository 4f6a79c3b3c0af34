// The frame of a window, with something of the application's drawn on top.

#include <gtest/gtest.h>

#include "engine/frame/screen.h"
#include "engine/graph/capability_sets.h"
#include "engine/graph/plan.h"

namespace nacre::graph {
namespace {

ScreenFrame windowFrame(Visibility visibility, Extent extent) {
    const ScreenTarget target{"window", VK_FORMAT_B8G8R8A8_SRGB, passes::Output::color, "impostor colour", Clear{1.0f},
                              true};
    ScreenOptions options;
    options.extent = extent;
    options.visibility = visibility;
    options.encoded = graph::encodedFormats()[0];
    options.targets = {&target, 1};
    ScreenFrame frame = screenFrame(options);
    frame.graph.graphics("overlay").color(frame.targets[0]);
    return frame;
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

TEST(WindowFrame, WhatIsDrawnOverFourSamplesIsResolvedWithThem) {
    const ScreenTarget target{"window", VK_FORMAT_B8G8R8A8_SRGB, passes::Output::color, "impostor colour", Clear{1.0f},
                              true};
    ScreenOptions options;
    options.extent = {64, 48};
    options.visibility = Visibility::fragdepth;
    options.targets = {&target, 1};
    options.samples = kMultisamples;
    ScreenFrame frame = screenFrame(options);
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
