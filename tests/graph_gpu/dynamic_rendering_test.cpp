// The renderer's own frames, carried out by dynamic rendering with local reads: bit for bit what render passes give.

#include <gtest/gtest.h>

#include "engine/devices.h"
#include "engine/gpu/execute.h"
#include "tests/renderer/scenes.h"
#include "tests/support/newer_lavapipe.h"

namespace nacre::test {
namespace {

struct Drawn {
    std::vector<float> rgba, z, occlusion;
    std::vector<std::uint32_t> id;
    std::uint32_t picked = 0;
    bool dynamic = false;
    friend bool operator==(const Drawn&, const Drawn&) = default;
};

Drawn drawn(Visibility path, OcclusionMaps maps) {
    Renderer renderer(DeviceOptions{.visibility = path});
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    renderer.setScene(r);
    RenderSettings s = settings(r, 80, Projection::perspective);
    s.supersample = 1;
    s.occlusion.directions = 4;
    s.occlusion.maps = maps;
    Drawn d;
    d.rgba = renderer.render(s).rgba;
    const LayerPicture layers = renderer.layers(s);
    d.z = layers.z, d.occlusion = layers.occlusion, d.id = layers.id;
    d.picked = renderer.atomAt(s, 40, 40, 3);
    d.dynamic = renderer.stats().device.localRead;
    return d;
}

TEST(NewerDriver, DrawsTheSameBitsByDynamicRenderingOnEveryPath) {
    if (!NewerLavapipe::there()) GTEST_SKIP() << NewerLavapipe::kAbsent;
    const NewerLavapipe newer;
    for (const Visibility path :
         {Visibility::encoded, Visibility::fragdepth, Visibility::deferred, Visibility::rasterOrder}) {
        const OcclusionMaps maps = path == Visibility::encoded ? OcclusionMaps::encoded : OcclusionMaps::fragdepth;
        Drawn now = drawn(path, maps);
        ASSERT_TRUE(now.dynamic);
        const RenderPassesOfOld old;
        const Drawn before = drawn(path, maps);
        ASSERT_FALSE(before.dynamic);
        now.dynamic = false;
        EXPECT_TRUE(now == before) << visibilityName(path);
        EXPECT_TRUE(std::any_of(now.id.begin(), now.id.end(), [](std::uint32_t id) { return id > 0; }));
    }
}

// What reads nothing on the tile is a VkRenderPass there, too: some encoders begin anew where inputs change.
TEST(NewerDriver, RendersDynamicallyOnlyWhereAPassReadsAnother) {
    if (!NewerLavapipe::there()) GTEST_SKIP() << NewerLavapipe::kAbsent;
    const NewerLavapipe newer;
    const gpu::Device device{DeviceOptions()};
    ASSERT_TRUE(device.caps().localRead);
    const auto takes = [&](bool reads) {
        graph::Graph g("frame");
        auto first = g.image("first", {VK_FORMAT_R8G8B8A8_UNORM, {8, 8}});
        auto second = g.image("second", {VK_FORMAT_R8G8B8A8_UNORM, {8, 8}});
        g.graphics("first").color(first, graph::Clear{0.0f});
        if (reads) g.graphics("second").input(first).color(second, graph::Clear{0.0f});
        g.output(reads ? second : first);
        const graph::Plan plan = graph::compile(g, device.caps().plan);
        EXPECT_EQ(plan.steps.size(), 1u);
        return gpu::DynamicRendering::takes(device, plan.steps[0].renderPass);
    };
    EXPECT_FALSE(takes(false));
    EXPECT_TRUE(takes(true));
}

// A driver that lacks it is drawn with as ever.
TEST(NewerDriver, IsAskedForWhatItHasAlone) {
    // Lavapipe 22.3 has nothing of it.
    for (const DeviceInfo& device : listDevices()) EXPECT_FALSE(device.localRead) << device.name;
    if (!NewerLavapipe::there()) GTEST_SKIP() << NewerLavapipe::kAbsent;
    const NewerLavapipe newer;
    const std::vector<DeviceInfo> devices = listDevices();
    ASSERT_EQ(devices.size(), 1u);
    EXPECT_TRUE(devices[0].localRead);
    const RenderPassesOfOld old;
    EXPECT_FALSE(listDevices()[0].localRead);
}

}  // namespace
}  // namespace nacre::test
