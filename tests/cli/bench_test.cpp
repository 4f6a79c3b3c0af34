// What `nacre bench` tells, held against what render says of the same frame. Times are not judged.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace nacre {
namespace {

using test::nacreIn;
using test::Outcome;
using test::TemporaryFolder;

constexpr const char* kSmall = "bench sample:dna --size 96x96 --occlusion 4 --frames 2";

TEST(Bench, FramesOfEveryPathAndTheFloorOfTheOneInUse) {
    const TemporaryFolder folder;
    const Outcome outcome = nacreIn(folder, std::string(kSmall) + " --only frames --rotate 10,20,30 --json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["paths"].size() + report["lacks"].size(), 5u);
    for (const auto& path : report["paths"]) {
        EXPECT_EQ(path["frames"], 2);
        EXPECT_GT(path["frame"]["min"], 0);
        EXPECT_LE(path["frame"]["min"], path["frame"]["p99"]);
        ASSERT_FALSE(path["passes"].empty());  // both drivers have a clock
        for (const auto& pass : path["passes"]) EXPECT_LE(pass["ms"]["min"], pass["ms"]["median"]) << pass;
        if (path["visibility"] == report["device"]["visibility"]) {
            EXPECT_EQ(path["frame"], report["times"]["frame"]);
        }
    }
    EXPECT_FALSE(report.contains("shapes") || report.contains("occlusion"));
    EXPECT_GT(report["floor"]["ratio"], 0);
    EXPECT_LT(report["atoms"]["visible"], report["atoms"]["drawn"]);
    EXPECT_EQ(report["spheres"]["submitted"], report["atoms"]["drawn"]);

    const Outcome render = nacreIn(folder,
                                   "render sample:dna --style spacefill --size 96x96 --occlusion 4 --rotate 10,20,30 "
                                   "--supersample 1 -o a.png --stats -");
    ASSERT_EQ(render.code, 0) << render.err;
    EXPECT_EQ(report["covered_pixels"], nlohmann::json::parse(render.out)["covered_pixels"]);
}

TEST(Bench, OnePathCloserBy) {
    const TemporaryFolder folder;
    const std::string deferred = std::string(kSmall) + " --only frames --visibility deferred --json";
    const auto report = nlohmann::json::parse(nacreIn(folder, deferred).out);
    const auto close = nlohmann::json::parse(nacreIn(folder, deferred + " --zoom 4").out);
    ASSERT_EQ(close["paths"].size(), 1u);
    EXPECT_EQ(close["paths"][0]["visibility"], "deferred");
    EXPECT_GT(close["covered_pixels"], report["covered_pixels"]);
    EXPECT_LT(close["atoms"]["visible"], report["atoms"]["visible"]);
}

TEST(Bench, ShapesAndBakesAlone) {
    const TemporaryFolder folder;
    const Outcome shapes = nacreIn(folder, std::string(kSmall) + " --only shapes");
    EXPECT_EQ(shapes.code, 0) << shapes.err;
    for (const char* word : {"shaded fragments per visible pixel", "dome of 3", "pyramid"})
        EXPECT_NE(shapes.out.find(word), std::string::npos) << word;
    EXPECT_EQ(shapes.out.find("raster-order"), std::string::npos);
    const Outcome bake = nacreIn(folder, std::string(kSmall) + " --only bake --json");
    const auto report = nlohmann::json::parse(bake.out);
    EXPECT_EQ(report["occlusion"].size(), 3u);
    EXPECT_FALSE(report.contains("paths") || report.contains("shapes"));
    EXPECT_EQ(nacreIn(folder, std::string(kSmall) + " --only pictures").code, 2);
}

}  // namespace
}  // namespace nacre
