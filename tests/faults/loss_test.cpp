// The device is lost at one submission or wait after the other: the error tells what is known, nothing is left behind,
// and another renderer draws the same picture.

#include "tests/faults/small_run.h"

namespace nacre::test {
namespace {

class Loss : public testing::Test {
protected:
    /// @returns the error's text
    std::string loseAt(const std::string& function, std::uint64_t number) {
        SCOPED_TRACE(function + " " + std::to_string(number));
        std::string text;
        faults::reset();
        faults::fail(function, number, VK_ERROR_DEVICE_LOST);
        {
            std::optional<Renderer> renderer;
            try {
                run_(renderer);
                ADD_FAILURE() << "no error";
            } catch (const Error& error) {
                text = error.what();
                expectClear(text);
                EXPECT_TRUE(text.starts_with("the device was lost: ")) << text;
            }
            if (renderer) {
                EXPECT_EQ(renderer->deviceLoss(), text);
                // It stays lost, and says so.
                EXPECT_THROW(run_.smaller(*renderer), Error);
                EXPECT_THROW(run_(renderer), Error);
            }
        }
        expectNothingLeft();
        return text;
    }
    Pictures fresh() {
        faults::reset();
        std::optional<Renderer> renderer;
        const Pictures pictures = run_(renderer);
        EXPECT_EQ(renderer->deviceLoss(), "");
        submissions_ = faults::count("vkQueueSubmit");
        waits_ = faults::count("vkWaitForFences");
        return pictures;
    }

    SmallRun run_{Visibility::encoded};
    std::uint64_t submissions_ = 0, waits_ = 0;
};

TEST_F(Loss, AtEverySubmissionAndWaitTellsTheWorkAndTheNextDeviceDrawsTheSame) {
    const Pictures before = fresh();
    const std::uint64_t submissions = submissions_, waits = waits_;
    ASSERT_GE(submissions, 5u);
    ASSERT_GE(waits, 5u);
    for (std::uint64_t i = 1; i <= submissions; ++i) {
        const std::string text = loseAt("vkQueueSubmit", i);
        const char* work = i == 1                 ? "last submitted: [white: upload];"
                           : i + 1 == submissions ? "last submitted: [screen: opaque prepass, depth encoding, impostor "
                                                    "colour, read back], before it [occlusion finish: occlusion finish,"
                           : i == submissions     ? "surface layer"
                                                  : "last submitted: [occlusion";
        EXPECT_NE(text.find(work), std::string::npos) << i << ": " << text;
        EXPECT_NE(text.find("; the driver tells no more"), std::string::npos) << text;
    }
    for (std::uint64_t i = 1; i <= waits; ++i) loseAt("vkWaitForFences", i);
    EXPECT_EQ(fresh(), before);
}

TEST(LossInFlight, GivesUpThePicturesThatAreStarted) {
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    RenderSettings s = settings(r, 48, Projection::orthographic);
    s.occlusion.directions = 0;
    const auto run = [&](std::optional<Renderer>& renderer) {
        renderer.emplace(DeviceOptions{.validate = true, .visibility = Visibility::tiles});
        renderer->setScene(r);
        for (int i = 0; i < 4; ++i) {
            renderer->startCoded(s, true);
            if (renderer->started() > 2) renderer->finishCoded();
        }
        while (renderer->started() > 0) renderer->finishCoded();
    };
    for (const char* function : {"vkQueueSubmit", "vkWaitForFences"}) {
        faults::reset();
        {
            std::optional<Renderer> renderer;
            run(renderer);
        }
        const std::uint64_t calls = faults::count(function);
        ASSERT_GE(calls, 4u);
        for (std::uint64_t i = 1; i <= calls; ++i) {
            SCOPED_TRACE(function + std::string(" ") + std::to_string(i));
            faults::reset();
            faults::fail(function, i, VK_ERROR_DEVICE_LOST);
            {
                std::optional<Renderer> renderer;
                EXPECT_THROW(run(renderer), Error);
                if (renderer) {
                    EXPECT_EQ(renderer->started(), 0u);
                    EXPECT_NE(renderer->deviceLoss(), "");
                    EXPECT_THROW(renderer->startCoded(s, true), Error);
                }
            }
            expectNothingLeft();
        }
    }
}

TEST_F(Loss, TheDriversOwnAccountIsInTheError) {
    faults::offerFaultData(true);
    const std::string text = loseAt("vkQueueSubmit", 3);
    faults::offerFaultData(false);
    EXPECT_NE(text.find("the driver tells: page fault of the fault layer, WriteInvalid at 0xdead0000 to 0xdead0fff, "
                        "shader core (code 0x7, data 0x9)"),
              std::string::npos)
        << text;
}

}  // namespace
}  // namespace nacre::test
