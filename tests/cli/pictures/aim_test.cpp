// --orient, --look-at and --zoom-to, in what the program says of its view.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace nacre::app {
namespace {

using test::nacreDone;
using test::nacreIn;
using test::Outcome;
using test::TemporaryFolder;

nlohmann::json renderView(const TemporaryFolder& folder, const std::string& options) {
    nacreDone(folder, "render -q -o a.png --size 64x48 --occlusion off --stats s.json " + options);
    return nlohmann::json::parse(test::readContents(folder / "s.json"))["view"];
}

TEST(Aim, ViewsAreToldSoThatTheyCanBeRepeated) {
    const TemporaryFolder folder;
    const nlohmann::json file = renderView(folder, "sample:dna");
    EXPECT_EQ(file["orientation"], nlohmann::json({1.0, 0.0, 0.0, 0.0}));
    EXPECT_GT(file["zoom"], 1.0) << "its picture is narrower than its sphere";
    EXPECT_EQ(renderView(folder, "sample:dna --zoom 1")["zoom"], 1.0);
    const nlohmann::json aimed =
        renderView(folder, "sample:dna --orient principal --zoom-to 'chain A and resi 3' --rotate 0,0,10");
    EXPECT_NE(aimed["rotation"], file["rotation"]);
    EXPECT_GT(aimed["zoom"], 1.5);
    // What it says, as a saved view: the same picture.
    const std::string picture = test::readContents(folder / "a.png");
    nlohmann::json view = {{"input", "sample:dna"}};
    for (const char* key : {"orientation", "zoom", "pan", "clip", "uncover"}) view[key] = aimed[key];
    std::ofstream(folder / "v.json") << view.dump();
    const nlohmann::json repeated = renderView(folder, "--view v.json");
    EXPECT_TRUE(test::readContents(folder / "a.png") == picture);  // bytes are no reading
    EXPECT_NEAR(repeated["pixels_per_angstrom"].get<double>(), aimed["pixels_per_angstrom"].get<double>(), 1e-9);
    // What hides it is left out there, too; `off` leaves it.
    EXPECT_EQ(aimed["uncover"], "chain A and resi 3");
    EXPECT_TRUE(renderView(folder, "--view v.json --uncover off").at("uncover").is_null());
    EXPECT_FALSE(test::readContents(folder / "a.png") == picture);
    EXPECT_TRUE(renderView(folder, "sample:dna --zoom-to 'chain A' --clip off").at("uncover").is_null());
    // Labels of what is left out are left out with a word.
    EXPECT_NE(nacreIn(folder,
                      "render sample:dna -o a.png --size 64x48 --occlusion off --orient principal "
                      "--zoom-to 'chain A and resi 3' --label 'chain B and resi 20 and name P=P'")
                  .err.find("no label at chain B and resi 20 and name P: none"),
              std::string::npos);
    // The file's frame again, whatever the view says.
    EXPECT_EQ(renderView(folder, "--view v.json --orient file")["orientation"], file["orientation"]);
    EXPECT_NE(renderView(folder, "sample:dna --look-at 'chain B and resi 20'")["rotation"], file["rotation"]);
}

/// What is drawn, in pixels.
struct Extent {
    int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1;
    int width() const { return right - left + 1; }
    int height() const { return bottom - top + 1; }
};
Extent measureExtent(const TemporaryFolder& folder, const std::string& options) {
    nacreDone(folder,
              "render -q -o a.png --size 300x200 --occlusion off --background transparent --stats s.json " + options);
    const std::unique_ptr<OIIO::ImageInput> file = OIIO::ImageInput::open(folder / "a.png");
    std::vector<unsigned char> pixels(300 * 200 * 4);
    EXPECT_TRUE(file && file->read_image(0, 0, 0, 4, OIIO::TypeDesc::UINT8, pixels.data()));
    Extent extent;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 300; ++x) {
            if (pixels[static_cast<std::size_t>(4 * (300 * y + x) + 3)] == 0) continue;
            extent.left = std::min(extent.left, x), extent.right = std::max(extent.right, x);
            extent.top = std::min(extent.top, y), extent.bottom = std::max(extent.bottom, y);
        }
    return extent;
}

TEST(Aim, ThePictureIsFilledUnlessItsScaleIsGiven) {
    const TemporaryFolder folder;
    for (const char* options :
         {"", " --rotate 0,0,90", " --rotate 30,40,50 --style cartoon", " --projection perspective"}) {
        const Extent e = measureExtent(folder, std::string("sample:dna") + options);
        EXPECT_TRUE(e.width() >= 280 || e.height() >= 187) << options << e.width() << " " << e.height();
        EXPECT_TRUE(e.width() <= 290 && e.height() <= 194) << options << e.width() << " " << e.height();
        EXPECT_NEAR(e.left, 299 - e.right, 4) << options;
        EXPECT_NEAR(e.top, 199 - e.bottom, 4) << options;
    }
    // Views that say how large keep to it: 95 % of the shorter side are the molecule's sphere.
    for (const char* json : {R"({"input": "sample:dna", "zoom": 1})", R"({"input": "sample:dna"})"}) {
        std::ofstream(folder / "v.json") << json;
        EXPECT_LT(measureExtent(folder, "--view v.json").height(), 187);
        const auto view = nlohmann::json::parse(test::readContents(folder / "s.json"))["view"];
        EXPECT_NEAR(view["pixels_per_angstrom"].get<double>(), 0.95 * 200 / (2 * view["radius"].get<double>()), 1e-9);
    }
}

TEST(Aim, NothingToAimAtIsAnError) {
    const TemporaryFolder folder;
    const auto fault = [&](const std::string& options) {
        const Outcome outcome = nacreIn(folder, "render sample:dna -o a.png --size 32x32 " + options);
        EXPECT_NE(outcome.code, 0);
        EXPECT_EQ(test::readContents(folder / "a.png"), "");
        return outcome.err;
    };
    EXPECT_EQ(fault("--look-at ligand"), "nacre: error: cannot look at: ligand: the molecule has no such atoms\n");
    EXPECT_EQ(fault("--hide 'chain A' --zoom-to 'chain A'"),
              "nacre: error: cannot zoom to: chain A: none of its atoms is drawn\n");
    EXPECT_EQ(fault("--uncover ligand"), "nacre: error: cannot uncover: ligand: the molecule has no such atoms\n");
    EXPECT_NE(fault("--orient best").find("--orient: cannot read selection: 'best'"), std::string::npos);
    EXPECT_NE(fault("--zoom-to 'chain'").find("--zoom-to"), std::string::npos);
}

}  // namespace
}  // namespace nacre::app
