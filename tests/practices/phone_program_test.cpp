// What the program tells of a phone (tests/phone_layer) and of what became of the plan there.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace nacre::test {
namespace {

using Json = nlohmann::json;

Json told(const std::string& arguments, const std::string& before = "true") {
    const TemporaryFolder folder;
    const Outcome outcome = nacreDone(folder, arguments, "", before);
    return Json::parse(outcome.out, nullptr, false);
}

TEST(PhoneProgram, BenchSkipsThePathsThatItLacks) {
    const Json report = told("bench sample:glucose --size 48x48 --occlusion 2 --frames 1 --json");
    std::vector<std::string> drawn, lacks;
    for (const Json& path : report["paths"]) drawn.push_back(path["visibility"]);
    for (const Json& path : report["lacks"]) lacks.push_back(path["visibility"]);
    EXPECT_EQ(drawn, (std::vector<std::string>{"encoded", "fragdepth", "deferred", "tiles"}));
    EXPECT_EQ(lacks, (std::vector<std::string>{"raster-order"}));
    EXPECT_NE(report["lacks"][0]["why"].get<std::string>().find("is missing"), std::string::npos) << report["lacks"];
}

TEST(PhoneProgram, StatsTellWhatLeftTheTile) {
    const std::string render =
        "render sample:glucose --size 48x48 --occlusion off --visibility encoded -o a.png --stats -";
    const Json large = told(render)["driver_feedback"],
               small = told(render, "export NACRE_PHONE_TILE=small")["driver_feedback"];
    ASSERT_EQ(large["merges"].size(), 1u) << large;  // a coarse and a fine frame have the same render pass
    for (const Json& merge : large["merges"]) {
        EXPECT_EQ(merge["planned_subpasses"], 3);
        EXPECT_EQ(merge["carried_out"], 1);
    }
    ASSERT_EQ(small["merges"].size(), 1u) << small;
    for (const Json& merge : small["merges"]) {
        EXPECT_EQ(merge["carried_out"], 3);
        EXPECT_NE(merge["why"].get<std::string>().find("the tile is full"), std::string::npos);
    }
    ASSERT_EQ(large["transient_images"].size(), 4u);  // depth, and its encoding, of both
    for (const Json& image : large["transient_images"]) EXPECT_EQ(image["committed"], 0) << image;
    for (const Json& image : small["transient_images"]) EXPECT_EQ(image["committed"], image["bytes"]) << image;
}

TEST(PhoneProgram, DevicesTellWhatItIsTakenForAndHowItsPathsDraw) {
    const Json phone = told("devices --self-test --cache here --json")[0];
    EXPECT_EQ(phone["capability_set"], "mali");
    EXPECT_NE(phone["known_by"], "");
    EXPECT_EQ(phone["merge_feedback"], true);
    EXPECT_EQ(phone["lazy_memory"], true);
    const std::string right = phone["self_test"];
    EXPECT_NE(right.find("encoded "), std::string::npos) << right;
    EXPECT_NE(right.find(" ms (3 subpasses as 1, 0 of "), std::string::npos) << right;
    const Json wrong = told("devices --self-test --cache here --json", "export NACRE_PHONE_WRONG=min")[0];
    EXPECT_NE(wrong["self_test"].get<std::string>().find("encoded wrong"), std::string::npos) << wrong;
    EXPECT_NE(wrong["visibility"], "encoded");
}

}  // namespace
}  // namespace nacre::test
