// Plans of the screen frame on each class of device.

#include <gtest/gtest.h>

#include "engine/graph/capability_sets.h"
#include "tests/frame/shapes.h"

namespace nacre::graph {
namespace {

constexpr Extent kScreen{100, 50};
/// The screen frame as the renderer declares it.
Graph frameBy(Visibility visibility, bool prepass = true, bool edges = false) {
    FrameShape shape = test::makeShape(visibility, kScreen);
    shape.choice.prepass = prepass;
    if (edges) shape.choice.samples = {Samples::Where::edges, 16};
    for (const EncodedFormat& format : encodedFormats())
        if (format.rung == EncodedDepth::rgba16f) shape.choice.encoded = format;
    return std::move(test::makeFrame(shape).graph);
}

TEST(ScreenPlan, PlatesThatRejectNothingAreNotDrawn) {
    const PlanCaps caps = capabilitySet("v3dv").plan;
    EXPECT_FALSE(platesReject(Visibility::fragdepth, caps));
    EXPECT_FALSE(platesReject(Visibility::deferred, caps));
    EXPECT_TRUE(platesReject(Visibility::encoded, caps));
    EXPECT_TRUE(platesReject(Visibility::fragdepth, capabilitySet("mali").plan));
    const Graph g = frameBy(Visibility::fragdepth, false);
    // As the driver's streams have it: colour alone leaves the tile.
    EXPECT_EQ(describe(g, compile(g, caps)),
              "render pass 100x50\n"
              "  depth  D32F  clear  -\n"
              "  colour  RGBA8 sRGB  clear  store\n"
              "  subpass 0 impostor colour: depth write, colour write, occlusion atlas sample\n"
              "  tile 4 B/px + depth\n"
              "memory: loaded 0 B, stored 20000 B\n");
}

TEST(ScreenPlan, TilesAreAComputePassAndOneThatShades) {
    const Graph g = frameBy(Visibility::tiles);
    PlanCaps caps = capabilitySet("desktop").plan;
    // 112 x 64 numbers, whole bins, go out of the one pass and into the other.
    EXPECT_EQ(describe(g, compile(g, caps)),
              "compute nearest primitive\n"
              "render pass 100x50\n"
              "  colour  RGBA8 sRGB  clear  store\n"
              "  subpass 0 impostor colour: colour write, primitive numbers read, occlusion atlas sample\n"
              "  tile 4 B/px\n"
              "memory: loaded 28672 B, stored 48672 B\n");
    const Plan plan = compile(g, caps);
    ASSERT_EQ(plan.bufferTraffic.size(), 1u);
    EXPECT_EQ(plan.bufferTraffic[0], (Traffic{28672, 28672}));
    ASSERT_EQ(plan.steps[1].before.size(), 1u);
    const Barrier& between = plan.steps[1].before[0];
    EXPECT_FALSE(between.isImage);
    EXPECT_EQ(between.from.stages, VkPipelineStageFlags{VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT});
    EXPECT_EQ(between.to.stages, VkPipelineStageFlags{VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT});
}

TEST(ScreenPlan, EdgesByTilesAreAComputePassAndAPassOfTheSameSubpass) {
    const Graph g = frameBy(Visibility::tiles, true, true);
    EXPECT_EQ(
        describe(g, compile(g, capabilitySet("desktop").plan)),
        "compute nearest primitive\n"
        "compute edge pixels\n"
        "compute edge samples\n"
        "render pass 100x50\n"
        "  colour  RGBA8 sRGB  clear  store\n"
        "  subpass 0 impostor colour + edge colour: colour write, primitive numbers read, occlusion atlas sample, "
        "edge colours read\n"
        "  tile 4 B/px\n"
        "memory: loaded 172032 B, stored 134688 B\n");
}

/// The screen frame by four samples of a pixel.
std::string fourSamplesOn(const char* set, Visibility visibility) {
    FrameShape shape = test::makeShape(visibility, kScreen);
    shape.choice.samples = {Samples::Where::resolved, kMultisamples};
    const Frame frame = test::makeFrame(shape);
    return describe(frame.graph, compile(frame.graph, capabilitySet(set).plan));
}

TEST(ScreenPlan, FourSamplesAreResolvedOnTheTileAndNeverStored) {
    EXPECT_EQ(fourSamplesOn("apple-moltenvk", Visibility::fragdepth),
              "render pass 100x50\n"
              "  depth  D32F  clear  -  transient  4 samples\n"
              "  colour samples  RGBA8 sRGB  clear  -  transient  4 samples\n"
              "  colour  RGBA8 sRGB  -  store\n"
              "  subpass 0 opaque prepass + impostor colour: depth write, colour samples write, colour resolve, "
              "occlusion atlas sample\n"
              "  tile 16 B/px + depth\n"
              "memory: loaded 0 B, stored 20000 B\n");
    EXPECT_EQ(fourSamplesOn("mali", Visibility::rasterOrder),
              "render pass 100x50\n"
              "  depth  D32F  clear  -  transient  4 samples\n"
              "  colour samples  RGBA8 sRGB  clear  -  transient  4 samples\n"
              "  colour  RGBA8 sRGB  -  store\n"
              "  nearest depth  R32F  clear  -  transient  4 samples\n"
              "  subpass 0 opaque prepass: depth write\n"
              "  subpass 1 impostor colour: depth test, colour samples write, nearest depth ordered, colour resolve, "
              "occlusion atlas sample\n"
              "  dependency 0 -> 1 by region\n"
              "  tile 32 B/px + depth\n"
              "memory: loaded 0 B, stored 20000 B\n");
}

TEST(ScreenPlan, MaliEncodedIsOneRenderPassOfThreeSubpasses) {
    const Graph g = frameBy(Visibility::encoded);
    EXPECT_EQ(describe(g, compile(g, capabilitySet("mali").plan)),
              "render pass 100x50\n"
              "  depth  D32F  clear  -  transient\n"
              "  encoded depth  RGBA16F  clear  -  transient\n"
              "  colour  RGBA8 sRGB  clear  store\n"
              "  subpass 0 opaque prepass: depth write\n"
              "  subpass 1 depth encoding: depth test, encoded depth write\n"
              "  subpass 2 impostor colour: depth test, encoded depth input, colour write, occlusion atlas sample\n"
              "  dependency 0 -> 1 by region\n"
              "  dependency 0 -> 2 by region\n"
              "  dependency 1 -> 2 by region\n"
              "  tile 12 B/px + depth\n"
              "memory: loaded 0 B, stored 20000 B\n");
}

TEST(ScreenPlan, MaliEncodesDepthInRasterOrderAndReadsItOnTheTile) {
    FrameShape shape = test::makeShape(Visibility::encoded, kScreen);
    shape.choice.encoded = capabilitySet("mali").encoded;
    const Frame frame = test::makeFrame(shape);
    const Plan plan = compile(frame.graph, capabilitySet("mali").plan);
    EXPECT_EQ(describe(frame.graph, plan),
              "render pass 100x50\n"
              "  depth  D32F  clear  -  transient\n"
              "  encoded depth  R32F  clear  -  transient\n"
              "  colour  RGBA8 sRGB  clear  store\n"
              "  subpass 0 opaque prepass: depth write\n"
              "  subpass 1 depth encoding: depth test, encoded depth ordered\n"
              "  subpass 2 impostor colour: depth test, encoded depth input, colour write, occlusion atlas sample\n"
              "  dependency 0 -> 1 by region\n"
              "  dependency 0 -> 2 by region\n"
              "  dependency 1 -> 2 by region\n"
              "  tile 8 B/px + depth\n"
              "memory: loaded 0 B, stored 20000 B\n");
}

TEST(ScreenPlan, MaliUnmergedIsThreeRenderPassesAndSixteenBytesEachWay) {
    PlanCaps caps = capabilitySet("mali").plan;
    caps.merge = false;
    const Graph g = frameBy(Visibility::encoded);
    EXPECT_EQ(describe(g, compile(g, caps)),
              "render pass 100x50\n"
              "  depth  D32F  clear  store\n"
              "  subpass 0 opaque prepass: depth write\n"
              "  tile 0 B/px + depth\n"
              "render pass 100x50\n"
              "  depth  D32F  load  none\n"
              "  encoded depth  RGBA16F  clear  store\n"
              "  subpass 0 depth encoding: depth test, encoded depth write\n"
              "  tile 8 B/px + depth\n"
              "render pass 100x50\n"
              "  depth  D32F  load  -\n"
              "  colour  RGBA8 sRGB  clear  store\n"
              "  subpass 0 impostor colour: depth test, colour write, encoded depth sample, occlusion atlas sample\n"
              "  tile 4 B/px + depth\n"
              "memory: loaded 80000 B, stored 80000 B\n");
}

TEST(ScreenPlan, AppleFragdepthIsOneSubpassWithoutInputAttachment) {
    const Graph g = frameBy(Visibility::fragdepth);
    EXPECT_EQ(describe(g, compile(g, capabilitySet("apple-moltenvk").plan)),
              "render pass 100x50\n"
              "  depth  D32F  clear  -  transient\n"
              "  colour  RGBA8 sRGB  clear  store\n"
              "  subpass 0 opaque prepass + impostor colour: depth write, colour write, occlusion atlas sample\n"
              "  tile 4 B/px + depth\n"
              "memory: loaded 0 B, stored 20000 B\n");
}

TEST(ScreenPlan, DeferredShadesFromNumbersOnTheTile) {
    const Graph g = frameBy(Visibility::deferred);
    EXPECT_EQ(describe(g, compile(g, capabilitySet("adreno").plan)),
              "render pass 100x50\n"
              "  depth  D32F  clear  -  transient\n"
              "  primitive number  R32_UINT  clear  -  transient\n"
              "  colour  RGBA8 sRGB  clear  store\n"
              "  subpass 0 opaque prepass + nearest primitive: depth write, primitive number write\n"
              "  subpass 1 impostor colour: primitive number input, colour write, occlusion atlas sample\n"
              "  dependency 0 -> 1 by region\n"
              "  tile 8 B/px + depth\n"
              "memory: loaded 0 B, stored 20000 B\n");
}

TEST(ScreenPlan, RasterOrderKeepsTheNearestDepthInItsOwnAttachment) {
    const Graph g = frameBy(Visibility::rasterOrder);
    EXPECT_EQ(describe(g, compile(g, capabilitySet("mali").plan)),
              "render pass 100x50\n"
              "  depth  D32F  clear  -  transient\n"
              "  colour  RGBA8 sRGB  clear  store\n"
              "  nearest depth  R32F  clear  -  transient\n"
              "  subpass 0 opaque prepass: depth write\n"
              "  subpass 1 impostor colour: depth test, colour write, nearest depth ordered, occlusion atlas sample\n"
              "  dependency 0 -> 1 by region\n"
              "  tile 8 B/px + depth\n"
              "memory: loaded 0 B, stored 20000 B\n");
    // A device without it is a fault that names the pass.
    EXPECT_THROW(compile(g, capabilitySet("powervr").plan), GraphError);
}

}  // namespace
}  // namespace nacre::graph
