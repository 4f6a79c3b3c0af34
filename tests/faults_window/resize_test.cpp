// A window that changes its size, where the display tells what it is done with (VK_EXT_swapchain_maintenance1) and
// where it does not.

#include "tests/faults_window/viewer_run.h"
#include "tests/support/newer_lavapipe.h"

namespace nacre::test {
namespace {

/// Devices that are made while this lives tell when the display is done with what was presented, or do not.
struct Maintained {
    explicit Maintained(bool on) {
        if (!on) faults::hideExtensions({VK_EXT_SWAPCHAIN_MAINTENANCE_1_EXTENSION_NAME});
    }
    ~Maintained() {
        faults::hideExtensions({});
        haveSmallWindows();
    }
};

void size(ViewerRun& run, std::uint32_t width, std::uint32_t height) {
    faults::setWindowSize(width, height);
    run.viewer().frames().resize({width, height}, 1, run.now());
}

/// Drags the window's corner: a frame or two of each size.
/// @param awaits  the next one's image is there by then, and is not drawn into
void drag(ViewerRun& run, bool awaits = true) {
    constexpr PixelSize kSizes[] = {{72, 64}, {80, 72}, {64, 96}, {96, 96}, {64, 64}};
    for (const PixelSize& s : kSizes) {
        size(run, s.width, s.height);
        run.rest(2);
        run.redraw();
        if (awaits) run.viewer().frames().await(run.now());
    }
    size(run, 64, 64);
}

TEST(Resize, WaitsForNothingWhereTheDisplayTellsWhatItIsDoneWith) {
    std::vector<float> pictures[2];
    for (const bool on : {false, true}) {
        const Maintained maintained(on);
        {
            faults::reset();
            ViewerRun run;
            size(run, 64, 64);
            ASSERT_TRUE(run.rest());
            const std::uint64_t before = faults::count("vkDeviceWaitIdle"),
                                made = faults::count("vkCreateSwapchainKHR");
            drag(run);
            ASSERT_TRUE(run.rest());
            EXPECT_GE(faults::count("vkCreateSwapchainKHR"), made + 5);
            if (on) {
                EXPECT_EQ(faults::count("vkDeviceWaitIdle"), before);
                const std::uint64_t given = faults::count("vkReleaseSwapchainImagesEXT");
                EXPECT_GE(given, 4u);
                drag(run, false);  // no image is asked for that is of another size than the picture
                ASSERT_TRUE(run.rest());
                EXPECT_EQ(faults::count("vkReleaseSwapchainImagesEXT"), given);
            } else {
                EXPECT_GT(faults::count("vkDeviceWaitIdle"), before);
                EXPECT_EQ(faults::count("vkReleaseSwapchainImagesEXT"), 0u);
            }
            EXPECT_TRUE(run.said().empty()) << run.said().front();
            pictures[on] = run.picture();
            // Of all those sizes only the last is held: two frames later nothing of the others is left.
            EXPECT_LE(faults::alive()["SwapchainKHR"], 2);
        }
        expectNothingLeft();
    }
    EXPECT_EQ(pictures[0], pictures[1]);
}

TEST(Resize, WhatFailsOnTheWayIsMadeAnew) {
    const Maintained maintained(true);
    {
        ViewerRun run;
        size(run, 64, 64);
        ASSERT_TRUE(run.rest());
        const std::vector<float> expected = run.picture();
        for (const auto& [function, result] : std::vector<std::pair<std::string, VkResult>>{
                 {"vkAcquireNextImageKHR", VK_ERROR_OUT_OF_DATE_KHR},
                 {"vkAcquireNextImageKHR", VK_ERROR_SURFACE_LOST_KHR},
                 {"vkQueuePresentKHR", VK_ERROR_OUT_OF_DATE_KHR},
                 {"vkQueuePresentKHR", VK_ERROR_SURFACE_LOST_KHR},
                 {"vkQueuePresentKHR", VK_SUBOPTIMAL_KHR},
                 {"vkQueuePresentKHR", VK_ERROR_OUT_OF_HOST_MEMORY},
                 {"vkCreateSwapchainKHR", VK_ERROR_OUT_OF_DEVICE_MEMORY},
                 {"vkGetPhysicalDeviceSurfaceCapabilitiesKHR", VK_ERROR_OUT_OF_HOST_MEMORY},
                 {"vkGetPhysicalDeviceSurfaceCapabilitiesKHR", VK_ERROR_SURFACE_LOST_KHR},
                 {"vkQueueSubmit", VK_ERROR_OUT_OF_HOST_MEMORY},
                 {"vkCreateFence", VK_ERROR_OUT_OF_HOST_MEMORY},
                 {"vkReleaseSwapchainImagesEXT", VK_ERROR_OUT_OF_HOST_MEMORY},
                 {"vkQueuePresentKHR", VK_ERROR_DEVICE_LOST},
                 {"vkQueueSubmit", VK_ERROR_DEVICE_LOST}}) {
            SCOPED_TRACE(function + ": " + std::to_string(result));
            faults::reset();
            faults::fail(function, 3, result);
            drag(run);
            ASSERT_TRUE(run.rest());
            EXPECT_EQ(faults::struck(), 1u);
            EXPECT_EQ(run.picture(), expected);
            for (const std::string& message : faults::messages()) ADD_FAILURE() << message;
        }
        EXPECT_EQ(run.devices(), 1 + 2);
    }
    expectNothingLeft();
}

// The extension as another driver has it. Mesa (25.0) jumps to nowhere where an image of a window that nobody sees is
// given back.
TEST(Resize, IsValidOnADriverThatHasTheExtension) {
    if (!NewerLavapipe::there()) GTEST_SKIP() << NewerLavapipe::kAbsent;
    const NewerLavapipe newer;
    {
        faults::reset();
        ViewerRun run;
        ASSERT_TRUE(run.rest());
        const std::uint64_t before = faults::count("vkDeviceWaitIdle");
        drag(run, false);
        ASSERT_TRUE(run.rest());
        EXPECT_EQ(faults::count("vkDeviceWaitIdle"), before);
        EXPECT_TRUE(run.said().empty()) << run.said().front();
    }
    expectNothingLeft();
}

}  // namespace
}  // namespace nacre::test
