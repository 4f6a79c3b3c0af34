// While a file is read, the pipelines of its first picture are made on a thread of their own. In a window that nobody
// sees; counted by the fault layer.

#include <algorithm>
#include <future>

#include "tests/faults_window/viewer_run.h"

namespace nacre::test {
namespace {

constexpr const char* kMakes[] = {"vkCreateGraphicsPipelines", "vkCreateComputePipelines"};

struct File {
    Visibility path;
    const char* input;
    Style style;
};

/// A viewer whose file is read when it is let.
class SlowRead {
public:
    explicit SlowRead(const File& file) : path_(file.path), session_(host(), sources(), makeView(file), {}, {}) {
        session_.open(now_);
        viewer().frames().resize({64, 64}, 1, now_);
        for (int i = 0; i < 5; ++i) step();
    }
    ~SlowRead() { read(); }

    app::Viewer& viewer() { return session_.viewer(); }
    void step() {
        session_.step(now_ += 0.02, [this] { return &overlay_; });
    }
    void read() {
        if (!std::exchange(isRead_, true)) mayRead_.set_value();
        viewer().reading().loader().wait();
    }
    std::uint64_t frames() { return session_.renderer()->stats().windowFrames; }

private:
    app::SessionHost host() {
        app::SessionHost host;
        host.device = [this] {
            DeviceOptions options{.validate = true, .visibility = path_, .surface = headlessSurface()};
            return options;
        };
        host.loadPipelines = [] { return std::vector<std::byte>(); };
        return host;
    }
    app::Sources sources() {
        const std::shared_future<void> may = mayRead_.get_future().share();
        return {[may](const app::PictureDescription& v) {
            may.wait();
            return sampleMolecule(v.input.path.substr(7));
        }};
    }
    static app::PictureDescription makeView(const File& file) {
        app::PictureDescription view;
        view.input.path = file.input;
        view.look.style = file.style;
        view.occlusion.directions = 0;
        return view;
    }

    const Visibility path_;
    std::promise<void> mayRead_;
    bool isRead_ = false;
    double now_ = 100;
    const Overlay overlay_ = ViewerRun::triangle();
    app::Session session_;
};

/// Until no thread has made a pipeline for long.
void waitForPipelines() {
    const auto made = [] { return faults::count(kMakes[0]) + faults::count(kMakes[1]); };
    std::uint64_t before = made();
    for (int still = 0; still < 70; ++still) {
        std::this_thread::sleep_for(std::chrono::milliseconds(15));
        if (const std::uint64_t now = made(); now != before) before = now, still = 0;
    }
}

struct ReadAhead : testing::TestWithParam<File> {};

TEST_P(ReadAhead, TheFirstPictureWaitsForNoPipeline) {
    {
        SlowRead run(GetParam());
        EXPECT_GT(run.frames(), 0u);
        waitForPipelines();
        faults::reset();
        run.read();
        const std::uint64_t before = run.frames();
        for (int i = 0; i < 100 && (!run.viewer().document() || run.frames() == before); ++i) run.step();
        EXPECT_TRUE(run.viewer().document());
        EXPECT_GT(run.frames(), before);
    }
    const auto here = [](const faults::Call& call) {
        return std::ranges::count(kMakes, call.function) > 0 && call.thread == std::this_thread::get_id();
    };
    EXPECT_EQ(std::ranges::count_if(faults::calls(), here), 0);
    for (const std::string& message : faults::messages()) ADD_FAILURE() << message;
}

TEST(ReadAheadOf, AnyQualityOfFrames) {
    Renderer renderer(DeviceOptions{.validate = true, .visibility = Visibility::encoded, .surface = headlessSurface()});
    renderer.setScene({});
    const Representation like = scene("sample:glucose", Style::spacefill);
    RenderSettings s = settings(like, 64, Projection::orthographic);
    s.occlusion.directions = 0;
    renderer.present(s, {});
    s.view = makeView({}, like.radius, renderer.windowSize().width, renderer.windowSize().height);
    EXPECT_EQ(renderer.present(s, {}), FrameOutcome::shown);
    using Quality = WindowFrame::Quality;
    for (const Quality quality : {Quality::live, Quality::refined, Quality::kept}) {
        s.effects.fog.range = quality == Quality::live ? Fog::Range::off : Fog::Range::automatic;
        s.lighting = quality != Quality::kept;
        waitForPipelines();
        faults::reset();
        renderer.expectScene(like, s, WindowFrame{.quality = quality});
        waitForPipelines();
        EXPECT_GT(faults::count(kMakes[0]), 0u);
    }
}

INSTANTIATE_TEST_SUITE_P(Files, ReadAhead,
                         testing::Values(File{Visibility::encoded, "sample:buckyball", Style::spacefill},
                                         File{Visibility::encoded, "sample:dna", Style::licorice},
                                         File{Visibility::encoded, "sample:dna", Style::cartoon},
                                         File{Visibility::fragdepth, "sample:dna", Style::licorice},
                                         File{Visibility::deferred, "sample:dna", Style::cartoon},
                                         File{Visibility::tiles, "sample:dna", Style::licorice}));

}  // namespace
}  // namespace nacre::test
