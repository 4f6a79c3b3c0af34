// When a window's frames start, by a display with a clock of its own (tests/fault_layer/display.h), which tells when it
// shows a frame: VK_KHR_present_wait, and its second version.

#include "tests/faults/fault_run.h"
#include "tests/support/headless_surface.h"

namespace nacre::test {
namespace {

using faults::Display;
using State = WindowPace::State;

constexpr double kInterval = 1.0 / 64;

/// A window whose picture moves, on such a display.
class MovingWindow {
public:
    explicit MovingWindow(const Display& display) {
        faults::reset();
        faults::setDisplay(display);
        faults::setWindowSize(32, 32);
        DeviceOptions options;
        options.validate = display.version == 1;  // the validation layer is older than the second
        options.visibility = Visibility::fragdepth;
        options.surface = headlessSurface();
        options.surface.clock = faults::displayTime;
        renderer_ = std::make_unique<Renderer>(options);
        const Representation r = scene("sample:glucose", Style::spacefill);
        settings_ = settings(r, 32, Projection::orthographic);
        renderer_->setScene(r);
    }
    ~MovingWindow() {
        if (renderer_) {
            EXPECT_EQ(renderer_->validationMessages(), std::vector<std::string>());
        }
        renderer_.reset();
        faults::setDisplay({});
        haveSmallWindows();
        faults::reset();
    }

    /// Draws a number of frames. @param work  seconds of the program for each
    void run(int frames, double work = kInterval / 8) {
        for (int i = 0; i < frames; ++i) {
            renderer_->awaitFrame();
            renderer_->awaitFrame();  // the viewer waits before it reads input, and before it draws
            started_ = faults::displayTime();
            faults::passTime(work);
            last_ = renderer_->present(settings_, {});
            if (last_ == FrameOutcome::shown) delays_.push_back(faults::presents().back().shown - started_);
        }
    }
    void resize(std::uint32_t size) {
        faults::setWindowSize(size, size);
        settings_.view.width = settings_.view.height = size;
    }
    /// Intervals per frame of the last ones.
    static double intervals(std::size_t frames) {
        const auto& presents = faults::presents();
        return (presents.back().taken - presents[presents.size() - 1 - frames].taken) / kInterval / double(frames);
    }
    /// Intervals from the start of the last frames to their display.
    double delay(std::size_t frames) const {
        double sum = 0;
        for (std::size_t i = delays_.size() - frames; i < delays_.size(); ++i) sum += delays_[i];
        return sum / kInterval / double(frames);
    }
    WindowPace pace() const { return renderer_->stats().windowPace; }
    FrameOutcome last() const { return last_; }
    Renderer& renderer() { return *renderer_; }

private:
    std::unique_ptr<Renderer> renderer_;
    RenderSettings settings_;
    double started_ = 0;
    std::vector<double> delays_;
    FrameOutcome last_ = FrameOutcome::hidden;
};

std::uint64_t waits() { return faults::count("vkWaitForPresentKHR"); }

TEST(WindowPace, WaitsForTheDisplayWhereThatCostsNoFrame) {
    for (const int version : {1, 2}) {
        SCOPED_TRACE(version);
        MovingWindow window({version, kInterval, 1});
        window.run(14);
        EXPECT_EQ(window.pace().state, State::freely);
        EXPECT_DOUBLE_EQ(window.intervals(8), 1);
        const double before = window.delay(8);
        window.run(100);
        EXPECT_EQ(window.pace().state, State::waiting);
        EXPECT_DOUBLE_EQ(window.intervals(90), 1);
        EXPECT_NEAR(before, 3, 0.01);  // the image is free, the frame is drawn, taken, and shown an interval later
        EXPECT_NEAR(window.delay(80), 2, 0.01);
        EXPECT_NEAR(window.pace().displayMilliseconds, 2000 * kInterval, 0.01);
    }
}

TEST(WindowPace, StopsWaitingWhereThatCostsFrames) {
    for (const int version : {1, 2}) {
        SCOPED_TRACE(version);
        MovingWindow window({version, kInterval, 2});  // waiting, a display of 60 Hz would show 40 frames
        window.run(14);
        EXPECT_NEAR(window.delay(8), 4, 0.01);
        window.run(20);
        EXPECT_NEAR(window.delay(10), 3, 0.01);
        ASSERT_EQ(window.pace().state, State::waiting);  // it is tried
        EXPECT_NEAR(window.intervals(10), 1.5, 0.1);
        window.run(30);
        EXPECT_EQ(window.pace().state, State::resting);
        EXPECT_EQ(window.pace().displayMilliseconds, 0);
        const std::uint64_t before = waits();
        window.run(500);
        EXPECT_EQ(waits(), before);
        EXPECT_DOUBLE_EQ(window.intervals(500), 1);
        window.run(200);  // another try, of 18 frames
        EXPECT_EQ(window.pace().state, State::resting);
        EXPECT_NEAR(window.intervals(200), 1.045, 0.02);
        // Another compositor: the next try, 1200 frames later, finds that waiting costs nothing now.
        faults::setDisplay(Display{version, kInterval, 1});
        const std::uint64_t tried = waits();
        window.run(900);
        EXPECT_EQ(waits(), tried);
        window.run(400);
        EXPECT_EQ(window.pace().state, State::waiting);
        EXPECT_DOUBLE_EQ(window.intervals(100), 1);
    }
}

TEST(WindowPace, NumbersRiseOverSwapchains) {
    for (const int version : {1, 2}) {
        SCOPED_TRACE(version);
        MovingWindow window({version, kInterval, 1});
        window.run(60);
        EXPECT_EQ(window.pace().state, State::waiting);
        for (const std::uint32_t size : {48u, 40u, 32u}) {
            const std::uint64_t made = faults::count("vkCreateSwapchainKHR");
            window.resize(size);
            window.run(20);
            EXPECT_EQ(window.last(), FrameOutcome::shown);
            EXPECT_EQ(faults::count("vkCreateSwapchainKHR"), made + 1);
        }
        window.renderer().releaseWindow();
        window.run(20);
        // The layer ends the program at a number that does not rise, or a wait for one of another swapchain.
        EXPECT_EQ(faults::presents().front().number, 1u);
        EXPECT_GE(faults::presents().back().number, 135u);
        EXPECT_EQ(window.pace().state, State::waiting);
    }
}

TEST(WindowPace, GivesUpWhereNothingIsShown) {
    MovingWindow window({1, kInterval, 1});
    window.run(60);
    ASSERT_EQ(window.pace().state, State::waiting);
    faults::setDisplay(Display{1, kInterval, 1, false});
    const double before = faults::displayTime();
    window.run(100);
    EXPECT_EQ(window.pace().state, State::resting);
    // Two frames were on their way, then one wait took its full time.
    EXPECT_LT(faults::displayTime() - before, 103 * kInterval + 0.1);
    EXPECT_GT(faults::displayTime() - before, 0.1);
}

TEST(WindowPace, LivesWithAWaitThatFails) {
    MovingWindow window({1, kInterval, 1});
    window.run(60);
    for (const VkResult result : {VK_ERROR_OUT_OF_DATE_KHR, VK_ERROR_SURFACE_LOST_KHR, VK_SUBOPTIMAL_KHR,
                                  VK_ERROR_OUT_OF_HOST_MEMORY, VK_ERROR_OUT_OF_DEVICE_MEMORY})
        for (const std::uint64_t call : {1u, 2u}) {  // the question, and the wait
            SCOPED_TRACE(std::to_string(result) + " of call " + std::to_string(call));
            const std::uint64_t struck = faults::struck(), made = faults::count("vkCreateSwapchainKHR");
            faults::fail("vkWaitForPresentKHR", call, result);
            window.run(10);
            EXPECT_EQ(faults::struck(), struck + 1);
            EXPECT_EQ(window.last(), FrameOutcome::shown);
            const bool stale = result != VK_ERROR_OUT_OF_HOST_MEMORY && result != VK_ERROR_OUT_OF_DEVICE_MEMORY;
            EXPECT_EQ(faults::count("vkCreateSwapchainKHR"), made + stale);
        }
    faults::fail("vkWaitForPresentKHR", 1, VK_ERROR_DEVICE_LOST);
    window.run(1);
    EXPECT_EQ(window.last(), FrameOutcome::lost);
    EXPECT_NE(window.renderer().deviceLoss().find("waiting for the display"), std::string::npos);
}

TEST(WindowPace, DoesWithoutWhereNothingTells) {
    {
        MovingWindow window(Display{.version = 2, .interval = kInterval, .latency = 1, .surfaceSupports = false});
        window.run(60);
        EXPECT_EQ(window.pace().state, State::absent);
        EXPECT_EQ(window.last(), FrameOutcome::shown);
        EXPECT_EQ(waits(), 0u);
    }
    faults::hideExtensions({VK_KHR_PRESENT_WAIT_EXTENSION_NAME});
    {
        MovingWindow window({1, kInterval, 1});
        window.run(60);
        EXPECT_EQ(window.pace().state, State::absent);
        EXPECT_EQ(window.last(), FrameOutcome::shown);
        EXPECT_EQ(waits(), 0u);
    }
    faults::hideExtensions({});
}

}  // namespace
}  // namespace nacre::test
