// A frame like the one before, seen from elsewhere, makes no object of Vulkan's, whatever the path; counted by the
// fault layer.

#include "tests/faults/fault_run.h"

namespace nacre::test {
namespace {

TEST(SteadyFrames, MakeNeitherBuffersNorImagesNorMemory) {
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    for (const Visibility path :
         {Visibility::encoded, Visibility::fragdepth, Visibility::deferred, Visibility::tiles}) {
        Renderer renderer(DeviceOptions{false, "", path});
        renderer.setScene(r);
        RenderSettings s = settings(r, 64, Projection::orthographic);
        s.occlusion.directions = 0;
        s.effects.clip.near = 1;  // hatches go by the scale of the picture
        Camera camera;
        const auto draw = [&](int frames) {
            for (int i = 0; i < frames; ++i) {
                camera.rotationDegrees.y += 5;
                camera.zoom *= 1.01;
                s.view = makeView(camera, r.radius, 64, 64);
                renderer.drawFrame(s);
            }
        };
        draw(12);  // lists of tiles grow by and by
        faults::reset();
        draw(12);
        for (const char* made : {"vkCreateBuffer", "vkCreateImage", "vkAllocateMemory", "vkCreateGraphicsPipelines"})
            EXPECT_EQ(faults::count(made), 0u) << made << ", " << visibilityName(path);
        EXPECT_GT(faults::count("vkQueueSubmit"), 0u);
    }
}

}  // namespace
}  // namespace nacre::test
