// The picture at rest takes a sum of its samples and the colour of one, however many there are; counted by the fault
// layer.

#include "tests/faults/fault_run.h"
#include "tests/support/headless_surface.h"

namespace nacre::test {
namespace {

using Quality = WindowFrame::Quality;

TEST(Refined, TakesTwoImagesMoreHoweverManySamplesThereAre) {
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    faults::setWindowSize(96, 96);
    for (const Visibility path : {Visibility::encoded, Visibility::fragdepth, Visibility::deferred}) {
        Renderer renderer(DeviceOptions{.validate = true, .visibility = path, .surface = headlessSurface()});
        renderer.setScene(r);
        RenderSettings s = settings(r, 96, Projection::orthographic);
        s.occlusion.directions = 0;
        const auto countImages = [&](Quality quality, std::uint32_t samples) {
            faults::reset();
            for (std::uint32_t sample = 0; sample < samples; ++sample)
                EXPECT_EQ(renderer.present(s, {quality, 1, samples, sample, nullptr}), FrameOutcome::shown);
            EXPECT_EQ(faults::count("vkQueueSubmit"), samples);  // each is a frame that a touch may come behind
            return faults::count("vkCreateImage");
        };
        const std::uint64_t live =
            countImages(Quality::live, 1);  // what stays on the tile, which each kind of frame has
        EXPECT_GT(live, 0u);
        EXPECT_EQ(countImages(Quality::refined, 16), live + 2) << visibilityName(path);
        EXPECT_EQ(countImages(Quality::refined, 64), 0u) << visibilityName(path);
        EXPECT_EQ(countImages(Quality::live, 1), 0u) << visibilityName(path);
        for (const std::string& message : renderer.validationMessages()) ADD_FAILURE() << message;
    }
    haveSmallWindows();
}

}  // namespace
}  // namespace nacre::test
