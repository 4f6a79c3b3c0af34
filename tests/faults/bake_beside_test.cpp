// A bake beside frames: one submission of it is in flight, and no call waits for it; counted by the fault layer, which
// says that a fence is not there yet for as long as a test likes.

#include <chrono>
#include <thread>

#include "tests/faults/fault_run.h"

namespace nacre::test {
namespace {

std::uint64_t waits() {
    return faults::count("vkWaitForFences") + faults::count("vkQueueWaitIdle") + faults::count("vkDeviceWaitIdle");
}

TEST(BakeBesideFrames, HasOneSubmissionInFlightAndNobodyWaits) {
    const Representation molecule = scene("sample:glucose", Style::ballAndStick);
    RenderSettings s = settings(molecule, 64, Projection::orthographic);
    s.occlusion.directions = 16;
    ValidatedRenderer renderer(Visibility::encoded, molecule, ValidatedRenderer::fresh);
    const auto advance = [&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return renderer->advanceOcclusion(s, OcclusionPace{1e-4, 0, false});
    };
    faults::reset();
    faults::failFrom("vkGetFenceStatus", 1, VK_NOT_READY);
    EXPECT_EQ(advance(), 0);
    EXPECT_EQ(faults::count("vkQueueSubmit"), 0u) << "the first picture comes before any of it";
    for (int call = 0; call < 60'000 && faults::count("vkQueueSubmit") == 0; ++call) EXPECT_EQ(advance(), 0);
    for (int call = 0; call < 50; ++call) EXPECT_EQ(advance(), 0);
    EXPECT_EQ(faults::count("vkQueueSubmit"), 1u);
    EXPECT_GE(faults::struck(), 49u);
    EXPECT_EQ(waits(), 0u);

    faults::reset();
    for (int call = 0; call < 60'000 && advance() < 1;) ++call;
    EXPECT_GT(faults::count("vkQueueSubmit"), 16u);  // a direction is more than one takes on
    EXPECT_GE(faults::count("vkGetFenceStatus"), faults::count("vkQueueSubmit"));
    EXPECT_EQ(waits(), 0u);
    EXPECT_EQ(renderer->stats().occlusion.done, 16);
}

/// What is shown until the next bake is done stays as long as a frame shows it, and no longer.
TEST(BakeBesideFrames, OfAMoleculeThatMovesNobodyWaits) {
    Representation molecule = scene("sample:glucose", Style::ballAndStick);
    RenderSettings s = settings(molecule, 64, Projection::orthographic);
    s.occlusion.directions = 16;
    ValidatedRenderer renderer(Visibility::encoded, molecule, ValidatedRenderer::fresh);
    const auto bake = [&] {
        for (int call = 0; call < 60'000 && renderer->advanceOcclusion(s, OcclusionPace{1, 0, false}) < 1; ++call)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    bake();
    for (int turn = 0; turn < 3; ++turn) {
        for (Sphere& sphere : molecule.spheres) sphere.center.x += 0.1f;
        renderer->moveScene(molecule);
        faults::reset();
        bake();
        EXPECT_GT(faults::count("vkQueueSubmit"), 0u);
        EXPECT_EQ(waits(), 0u) << turn;
        EXPECT_EQ(renderer->stats().occlusion.done, 16);
    }
}

}  // namespace
}  // namespace nacre::test
