// Molecules that move: which frame is due when, and what the viewer shows of it.

#include <gtest/gtest.h>

#include <set>

#include "app/input/map_input.h"
#include "app/input/read_input.h"
#include "app/viewer/viewer.h"
#include "engine/molecule/read.h"

namespace nacre::app {
namespace {

std::vector<std::size_t> played(PlayClock clock, int count) {
    std::vector<std::size_t> frames{clock.frame()};
    for (double now = 0; static_cast<int>(frames.size()) <= count; ++now) {
        const auto next = clock.next();
        if (!next) break;
        clock.shown(*next, now);
        frames.push_back(*next);
    }
    return frames;
}

TEST(PlayClock, GoesRoundToAndFroOrToItsEnd) {
    using Frames = std::vector<std::size_t>;
    PlayClock clock;
    clock.begin(3, 1, 10);
    EXPECT_EQ(played(clock, 4), (Frames{1, 2, 0, 1, 2}));
    clock.setOrder(PlayOrder::backAndForth);
    EXPECT_EQ(played(clock, 6), (Frames{1, 2, 1, 0, 1, 2, 1}));
    clock.setOrder(PlayOrder::once);
    EXPECT_EQ(played(clock, 6), (Frames{1, 2}));
    clock.goTo(2);
    clock.play(0);
    EXPECT_EQ(played(clock, 6), (Frames{2, 0, 1, 2})) << "from its end it plays once more";
    clock.begin(1, 0, 10);
    clock.play(0);
    EXPECT_FALSE(clock.playing());
    EXPECT_FALSE(clock.next());
}

TEST(PlayClock, KeepsItsPace) {
    PlayClock clock;
    clock.begin(100, 0, 20);
    clock.play(5);
    EXPECT_EQ(clock.due(), 5);
    clock.shown(1, 5.01);
    EXPECT_DOUBLE_EQ(clock.due(), 5.05) << "what is a little late is made up for";
    clock.shown(2, 6);
    EXPECT_DOUBLE_EQ(clock.due(), 6) << "what is much too late is not";
    clock.stepRate(1);
    EXPECT_EQ(clock.rate(), 24);
    clock.stepRate(-1);
    clock.stepRate(-1);
    EXPECT_EQ(clock.rate(), 15);
    clock.setRate(1e9);
    EXPECT_EQ(clock.rate(), PlayClock::kFastest);
    clock.stepRate(1);
    EXPECT_EQ(clock.rate(), PlayClock::kFastest);
}

/// Five models of two atoms; the second moves away by half an ångström a model. @param last  of another kind
std::string fiveModels(bool last = false) {
    std::string text;
    for (int m = 0; m < 5; ++m)
        text += "2\nframe\nC 0 0 0\n" + std::string(last && m == 4 ? "N" : "O") + " " + std::to_string(1 + 0.5 * m) +
                " 0 0\n";
    return text;
}

class MovingScreen : public Screen {
public:
    void setScene(Representation scene) override { ++scenes, shown = std::move(scene); }
    void moveScene(Representation scene) override { ++moves, shown = std::move(scene); }
    double advanceOcclusion(const RenderSettings& settings, const OcclusionPace& pace) override {
        hurried = hurried || !pace.mustFit;
        moving = settings.occlusion.moving;
        return 0.5;
    }
    FrameOutcome present(const RenderSettings& settings, const WindowFrame&) override {
        scale = settings.view.pixelsPerAngstrom;
        return FrameOutcome::shown;
    }
    PixelSize windowSize() const override { return {600, 400}; }
    std::uint32_t atomAt(const RenderSettings&, double, double, double) override { return 1; }
    int scenes = 0, moves = 0;
    bool hurried = false, moving = false;
    double scale = 0;
    Representation shown;
};

struct PlayingBench {
    explicit PlayingBench(std::string content = fiveModels())
        : text(std::move(content)), viewer(screen, sources(), viewOfFile(), {}) {
        viewer.frames().resize({600, 400}, 1, now);
        run(1);
    }
    static PictureDescription viewOfFile() {
        PictureDescription view;
        view.input.path = "five.xyz";
        return view;
    }
    Sources sources() {
        Sources s;
        s.read = [this](const PictureDescription& v) {
            ++reads;
            return readMolecule(v.input.path, text, {.model = v.input.model, .others = true});
        };
        s.motion = [](const std::shared_ptr<const Molecule>& molecule,
                      const PictureDescription& v) -> std::unique_ptr<Motion> {
            auto models = trajectoryOfModels(molecule, v.input.model);
            if (!models) return nullptr;
            return std::make_unique<Motion>(std::move(models), *molecule, motionOptions(v.input.trajectory, *molecule));
        };
        return s;
    }
    /// @returns when the viewer wants to be called again
    void run(double seconds) {
        for (const double end = now + seconds; now < end; now += 0.005) {
            viewer.reading().loader().wait();
            viewer.playback().wait();
            viewer.update(now);
        }
    }
    double distance() const {
        const auto& spheres = screen.shown.spheres;
        return spheres.size() == 2 ? glm::distance(spheres[0].center, spheres[1].center) : -1;
    }

    std::string text;
    int reads = 0;
    double now = 100;
    MovingScreen screen;
    Viewer viewer;
};

TEST(Playback, AllModelsAreShownTogetherAndOneByOneAgain) {
    PlayingBench b;
    ASSERT_EQ(b.viewer.playback().models(), 5);
    EXPECT_EQ(b.screen.shown.spheres.size(), 2u);
    PictureDescription all = b.viewer.view();
    all.input.model = kAllModels;
    b.viewer.show(all, b.now);
    b.run(1);
    EXPECT_EQ(b.screen.shown.spheres.size(), 10u);
    EXPECT_EQ(b.viewer.document()->view.input.model, kAllModels);
    b.viewer.undo(b.now);
    b.run(1);
    EXPECT_EQ(b.screen.shown.spheres.size(), 2u);
}

// What is shown is read on one thread, and let go of, while another makes the frames that follow.
TEST(Player, MakesFramesInMoleculesThatNobodyHoldsAnyMore) {
    const auto molecule = std::make_shared<const Molecule>(readMolecule("five.xyz", fiveModels(), {.others = true}));
    auto motion = std::make_shared<Motion>(trajectoryOfModels(molecule, 1), *molecule, MotionOptions());
    Player player(molecule, std::move(motion), {});
    player.setScene(std::make_shared<MovingPicture>(*molecule, PictureDescription()));
    const auto frame = [&](std::size_t number) {
        player.want(number);
        player.wait();
        const std::optional<PlayedFrame> played = player.take();
        return played ? played->molecule : nullptr;
    };
    const std::shared_ptr<const Molecule> held = frame(3);
    std::set<const Molecule*> places;
    for (std::size_t i = 0; i < 200; ++i) {
        const std::shared_ptr<const Molecule> shown = frame(i % 5);
        ASSERT_TRUE(shown);
        EXPECT_NE(shown, held);
        player.want((i + 1) % 5);  // is made while this one is looked at
        EXPECT_EQ(shown->atoms[1].position.x, 1 + 0.5f * static_cast<float>(i % 5));
        places.insert(shown.get());
    }
    EXPECT_LE(places.size(), 4u) << "molecules are used again";
    EXPECT_EQ(held->atoms[1].position.x, 2.5f);
}

TEST(Playing, ModelsOfOneMoleculeMoveWithoutBeingReadAgain) {
    PlayingBench b;
    EXPECT_EQ(b.viewer.playback().clock().frames(), 5u);
    EXPECT_TRUE(b.viewer.playback().canLay());
    EXPECT_FALSE(b.viewer.playback().hasTrajectory());
    const double scale = b.screen.scale;
    const int scenes = b.screen.scenes;
    b.viewer.playback().show(3, b.now);
    b.run(0.1);
    EXPECT_NEAR(b.distance(), 2.5, 1e-5);
    EXPECT_EQ(b.viewer.view().input.model, 4);
    EXPECT_EQ(b.viewer.document()->placed->atoms[1].position.x, 2.5f);
    b.viewer.run(ViewerCommand::nextModel, b.now);
    b.run(0.1);
    b.viewer.run(ViewerCommand::nextModel, b.now);
    b.run(0.1);
    EXPECT_NEAR(b.distance(), 1, 1e-5) << "after the last comes the first";
    b.viewer.run(ViewerCommand::lastModel, b.now);
    b.run(0.1);
    EXPECT_NEAR(b.distance(), 3, 1e-5);
    EXPECT_EQ(b.screen.scale, scale) << "the camera stays";
    EXPECT_EQ(b.screen.scenes, scenes) << "what moves keeps what was baked";
    EXPECT_EQ(b.reads, 1);
}

TEST(Playing, AMorphLeadsFromModelToModel) {
    PlayingBench b;
    Playback& playback = b.viewer.playback();
    ASSERT_TRUE(playback.canMorph());
    playback.show(1, b.now);
    b.run(0.1);
    playback.setMorph(true, b.now);
    b.run(0.1);
    EXPECT_EQ(playback.place(), 1) << "it goes on from the model that was shown";
    EXPECT_NEAR(b.distance(), 1.5, 1e-5);
    const std::size_t perModel = (playback.clock().frames() - 1) / 4;
    ASSERT_GE(perModel, 10u);
    playback.show(perModel * 5 / 2, b.now);
    b.run(0.1);
    EXPECT_EQ(playback.place(), 2.5);
    EXPECT_NEAR(b.distance(), 2.25, 1e-3) << "halfway between 2 and 2.5 Å";
    // Another look leaves it there.
    PictureDescription view = b.viewer.view();
    view.look.rules.push_back({});
    view.look.rules.back().selection = parseSelection("all");
    b.viewer.show(view, b.now);
    b.run(0.2);
    EXPECT_EQ(playback.place(), 2.5);
    b.viewer.run(ViewerCommand::nextModel, b.now);
    b.run(0.1);
    EXPECT_NEAR(b.distance(), 2.5, 1e-5);
    EXPECT_EQ(b.viewer.view().input.model, 4);
    b.viewer.run(ViewerCommand::lastModel, b.now);
    b.run(0.1);
    EXPECT_NEAR(b.distance(), 3, 1e-5);
    const int moves = b.screen.moves;
    b.viewer.run(ViewerCommand::playModels, b.now);
    b.run(1);
    EXPECT_NEAR(b.screen.moves - moves, 30, 3) << "as a movie";
    playback.setMorph(false, b.now);
    EXPECT_EQ(playback.clock().frames(), 5u);
    EXPECT_TRUE(playback.playing());
    EXPECT_EQ(b.reads, 1);
}

TEST(Playing, ASurfaceHasTheColoursOfAMapInEveryFrame) {
    std::vector<float> values;
    for (int i = 0; i < 1000; ++i) values.push_back(static_cast<float>(i % 10));  // the place along x
    keepMap("along x",
            std::make_shared<const DensityMap>(mapOfValues("along x", glm::ivec3(10), {glm::dvec3(10), glm::dvec3(90)},
                                                           glm::dvec3(-4), false, std::move(values))));
    PlayingBench b;
    PictureDescription look = b.viewer.view();
    look.look.style = Style::surface;
    look.maps.surface.file = "along x";
    b.viewer.setLook(look, b.now);
    b.run(0.2);
    ASSERT_FALSE(b.screen.shown.legends.empty());
    const std::vector<Legend> first = b.screen.shown.legends;
    const int moves = b.screen.moves;
    for (const std::size_t frame : {3, 1, 4}) {
        b.viewer.playback().show(frame, b.now);
        b.run(0.1);
        ASSERT_GT(b.screen.shown.triangles.size(), 0u);
        std::set<std::uint32_t> colors;
        for (const MeshVertex& v : b.screen.shown.meshVertices)
            colors.insert(b.screen.shown.meshLooks[v.look].color & 0xffffff);
        EXPECT_GT(colors.size(), 20u) << "of the ramp, frame " << frame;
        EXPECT_TRUE(b.screen.shown.blendsColors);
        ASSERT_EQ(b.screen.shown.legends.size(), first.size());
        for (std::size_t i = 0; i < first.back().entries.size(); ++i)
            EXPECT_EQ(b.screen.shown.legends.back().entries[i].label, first.back().entries[i].label)
                << "in one range, frame " << frame;
    }
    EXPECT_GT(b.screen.moves, moves);
}

TEST(Playing, ComesAtItsRateAndStops) {
    PlayingBench b;
    b.viewer.playback().setRate(20);
    const int moves = b.screen.moves;
    b.viewer.run(ViewerCommand::playModels, b.now);
    b.screen.hurried = false;
    b.run(2);
    EXPECT_NEAR(b.screen.moves - moves, 40, 3);
    EXPECT_FALSE(b.screen.hurried) << "occlusion takes what frames leave";
    EXPECT_TRUE(b.screen.moving);
    b.viewer.run(ViewerCommand::playModels, b.now);
    const int stopped = b.screen.moves;
    b.run(1);
    EXPECT_LE(b.screen.moves - stopped, 1);
    EXPECT_TRUE(b.screen.hurried);
    EXPECT_FALSE(b.screen.moving);
    EXPECT_EQ(b.reads, 1);
}

TEST(Playing, ALookIsBuiltWhereTheMoleculeStands) {
    PlayingBench b;
    b.viewer.playback().show(4, b.now);
    b.run(0.1);
    b.viewer.run(ViewerCommand::spacefill, b.now);
    b.run(0.2);
    EXPECT_NEAR(b.distance(), 3, 1e-5);
    EXPECT_EQ(b.viewer.view().input.model, 5);
    b.viewer.undo(b.now);
    b.run(0.3);
    b.viewer.undo(b.now);
    b.run(0.3);
    EXPECT_EQ(b.viewer.view().input.model, 1);
    EXPECT_NEAR(b.distance(), 1, 1e-5);
    EXPECT_EQ(b.reads, 1);
}

TEST(Playing, FramesAreSmoothedAsAsked) {
    PlayingBench b;
    TrajectoryOptions laid;
    laid.smooth = 3;
    b.viewer.playback().setMotion(laid, b.now);
    b.run(0.1);
    EXPECT_NEAR(b.distance(), 1.25, 1e-5) << "of the first and the second";
    b.viewer.playback().show(2, b.now);
    b.run(0.1);
    EXPECT_NEAR(b.distance(), 2, 1e-5);
    const PictureDescription saved = parseSavedView(savedViewJson(b.viewer.picking().savedView()), "view");
    EXPECT_EQ(saved.input.trajectory.smooth, 3);
    laid.fit = parseSelection("element N");
    b.viewer.playback().setMotion(laid, b.now);
    b.run(0.1);
    EXPECT_NE(b.viewer.picking().annotations().message.find("fewer than three"), std::string::npos);
    EXPECT_NEAR(b.distance(), 2, 1e-5);
}

TEST(Playing, ModelsOfDifferentMoleculesAreReadOneByOne) {
    PlayingBench b(fiveModels(true));
    EXPECT_FALSE(b.viewer.playback().canLay());
    EXPECT_EQ(b.viewer.playback().clock().frames(), 5u);
    b.viewer.run(ViewerCommand::lastModel, b.now);
    b.run(0.2);
    EXPECT_EQ(b.viewer.document()->molecule->atoms[1].element, 7);
    EXPECT_EQ(b.viewer.view().input.model, 5);
    b.viewer.run(ViewerCommand::playModels, b.now);
    b.run(1);
    EXPECT_GE(b.reads, 8);
}

}  // namespace
}  // namespace nacre::app
