// What `nacre bench` tells, held against what render says of the same frame. Times are not judged.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace nacre {
namespace {

using test::nacreDone;
using test::nacreIn;
using test::Outcome;
using test::TemporaryFolder;

constexpr const char* kSmall = "bench sample:dna --size 96x96 --occlusion 4 --frames 2";

TEST(Bench, FramesOfEveryPathAndTheFloorOfTheOneInUse) {
    const TemporaryFolder folder;
    const Outcome outcome = nacreDone(folder, std::string(kSmall) + " --rotate 10,20,30 --json");
    const auto report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["paths"].size() + report["lacks"].size(), 5u);
    for (const auto& path : report["paths"]) {
        EXPECT_EQ(path["frames"], 2);
        EXPECT_GT(path["frame"]["min"], 0);
        EXPECT_LE(path["frame"]["min"], path["frame"]["p99"]);
        ASSERT_FALSE(path["passes"].empty());  // both drivers have a clock
        for (const auto& pass : path["passes"]) EXPECT_LE(pass["ms"]["min"], pass["ms"]["median"]) << pass;
        EXPECT_GT(path["processor"]["min"], 0);
        EXPECT_EQ(path["samples_per_pixel"], 1);
        EXPECT_EQ(path["geometry"]["vertices"] > 0, path["visibility"] != "tiles");
        EXPECT_EQ(!path.at("lists").is_null(), path["visibility"] == "tiles");
        if (path["visibility"] == report["device"]["visibility"]) {
            EXPECT_EQ(path["frame"], report["times"]["frame"]);
        }
    }
    EXPECT_GT(report["floor"]["ratio"], 0);
    EXPECT_LT(report["atoms"]["visible"], report["atoms"]["drawn"]);
    const auto& spheres = report["spheres"];
    EXPECT_EQ(spheres["submitted"], report["atoms"]["drawn"]);
    EXPECT_LE(spheres["kept"], spheres["submitted"]);
    EXPECT_LE(spheres["visible"], spheres["kept"]);
    EXPECT_EQ(spheres["visible"], report["atoms"]["visible"]);
    EXPECT_GT(report["times"]["load"], 0);
    EXPECT_GT(report["times"]["frame_processor"]["min"], 0);
    EXPECT_GT(report["memory"]["resident_peak"], 1 << 20);

    const Outcome render = nacreDone(folder,
                                     "render sample:dna --style spacefill --size 96x96 --occlusion 4 --rotate 10,20,30 "
                                     "--supersample 1 --zoom 1 -o a.png --stats -");
    EXPECT_EQ(report["covered_pixels"], nlohmann::json::parse(render.out)["covered_pixels"]);
}

TEST(Bench, OnePathCloserBy) {
    const TemporaryFolder folder;
    const std::string deferred = std::string(kSmall) + " --visibility deferred --json";
    const auto report = nlohmann::json::parse(nacreIn(folder, deferred).out);
    const auto close = nlohmann::json::parse(nacreIn(folder, deferred + " --zoom 4").out);
    ASSERT_EQ(close["paths"].size(), 1u);
    EXPECT_EQ(close["paths"][0]["visibility"], "deferred");
    EXPECT_GT(close["covered_pixels"], report["covered_pixels"]);
    EXPECT_LT(close["atoms"]["visible"], report["atoms"]["visible"]);
    EXPECT_LT(close["spheres"]["submitted"], report["spheres"]["submitted"]);
}

TEST(Bench, SeveralInputsEachByItselfAndWhatIsSaidOfOneThatFails) {
    const TemporaryFolder folder;
    const std::string flags = " --style spacefill --size 64x64 --occlusion off --frames 1 --visibility tiles";
    const Outcome outcome = nacreIn(folder, "bench sample:glucose nothing.pdb sample:buckyball --json" + flags);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("nothing.pdb"), std::string::npos) << outcome.err;
    const auto reports = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(reports.size(), 2u);
    EXPECT_EQ(reports[0]["input"], "sample:glucose");
    EXPECT_EQ(reports[1]["atoms"]["drawn"], 60);
    EXPECT_GT(reports[1]["paths"][0]["lists"]["entries"], reports[1]["spheres"]["kept"]);
    const Outcome table = nacreIn(folder, "bench sample:glucose sample:buckyball" + flags);
    EXPECT_LT(table.out.find("sample:glucose"), table.out.find("sample:buckyball"));
    EXPECT_NE(table.out.find("entries of lists"), std::string::npos) << table.out;
}

TEST(Bench, TableOfAPathWithoutListsAndOfAPictureWithoutAtoms) {
    const TemporaryFolder folder;
    const std::string options = "bench sample:glucose --size 64x64 --occlusion off --frames 1 --visibility fragdepth";
    const Outcome table = nacreDone(folder, options);
    EXPECT_EQ(table.out.find("of lists"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("times as long\n"), std::string::npos) << table.out;
    const Outcome nothing = nacreDone(folder, options + " --pan 9,9");
    EXPECT_NE(nothing.out.find("; 0 pixels covered\n"), std::string::npos) << nothing.out;
}

TEST(Bench, EdgesByTilesAndByMoreSamples) {
    const TemporaryFolder folder;
    struct Case {
        const char* options;
        int samples;
    };
    for (const Case& c :
         {Case{"tiles --supersample auto", 16}, Case{"encoded --supersample auto", 16},
          Case{"tiles --supersample auto --show all=surface:opacity=0.5", 16}, Case{"encoded --supersample 2", 4}}) {
        const Outcome outcome = nacreIn(folder, std::string("bench sample:glucose --size 64x64 ") +
                                                    "--occlusion off --frames 1 --json --visibility " + c.options);
        const auto path = nlohmann::json::parse(outcome.out)["paths"][0];
        EXPECT_EQ(path["samples_per_pixel"], c.samples) << c.options;
    }
}

TEST(Bench, ModelsDrawnTogetherHaveAFloor) {
    const TemporaryFolder folder;
    std::ofstream(folder / "two.xyz") << "2\none\nO 0 0 0\nC 0 0 3\n2\ntwo\nO 4 0 0\nC 4 0 3\n";
    const Outcome outcome = nacreDone(folder,
                                      "bench two.xyz --model all --style spacefill --size 64x64 "
                                      "--occlusion 4 --frames 1 --visibility tiles --json");
    const auto report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["spheres"]["submitted"], 4);
    EXPECT_EQ(report["spheres"]["visible"], 2);  // two hide behind the others
    EXPECT_GT(report["floor"]["ratio"], 0);
}

}  // namespace
}  // namespace nacre
