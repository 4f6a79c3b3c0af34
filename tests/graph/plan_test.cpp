#include "engine/graph/plan.h"

#include <gtest/gtest.h>

#include "engine/graph/capability_sets.h"

namespace nacre::graph {
namespace {

constexpr Extent kScreen{100, 50};
constexpr State kTexture{VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT,
                         VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};

/// The screen frame of the encoded path, as the renderer declares it.
Graph encodedFrame() {
    Graph g("screen");
    const Image color = g.image("colour", {VK_FORMAT_R8G8B8A8_SRGB, kScreen});
    const Image depth = g.image("depth", {VK_FORMAT_D32_SFLOAT, kScreen});
    const Image nearest = g.image("encoded depth", {VK_FORMAT_R16G16B16A16_SFLOAT, kScreen});
    const Image atlas = g.importImage("occlusion atlas", {VK_FORMAT_R8_UNORM, {64, 64}}, kTexture);
    g.graphics("opaque prepass").depth(depth, Clear{1.0f});
    g.graphics("depth encoding").depthTest(depth).color(nearest, Clear{1.0f});
    g.graphics("impostor colour").depthTest(depth).input(nearest).samples(atlas).color(color, Clear{1.0f});
    g.output(color);
    return g;
}

Graph fragdepthFrame() {
    Graph g("screen");
    const Image color = g.image("colour", {VK_FORMAT_R8G8B8A8_SRGB, kScreen});
    const Image depth = g.image("depth", {VK_FORMAT_D32_SFLOAT, kScreen});
    g.graphics("opaque prepass").depth(depth, Clear{1.0f});
    g.graphics("impostor colour").depth(depth).color(color, Clear{1.0f});
    g.output(color);
    return g;
}

TEST(ScreenPlan, MaliEncodedIsOneRenderPassOfThreeSubpasses) {
    const Graph g = encodedFrame();
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

TEST(ScreenPlan, MaliUnmergedIsThreeRenderPassesAndSixteenBytesEachWay) {
    PlanCaps caps = capabilitySet("mali").plan;
    caps.merge = false;
    const Graph g = encodedFrame();
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
    const Graph g = fragdepthFrame();
    EXPECT_EQ(describe(g, compile(g, capabilitySet("apple-moltenvk").plan)),
              "render pass 100x50\n"
              "  depth  D32F  clear  -  transient\n"
              "  colour  RGBA8 sRGB  clear  store\n"
              "  subpass 0 opaque prepass + impostor colour: depth write, colour write\n"
              "  tile 4 B/px + depth\n"
              "memory: loaded 0 B, stored 20000 B\n");
}

}  // namespace
}  // namespace nacre::graph
