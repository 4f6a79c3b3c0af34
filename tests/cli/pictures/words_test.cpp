// --label, --measure, --title, --scale-bar and --legend, and colours by options, in pictures that the program draws.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "tests/support/run_program.h"

namespace nacre::app {
namespace {

using test::nacreDone;
using test::nacreIn;
using test::Outcome;
using test::TemporaryFolder;

std::vector<float> readPixels(const std::string& path) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path, &config);
    if (!input) return {};
    const OIIO::ImageSpec& spec = input->spec();
    std::vector<float> pixels(static_cast<std::size_t>(spec.width * spec.height * spec.nchannels));
    input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data());
    return pixels;
}

std::size_t differing(const std::vector<float>& a, const std::vector<float>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size() && a.size() == b.size(); ++i) count += std::abs(a[i] - b[i]) > 0.02f;
    return count;
}

constexpr const char* kBase = "render sample:glucose --size 200x160 --occlusion off --zoom 1 ";

TEST(WordOptions, EachPutsInkIntoThePictureAndAViewKeepsIt) {
    const TemporaryFolder folder;
    nacreDone(folder, std::string(kBase) + "-o plain.png");
    const std::vector<float> plain = readPixels(folder / "plain.png");
    const std::pair<const char*, const char*> options[] = {
        {"--label 'elem O={element}_{id}'", R"("labels": ["elem O={element}_{id}"])"},
        {"--measure 1,2,3", R"("measures": ["1,2,3"])"},
        {"--title 'Glucose, \\alpha'", R"("title": "Glucose, \\alpha")"},
        {"--scale-bar nm", R"("scale-bar": "nm")"},
        {"--axes on", R"("axes": "on")"},
        {"--legend on --text-color red --text-size 15", R"("legend": "on", "text-color": "#ff0000", "text-size": 15)"}};
    for (const auto& [option, keys] : options) {
        const Outcome outcome = nacreDone(folder, std::string(kBase) + "-o a.png " + option);
        EXPECT_EQ(outcome.err, "");
        EXPECT_GT(differing(plain, readPixels(folder / "a.png")), 100u) << option;
        std::ofstream(folder / "v.json") << "{\"input\": \"sample:glucose\", " << keys << "}";
        nacreDone(folder, "render --view v.json --size 200x160 --occlusion off -o b.png");
        EXPECT_TRUE(test::readContents(folder / "a.png") == test::readContents(folder / "b.png")) << keys;
    }
}

TEST(WordOptions, WhatIsMissingInThePictureIsSaid) {
    const TemporaryFolder folder;
    const auto said = [&](const std::string& labels) {
        return nacreIn(folder, "render sample:glucose --size 64x64 --occlusion off -o a.png " + labels).err;
    };
    const std::string one = "--label 'name C1=A text that is too long for it' ";
    EXPECT_NE(said(one).find("warning: 1 label does not fit into the picture"), std::string::npos);
    EXPECT_NE(said(one + one).find("warning: 2 labels do not fit into the picture"), std::string::npos);
    EXPECT_NE(said("--title \U0010fffd").find("warning: no installed font has the character U+10FFFD"),
              std::string::npos);
}

TEST(PictureOptions, TransparentEdgesAreRightOnBlackAndOnWhite) {
    const TemporaryFolder folder;
    const std::string draw = "render sample:dna --zoom 1 --size 160x160 --occlusion off --look default -o ";
    nacreDone(folder, draw + "open.png --transparent");
    const std::vector<float> open = readPixels(folder / "open.png");
    for (const float ground : {0.0f, 1.0f}) {
        nacreDone(folder, draw + "on.png --background " + (ground > 0 ? "white" : "black"));
        const std::vector<float> on = readPixels(folder / "on.png");
        ASSERT_EQ(open.size() / 4, on.size() / 3);
        double sum = 0;
        for (std::size_t i = 0; i < on.size(); ++i) {
            const float alpha = open[i / 3 * 4 + 3];
            const float mixed = open[i / 3 * 4 + i % 3] * alpha + (1 - alpha) * ground;
            sum += (mixed - on[i]) * (mixed - on[i]);
        }
        EXPECT_GT(10 * std::log10(static_cast<double>(on.size()) / sum), 45) << ground;
    }
}

TEST(PictureOptions, AThumbnailIsSmallAndTurnedToItsAxes) {
    const TemporaryFolder folder;
    const auto draws = [&](const std::string& options) {
        nacreDone(folder, "render sample:dna --occlusion 4 -o a.png " + options);
        return test::readContents(folder / "a.png");
    };
    const std::string small = draws("--size 64x64 --orient principal --occlusion-detail 12");
    EXPECT_TRUE(draws("--thumbnail 64") == small);
    EXPECT_TRUE(draws("--thumbnail 256 --size 64x64") == small);
    EXPECT_FALSE(draws("--thumbnail 64 --orient file") == small);
    std::ofstream(folder / "jobs") << R"({"input": "sample:dna", "output": "b.png", "thumbnail": 64, "occlusion": 4})";
    nacreDone(folder, "batch jobs");
    EXPECT_TRUE(test::readContents(folder / "b.png") == small);
}

TEST(PictureOptions, AThumbnailIsNearlyAsGoodAsFullOcclusion) {
    const TemporaryFolder folder;
    const auto draws = [&](const std::string& options) {
        nacreDone(folder, "render sample:dna --cache off -o a.png " + options);
        return readPixels(folder / "a.png");
    };
    const std::vector<float> small = draws("--thumbnail 256");
    EXPECT_EQ(small, draws("--size 256x256 --orient principal --occlusion-detail 12 --occlusion 64"));
    const std::vector<float> full = draws("--size 256x256 --orient principal --occlusion 512");
    ASSERT_EQ(small.size(), full.size());
    double sum = 0;
    for (std::size_t i = 0; i < full.size(); ++i) sum += (small[i] - full[i]) * (small[i] - full[i]);
    EXPECT_GT(10 * std::log10(static_cast<double>(full.size()) / sum), 41);
}

TEST(WordOptions, LayersAndDebugViewsHaveNoWords) {
    const TemporaryFolder folder;
    for (const char* title : {"", "--title TITLE --legend on"})
        nacreDone(folder, std::string(kBase) + "--debug overdraw -o " + (*title ? "b" : "a") + ".png --layers " +
                              (*title ? "b" : "a") + ".exr " + title);
    EXPECT_TRUE(test::readContents(folder / "a.png") == test::readContents(folder / "b.png"));
    EXPECT_TRUE(test::readContents(folder / "a.exr") == test::readContents(folder / "b.exr"));
}

TEST(WordOptions, ALegendNeedsNoValueAndLeavesTheInputAlone) {
    const TemporaryFolder folder;
    const auto drawn = [&](const std::string& words) {
        const Outcome outcome = nacreDone(folder, "render -o - --size 64x64 --occlusion off " + words);
        return outcome.out;
    };
    const std::string with = drawn("sample:glucose --legend on");
    EXPECT_NE(with, drawn("sample:glucose --legend off"));
    EXPECT_EQ(with, drawn("--legend sample:glucose"));
    EXPECT_EQ(with, drawn("sample:glucose --legend"));
    EXPECT_EQ(nacreIn(folder, "render -o - sample:glucose --legend=maybe").code, 2);
}

TEST(WordOptions, StandInMovies) {
    const TemporaryFolder folder;
    const auto frame = [&](const std::string& words) {
        nacreDone(folder,
                  "movie sample:glucose -o frames/ --spin y --seconds 0.1 --fps 20 --size 64x64 "
                  "--occlusion off " +
                      words);
        std::string all;
        for (const auto& file : std::filesystem::directory_iterator(folder / "frames"))
            all += test::readContents(file.path().string());
        return all;
    };
    const std::string plain = frame("");
    EXPECT_NE(plain, frame("--title Sugar"));
    EXPECT_NE(plain, frame("--label 'id 1={atom}'"));
    EXPECT_NE(plain, frame("--look dark"));
}

TEST(WordOptions, LabelsOfWhatLiesBehindAreShownOrNot) {
    const TemporaryFolder folder;
    const auto labelled = [&](const char* which) {
        nacreDone(folder, std::string("render -q sample:dna --size 160x160 --occlusion off --supersample 1 -o a.png "
                                      "--label 'resi 1-12={number}' --show-labels ") +
                              which);
        return readPixels(folder / "a.png");
    };
    EXPECT_GT(differing(labelled("all"), labelled("seen")), 20u);
    EXPECT_EQ(nacreIn(folder, "render sample:dna -o b.png --show-labels some").code, 2);
}

TEST(MeshOptions, ErrorInPixelsChoosesTheLevelOfACartoon) {
    const TemporaryFolder folder;
    const auto drawn = [&](const std::string& error) {
        const Outcome outcome = nacreDone(folder, "plan sample:dna --style cartoon --json --mesh-error " + error);
        const auto levels = nlohmann::json::parse(outcome.out)["mesh_levels"];
        EXPECT_GT(levels.size(), 2u);
        std::size_t sum = 0;
        for (const auto& level : levels) sum += level["drawn"].get<std::size_t>();
        if (error == "0") {
            EXPECT_EQ(levels[0]["drawn"], levels[0]["triangles"]);
        }
        return sum;
    };
    EXPECT_GT(drawn("0"), 2 * drawn("4"));
    EXPECT_EQ(nacreIn(folder, "plan sample:dna --style cartoon --mesh-error -1").code, 2);
}

TEST(ColorOptions, SchemesPalettesAndRangesReachTheLegend) {
    const TemporaryFolder folder;
    const auto legend = [&](const std::string& options) {
        nacreDone(folder, "render -q sample:dna --size 48x48 --occlusion off -o a.png --stats s.json " + options);
        return nlohmann::json::parse(test::readContents(folder / "s.json"))["legend"][0];
    };
    EXPECT_EQ(legend("--color cbc")["scheme"], "chain-carbons");
    EXPECT_EQ(legend("--color chain --palette okabe-ito")["scheme"], "chain:okabe-ito");
    EXPECT_EQ(legend("--color chain --palette okabe-ito")["entries"][0]["color"], "#56b4e9");
    EXPECT_EQ(legend("--color chain --palette viridis")["scheme"], "chain");  // a ramp is not for categories
    EXPECT_EQ(legend("--color chain:light --palette muted")["scheme"], "chain:light");
    EXPECT_EQ(legend("--color b-factor:0..50 --palette plasma")["scheme"], "b-factor:0..50:plasma");
}

}  // namespace
}  // namespace nacre::app
