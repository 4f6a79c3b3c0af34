// Pipelines of the window's next shapes are made on a thread of their own: a zoom waits for none. In a window that
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

TEST(PipelinesAhead, AZoomWaitsForNone) {
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
    const auto show = [&](double zoom) {
        Camera camera;
        camera.zoom = zoom;
        s.view = viewOf(camera, r.radius, size.width, size.height);
        EXPECT_EQ(renderer.present(s, {}), FrameOutcome::shown);
    };
    show(0.002);  // spheres of a pixel
    const int first = Made(file).here;
    EXPECT_GT(first, 0);
    for (int i = 0; i < 3'000 && Made(file).elsewhere < 2; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_GE(Made(file).elsewhere, 2);  // octagons of plates and of impostors
    for (const double zoom : {0.02, 0.1, 1.0, 0.002}) show(zoom);
    EXPECT_EQ(Made(file).here, first);
    unsetenv("NACRE_PHONE_PIPELINES");
    for (const std::string& message : renderer.validationMessages()) ADD_FAILURE() << message;
}

}  // namespace
}  // namespace nacre::test
