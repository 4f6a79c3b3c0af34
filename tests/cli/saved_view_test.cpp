// `nacre render --view`: a saved view is the options that it stands for.

#include "app/picture/saved_view.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/input/input_files.h"
#include "app/picture/appearance_values.h"
#include "tests/support/run_program.h"

namespace nacre {
namespace {

using test::nacreDone;
using test::nacreIn;
using test::readContents;
using test::TemporaryFolder;

constexpr const char* kView = R"({"input": "sample:glucose", "style": "licorice", "color": "chain",
    "rules": [{"show": "elem O=spacefill"}, {"color-by": "elem O=#ff8000"}], "hydrogens": "hide",
    "projection": "perspective", "fov": 40, "zoom": 1.25, "background": "#203040", "lighting": "off",
    "occlusion": "off", "orientation": [0.7071067811865476, 0, 0.7071067811865476, 0]})";
constexpr const char* kOptions =
    "--style licorice --color chain --show 'elem O=spacefill' --color-by 'elem O=#ff8000' --hydrogens hide "
    "--projection perspective --fov 40 --zoom 1.25 --background '#203040' --lighting off --occlusion off "
    "--rotate 0,90,0";

std::string rendered(const TemporaryFolder& folder, const std::string& arguments) {
    nacreDone(folder, "render " + arguments + " -o a.png --size 160x120");
    return readContents(folder / "a.png");
}

TEST(SavedView, IsTheOptionsThatItStandsFor) {
    const TemporaryFolder folder;
    std::ofstream(folder / "v.json") << kView;
    const std::string picture = rendered(folder, std::string("sample:glucose ") + kOptions);
    EXPECT_EQ(rendered(folder, "--view v.json"), picture);
    EXPECT_EQ(rendered(folder, "sample:glucose --view v.json"), picture);
    EXPECT_NE(rendered(folder, "sample:dna --view v.json"), picture);
    // An INPUT takes the place of the view's.
    rendered(folder, "sample:glucose --view v.json --stats s.json");
    EXPECT_NE(readContents(folder / "s.json").find("\"read\": 24"), std::string::npos);
}

TEST(SavedView, OptionsPrevailWhereverTheyStand) {
    const TemporaryFolder folder;
    std::ofstream(folder / "v.json") << kView;
    const std::string options = std::string("sample:glucose ") + kOptions;
    for (const char* order : {"--zoom 2 --background white --view v.json", "--view v.json --background white --zoom 2"})
        EXPECT_EQ(rendered(folder, order),
                  rendered(folder,
                           "sample:glucose --style licorice --color chain --show 'elem O=spacefill' --color-by "
                           "'elem O=#ff8000' --hydrogens hide --projection perspective --fov 40 --zoom 2 "
                           "--background white --lighting off --occlusion off --rotate 0,90,0"))
            << order;
    // Rules of the command line come after those of the view.
    EXPECT_EQ(rendered(folder, "--color-by 'elem O=#0000ff' --view v.json"),
              rendered(folder, options + " --color-by 'elem O=#0000ff'"));
}

TEST(SavedView, WithoutAnInputOrAReadableFileNothingIsDrawn) {
    const TemporaryFolder folder;
    std::ofstream(folder / "v.json") << R"({"zoom": 2})";
    std::ofstream(folder / "bad.json") << R"({"zoom": -2})";
    EXPECT_EQ(nacreIn(folder, "render --view v.json -o a.png").code, 2);
    const test::Outcome bad = nacreIn(folder, "render sample:dna --view bad.json -o a.png");
    EXPECT_EQ(bad.code, 2);
    EXPECT_NE(bad.err.find("zoom"), std::string::npos) << bad.err;
    EXPECT_EQ(nacreIn(folder, "render sample:dna --view none.json -o a.png").code, 2);
    EXPECT_EQ(folder.count(), 2u);
}

// A view and its file that were moved together, or sent to someone: the file is found by what it holds.
TEST(SavedView, NamesMapsFromItsFolderAndTellsOfOthers) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "views");
    std::string cube = "a map\nof one blob\n1 -3 -3 -3\n4 4 0 0\n4 0 4 0\n4 0 0 4\n6 0 0 0 0\n";
    for (int i = 0; i < 64; ++i) cube += i == 21 || i == 42 ? "1 " : "0 ";
    for (const char* place : {"views/inside.cube", "outside.cube"}) std::ofstream(folder / place) << cube << "\n";
    for (const auto& [map, told] : {std::pair("inside.cube", false), {"../outside.cube", true}}) {
        std::ofstream(folder / "views/v.json")
            << R"({"input": "sample:glucose", "map": [")" << map << R"("], "map-level": ["0.5"]})";
        const Outcome outcome = nacreDone(folder, "render --view views/v.json -o a.png --size 32x32 --occlusion off");
        EXPECT_EQ(outcome.err.find("not in its folder") != std::string::npos, told) << outcome.err;
        app::PictureDescription view;
        app::applySavedView(folder / "views/v.json", view);
        EXPECT_EQ(view.maps.files.front(), folder / (std::string("views/") + map));
    }
    // Whoever names the map means it.
    const test::Outcome own = nacreIn(
        folder, "render sample:glucose --map outside.cube --map-level 0.5 -o a.png --size 32x32 --occlusion off");
    EXPECT_EQ(own.err, "");
    // A map alone is drawn.
    nacreDone(folder, "render outside.cube --map-level 0.5 -o a.png --size 32x32 --occlusion off --stats s.json");
    EXPECT_NE(readContents(folder / "s.json").find("\"read\": 0"), std::string::npos);
    EXPECT_NE(nacreIn(folder, "render sample:glucose --map-level 0.5 -o a.png --size 32x32").err.find("without --map"),
              std::string::npos);
}

TEST(SavedView, FindsItsFileBesideItByItsHash) {
    const TemporaryFolder folder;
    const auto put = [&](const char* name, const char* element) {
        std::ofstream(folder / name) << "ATOM      1  X   GLY A   1       0.000   0.000   0.000  1.00  0.00           "
                                     << element << "\nEND\n";
    };
    const auto view = [&](const std::string& input, const std::string& hash) {
        std::ofstream(folder / "v.json") << "{\"input\": \"" << input << "\", \"hash\": \"" << hash
                                         << "\", \"occlusion\": \"off\"}";
    };
    const auto draw = [&] { return nacreIn(folder, "render --view v.json -o a.png --size 16x16"); };
    put("carbon.pdb", "C");
    const std::string carbon = app::fileHash(folder / "carbon.pdb");
    EXPECT_EQ(carbon.substr(0, carbon.find('-')), "83") << carbon;
    put("oxygen.pdb", "O");
    EXPECT_NE(app::fileHash(folder / "oxygen.pdb"), carbon);
    nacreDone(folder, "render carbon.pdb -o c.png --size 16x16 --occlusion off");
    const std::string picture = readContents(folder / "c.png");

    view("/nowhere/at/all/carbon.pdb", carbon);
    test::Outcome outcome = draw();
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(readContents(folder / "a.png"), picture);
    EXPECT_NE(outcome.err.find("this one has the same content: carbon.pdb"), std::string::npos) << outcome.err;

    view("elsewhere/other-name.pdb", carbon);  // by another name, beside one as long
    outcome = draw();
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(readContents(folder / "a.png"), picture);

    view("/nowhere/at/all/oxygen.pdb", carbon + "0");  // the name alone is not enough
    outcome = draw();
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("/nowhere/at/all/oxygen.pdb"), std::string::npos) << outcome.err;

    view("oxygen.pdb", carbon);
    outcome = draw();
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("oxygen.pdb has changed since v.json was saved"), std::string::npos) << outcome.err;
}

TEST(SavedView, OptionsBecomeAViewThatMeansThem) {
    app::PictureDescription options;
    options.input.path = "x.pdb";
    options.input.format = Format::pdb;
    options.look.style = Style::licorice;
    options.look.rules = {app::parseShow("chain A=spacefill"), app::parseHide("water"),
                          app::parseColorBy("chain A=b-factor")};
    options.background = {1, 0, 0, 0.5f};
    options.camera.zoom = 3;
    const TemporaryFolder folder;
    std::ofstream(folder / "v.json") << app::savedViewJson(options);
    app::PictureDescription back;
    app::applySavedView(folder / "v.json", back);
    EXPECT_EQ(app::savedViewJson(back), app::savedViewJson(options));
    EXPECT_EQ(back.input.path, "x.pdb");
    EXPECT_EQ(back.input.namedBy, (folder / "v.json"));
    EXPECT_EQ(back.look.rules.size(), 3u);
    EXPECT_EQ(back.look.rules[2].coloring.scheme, ColorScheme::bFactor);
    EXPECT_EQ(back.camera.zoom, 3);
}

}  // namespace
}  // namespace nacre
