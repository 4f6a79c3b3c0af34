// What the window keeps of earlier files, and the programs of the desktop that it asks.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "app/desktop/processes.h"
#include "app/desktop/state_files.h"
#include "app/download/molecule_sources.h"
#include "tests/desktop/environment.h"

namespace nacre::app {
namespace {

using test::FakePrograms;
using test::TemporaryFolder;
using test::Variable;

Picture makePicture(float red, PixelSize size = RecentFiles::kPicture) {
    Picture picture;
    picture.width = size.width;
    picture.height = size.height;
    for (std::uint32_t i = 0; i < picture.width * picture.height; ++i)
        picture.rgba.insert(picture.rgba.end(), {red, 0.0f, i == 5 ? 1.0f : 0.0f, 1.0f});
    return picture;
}

TEST(RecentFiles, TheLatestComeFirstAndHaveTheirPictures) {
    const TemporaryFolder folder;
    const std::string path = folder / "state/recent.json";
    RecentFiles files(path);
    EXPECT_TRUE(files.files().empty());
    for (int i = 0; i < 10; ++i) files.add("/some/" + std::to_string(i) + ".pdb", std::to_string(i), makePicture(0));
    files.add("/some/5.pdb", "5", makePicture(1));
    files.add("pdb:1bna", "pdb:1bna", {});
    const RecentFiles again(path);
    ASSERT_EQ(again.files().size(), RecentFiles::kMost);
    EXPECT_EQ(again.files()[0].input, "pdb:1bna");
    EXPECT_EQ(again.files()[0].width, 0u);
    EXPECT_EQ(again.files()[1].input, "/some/5.pdb");
    EXPECT_EQ(again.files()[2].name, "9");
    ASSERT_EQ(again.files()[1].pixels.size(), std::size_t{RecentFiles::kPicture.width} * RecentFiles::kPicture.height);
    EXPECT_EQ(again.files()[1].pixels[4], 0xff0000ffu);
    EXPECT_EQ(again.files()[1].pixels[5], 0xffff00ffu);
}

TEST(RecentFiles, KeepTheBannerOfTheStartScreenAtItsSize) {
    const TemporaryFolder folder;
    const std::string path = folder / "samples.json";
    RecentFiles(path).add("sample:dna", "DNA", makePicture(1, RecentFiles::kBanner));
    const RecentFiles again(path);
    ASSERT_EQ(again.files().size(), 1u);
    EXPECT_EQ(again.files()[0].width, RecentFiles::kBanner.width);
    EXPECT_EQ(again.files()[0].height, RecentFiles::kBanner.height);
    EXPECT_EQ(again.files()[0].pixels[5], 0xffff00ffu);
    RecentFiles(path).add("sample:dna", "DNA", makePicture(1, {100, 100}));  // of another version
    EXPECT_EQ(RecentFiles(path).files()[0].width, 0u);
}

TEST(RecentFiles, WhatIsNoListIsNone) {
    const TemporaryFolder folder;
    for (const char* text :
         {"", "{}", "[1, {\"input\": 2}, {\"name\": \"x\"}]", "[{\"input\": \"a\", \"picture\": \"zz\"}", "\xff"}) {
        std::ofstream(folder / "recent.json") << text;
        EXPECT_TRUE(RecentFiles(folder / "recent.json").files().empty()) << text;
    }
    std::ofstream(folder / "recent.json") << R"([{"input": "a.pdb", "picture": "not one"}])";
    const RecentFiles files(folder / "recent.json");
    ASSERT_EQ(files.files().size(), 1u);
    EXPECT_EQ(files.files()[0].name, "a.pdb");
    EXPECT_EQ(files.files()[0].width, 0u);
}

TEST(WindowState, IsKeptAndNonsenseIsNot) {
    const TemporaryFolder folder;
    const Variable state("XDG_STATE_HOME", folder.path());
    EXPECT_EQ(loadWindowState(), WindowState());
    const WindowState left{900, 700, Panel::Brightness::dark, false, true, 150};
    saveWindowState(left);
    EXPECT_EQ(loadWindowState(), left);
    for (const char* text : {"", "[]", R"({"width": -3, "height": 1e9, "theme": 7, "panel": "no"})",
                             R"({"width": 1, "height": 700})", "\xff"}) {
        std::ofstream(folder / "nacre/window.json") << text;
        EXPECT_EQ(loadWindowState(), WindowState()) << text;
    }
}

TEST(Processes, TakeInputAndGiveOutputWithoutAShell) {
    EXPECT_EQ(runProgram({"cat"}, "three $HOME words"), "three $HOME words");
    EXPECT_EQ(runProgram({"printf", "%s", "$(id);"}), "$(id);");
    EXPECT_EQ(runProgram({"false"}), std::nullopt);
    EXPECT_EQ(runProgram({"nacre-has-no-such-program"}), std::nullopt);
    EXPECT_EQ(runProgram({"true"}, std::string(1 << 20, 'x')), "");  // which nobody reads
    EXPECT_TRUE(hasProgram("sh"));
    EXPECT_FALSE(hasProgram("nacre-has-no-such-program"));
}

TEST(Processes, APictureIsCopiedByWhateverIsThere) {
    const FakePrograms programs;
    std::ofstream(programs / "a.png") << "a picture";
    const auto takes = [&](const char* name, const std::string& more = "") {
        programs.addAsked(name, "cat > '" + programs / (name + std::string(".taken")) + "'" + more);
    };
    // As the real one, it leaves a process behind that holds what it was started with.
    takes("xclip", "; (sleep 20; : > '" + (programs / "late") + "') &");
    takes("wl-copy");
    {
        const Variable none("WAYLAND_DISPLAY", std::nullopt);
        EXPECT_TRUE(copyPng(programs / "a.png"));
        EXPECT_FALSE(std::filesystem::exists(programs / "late")) << "that process was waited for";
    }
    EXPECT_EQ(test::readContents(programs / "xclip.taken"), "a picture");
    EXPECT_EQ(test::readContents(programs / "xclip.asked"), "-selection\nclipboard\n-t\nimage/png\n-i\n");
    EXPECT_FALSE(std::filesystem::exists(programs / "wl-copy.taken"));
    const Variable wayland("WAYLAND_DISPLAY", "wayland-0");
    EXPECT_TRUE(copyPng(programs / "a.png"));
    EXPECT_EQ(test::readContents(programs / "wl-copy.taken"), "a picture");
    EXPECT_EQ(test::readContents(programs / "wl-copy.asked"), "--type\nimage/png\n");
    programs.add("wl-copy", "exit 1");
    programs.add("xclip", "exit 1");
    EXPECT_FALSE(copyPng(programs / "a.png"));
}

TEST(Processes, TheDesktopSaysWhetherItIsDark) {
    setenv("GTK_THEME", "Adwaita:dark", 1);
    EXPECT_TRUE(systemIsDark());
    setenv("GTK_THEME", "Adwaita", 1);
    EXPECT_FALSE(systemIsDark());
    unsetenv("GTK_THEME");
}

TEST(WindowSources, AskWithTheServersName) {
    unsetenv("NACRE_PDB_URL");
    PictureDescription view;
    view.input.path = "pdb:1xyz";
    view.input.namedBy = "sent.view.json";
    try {
        windowSources({}).read(view);
        FAIL() << "it was downloaded unasked";
    } catch (const Question& question) {
        EXPECT_STREQ(question.what(), "This view downloads pdb:1xyz from models.rcsb.org.");
        EXPECT_EQ(question.yes(), "Download");
    }
}

}  // namespace
}  // namespace nacre::app
