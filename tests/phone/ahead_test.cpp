// Pipelines of the window's next shapes are made on a thread of their own: neither a zoom nor
// a smaller or a refined picture waits for one; and shapes stay while a zoom goes to and fro. In a window that
// nobody sees, which SwiftShader has, as a phone (tests/phone_layer), since software devices have one shape alone.

#include <chrono>
#include <cmath>
#include <fstream>
#include <sstream>
#include <thread>

#include "tests/renderer/scenes.h"
#include "tests/support/headless_surface.h"
#include "tests/support/temporary_folder.h"

namespace nacre::test {
namespace {

DeviceOptions window() {
    DeviceOptions options{.validate = true, .visibility = Visibility::encoded, .surface = headlessSurface()};
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

void neitherAZoomNorAnotherQualityWaits(const DeviceOptions& options) {
    const TemporaryFolder folder;
    const std::string file = folder / "pipelines";
    setenv("NACRE_PHONE_PIPELINES", file.c_str(), 1);
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    Renderer renderer(options);
    renderer.setScene(r);
    RenderSettings s = settings(r, 32, Projection::orthographic);
    s.occlusion.directions = 0;
    renderer.present(s, {});
    const PixelSize size = renderer.windowSize();
    const auto show = [&](double zoom, const WindowFrame& frame = {}) {
        s.view = makeView(Camera{.zoom = zoom}, r.radius, size.width, size.height);
        EXPECT_EQ(renderer.present(s, frame), FrameOutcome::shown);
    };
    show(0.002);  // spheres of a pixel
    const int first = Made(file).here;
    EXPECT_GT(first, 0);
    // Octagons of plates and of impostors, a smaller picture and the kept sum onto the window; and those of a window at
    // rest: its scene, the sum, and the sum onto the window.
    for (int i = 0; i < 3'000 && renderer.stats().pipelinesPending; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        show(0.002);
    }
    ASSERT_FALSE(renderer.stats().pipelinesPending);
    EXPECT_GE(Made(file).elsewhere, 6);
    for (const double zoom : {0.02, 0.1, 1.0, 0.002}) show(zoom);
    EXPECT_EQ(Made(file).here, first);
    WindowFrame other{.scale = 0.5};
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

TEST(PipelinesAhead, NeitherAZoomNorAnotherQualityWaitsForOne) { neitherAZoomNorAnotherQualityWaits(window()); }

// Frames at rest have single samples, by other pipelines than those in motion.
TEST(PipelinesAhead, NorDoesAWindowThatComesToRestAfterFramesOfFourSamples) {
    DeviceOptions options = window();
    options.visibility = Visibility::fragdepth;
    options.multisampling = Multisampling::four;
    neitherAZoomNorAnotherQualityWaits(options);
}

/// What the window's frames draw, by zoom.
class Shapes {
public:
    Shapes() : file_(folder_ / "draws"), renderer_(window()), scene_(scene("sample:glucose", Style::spacefill)) {
        setenv("NACRE_PHONE_DRAWS", file_.c_str(), 1);
        renderer_.setScene(scene_);
        settings_ = settings(scene_, 32, Projection::orthographic);
        settings_.occlusion.directions = 0;
        renderer_.present(settings_, {});
    }
    ~Shapes() { unsetenv("NACRE_PHONE_DRAWS"); }

    /// Corners of each draw of the next frame, and its timestamps.
    std::string at(double zoom, const WindowFrame& frame = {}) {
        const PixelSize size = renderer_.windowSize();
        settings_.view = makeView(Camera{.zoom = zoom}, scene_.radius, size.width, size.height);
        std::ofstream(file_, std::ios::trunc).close();
        EXPECT_EQ(renderer_.present(settings_, frame), FrameOutcome::shown);
        std::ostringstream draws;
        draws << std::ifstream(file_).rdbuf();
        EXPECT_FALSE(draws.str().empty());
        return draws.str();
    }

    double windowMilliseconds() const { return renderer_.stats().windowMilliseconds; }

    /// The zoom at which frames that come from one zoom no longer draw what they draw there, on the way to another.
    double changes(double from, double to) {
        const std::string there = at(from);
        double same = from, other = to;
        EXPECT_NE(at(to), there);
        for (int i = 0; i < 12; ++i) {
            const double middle = std::sqrt(same * other);
            EXPECT_EQ(at(from), there);
            (at(middle) == there ? same : other) = middle;
        }
        return other;
    }

private:
    const TemporaryFolder folder_;
    const std::string file_;
    Renderer renderer_;
    const Representation scene_;
    RenderSettings settings_;
};

// A timestamp is an encoder of its own over Metal: frames that nobody measures have none.
TEST(PipelinesAhead, OnlyLiveFramesAreTimed) {
    Shapes shapes;
    const auto countStamps = [&](const WindowFrame& frame) {
        std::istringstream lines(shapes.at(1, frame));
        int count = 0;
        for (std::string line; std::getline(lines, line);) count += line == "stamp";
        return count;
    };
    EXPECT_EQ(countStamps({}), 2);
    WindowFrame still{.quality = WindowFrame::Quality::refined, .samples = 4};
    EXPECT_EQ(countStamps(still), 0);
    still.quality = WindowFrame::Quality::kept;
    EXPECT_EQ(countStamps(still), 0);
    EXPECT_EQ(countStamps({}), 2);
    countStamps({});
    EXPECT_GT(shapes.windowMilliseconds(), 0);
}

TEST(PipelinesAhead, ShapesStayWhileAZoomGoesToAndFro) {
    Shapes shapes;
    const double up = shapes.changes(0.002, 1);
    const double down = shapes.changes(1.05 * up, 0.002);
    EXPECT_GT(up, 1.3 * down);
    const double between = std::sqrt(up * down);
    const std::string before = shapes.at(0.94 * between);
    for (int frame = 0; frame < 20; ++frame) EXPECT_EQ(shapes.at(between * (frame % 2 ? 0.94 : 1.06)), before);
}

}  // namespace
}  // namespace nacre::test
