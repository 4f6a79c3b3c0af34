// Pipelines of the window's next shapes are made on a thread of their own: neither a zoom nor
// a smaller or a refined picture waits for one. In a window that
// nobody sees, which SwiftShader has, as a phone (tests/phone_layer), since software devices have one shape alone.

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

#include "tests/renderer/scenes.h"
#include "tests/support/headless_surface.h"
#include "tests/support/temporary_folder.h"

namespace nacre::test {
namespace {

DeviceOptions window() {
    DeviceOptions options;
    options.validate = true;
    options.visibility = Visibility::encoded;
    options.surface = headlessSurface();
    return options;
}

/// Pipelines that were made so far, on this thread and on others.
struct Made {
    int here = 0, elsewhere = 0;
    explicit Made(const std::string& file) {
        std::ostringstream mine;
        mine << std::this_thread::get_id();
        std::ifstream lines(file);
        for (std::string line; std::getline(lines, line);) ++(line == mine.str() ? here : elsewhere);
    }
};

TEST(PipelinesAhead, NeitherAZoomNorAnotherQualityWaitsForOne) {
    const TemporaryFolder folder;
    const std::string file = folder / "pipelines";
    setenv("NACRE_PHONE_PIPELINES", file.c_str(), 1);
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    Renderer renderer(window());
    renderer.setScene(r);
    RenderSettings s = settings(r, 32, Projection::orthographic);
    s.occlusion.directions = 0;
    renderer.present(s, {});
    const PixelSize size = renderer.windowSize();
    const auto show = [&](double zoom, const WindowFrame& frame = {}) {
        Camera camera;
        camera.zoom = zoom;
        s.view = viewOf(camera, r.radius, size.width, size.height);
        EXPECT_EQ(renderer.present(s, frame), FrameOutcome::shown);
    };
    show(0.002);  // spheres of a pixel
    const int first = Made(file).here;
    EXPECT_GT(first, 0);
    for (int i = 0; i < 3'000 && Made(file).elsewhere < 6; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    // Octagons of plates and of impostors, a sum's first sample and its next, the sum onto the window, a smaller
    // picture onto the window.
    EXPECT_GE(Made(file).elsewhere, 6);
    for (const double zoom : {0.02, 0.1, 1.0, 0.002}) show(zoom);
    EXPECT_EQ(Made(file).here, first);
    WindowFrame other;
    other.scale = 0.5;
    show(1, other);
    EXPECT_EQ(Made(file).here, first) << "in a smaller picture";
    other = {};
    other.quality = WindowFrame::Quality::refined;
    for (other.samples = 4; other.sample < 2; ++other.sample) show(1, other);
    other.quality = WindowFrame::Quality::kept;
    show(1, other);
    EXPECT_EQ(Made(file).here, first) << "in a refined picture";
    unsetenv("NACRE_PHONE_PIPELINES");
    for (const std::string& message : renderer.validationMessages()) ADD_FAILURE() << message;
}

}  // namespace
}  // namespace nacre::test
