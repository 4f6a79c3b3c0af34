// Cards that lie over the picture: help, quitting, the panel's own dialog for files.

#include <fstream>

#include "tests/panel/panel_bench.h"
#include "tests/support/temporary_folder.h"

namespace nacre::app::test {
namespace {

using nacre::test::TemporaryFolder;

/// Whether something is told of by these words, seen or scrolled away.
bool told(const Bench& b, const std::string& words) {
    const auto& all = b.panel.controls();
    return std::any_of(all.begin(), all.end(),
                       [&](const Control& c) { return c.name.find(words) != std::string::npos; });
}

void typeInto(Bench& b, const std::string& field, const std::string& text) {
    b.click(field);
    for (const char c : text) b.panel.input().character(static_cast<unsigned char>(c));
    b.settle();
}

TEST(Start, HasTheFirstSampleAsABanner) {
    std::vector<RecentFile> samples;
    for (const auto& [name, input] : kSampleNames) samples.push_back({input, name, 130, 88, {}});
    samples[0].width = 592, samples[0].height = 208;  // more pixels than 16 bits count
    for (RecentFile& sample : samples) sample.pixels.resize(std::size_t{sample.width} * sample.height, 0xff00ff00u);
    Bench b("", kUsual, 1, PanelHand::mouse, sampleSources(),
            [&](PanelHost& host) { host.samples = [&]() -> const std::vector<RecentFile>& { return samples; }; });
    const Control* banner = b.find("Open DNA");
    ASSERT_TRUE(banner);
    EXPECT_GT(banner->right - banner->left, 550);
    EXPECT_NEAR((banner->right - banner->left) / (banner->bottom - banner->top), 592.0 / 208, 0.05);
    EXPECT_TRUE(b.find("Glucose"));
    b.click("Open DNA");
    ASSERT_TRUE(b.viewer.document());
    EXPECT_EQ(b.viewer.document()->view.input.path, "sample:dna");
}

TEST(Help, TellsOfEveryKey) {
    Bench b("sample:dna", kUsual);
    b.panel.toggleHelp();
    b.settle();
    for (const Binding& binding : keyBindings()) EXPECT_TRUE(told(b, binding.what)) << binding.keys;
    for (const char* keys : {"4", "5", "Ctrl Q", "F12"}) EXPECT_TRUE(told(b, keys)) << keys;
    EXPECT_TRUE(told(b, b.viewer.explanation())) << "what is seen";
}

TEST(Help, IsSearchedAndItsHeaderStays) {
    Bench b("sample:dna", kUsual);
    b.panel.toggleHelp();
    b.settle();
    ASSERT_TRUE(b.find("Help", "text"));
    const float title = b.find("Help", "text")->top;
    b.panel.input().pointer({500, 500});
    b.panel.input().wheel(-30);
    b.settle();
    EXPECT_FALSE(b.find("Rotate left", "text")) << "scrolled away";
    ASSERT_TRUE(b.find("Help", "text"));
    EXPECT_EQ(b.find("Help", "text")->top, title);
    EXPECT_TRUE(b.find("Close"));
    typeInto(b, "Search the help", "HYDRO");
    EXPECT_TRUE(b.find("Show or hide hydrogens", "text"));
    EXPECT_FALSE(told(b, "Rotate left"));
    EXPECT_FALSE(told(b, "Mouse and trackpad"));
}

TEST(Quitting, AsksWhatIsToBecomeOfUnsavedWork) {
    for (const char* answer : {"Save view and quit", "Quit", "Cancel"}) {
        int quits = 0, saved = 0;
        Bench b("sample:dna", kUsual, 1, PanelHand::mouse, sampleSources(), [&](PanelHost& host) {
            host.quit = [&] { ++quits; };
            host.saveAndQuit = [&] { ++saved; };
        });
        EXPECT_FALSE(b.viewer.hasUnsavedWork());
        PictureDescription look = b.viewer.view();
        look.words.title = "mine";
        b.viewer.setLook(look, b.now);
        EXPECT_TRUE(b.viewer.hasUnsavedWork());
        b.panel.askToQuit("Labels are not in a saved view.");
        b.settle();
        EXPECT_TRUE(b.panel.asksToQuit());
        EXPECT_TRUE(told(b, "Labels are not in a saved view."));
        b.click(answer);
        EXPECT_EQ(quits, answer == std::string("Quit") ? 1 : 0) << answer;
        EXPECT_EQ(saved, answer == std::string("Save view and quit") ? 1 : 0) << answer;
        EXPECT_FALSE(b.panel.asksToQuit());
        b.viewer.undo(b.now);
        EXPECT_FALSE(b.viewer.hasUnsavedWork()) << "what was undone is no work";
    }
}

struct Folders {
    TemporaryFolder folder;
    std::string opened;
    Folders() {
        std::filesystem::create_directories(folder / "deep");
        for (const char* name : {"a.txt", "b.pdb", "c.cif.gz", ".hidden.pdb", "deep/d.sdf"})
            std::ofstream(folder / name) << "x";
    }
    std::function<void(PanelHost&)> lend() {
        return [this](PanelHost& host) {
            host.browses = true;
            host.openDialog = nullptr;
            host.saveDialog = nullptr;
            host.open = [this](const std::vector<std::string>& paths, bool) { opened = paths.front(); };
        };
    }
};

TEST(Browsing, OpensAFileOfAnyFolder) {
    Folders files;
    Bench b("sample:dna", kUsual, 1, PanelHand::mouse, sampleSources(), files.lend());
    b.recent = {{files.folder / "b.pdb", "b.pdb", 0, 0, {}}};
    b.panel.showStart();
    b.settle();
    b.click("Open a file ...");
    b.click(std::filesystem::path(files.folder.path()).filename().string());  // the folder of a recent file
    for (const char* name : {"deep/", "b.pdb", "c.cif.gz"}) EXPECT_TRUE(b.find(name)) << name;
    for (const char* name : {"a.txt", ".hidden.pdb"}) EXPECT_FALSE(b.find(name)) << name;
    b.click("deep/");
    EXPECT_TRUE(b.find("d.sdf"));
    EXPECT_FALSE(b.find("b.pdb"));
    b.click("Parent folder");
    typeInto(b, "Name or folder", "C.CI");
    EXPECT_FALSE(b.find("b.pdb"));
    b.press(SpecialKey::enter);
    b.settle();
    EXPECT_EQ(files.opened, files.folder / "c.cif.gz");
    EXPECT_FALSE(b.find("c.cif.gz"));
}

TEST(Browsing, ChoosesWhereAnImageIsSaved) {
    Folders files;
    Bench b("sample:dna", kUsual, 1, PanelHand::mouse, sampleSources(), files.lend());
    b.panel.setSavePath(files.folder / "a.png");
    b.panel.showSave();
    b.settle();
    b.click("Choose ...");
    EXPECT_TRUE(b.find("deep/"));
    EXPECT_FALSE(b.find("b.pdb"));
    b.click("deep/");
    b.click("Choose");
    ASSERT_TRUE(b.find("Path"));
    EXPECT_EQ(b.find("Path")->value, files.folder / "deep/a.png");
}

TEST(Browsing, SaysWhatCannotBeRead) {
    Folders files;
    Bench b("sample:dna", kUsual, 1, PanelHand::mouse, sampleSources(), files.lend());
    b.panel.setSavePath("/no/such/folder/a.png");
    b.panel.showSave();
    b.settle();
    b.click("Choose ...");
    EXPECT_TRUE(told(b, "Cannot read /no/such/folder: No such file or directory"));
}

TEST(Panel, SaysWhatAutomaticChoseAndWhatIsSeen) {
    Bench b("sample:glucose", kUsual);
    EXPECT_TRUE(told(b, "Automatic: Ball and stick"));
    b.click("Spacefill");
    EXPECT_FALSE(told(b, "Automatic chose"));
    EXPECT_EQ(b.viewer.explanation().substr(0, 52), "Each atom is a sphere of its van der Waals radius. E");
    b.panel.showPage("Parts");
    b.settle();
    EXPECT_TRUE(told(b, b.viewer.explanation()));
}

TEST(Fonts, WhatIsMissingIsNamedByTheFontToInstall) {
    Bench b("sample:dna", kUsual, 1, PanelHand::mouse, sampleSources(),
            [](PanelHost& host) { host.fontWith = [](const auto&) { return std::optional<FontFile>(); }; });
    EXPECT_FALSE(told(b, "install"));
    PictureDescription look = b.viewer.view();
    look.words.title = "\u4e2d\u6587";
    b.viewer.setLook(look, b.now);
    b.settle();
    EXPECT_TRUE(told(b, "Characters are missing: install Noto Sans CJK."));
}

}  // namespace
}  // namespace nacre::app::test
