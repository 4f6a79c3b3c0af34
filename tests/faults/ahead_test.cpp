// Pipelines that are made on a thread of their own, counted, and failed, by the fault layer: those that draw a
// picture's edges while that of its first pass is made; those of an occlusion bake beside that of its depth maps while
// somebody waits for the bake, and before its first submission beside frames.

#include <algorithm>
#include <chrono>
#include <thread>

#include "engine/error.h"
#include "tests/faults/fault_run.h"

namespace nacre::test {
namespace {

/// Pipelines that were made since, on this thread or on others.
std::ptrdiff_t made(bool here) {
    return std::ranges::count_if(faults::calls(), [&](const faults::Call& call) {
        const bool pipelines =
            call.function == "vkCreateComputePipelines" || call.function == "vkCreateGraphicsPipelines";
        return pipelines && (call.thread == std::this_thread::get_id()) == here;
    });
}

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

/// Depth maps by what tiles draw (where the device has those), and by both ways of rasterising.
class BakeAhead : public testing::TestWithParam<OcclusionMaps> {
protected:
    BakeAhead() {
        asked_.occlusion.directions = 16;
        asked_.occlusion.maps = GetParam();
        asked_.supersample = 1;
    }
    std::unique_ptr<Renderer> renderer(bool ahead) const {
        auto renderer = std::make_unique<Renderer>(DeviceOptions{true, "", Visibility::encoded});
        if (ahead) renderer->makePipelinesAhead();
        renderer->setScene(molecule_);
        renderer->drawFrame(withoutOcclusion());  // its pipelines are there
        faults::reset();
        return renderer;
    }
    RenderSettings withoutOcclusion() const {
        RenderSettings s = asked_;
        s.occlusion.directions = 0;
        return s;
    }
    /// Bakes as a window does between its frames.
    void bakeBeside(Renderer& renderer, const OcclusionPace& pace) const {
        for (int i = 0; i < 60'000 && renderer.advanceOcclusion(asked_, pace) < 1; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }

    const Representation molecule_ = scene("sample:glucose", Style::ballAndStick);
    RenderSettings asked_ = settings(molecule_, 64, Projection::orthographic);
};

TEST_P(BakeAhead, IsMadeBesideItsDepthMaps) {
    const auto alone = renderer(false), ahead = renderer(true);
    const std::vector<float> picture = alone->render(asked_).rgba;
    const std::ptrdiff_t count = made(true);
    EXPECT_GE(count, 4) << "of maps, of spheres' texels, of cylinders', and of their sums";
    EXPECT_EQ(made(false), 0);
    faults::reset();
    EXPECT_TRUE(ahead->render(asked_).rgba == picture);
    EXPECT_GE(made(false), 1);
    EXPECT_EQ(made(true) + made(false), count) << "what was wanted is what was asked for";
}

TEST_P(BakeAhead, BesideFramesNoneIsMadeHere) {
    // By tiles, parts want the same.
    const std::vector<double> slices = GetParam() == OcclusionMaps::tiles ? std::vector{4.0} : std::vector{4.0, 1e-4};
    for (const double milliseconds : slices) {  // the latter: depth maps in parts
        const auto ahead = renderer(true);
        bakeBeside(*ahead, {milliseconds});
        EXPECT_EQ(made(true), 0) << milliseconds;
        EXPECT_GE(made(false), 4);
        EXPECT_EQ(ahead->validationMessages(), std::vector<std::string>());
    }
}

struct FailingBakeAhead : BakeAhead {};

TEST_P(FailingBakeAhead, IsMadeAnewOrTold) {
    const std::vector<float> picture = renderer(false)->render(asked_).rgba;
    for (const char* function : {"vkCreateComputePipelines", "vkCreateGraphicsPipelines"})
        for (std::uint64_t number = 1; number <= 2; ++number) {
            const auto ahead = renderer(true);
            faults::fail(function, number, VK_ERROR_INITIALIZATION_FAILED);
            try {
                EXPECT_TRUE(ahead->render(asked_).rgba == picture);
            } catch (const Error& error) {
                EXPECT_NE(std::string(error.what()).find("pipeline"), std::string::npos) << error.what();
            }
            EXPECT_TRUE(ahead->render(asked_).rgba == picture);
        }
}

INSTANTIATE_TEST_SUITE_P(Maps, FailingBakeAhead, testing::Values(OcclusionMaps::encoded),
                         [](const auto&) { return std::string("encoded"); });
INSTANTIATE_TEST_SUITE_P(Maps, BakeAhead,
                         testing::Values(OcclusionMaps::tiles, OcclusionMaps::encoded, OcclusionMaps::fragdepth),
                         [](const auto& param) {
                             return param.param == OcclusionMaps::tiles     ? "tiles"
                                    : param.param == OcclusionMaps::encoded ? "encoded"
                                                                            : "fragdepth";
                         });

}  // namespace
}  // namespace nacre::test
