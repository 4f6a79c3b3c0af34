// --orient, --look-at and --zoom-to, in what the program says of its view.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace nacre::app {
namespace {

using test::nacreIn;
using test::Outcome;
using test::TemporaryFolder;

nlohmann::json viewOf(const TemporaryFolder& folder, const std::string& options) {
    const Outcome outcome =
        nacreIn(folder, "render -q -o a.png --size 64x48 --occlusion off --stats s.json " + options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return nlohmann::json::parse(test::contentOf(folder / "s.json"))["view"];
}

TEST(Aim, ViewsAreToldSoThatTheyCanBeRepeated) {
    const TemporaryFolder folder;
    const nlohmann::json file = viewOf(folder, "sample:dna");
    EXPECT_EQ(file["orientation"], nlohmann::json({1.0, 0.0, 0.0, 0.0}));
    EXPECT_EQ(file["zoom"], 1.0);
    const nlohmann::json aimed =
        viewOf(folder, "sample:dna --orient principal --zoom-to 'chain A and resi 3' --rotate 0,0,10");
    EXPECT_NE(aimed["rotation"], file["rotation"]);
    EXPECT_GT(aimed["zoom"], 1.5);
    // What it says, as a saved view: the same picture.
    const std::string picture = test::contentOf(folder / "a.png");
    nlohmann::json view = {{"input", "sample:dna"}};
    for (const char* key : {"orientation", "zoom", "pan", "clip", "uncover"}) view[key] = aimed[key];
    std::ofstream(folder / "v.json") << view.dump();
    const nlohmann::json repeated = viewOf(folder, "--view v.json");
    EXPECT_TRUE(test::contentOf(folder / "a.png") == picture);  // bytes are no reading
    EXPECT_NEAR(repeated["pixels_per_angstrom"].get<double>(), aimed["pixels_per_angstrom"].get<double>(), 1e-9);
    // What hides it is left out there, too; `off` leaves it.
    EXPECT_EQ(aimed["uncover"], "chain A and resi 3");
    EXPECT_FALSE(viewOf(folder, "--view v.json --uncover off").contains("uncover"));
    EXPECT_FALSE(test::contentOf(folder / "a.png") == picture);
    EXPECT_FALSE(viewOf(folder, "sample:dna --zoom-to 'chain A' --clip off").contains("uncover"));
    // Labels of what is left out are left out with a word.
    EXPECT_NE(nacreIn(folder,
                      "render sample:dna -o a.png --size 64x48 --occlusion off --orient principal "
                      "--zoom-to 'chain A and resi 3' --label 'chain B and resi 20 and name P=P'")
                  .err.find("no words at chain B and resi 20 and name P: none"),
              std::string::npos);
    // The file's frame again, whatever the view says.
    EXPECT_EQ(viewOf(folder, "--view v.json --orient file")["orientation"], file["orientation"]);
    EXPECT_NE(viewOf(folder, "sample:dna --look-at 'chain B and resi 20'")["rotation"], file["rotation"]);
}

TEST(Aim, NothingToAimAtIsAnError) {
    const TemporaryFolder folder;
    const auto fault = [&](const std::string& options) {
        const Outcome outcome = nacreIn(folder, "render sample:dna -o a.png --size 32x32 " + options);
        EXPECT_NE(outcome.code, 0);
        EXPECT_EQ(test::contentOf(folder / "a.png"), "");
        return outcome.err;
    };
    EXPECT_EQ(fault("--look-at ligand"), "nacre: error: cannot look at: ligand: the molecule has no such atoms\n");
    EXPECT_EQ(fault("--hide 'chain A' --zoom-to 'chain A'"),
              "nacre: error: cannot zoom to: chain A: none of its atoms is drawn\n");
    EXPECT_EQ(fault("--uncover ligand"), "nacre: error: cannot uncover: ligand: the molecule has no such atoms\n");
    EXPECT_NE(fault("--orient best").find("principal or file, not 'best'"), std::string::npos);
    EXPECT_NE(fault("--zoom-to 'chain'").find("--zoom-to"), std::string::npos);
}

}  // namespace
}  // namespace nacre::app
