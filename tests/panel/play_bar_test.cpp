// The bar for playing and the card for films, on a screen that draws nothing.

#include <gtest/gtest.h>

#include <cmath>

#include "app/panel/panel.h"
#include "app/shared/trajectory_input.h"
#include "engine/molecule/read.h"

namespace nacre::app {
namespace {

class BlindScreen : public Screen {
public:
    void setScene(const Representation&) override {}
    double advanceOcclusion(const RenderSettings&, const OcclusionPace&) override { return 1; }
    FrameOutcome present(const RenderSettings&, const WindowFrame&) override { return FrameOutcome::shown; }
    PixelSize windowSize() const override { return {1, 1}; }
    std::uint32_t atomAt(const RenderSettings&, double, double, double) override { return 1; }
};

/// Sixty models of four atoms.
Sources movingSources() {
    Sources s;
    s.read = [](const SavedView& v) {
        std::string text;
        for (int m = 0; m < 60; ++m)
            text += "4\nframe\nC 0 0 0\nO " + std::to_string(1.2 + 0.01 * m) + " 0 0\nN 0 1.4 0\nC 0 0 1.5\n";
        ReadOptions options;
        options.model = v.model;
        options.others = true;
        return readMolecule(v.input, text, options);
    };
    s.build = sceneOfView;
    s.motion = [](const std::shared_ptr<const Molecule>& molecule, const SavedView& v) {
        return std::make_unique<Motion>(trajectoryOfModels(molecule, v.model), *molecule,
                                        motionOptions(v.trajectory, *molecule));
    };
    return s;
}

struct PlayBench {
    BlindScreen screen;
    Viewer viewer;
    Panel panel;
    PixelSize size;
    double now = 100;
    std::vector<RecordingWish> films;
    std::size_t keys = 0;
    RecordingState recording;

    explicit PlayBench(PixelSize points, PanelHand hand = PanelHand::mouse)
        : viewer(screen, movingSources(), viewOf(), {}), panel(1, host(), hand), size(points) {
        EXPECT_GT(panel.glyphs().width, 0u);
        viewer.resize(size, 1, now);
        settle();
    }
    static SavedView viewOf() {
        SavedView v;
        v.input = "models.xyz";
        return v;
    }
    PanelHost host() {
        PanelHost h;
        h.run = [this](ViewerCommand c) { viewer.run(c, now); };
        h.freeName = [](const char* extension) { return std::string("film") + extension; };
        h.record = [this](const RecordingWish& wish, const std::vector<SavedView>& views) {
            films.push_back(wish);
            keys = views.size();
        };
        h.recording = [this] { return recording; };
        h.stopRecording = [this] { recording.stopping = true; };
        h.videos = true;
        return h;
    }
    void frame() {
        now += 1.0 / 60;
        viewer.waitForFrame();
        viewer.update(now);
        panel.draw(viewer, size, now);
    }
    void settle() {
        for (int i = 0; i < 6; ++i) {
            viewer.waitForLoading();
            frame();
        }
    }
    const Control* find(const std::string& name) {
        for (const Control& c : panel.controls())
            if (c.name == name && c.seen() && c.role != "text") return &c;
        return nullptr;
    }
    bool says(const std::string& text) {
        for (const Control& c : panel.controls())
            if (c.name.find(text) != std::string::npos) return true;
        return false;
    }
    void clickAt(double x, double y) {
        panel.pointer({x, y});
        frame();
        panel.button(MouseButton::left, true);
        frame();
        panel.button(MouseButton::left, false);
        settle();
    }
    void click(const std::string& name) {
        const Control* c = find(name);
        ASSERT_TRUE(c) << name;
        clickAt((c->seenLeft + c->seenRight) / 2, (c->seenTop + c->seenBottom) / 2);
    }
};

void expectWhole(PlayBench& b, const std::string& where) {
    for (const Control& c : b.panel.controls()) {
        if (c.window == "Nacre") continue;
        EXPECT_FALSE(c.cut) << where << ": " << c.name;
        EXPECT_GE(c.left, 0) << where << ": " << c.name;
        EXPECT_LE(c.right, static_cast<float>(b.size.width) + 0.5f) << where << ": " << c.name;
        EXPECT_LE(c.seenBottom, static_cast<float>(b.size.height) + 0.5f) << where << ": " << c.name;
        for (const Control& d : b.panel.controls())
            EXPECT_FALSE(&c < &d && c.window == d.window &&
                         std::min(c.right, d.right) - std::max(c.left, d.left) > 1.5f &&
                         std::min(c.bottom, d.bottom) - std::max(c.top, d.top) > 1.5f)
                << where << ": " << c.name << " and " << d.name;
    }
}

TEST(PlayBar, StepsPlaysAndScrubs) {
    PlayBench b({1000, 700});
    EXPECT_TRUE(b.says("Model 1 of 60"));
    b.click("Next model");
    EXPECT_EQ(b.viewer.view().model, 2);
    EXPECT_TRUE(b.says("Model 2 of 60"));
    const Control* slider = b.find("Frame");
    ASSERT_TRUE(slider);
    b.clickAt((slider->left + slider->right) / 2, (slider->top + slider->bottom) / 2);
    EXPECT_NEAR(b.viewer.view().model, 30, 3);
    b.click("Play");
    EXPECT_TRUE(b.viewer.playing());
    EXPECT_TRUE(b.find("Pause"));
    b.click("How it is played");
    b.click("Order");
    b.click("To and fro");
    EXPECT_EQ(b.viewer.playback().order(), PlayOrder::toAndFro);
    b.click("Pause");
    b.click("Fit");
    b.click("Lay all atoms together");
    EXPECT_EQ(b.viewer.view().trajectory.fit->text, "all");
    EXPECT_TRUE(b.says("RMSD"));
}

TEST(PlayBar, AFingerThatHoldsTheSliderMovesIt) {
    PlayBench b({420, 760}, PanelHand::fingers);
    const Control* slider = b.find("Frame");
    ASSERT_TRUE(slider);
    const double y = (slider->top + slider->bottom) / 2, left = slider->left, right = slider->right;
    EXPECT_TRUE(b.panel.touch({1, TouchPhase::began, {left + 14, y}}));
    b.frame();
    for (int i = 1; i <= 10; ++i) {
        b.panel.touch({1, TouchPhase::moved, {left + 14 + (right - left - 28) * 0.1 * i, y}});
        b.frame();
    }
    EXPECT_GT(b.viewer.view().model, 50) << "before it lets go";
    b.panel.touch({1, TouchPhase::ended, {right - 14, y}});
    b.settle();
    EXPECT_EQ(b.viewer.view().model, 60);
}

TEST(PlayBar, IsWholeEverywhereAndNextToTheMolecule) {
    for (const auto& [size, hand] : {std::pair(PixelSize{1000, 700}, PanelHand::mouse),
                                     {PixelSize{360, 640}, PanelHand::mouse},
                                     {PixelSize{390, 780}, PanelHand::fingers},
                                     {PixelSize{900, 420}, PanelHand::fingers}}) {
        PlayBench b(size, hand);
        const std::string where = std::to_string(size.width) + "x" + std::to_string(size.height);
        expectWhole(b, where);
        const View view = b.viewer.settings().view;
        const Control* bar = b.find("Frame");
        ASSERT_TRUE(bar) << where;
        EXPECT_LE(view.height / 2.0 + (view.radius - view.pan.y) * view.pixelsPerAngstrom, bar->top) << where;
        b.click("How it is played");
        expectWhole(b, where + ", unfolded");
        b.panel.showRecord();
        b.settle();
        expectWhole(b, where + ", film");
        b.panel.closeTop();
    }
}

TEST(Films, AreAskedForAsTheCardSays) {
    PlayBench b({1000, 760});
    b.panel.showRecord();
    b.settle();
    b.click("Record");
    ASSERT_EQ(b.films.size(), 1u);
    EXPECT_EQ(b.films[0].motion, RecordingWish::Motion::spin);
    EXPECT_EQ(b.films[0].seconds, 6);
    EXPECT_EQ(b.films[0].path, "film.mp4");
    b.panel.showRecord();
    b.settle();
    b.click("Motion");
    b.click("Models");
    b.click("Film format");
    b.click("GIF");
    b.click("Record");
    ASSERT_EQ(b.films.size(), 2u);
    EXPECT_EQ(b.films[1].motion, RecordingWish::Motion::models);
    EXPECT_EQ(b.films[1].seconds, 6) << "sixty models, ten a second";
    EXPECT_EQ(b.films[1].framesPerSecond, 25);
    EXPECT_EQ(b.films[1].path, "film.gif");
    // Of views it takes two.
    b.panel.showRecord();
    b.settle();
    b.click("Motion");
    b.click("Kept views");
    b.click("Record");
    EXPECT_EQ(b.films.size(), 2u);
    b.click("Keep the view as it is now");
    b.viewer.run(ViewerCommand::zoomIn, b.now);
    b.click("Keep the view as it is now");
    b.click("Record");
    ASSERT_EQ(b.films.size(), 3u);
    EXPECT_EQ(b.keys, 2u);
    // While it goes on.
    b.recording.running = true;
    b.recording.frame = 12, b.recording.frames = 60, b.recording.share = 0.2, b.recording.left = 8;
    b.settle();
    EXPECT_TRUE(b.says("frame 12 of 60, 8 s left"));
    b.click("Stop");
    EXPECT_TRUE(b.recording.stopping);
}

}  // namespace
}  // namespace nacre::app
