// What a person at a terminal sees while a command works, and that nobody else sees it.

#include "app/cli/progress.h"

#include <gtest/gtest.h>

#include "tests/support/measured_run.h"

namespace nacre {
namespace {

using namespace std::chrono_literals;
using app::progressText;
using test::MeasuredRun;
using test::TemporaryFolder;

TEST(ProgressText, HasABarWhereTheShareIsKnown) {
    EXPECT_EQ(progressText("reading", std::nullopt, 3s), "nacre: reading, 3 s");
    EXPECT_EQ(progressText("baking", 0.0, 3s), "nacre: baking [                        ]   0 %");
    EXPECT_EQ(progressText("baking", 0.5, 3s), "nacre: baking [############            ]  50 %");
    EXPECT_EQ(progressText("baking", 1.0, 3s), "nacre: baking [########################] 100 %");
    EXPECT_EQ(progressText("baking", 7.0, 3s), progressText("baking", 1.0, 3s));
}

TEST(ProgressText, SaysWhatIsLeftWhereThatIsKnown) {
    EXPECT_EQ(progressText("drawing frames", 0.5, 3s, 7s), "nacre: drawing frames [######      ]  50 %, 0:07 left");
    EXPECT_EQ(progressText("drawing frames", 0.5, 3s, 3723s),
              "nacre: drawing frames [######      ]  50 %, 1:02:03 left");
}

TEST(ProgressText, FitsANarrowTerminal) {
    EXPECT_LE(progressText("drawing frames", 1.0, 3s, 359999s).size(), 60u);
    EXPECT_LE(progressText("ambient occlusion", 1.0, 3s).size(), 60u);
    EXPECT_LE(progressText("building the scene", std::nullopt, 1000000s).size(), 60u);
}

/// A cube of atoms.
std::string bigStructure(const TemporaryFolder& folder, int side) {
    std::string xyz = std::to_string(side * side * side) + "\nmany\n";
    for (int i = 0; i < side * side * side; ++i)
        xyz += "O " + std::to_string(i % side * 3) + " " + std::to_string(i / side % side * 3) + " " +
               std::to_string(i / side / side * 3) + "\n";
    std::ofstream(folder / "big.xyz") << xyz;
    return folder / "big.xyz";
}

/// More than a second of work, however fast the device.
MeasuredRun longRun(const TemporaryFolder& folder, bool terminal) {
    test::RunOptions options;
    options.terminal = terminal;
    options.oneCore = true;
    MeasuredRun run;
    const std::string big = bigStructure(folder, 12);
    for (const char* directions : {"1536", "4096"}) {
        run = test::runMeasured({"render", big, "-o", folder / "a.png", "--size", "32x32", "--occlusion", directions},
                                options);
        if (run.seconds > 1.5) break;
    }
    return run;
}

TEST(Progress, IsSeenOnATerminalOnceWorkTakesASecond) {
    const TemporaryFolder folder;
    const MeasuredRun run = longRun(folder, true);
    ASSERT_EQ(run.code, 0) << run.err;
    ASSERT_GT(run.seconds, 1.5) << "the work no longer takes long enough to tell";
    EXPECT_NE(run.err.find("nacre: ambient occlusion ["), std::string::npos) << run.err;
    EXPECT_NE(run.err.find(" %"), std::string::npos) << run.err;
    const std::string cleared = "\r\x1b[K";
    ASSERT_GE(run.err.size(), cleared.size());
    EXPECT_EQ(run.err.substr(run.err.size() - cleared.size()), cleared) << "the line is not empty at the end";
    EXPECT_EQ(run.out, "");
}

TEST(Progress, IsNotSeenElsewhere) {
    const TemporaryFolder folder;
    const MeasuredRun run = longRun(folder, false);
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.out + run.err, "");
}

TEST(Progress, IsSeenWhileASurfaceIsMadeAndWhileABatchIsDrawn) {
    const TemporaryFolder folder;
    test::RunOptions options;
    options.terminal = options.oneCore = true;
    const std::string big = bigStructure(folder, 32);
    MeasuredRun run;
    for (const char* resolution : {"0.3", "0.2", "0.15"}) {
        run = test::runMeasured(
            {"export", big, "-o", folder / "a.ply", "--style", "surface", "--surface-resolution", resolution}, options);
        if (run.err.find("nacre: building the scene") != std::string::npos) break;
    }
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.err.find("nacre: building the scene"), std::string::npos) << run.err;
    std::ofstream(folder / "jobs") << "{\"input\": \"" << big << "\", \"output\": \"" << folder / "b.png"
                                   << "\", \"size\": \"32x32\", \"occlusion\": \"512\"}\n";
    run = test::runMeasured({"batch", folder / "jobs"}, options);
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.err.find("nacre: no job done, "), std::string::npos) << run.err;
    // What is said afterwards stands on a line of its own.
    EXPECT_NE(run.err.find("\r\x1b[Knacre: 1 jobs done"), std::string::npos) << run.err;
    run = test::runMeasured({"batch", folder / "jobs", "--quiet"}, options);
    EXPECT_EQ(run.err, "");
}

TEST(Progress, AnErrorOnATerminalIsOneLineByItself) {
    const TemporaryFolder folder;
    test::RunOptions options;
    options.terminal = true;
    const MeasuredRun run = test::runMeasured({"render", "none.pdb", "-o", folder / "a.png"}, options);
    EXPECT_EQ(run.code, 1);
    EXPECT_EQ(run.err.rfind("nacre: error: ", 0), 0u) << run.err;
}

}  // namespace
}  // namespace nacre
