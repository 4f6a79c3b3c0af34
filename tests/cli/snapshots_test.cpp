// Several snapshots of a MolViewSpec scene: one, all as pictures, all as a movie.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "app/cli/movie_snapshots.h"
#include "app/download/load_molecule.h"
#include "app/download/load_scene.h"
#include "tests/support/run_program.h"

namespace nacre {
namespace {

using test::nacreDone;
using test::nacreIn;
using test::Outcome;
using test::TemporaryFolder;

std::string makeSnapshot(const std::string& color, int linger, int transition) {
    return R"({"metadata": {"linger_duration_ms": )" + std::to_string(linger) + R"(, "transition_duration_ms": )" +
           std::to_string(transition) + R"(}, "root": {"kind": "root", "children": [{"kind": "primitives", "params":
        {"color": ")" +
           color + R"("}, "children": [{"kind": "primitive", "params":
        {"kind": "ellipsoid", "center": [0, 0, 0], "radius": 2}}]}]}})";
}

void putSnapshots(const TemporaryFolder& folder) {
    std::ofstream(folder / "s.mvsj") << R"({"kind": "multiple", "metadata": {}, "snapshots": [)"
                                     << makeSnapshot("red", 300, 200) << "," << makeSnapshot("blue", 500, 400) << "]}";
}

constexpr const char* kTinyPicture = " --size 32x32 --occlusion off";

TEST(Snapshots, AllOfThemArePicturesOfTheirOwn) {
    const TemporaryFolder folder;
    putSnapshots(folder);
    nacreDone(folder, std::string("render s.mvsj --snapshot all -o a.png") + kTinyPicture);
    const std::string first = test::readContents(folder / "a-1.png"), second = test::readContents(folder / "a-2.png");
    EXPECT_FALSE(first.empty());
    EXPECT_NE(first, second);
    nacreDone(folder, std::string("render s.mvsj --snapshot 2 -o b.png") + kTinyPicture);
    EXPECT_EQ(test::readContents(folder / "b.png"), second);
    nacreDone(folder, std::string("render s.mvsj -o c.png") + kTinyPicture);
    EXPECT_EQ(test::readContents(folder / "c.png"), first);
    const Outcome missing = nacreIn(folder, std::string("render s.mvsj --snapshot 3 -o d.png") + kTinyPicture);
    EXPECT_EQ(missing.code, 1);
    EXPECT_NE(missing.err.find("there is no snapshot 3; it has 2"), std::string::npos) << missing.err;
}

TEST(Snapshots, AMovieRestsAtEachAndGoesOverIntoTheNext) {
    const TemporaryFolder folder;
    putSnapshots(folder);
    // 0.3 s at rest, 0.2 s on the way, 0.5 s at rest: the last has no next.
    const Outcome movie = nacreDone(folder, std::string("movie s.mvsj -o frames/ --fps 10") + kTinyPicture);
    const auto frame = [&](int number) {
        return test::readContents(
            folder / (std::string("frames/frame_000") + (number < 10 ? "0" : "") + std::to_string(number) + ".png"));
    };
    EXPECT_FALSE(frame(10).empty());
    EXPECT_TRUE(frame(11).empty());
    EXPECT_EQ(frame(1), frame(3));
    EXPECT_NE(frame(3), frame(5));
    EXPECT_NE(frame(5), frame(6));
    EXPECT_EQ(frame(6), frame(10));
    const Outcome spin = nacreIn(folder, std::string("movie s.mvsj --snapshot all --spin y -o a.gif") + kTinyPicture);
    EXPECT_EQ(spin.code, 2) << spin.err;
}

TEST(Snapshots, AnAnimationPlaysWhileItsSnapshotRests) {
    const TemporaryFolder folder;
    const std::string ball = R"({"kind": "primitives", "ref": "balls", "params": {"color": "red"}, "children": [
        {"kind": "primitive", "params": {"kind": "ellipsoid", "center": [0, 0, 0], "radius": 2}}]})";
    std::ofstream(folder / "s.mvsj") << R"({"root": {"kind": "root", "children": [)" << ball
                                     << R"(]}, "animation": {"kind": "animation", "children": [{"kind": "interpolate",
        "params": {"kind": "color", "target_ref": "balls", "property": "color", "end": "blue", "duration_ms": 400}}]}})";
    nacreDone(folder, std::string("movie s.mvsj -o frames/ --fps 10") + kTinyPicture);
    const auto frame = [&](int number) {
        return test::readContents(folder / ("frames/frame_0000" + std::to_string(number) + ".png"));
    };
    EXPECT_FALSE(frame(4).empty());
    EXPECT_TRUE(frame(5).empty());
    EXPECT_NE(frame(1), frame(2));
    EXPECT_NE(frame(3), frame(4));
    // The first frame is the scene as a picture shows it.
    nacreDone(folder, std::string("render s.mvsj -o a.png") + kTinyPicture);
    EXPECT_EQ(test::readContents(folder / "a.png"), frame(1));
}

TEST(Snapshots, AnimationsLengthenTheRestOfTheirSnapshot) {
    app::SnapshotTimes moving{.linger = 1, .transition = 2, .animation = 1.5};
    app::SnapshotTimeline line({moving, {1, 0}}, false);
    EXPECT_EQ(line.seconds(), 4.5);
    EXPECT_EQ(line.at(1.25).seconds, 1.25);
    EXPECT_EQ(line.at(2.5).share, 0.5);
    EXPECT_EQ(line.animationAt(0, 9), 1.5);
    EXPECT_EQ(line.animationAt(1, 0.5), std::nullopt);
    moving.loops = true;
    moving.linger = 6;
    EXPECT_EQ(app::SnapshotTimeline({moving}, false).animationAt(0, 4), 1);
}

TEST(Snapshots, ALeapShowsBothEndsOnItsWay) {
    app::Lens from;
    from.projection = Projection::perspective;
    from.scale = 10, from.distance = 100;  // of a picture of 200 pixels: 10 Å are seen
    app::Lens to = from;
    to.focus = {100, 0, 0};
    to.scale = 5, to.distance = 200;
    const auto seen = [&](const char* way, double share) {
        return 100 / app::lensBetween(from, to, way, share, 200).scale;
    };
    EXPECT_NEAR(seen("linear", 0.5), 15, 1e-9);
    for (const char* way : {"linear", "linear-relative", "leap", "leap-relative"}) {
        EXPECT_NEAR(seen(way, 0), 10, 1e-9) << way;
        EXPECT_NEAR(seen(way, 1), 20, 1e-9) << way;
        EXPECT_NEAR(
            app::lensBetween(from, to, way, 0.3, 200).distance * app::lensBetween(from, to, way, 0.3, 200).scale, 1000,
            1e-6)
            << way;
    }
    EXPECT_NEAR(seen("leap", 0.55), 65, 1e-6);  // half of 10 + 100 + 20, and then the ball holds both
    EXPECT_GT(seen("leap", 0.3), 40);
    // Half of the way of ln(11) to ln(21).
    EXPECT_NEAR(seen("linear-relative", 0.5), std::sqrt(11.0 * 21.0) - 1, 1e-9);
    to.focus = {5, 0, 0};  // within what is seen
    EXPECT_NEAR(seen("leap", 0.5), 15, 1e-9);
}

TEST(Snapshots, AnOpenSceneReadsItsFilesOnce) {
    const TemporaryFolder folder;
    const std::string root = R"({"root": {"kind": "root", "children": [{"kind": "download", "params": {"url": "m.pdb"},
        "children": [{"kind": "parse", "params": {"format": "pdb"}, "children": [{"kind": "structure", "params":
        {"type": "model"}, "children": [{"kind": "component", "params": {"selector": "all"}, "children": [
        {"kind": "representation", "params": {"type": "spacefill"}}]}]}]}]}]}})";
    std::ofstream(folder / "s.mvsj") << R"({"snapshots": [)" << root << "," << root << "]}";
    std::ofstream(folder / "m.pdb")
        << "HETATM    1 ZN    ZN A   1       1.000   2.000   3.000  1.00  0.00          ZN\n";
    app::InputOptions input;
    input.path = folder / "s.mvsj";
    app::OpenScene scene(input);
    std::filesystem::remove(folder / "s.mvsj");
    EXPECT_EQ(app::loadSnapshot(scene, input).atoms.size(), 1u);
    std::filesystem::remove(folder / "m.pdb");
    input.snapshot = 2;
    EXPECT_EQ(app::loadSnapshot(scene, input).atoms.size(), 1u);
    EXPECT_EQ(scene.times().size(), 2u);
}

TEST(Snapshots, TimesThatNobodyStatesAreTwoSecondsEach) {
    const app::SnapshotTimeline silent({{0, 0}, {0, 1}, {0, 0}}, false);
    EXPECT_EQ(silent.seconds(), 7);
    EXPECT_EQ(silent.at(3.9).from, 1u);
    EXPECT_EQ(silent.at(3.9).share, 0);
    EXPECT_EQ(silent.at(4.5).share, 0.5);
    EXPECT_EQ(silent.at(7).from, 2u);
    // Frames at the limits of times that no binary number is: each belongs to what begins there.
    const app::SnapshotTimeline tenths({{0.3, 0.4}, {0.4, 0}, {0.1, 0}}, false);
    for (int frame = 0; frame < 12; ++frame) {
        const app::SnapshotPlace place = tenths.at(frame * 0.1);
        EXPECT_EQ(place.from, frame < 7 ? 0u : frame < 11 ? 1u : 2u) << frame;
        EXPECT_EQ(place.share > 0, frame > 3 && frame < 7) << frame;
    }
    const app::SnapshotTimeline loop({{1, 0}, {1, 2}}, true);
    EXPECT_EQ(loop.seconds(), 4);
    EXPECT_EQ(loop.at(3).from, 1u);
    EXPECT_EQ(loop.at(3).share, 0.5);
}

}  // namespace
}  // namespace nacre
