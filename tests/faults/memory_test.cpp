// Memory runs out at one call after the other, and pipelines cannot be made: an error in words, nothing left behind,
// and the renderer goes on.

#include <algorithm>

#include "tests/faults/small_run.h"

namespace nacre::test {
namespace {

class MemoryFaults : public testing::Test {
protected:
    void SetUp() override {
        {
            std::optional<Renderer> renderer;
            faults::reset();
            expected_ = run_(renderer);
            calls_ = faults::calls();
            smaller_ = run_.smaller(*renderer);
        }
        expectNothingLeft();
        faults::reset();
    }

    /// @returns whether there was an error
    bool runs(std::optional<Renderer>& renderer, bool keep = false) {
        try {
            EXPECT_EQ(run_(renderer, keep), expected_);
            return true;
        } catch (const Error& error) {
            expectClear(error.what());
            return false;
        }
    }

    SmallRun run_{Visibility::encoded};
    Pictures expected_, smaller_;
    std::vector<faults::Call> calls_;
};

TEST_F(MemoryFaults, OnceFromEveryPlaceAndTheSameRendererDrawsTheSamePicture) {
    faults::failEverySite("*", VK_ERROR_OUT_OF_HOST_MEMORY);
    int errors = 0;
    {
        std::optional<Renderer> renderer;
        while (!runs(renderer, true)) {
            ASSERT_LT(++errors, 1000);
            if (HasFailure()) FAIL() << "after " << faults::calls().back().function;
        }
        EXPECT_GE(faults::struck(), sites(calls_));
        EXPECT_GT(errors, 100);
        faults::reset();
        EXPECT_EQ(run_.smaller(*renderer), smaller_);
    }
    expectNothingLeft();
}

TEST_F(MemoryFaults, NoMemoryFromEveryAllocationOn) {
    std::optional<Renderer> renderer;
    std::uint64_t first = 1;
    for (;; ++first) {
        renderer.reset();  // it would keep the memory that the last run allocated
        faults::reset();
        faults::failFrom("vkAllocateMemory", first, VK_ERROR_OUT_OF_DEVICE_MEMORY);
        if (runs(renderer)) break;
        ASSERT_LT(first, 1000u);
        if (!renderer) continue;
        // Nothing is left to be allocated, and the scene that was there can still not be drawn; then there is again.
        faults::reset();
        if (first % 5 == 0) {
            EXPECT_TRUE(runs(renderer));
        }
    }
    EXPECT_GT(first, 10u);
    renderer.reset();
    expectNothingLeft();
}

TEST_F(MemoryFaults, EveryPipelineInTurnCannotBeMade) {
    const auto countCalls = [&](const char* function) {
        return std::count_if(calls_.begin(), calls_.end(), [&](const auto& call) { return call.function == function; });
    };
    std::optional<Renderer> renderer;
    const auto failsAt = [&](const char* function, std::uint64_t number) {
        faults::reset();
        faults::fail(function, number, VK_ERROR_INITIALIZATION_FAILED);
        return !runs(renderer);
    };
    // They are kept, so that each run makes the one that failed, and fails at the next.
    for (const char* function : {"vkCreateComputePipelines", "vkCreateGraphicsPipelines"}) {
        renderer.reset();
        ASSERT_TRUE(failsAt(function, 1));
        int made = 1;
        while (failsAt(function, 2)) ASSERT_LT(++made, 1000);
        EXPECT_GT(made, 2);
        EXPECT_EQ(made, countCalls(function)) << function;
    }
    renderer.reset();
    expectNothingLeft();
}

TEST_F(MemoryFaults, ACacheThatTheDriverRefusesIsDropped) {
    std::optional<Renderer> renderer;
    ASSERT_TRUE(runs(renderer));
    run_.startFrom(renderer->pipelineCache());
    renderer.reset();
    faults::reset();
    faults::fail("vkCreatePipelineCache", 1, VK_ERROR_OUT_OF_HOST_MEMORY);
    EXPECT_TRUE(runs(renderer));
    EXPECT_EQ(faults::count("vkCreatePipelineCache"), 2u);
    renderer.reset();
    expectNothingLeft();
}

/// The whole walk: NACRE_FAULTS_ALL=1.
TEST_F(MemoryFaults, AtEveryCallInTurnInARunOfItsOwn) {
    const std::uint64_t count = everyCall() ? calls_.size() : 2;
    for (std::uint64_t i = 1; i <= count; ++i) {
        SCOPED_TRACE(calls_[i - 1].function + ", call " + std::to_string(i));
        faults::reset();
        faults::fail("*", i, i % 2 ? VK_ERROR_OUT_OF_DEVICE_MEMORY : VK_ERROR_OUT_OF_HOST_MEMORY);
        {
            std::optional<Renderer> renderer;
            if (!runs(renderer) && renderer && renderer->stats().occlusion.directions > 0) {
                EXPECT_EQ(run_.smaller(*renderer), smaller_);
            }
            EXPECT_TRUE(runs(renderer));
        }
        EXPECT_EQ(faults::struck(), 1u);
        expectNothingLeft();
    }
}

}  // namespace
}  // namespace nacre::test
