// The viewer goes on whatever happens to its window, its memory and its device, and shows the same picture.

#include "tests/faults_window/viewer_run.h"

namespace nacre::test {
namespace {

constexpr VkResult kWindowResults[] = {VK_ERROR_OUT_OF_DATE_KHR, VK_ERROR_SURFACE_LOST_KHR, VK_SUBOPTIMAL_KHR};

/// What the viewer shows when nothing happens, and the calls that it takes.
struct Undisturbed {
    std::vector<float> picture;
    std::size_t sites = 0;
    std::map<std::string, std::uint64_t> counts;

    explicit Undisturbed(int directions) {
        {
            faults::reset();
            ViewerRun run(directions);
            EXPECT_TRUE(run.rest());
            for (const char* function :
                 {"vkAcquireNextImageKHR", "vkQueuePresentKHR", "vkQueueSubmit", "vkWaitForFences", "vkDeviceWaitIdle"})
                counts[function] = faults::count(function);
            sites = test::sites(faults::calls());
            picture = run.picture();
            EXPECT_TRUE(run.said().empty());
        }
        expectNothingLeft();
        faults::reset();
    }
};

const Undisturbed& undisturbed() {
    static const Undisturbed it(0);
    return it;
}

void expectTheSame(ViewerRun& run, const Undisturbed& expected) {
    EXPECT_TRUE(run.rest());
    EXPECT_EQ(run.picture(), expected.picture);
    for (const std::string& message : run.said()) expectClear(message);
}

TEST(WindowFaults, AWindowThatIsOutOfDateOrGoneIsMadeAnewAndNothingIsSaid) {
    const Undisturbed& expected = undisturbed();
    {
        ViewerRun run;
        for (const char* function : {"vkAcquireNextImageKHR", "vkQueuePresentKHR"}) {
            for (std::uint64_t i = 1; i <= 2; ++i)  // the frame at once, and the refined one
                for (const VkResult result : kWindowResults) {
                    SCOPED_TRACE(std::string(function) + " " + std::to_string(i) + ": " + std::to_string(result));
                    faults::reset();
                    faults::fail(function, i, result);
                    run.redraw();
                    ASSERT_TRUE(run.rest());
                    EXPECT_EQ(faults::struck(), 1u);
                }
        }
        faults::reset();
        expectTheSame(run, expected);
        EXPECT_EQ(run.devices(), 1);
        EXPECT_TRUE(run.said().empty()) << run.said().front();
    }
    expectNothingLeft();
}

TEST(WindowFaults, AWindowThatIsNeverAsItShouldBeEndsNothing) {
    const Undisturbed& expected = undisturbed();
    {
        ViewerRun run;
        ASSERT_TRUE(run.rest());
        for (const char* function : {"vkAcquireNextImageKHR", "vkQueuePresentKHR"})
            for (const VkResult result : kWindowResults) {
                SCOPED_TRACE(std::string(function) + ": " + std::to_string(result));
                faults::reset();
                faults::failFrom(function, 1, result);
                run.redraw();
                run.rest(5);
                EXPECT_GT(faults::struck(), 1u);
                faults::reset();
                expectTheSame(run, expected);
            }
        EXPECT_EQ(run.devices(), 1);
        EXPECT_TRUE(run.said().empty()) << run.said().front();
    }
    expectNothingLeft();
}

TEST(WindowFaults, ALostDeviceIsReplacedAndTheLossIsSaid) {
    const int directions = everyCall() ? 3 : 0;
    const Undisturbed expected(directions);
    {
        ViewerRun run(directions);
        int losses = 0;
        for (const auto& [function, count] : expected.counts) {
            ASSERT_GE(count, 1u) << function;
            // Every one in turn, or one: of submissions that of a frame, behind those of the occlusion.
            const std::uint64_t first = everyCall() ? 1 : (count + 1) / 2, last = everyCall() ? count : first;
            for (std::uint64_t i = first; i <= last; ++i) {
                SCOPED_TRACE(function + " " + std::to_string(i));
                faults::reset();
                faults::fail(function, i, VK_ERROR_DEVICE_LOST);
                run.anew();
                ASSERT_TRUE(run.rest());
                if (faults::struck() == 0) continue;  // the window came to rest sooner
                ++losses;
                EXPECT_EQ(run.devices(), 1 + losses);
                ASSERT_FALSE(run.said().empty());
                EXPECT_TRUE(run.said().back().starts_with("the device was lost: ")) << run.said().back();
            }
        }
        EXPECT_GE(losses, everyCall() ? 15 : 4);
        faults::reset();
        expectTheSame(run, expected);
    }
    expectNothingLeft();
}

TEST(WindowFaults, MemoryRunsOutOnceAtEveryPlace) {
    const Undisturbed& expected = undisturbed();
    faults::failEverySite("*", VK_ERROR_OUT_OF_DEVICE_MEMORY);
    {
        std::unique_ptr<ViewerRun> run;
        for (int failed = 0; !run;) {
            try {
                run = std::make_unique<ViewerRun>();
            } catch (const Error& error) {
                expectClear(error.what());
                ASSERT_LT(++failed, 1000);
            }
        }
        // A scene that finds no room is not loaded: whoever wants it opens it again.
        for (int i = 0; i < 100 && !run->rest(); ++i)
            if (!run->viewer().document()) run->open();
        EXPECT_GE(faults::struck(), expected.sites);
        EXPECT_GT(run->said().size(), 3u);
        faults::reset();
        expectTheSame(*run, expected);
        EXPECT_EQ(run->devices(), 1);
    }
    expectNothingLeft();
}

TEST(WindowFaults, AnOcclusionThatFailsHalfWayIsBegunAnew) {
    const Undisturbed expected(3);
    {
        ViewerRun run(3);
        ASSERT_TRUE(run.rest());
        // Of a new scene: the submission of a direction, and the wait for one, which is done all the same.
        for (const char* function : {"vkQueueSubmit", "vkWaitForFences"}) {
            faults::reset();
            run.forgetScene();
            faults::fail(function, 2, VK_ERROR_OUT_OF_HOST_MEMORY);
            run.forgetSaid();
            run.anew();
            ASSERT_TRUE(run.rest());
            EXPECT_EQ(faults::struck(), 1u);
            ASSERT_FALSE(run.said().empty());
            EXPECT_TRUE(run.said().back().starts_with("out of memory: ")) << run.said().back();
            EXPECT_EQ(run.picture(), expected.picture);
        }
        faults::reset();
        run.forgetScene();
        faults::fail("vkQueueSubmit", 2, VK_ERROR_DEVICE_LOST);
        run.anew();
        expectTheSame(run, expected);
        EXPECT_EQ(run.devices(), 2);
        EXPECT_NE(run.said().back().find("last submitted: [occlusion: "), std::string::npos) << run.said().back();
    }
    expectNothingLeft();
}

/// Loses the device at the next submission and comes to rest. @returns whether it did
bool loseOnce(ViewerRun& run) {
    faults::reset();
    faults::fail("vkQueueSubmit", 1, VK_ERROR_DEVICE_LOST);
    run.redraw();
    return run.rest() && faults::struck() == 1;
}

TEST(WindowFaults, LossesOfALongSittingAreForgottenAndThoseOfAMinuteAreNot) {
    {
        ViewerRun run;
        ASSERT_TRUE(run.rest());
        for (int loss = 1; loss <= 6; ++loss) {
            ASSERT_TRUE(loseOnce(run)) << loss;
            EXPECT_EQ(run.devices(), 1 + loss);
        }
        run.secondsAfterALoss = 1;
        for (int loss = 1; loss <= app::Session::kMostLosses; ++loss) ASSERT_TRUE(loseOnce(run)) << loss;
        try {
            loseOnce(run);
            ADD_FAILURE() << "a device that is lost again and again is made again and again";
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).rfind("drawing was given up: 4 times within minutes: the device", 0),
                      0u)
                << error.what();
        }
        EXPECT_EQ(run.devices(), 1 + 6 + 3);
    }
    expectNothingLeft();
}

}  // namespace
}  // namespace nacre::test
