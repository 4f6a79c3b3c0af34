// What the device says that passes took. Times themselves are not judged.

#include <gtest/gtest.h>

#include "engine/gpu/timer.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

TEST(PassTimes, AreOfEveryRenderPassAndOnlyWhereAskedFor) {
    ValidatedRenderer renderer(Visibility::encoded);
    const Representation r = scene("sample:glucose", Style::spacefill);
    renderer->setScene(r);
    RenderSettings s = settings(r, 96, Projection::orthographic);
    s.occlusion.directions = 0;
    s.supersample = 1;
    renderer->render(s);
    EXPECT_TRUE(renderer->stats().passTimes.empty());
    s.tuning.timePasses = true;
    renderer->render(s);
    const std::vector<PassTime> merged = renderer->stats().passTimes;
    ASSERT_EQ(merged.size(), 2u);
    EXPECT_EQ(merged[0].name, "opaque prepass + depth encoding + impostor colour");
    EXPECT_EQ(merged[1].name, "read back");
    EXPECT_GT(merged[0].milliseconds, 0);
    s.tuning.merge = false;
    renderer->render(s);
    ASSERT_EQ(renderer->stats().passTimes.size(), 4u);
    EXPECT_EQ(renderer->stats().passTimes[1].name, "depth encoding");
    double sum = 0;
    for (const PassTime& pass : renderer->stats().passTimes) sum += pass.milliseconds;
    EXPECT_LE(sum, renderer->stats().frameMilliseconds);  // which the host saw, from submission to completion
}

TEST(PassTimes, OfAPictureAreThoseOfAllItsBlocks) {
    ValidatedRenderer renderer(Visibility::fragdepth);
    const Representation r = scene("sample:glucose", Style::spacefill);
    renderer->setScene(r);
    RenderSettings s = settings(r, 32, Projection::orthographic);
    s.view.width = 400;
    s.occlusion.directions = 0;
    s.supersample = RenderSettings::kEdges;
    s.tuning.timePasses = true;
    renderer->render(s);
    ASSERT_GT(renderer->stats().frames, 1u);
    double sum = 0;
    for (const PassTime& pass : renderer->stats().passTimes) sum += pass.milliseconds;
    EXPECT_GT(sum, 0);
    EXPECT_LE(sum, renderer->stats().frameMilliseconds);
}

TEST(PassTimes, ATimerTellsNothingThatWasNotRecordedAndNoMoreThanItHasRoomFor) {
    const gpu::Device device(DeviceOptions{.validate = true});
    gpu::Timer timer(device);
    ASSERT_TRUE(timer.there());
    EXPECT_TRUE(timer.times().empty());
    EXPECT_FALSE(timer.milliseconds());
    device.submitAndWait([&](const vk::raii::CommandBuffer& commands) {
        timer.begin(commands);
        for (int i = 0; i < 100; ++i) timer.lap(commands, std::to_string(i));
    });
    EXPECT_EQ(timer.times().size(), 63u);
    EXPECT_EQ(timer.times().back().name, "62");
    device.submitAndWait([&](const vk::raii::CommandBuffer& commands) {
        timer.begin(commands);
        timer.lap(commands, "one");
    });
    ASSERT_EQ(timer.times().size(), 1u);
    EXPECT_EQ(timer.times()[0].name, "one");
    EXPECT_GE(*timer.milliseconds(), 0);
    EXPECT_TRUE(device.validationMessages().empty());
}

}  // namespace
}  // namespace nacre::test
