// --occlusion-memory, as a user meets it.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace nacre::app {
namespace {

using test::nacreDone;
using test::nacreIn;
using test::Outcome;
using test::readContents;
using test::TemporaryFolder;

TEST(OcclusionMemory, IsKeptToAndSaid) {
    const TemporaryFolder folder;
    for (const int megabytes : {1, 64}) {
        const Outcome outcome = nacreDone(
            folder, "render sample:dna -o a.png --size 64x64 --occlusion 16 --stats s.json --occlusion-memory " +
                        std::to_string(megabytes));
        const auto occlusion = nlohmann::json::parse(readContents(folder / "s.json"))["occlusion"];
        EXPECT_LE(occlusion["bytes"].get<std::uint64_t>(), std::uint64_t(megabytes) << 20);
        const std::string patch = std::to_string(occlusion["patch_texels"].get<int>());
        EXPECT_NE(outcome.err.find(patch + " x " + patch + " texels per atom"), std::string::npos) << outcome.err;
        EXPECT_NE(outcome.err.find(" of " + std::to_string(megabytes) + " MB"), std::string::npos) << outcome.err;
    }
}

TEST(OcclusionMemory, SaysNothingUnasked) {
    const TemporaryFolder folder;
    EXPECT_EQ(nacreIn(folder, "render sample:glucose -o a.png --size 32x32 --occlusion 8").err, "");
}

TEST(OcclusionMemory, RefusesWhatIsNoSize) {
    const TemporaryFolder folder;
    for (const char* size : {"0", "-1", "65537", "many", "1.5", ""})
        EXPECT_EQ(nacreIn(folder, std::string("render sample:glucose -o a.png --occlusion-memory '") + size + "'").code,
                  2)
            << size;
}

TEST(OcclusionDetail, BoundsPatchesAndDepthMaps) {
    const TemporaryFolder folder;
    const auto bakeWith = [&](const std::string& detail) {
        const std::string command = "render sample:dna -o a.png --size 64x64 --occlusion 4 --stats s.json";
        nacreDone(folder, command + detail);
        return nlohmann::json::parse(readContents(folder / "s.json"))["occlusion"];
    };
    const auto full = bakeWith(""), coarse = bakeWith(" --occlusion-detail 12");
    EXPECT_EQ(full["patch_texels"], 32);
    EXPECT_EQ(coarse["patch_texels"], 12);
    EXPECT_LT(coarse["texels"].get<int>(), full["texels"].get<int>() / 5);
    EXPECT_LT(coarse["map_pixels"].get<int>(), full["map_pixels"].get<int>());
    for (const char* detail : {"3", "33", "fine"})
        EXPECT_EQ(nacreIn(folder, std::string("render sample:dna -o a.png --occlusion-detail ") + detail).code, 2);
}

}  // namespace
}  // namespace nacre::app
