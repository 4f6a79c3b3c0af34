// The bar for playing and the card for films, on a screen that draws nothing.

#include <gtest/gtest.h>

#include <algorithm>

#include "app/input/read_input.h"
#include "tests/panel/panel_bench.h"

namespace nacre::app::test {
namespace {

/// Sixty models of four atoms.
Sources movingSources() {
    Sources s;
    s.read = [](const PictureDescription& v) {
        std::string text;
        for (int m = 0; m < 60; ++m)
            text += "4\nframe\nC 0 0 0\nO " + std::to_string(1.2 + 0.01 * m) + " 0 0\nN 0 1.4 0\nC 0 0 1.5\n";
        return readMolecule(v.input.path, text, {.model = v.input.model, .others = true});
    };
    s.motion = [](const std::shared_ptr<const Molecule>& molecule, const PictureDescription& v) {
        return std::make_unique<Motion>(trajectoryOfModels(molecule, v.input.model), *molecule,
                                        motionOptions(v.input.trajectory, *molecule));
    };
    return s;
}

struct Films {
    std::vector<RecordingWish> films;
    std::size_t keys = 0;
    RecordingState recording;
};

struct PlayBench : Films, Bench {
    explicit PlayBench(PixelSize points, PanelHand hand = PanelHand::mouse)
        : Bench("models.xyz", points, 1, hand, movingSources(), [this](PanelHost& h) { lend(h); }) {}
    void lend(PanelHost& h) {
        h.freeName = [](const char* extension) { return std::string("film") + extension; };
        h.record = [this](const RecordingWish& wish, const std::vector<PictureDescription>& views) {
            films.push_back(wish);
            keys = views.size();
        };
        h.recording = [this] { return recording; };
        h.stopRecording = [this] { recording.stopping = true; };
        h.videos = true;
    }
    bool says(const std::string& text) {
        for (const Control& c : panel.controls())
            if (c.name.find(text) != std::string::npos) return true;
        return false;
    }
};

TEST(PlayBar, StepsPlaysAndScrubs) {
    PlayBench b({1000, 700});
    EXPECT_TRUE(b.says("Model 1 of 60"));
    b.click("Next model");
    EXPECT_EQ(b.viewer.view().input.model, 2);
    EXPECT_TRUE(b.says("Model 2 of 60"));
    const Control* slider = b.find("Frame");
    ASSERT_TRUE(slider);
    b.clickAt((slider->left + slider->right) / 2, (slider->top + slider->bottom) / 2);
    EXPECT_NEAR(b.viewer.view().input.model, 30, 3);
    b.click("Play");
    EXPECT_TRUE(b.viewer.playback().playing());
    EXPECT_TRUE(b.find("Pause"));
    b.click("Playback options");
    b.click("Order");
    b.click("Back and forth");
    EXPECT_EQ(b.viewer.playback().clock().order(), PlayOrder::backAndForth);
    b.click("Pause");
    b.click("Fit");
    b.click("Superpose all atoms");
    EXPECT_EQ(b.viewer.view().input.trajectory.fit->text, "all");
    EXPECT_TRUE(b.says("RMSD"));
    b.click("Morph between models");
    b.viewer.playback().show(15, b.now);
    b.settle();
    EXPECT_TRUE(b.says("Between models 1 and 2"));
    b.click("Next model");
    EXPECT_TRUE(b.says("Model 2 of 60"));
    b.panel.showRecord();
    b.settle();
    b.click("Motion");
    b.click("Morph");
    b.click("Record");
    ASSERT_EQ(b.films.size(), 1u);
    EXPECT_EQ(b.films[0].motion, RecordingWish::Motion::morph);
    EXPECT_NEAR(b.films[0].seconds, 59, 0.1) << "59 steps of a second";
}

TEST(PlayBar, AFingerThatHoldsTheSliderMovesIt) {
    PlayBench b({420, 760}, PanelHand::fingers);
    const Control* slider = b.find("Frame");
    ASSERT_TRUE(slider);
    const double y = (slider->top + slider->bottom) / 2, left = slider->left, right = slider->right;
    EXPECT_TRUE(b.panel.input().touch({1, TouchPhase::began, {left + 14, y}}));
    b.frame();
    for (int i = 1; i <= 10; ++i) {
        b.panel.input().touch({1, TouchPhase::moved, {left + 14 + (right - left - 28) * 0.1 * i, y}});
        b.frame();
    }
    EXPECT_GT(b.viewer.view().input.model, 50) << "before it lets go";
    b.panel.input().touch({1, TouchPhase::ended, {right - 14, y}});
    b.settle();
    EXPECT_EQ(b.viewer.view().input.model, 60);
}

TEST(PlayBar, IsWholeEverywhereAndNextToTheMolecule) {
    for (const auto& [size, hand] : {std::pair(PixelSize{1000, 700}, PanelHand::mouse),
                                     {PixelSize{360, 640}, PanelHand::mouse},
                                     {PixelSize{390, 780}, PanelHand::fingers},
                                     {PixelSize{900, 420}, PanelHand::fingers}}) {
        PlayBench b(size, hand);
        const std::string where = std::to_string(size.width) + "x" + std::to_string(size.height);
        expectReadable(b, where);
        const View view = b.viewer.frames().settings().view;
        const Control* bar = b.find("Frame");
        ASSERT_TRUE(bar) << where;
        EXPECT_LE(view.height / 2.0 + (view.radius - view.pan.y) * view.pixelsPerAngstrom, bar->top) << where;
        b.click("Playback options");
        expectReadable(b, where + ", unfolded");
        b.panel.showRecord();
        b.settle();
        expectReadable(b, where + ", film");
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
    b.click("Movie format");
    b.click("GIF");
    b.click("Record");
    ASSERT_EQ(b.films.size(), 2u);
    EXPECT_EQ(b.films[1].motion, RecordingWish::Motion::models);
    EXPECT_EQ(b.films[1].seconds, 6) << "sixty models, ten per second";
    EXPECT_EQ(b.films[1].framesPerSecond, 25);
    EXPECT_EQ(b.films[1].path, "film.gif");
    // Of views it takes two.
    b.panel.showRecord();
    b.settle();
    b.click("Motion");
    b.click("Keyframes");
    b.click("Record");
    EXPECT_EQ(b.films.size(), 2u);
    b.click("Add keyframe");
    b.viewer.run(ViewerCommand::zoomIn, b.now);
    const double far = b.viewer.view().camera.zoom;
    b.click("Add keyframe");
    // The preview flies along them in the time that the film takes, and leads back to the card.
    b.click("Preview");
    EXPECT_FALSE(b.find("Preview"));
    std::vector<double> zooms;
    for (int i = 0; i < 200 && !b.find("Record"); ++i) {
        b.frame();
        zooms.push_back(b.viewer.view().camera.zoom);
    }
    EXPECT_TRUE(b.find("Record"));
    EXPECT_EQ(*std::min_element(zooms.begin(), zooms.end()), 1);
    EXPECT_NEAR(zooms.back(), far, 1e-6);
    EXPECT_GT(std::count_if(zooms.begin(), zooms.end(), [&](double z) { return z > 1 && z < far; }), 60);
    b.settle();
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
}  // namespace nacre::app::test
