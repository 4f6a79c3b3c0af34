// Frames are declared and planned once for each shape.

#include "engine/frame/declared_frames.h"

#include <gtest/gtest.h>

#include <functional>

#include "engine/graph/capability_sets.h"
#include "tests/frame/shapes.h"

namespace nacre::test {
namespace {

constexpr ScreenTarget kTarget{"colour", VK_FORMAT_R8G8B8A8_SRGB, passes::Output::color, "impostor colour"};
constexpr ScreenTarget kOnGrey{"colour", VK_FORMAT_R8G8B8A8_SRGB, passes::Output::color, "impostor colour",
                               graph::Clear{0.5f}};

FrameShape encodedShape(std::uint32_t width = 64) {
    FrameShape shape = makeShape(Visibility::encoded, {width, 48});
    shape.targets = {&kTarget, 1};
    return shape;
}

class DeclaredFramesTest : public testing::Test {
protected:
    const DeclaredFrame& of(const FrameShape& shape) {
        return *frames.of(shape, [&](Frame& frame) {
            ++declared;
            frame.graph.output(frame.targets[0]);
        });
    }
    graph::PlanCaps caps = graph::capabilitySet("mali").plan;
    DeclaredFrames frames{caps};
    int declared = 0;
};

TEST_F(DeclaredFramesTest, AnEqualShapeIsTheSameFrame) {
    const DeclaredFrame* frame = &of(encodedShape());
    EXPECT_EQ(frame->plan, graph::compile(frame->frame.graph, caps));
    EXPECT_EQ(frame->plan.steps.size(), 1u);  // its end's output keeps the passes
    for (int i = 0; i < 10; ++i) {
        const std::string name = "screen";  // names count, not where they stand
        const ScreenTarget target = kTarget;
        FrameShape again = encodedShape();
        again.name = name.c_str();
        again.targets = {&target, 1};
        EXPECT_EQ(&of(again), frame);
    }
    EXPECT_EQ(declared, 1);
}

TEST_F(DeclaredFramesTest, WhateverDiffersIsAnother) {
    using Change = std::function<void(FrameShape&)>;
    const Change changes[] = {
        [](FrameShape&) {},
        [](FrameShape& s) { s.extent.height = 49; },
        [](FrameShape& s) { s.choice.path = Visibility::fragdepth; },
        [](FrameShape& s) { s.choice.encoded = graph::encodedFormats()[1]; },
        [](FrameShape& s) { s.atlas.extent.width = 8; },
        [](FrameShape& s) {
            s.targets = {&kOnGrey, 1};
        },
        [](FrameShape& s) { s.choice.prepass = false, s.choice.path = Visibility::fragdepth; },
        [](FrameShape& s) { s.name = "other"; },
        [](FrameShape& s) { s.choice.path = Visibility::tiles; },
        [](FrameShape& s) {
            s.choice.path = Visibility::tiles, s.choice.samples = {Samples::Where::edges, 16};
        },
        [](FrameShape& s) { s.choice.path = Visibility::deferred, s.choice.effects.add({Effect::Kind::halos}); },
        [](FrameShape& s) {
            s.choice.effects.add({Effect::Kind::shadow, 512});
        },
        [](FrameShape& s) {
            s.choice.effects.add({Effect::Kind::translucency, 2});
        },
        [](FrameShape& s) { s.choice.debug = DebugView::normals; },
        [](FrameShape& s) { s.choice.ending = Ending::readBack; },
        [](FrameShape& s) { s.picture.masked = true; },
        [](FrameShape& s) { s.window.width = 7; },
        [](FrameShape& s) { s.overlay = true; },
        [](FrameShape& s) { s.merge = false; },
        [](FrameShape& s) { s.transient = false; },
    };
    int wanted = 0;
    for (const Change& change : changes) {
        FrameShape shape = encodedShape();
        change(shape);
        const DeclaredFrame& frame = of(shape);
        EXPECT_EQ(declared, ++wanted);
        EXPECT_TRUE(frame.shape == shape);
        EXPECT_EQ(frame.plan, graph::compile(frame.frame.graph, planCaps(caps, shape)));
    }
}

TEST_F(DeclaredFramesTest, HoldBoundedNumbers) {
    for (std::uint32_t width = 1; width < 200; ++width) of(encodedShape(width));
    EXPECT_LE(frames.size(), DeclaredFrames::kMost);
    of(encodedShape(199));
    EXPECT_EQ(declared, 199);
}

}  // namespace
}  // namespace nacre::test
