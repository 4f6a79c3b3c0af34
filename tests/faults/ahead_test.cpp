// The pipelines that draw a picture's edges are made on a thread of their own while that of its first pass is made;
// counted, and failed, by the fault layer.

#include <algorithm>
#include <thread>

#include "engine/error.h"
#include "tests/faults/fault_run.h"

namespace nacre::test {
namespace {

struct EdgesAhead : testing::Test {
    const Representation molecule = scene("sample:glucose", Style::ballAndStick);
    RenderSettings asked = settings(molecule, 64, Projection::orthographic);
    EdgesAhead() { asked.supersample = RenderSettings::kEdges; }

    std::vector<float> draw(bool ahead) const {
        Renderer renderer(DeviceOptions{false, "", Visibility::tiles});
        if (ahead) renderer.makePipelinesAhead();
        renderer.setScene(molecule);
        faults::reset();
        return renderer.render(asked).rgba;
    }
    /// Compute pipelines that were made since, on this thread or on others.
    static std::ptrdiff_t made(bool here) {
        return std::ranges::count_if(faults::calls(), [&](const faults::Call& call) {
            return call.function == "vkCreateComputePipelines" && (call.thread == std::this_thread::get_id()) == here;
        });
    }
};

TEST_F(EdgesAhead, AreMadeBesideTheFirstPass) {
    const std::vector<float> alone = draw(false);
    const std::ptrdiff_t count = made(true);
    EXPECT_EQ(count, 3);
    EXPECT_EQ(made(false), 0);
    EXPECT_TRUE(draw(true) == alone);
    EXPECT_GE(made(false), 1);
    EXPECT_EQ(made(true) + made(false), count) << "what was wanted is what was asked for";
}

TEST_F(EdgesAhead, OneThatCannotBeMadeIsMadeAnewOrTold) {
    const std::vector<float> alone = draw(false);
    for (std::uint64_t number = 1; number <= 3; ++number) {
        Renderer renderer(DeviceOptions{false, "", Visibility::tiles});
        renderer.makePipelinesAhead();
        renderer.setScene(molecule);
        faults::reset();
        faults::fail("vkCreateComputePipelines", number, VK_ERROR_INITIALIZATION_FAILED);
        try {
            EXPECT_TRUE(renderer.render(asked).rgba == alone);
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("pipeline"), std::string::npos) << error.what();
        }
        EXPECT_EQ(faults::struck(), 1u);
        EXPECT_TRUE(renderer.render(asked).rgba == alone);
    }
    // A driver that makes none is told of.
    Renderer renderer(DeviceOptions{false, "", Visibility::tiles});
    renderer.makePipelinesAhead();
    renderer.setScene(molecule);
    faults::reset();
    faults::failFrom("vkCreateComputePipelines", 1, VK_ERROR_INITIALIZATION_FAILED);
    EXPECT_THROW(renderer.render(asked), Error);
    faults::reset();
}

}  // namespace
}  // namespace nacre::test
