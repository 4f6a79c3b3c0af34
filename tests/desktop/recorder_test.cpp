// Films that the window records, by the program that makes movies.

#include "app/desktop/recorder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "engine/error.h"
#include "tests/desktop/environment.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace nacre::app {
namespace {

using test::readContents;
using test::TemporaryFolder;

struct Recording {
    TemporaryFolder folder;
    Recorder recorder{{}, NACRE_PROGRAM};
    RecordingWish wish;
    PictureDescription shown;

    Recording() {
        shown.input.path = "sample:glucose";
        shown.occlusion.directions = 2;
        wish.seconds = 0.4;
        wish.framesPerSecond = 10;
        wish.size = {40, 30};
        wish.path = folder / "film.gif";
    }
    RecordingState wait(const std::function<bool(const RecordingState&)>& so) const {
        for (int i = 0; i < 6000 && !so(recorder.state()); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        return recorder.state();
    }
    RecordingState record(const std::vector<PictureDescription>& keys = {}) {
        recorder.start(wish, shown, keys, {"--cache", "off"});
        return wait([](const RecordingState& s) { return !s.running; });
    }
};

TEST(Recorder, MakesTheFilmThatMovieMakes) {
    Recording r;
    const RecordingState state = r.record();
    EXPECT_EQ(state.message, "saved " + r.wish.path);
    EXPECT_FALSE(state.failed);
    EXPECT_EQ(state.frame, 4u);
    EXPECT_EQ(state.share, 1);
    const test::Outcome outcome =
        test::nacreIn(r.folder,
                      "movie sample:glucose -o own.gif --spin y --seconds 0.4 --fps 10 --size 40x30 "
                      "--occlusion 2 --cache off");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(readContents(r.wish.path), readContents(r.folder / "own.gif"));
}

TEST(Recorder, GoesThroughKeptViews) {
    Recording r;
    PictureDescription other = r.shown;
    other.camera.zoom = 2;
    r.wish.motion = RecordingWish::Motion::views;
    EXPECT_FALSE(r.record({r.shown, other}).failed);
    EXPECT_TRUE(std::filesystem::exists(r.wish.path));
    // What cannot be one film is said in the words of the program.
    other.camera.projection = Projection::perspective;
    const RecordingState state = r.record({r.shown, other});
    EXPECT_TRUE(state.failed);
    EXPECT_NE(state.message.find("projection"), std::string::npos) << state.message;
}

TEST(Recorder, KeepsWhatIsWholeWhenItIsStopped) {
    Recording r;
    r.wish.seconds = 600;
    r.recorder.start(r.wish, r.shown, {}, {"--cache", "off"});
    r.wait([](const RecordingState& s) { return s.frame > 2 || !s.running; });
    EXPECT_GT(r.recorder.state().left, 0);
    r.recorder.stop();
    const RecordingState state = r.wait([](const RecordingState& s) { return !s.running; });
    EXPECT_FALSE(state.failed);
    EXPECT_NE(state.message.find("of 6000 frames are in it"), std::string::npos) << state.message;
    EXPECT_EQ(readContents(r.wish.path).substr(0, 4), "GIF8");
}

TEST(Recorder, StopsWhereInterruptsAreIgnored) {
    // As of a program that a shell starts in the background.
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGTERM, SIG_IGN);
    Recording r;
    r.wish.seconds = 600;
    r.recorder.start(r.wish, r.shown, {}, {"--cache", "off"});
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    r.wait([](const RecordingState& s) { return s.frame > 2 || !s.running; });
    r.recorder.finish();
    EXPECT_FALSE(r.recorder.state().running);
    EXPECT_FALSE(r.recorder.state().failed);
    EXPECT_EQ(readContents(r.wish.path).substr(0, 4), "GIF8");
}

TEST(Recorder, EndsAProgramThatDoesNotStop) {
    const test::FakePrograms programs;
    programs.add("stubborn", "trap '' INT TERM; echo '{\"frame\": 1, \"frames\": 9}'; while :; do sleep 1; done");
    RecordingWish wish;
    wish.path = "film.gif";
    PictureDescription shown;
    shown.input.path = "sample:glucose";
    Recorder recorder({}, programs / "stubborn", 0.2);
    recorder.start(wish, shown, {}, {});
    while (recorder.state().frame == 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    recorder.finish();
    EXPECT_FALSE(recorder.state().running);
}

TEST(Recorder, SaysWhyItCannot) {
    Recording r;
    r.wish.path = r.folder / "missing/film.gif";
    const RecordingState state = r.record();
    EXPECT_TRUE(state.failed);
    EXPECT_NE(state.message.find("missing"), std::string::npos) << state.message;
    Recorder none({}, "/nonexistent/nacre");
    EXPECT_THROW(none.start(r.wish, r.shown, {}, {}), Error);
    EXPECT_FALSE(none.state().running);
}

/// This test's program in the place of nacre.
__attribute__((constructor)) void makeMovie(int count, char** words) {
    if (count < 5 || words[1] != std::string_view("movie")) return;
    std::puts("{\"frame\": 1, \"frames\": 1}");
    std::fflush(stdout);
    _exit(words[3] == std::string_view("--output") ? 0 : 1);
}

TEST(Recorder, DISABLED_InAProgramThatIsGoneFromDisk) {
    const std::string program = std::filesystem::read_symlink("/proc/self/exe");
    ASSERT_EQ(std::filesystem::path(program).filename(), "gone");
    std::filesystem::remove(program);
    Recorder recorder({});
    PictureDescription shown;
    shown.input.path = "sample:glucose";
    RecordingWish wish;
    wish.path = "film.gif";
    recorder.start(wish, shown, {}, {});
    while (recorder.state().running) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(recorder.state().message, "saved film.gif");
    EXPECT_EQ(recorder.state().frame, 1u);
}

TEST(Recorder, RecordsWhenItsProgramIsGoneFromDisk) {
    const TemporaryFolder folder;
    const std::string program = folder / "gone";
    std::filesystem::copy_file("/proc/self/exe", program);
    const std::string command =
        "'" + program + "' --gtest_also_run_disabled_tests --gtest_filter='Recorder.DISABLED_*'";
    EXPECT_EQ(std::system((command + " >'" + (folder / "log") + "' 2>&1").c_str()), 0) << readContents(folder / "log");
    EXPECT_FALSE(std::filesystem::exists(program));
}

TEST(Recorder, AsksForWhatTheWindowShows) {
    RecordingWish wish{.motion = RecordingWish::Motion::models, .size = {64, 48}, .path = "movie.mp4"};
    PictureDescription shown;
    shown.input.path = "/data/md.gro";
    shown.input.trajectory.path = "/data/md.xtc";
    shown.input.trajectory.smooth = 5;
    shown.input.trajectory.whole = true;
    shown.input.trajectory.fit = parseSelection("backbone");
    const std::vector<std::string> words = movieArguments(wish, shown, "v.json", {});
    const auto after = [&](const std::string& option) {
        const auto at = std::find(words.begin(), words.end(), option);
        return at == words.end() || at + 1 == words.end() ? std::string("none") : at[1];
    };
    EXPECT_EQ(words[1], "/data/md.gro");
    EXPECT_EQ(after("--trajectory"), "/data/md.xtc");
    EXPECT_EQ(after("--fit-frames"), "backbone");
    EXPECT_EQ(after("--smooth"), "5");
    EXPECT_EQ(after("--view"), "v.json");
    EXPECT_NE(std::find(words.begin(), words.end(), "--models"), words.end());
    EXPECT_NE(std::find(words.begin(), words.end(), "--whole"), words.end());
    EXPECT_EQ(after("--frame"), "none") << "it goes through all of them";
    wish.motion = RecordingWish::Motion::morph;
    shown.input.trajectory = {};
    shown.input.further.push_back({"", "/data/b.gro", ""});
    const std::vector<std::string> morph = movieArguments(wish, shown, "v.json", {});
    EXPECT_EQ(morph[1], "--output") << "the view names the inputs";
    EXPECT_NE(std::find(morph.begin(), morph.end(), "--morph"), morph.end());
    wish.motion = RecordingWish::Motion::spin;
    shown.input.further.clear();
    shown.input.trajectory.path = "/data/md.xtc";
    shown.input.trajectory.frame = 7;
    const std::vector<std::string> spin = movieArguments(wish, shown, "v.json", {});
    EXPECT_EQ(*(std::find(spin.begin(), spin.end(), "--frame") + 1), "7");
}

}  // namespace
}  // namespace nacre::app
