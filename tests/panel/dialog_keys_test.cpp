// Keys while a dialog is open: they are its own, whatever they do to the picture otherwise.

#include <functional>

#include "app/picture/saved_view.h"
#include "tests/panel/panel_bench.h"

namespace nacre::app::test {
namespace {

/// As a shell does.
void pass(Bench& b, const std::optional<ViewerCommand>& command) {
    if (command) b.viewer.run(*command, b.now);
    b.frame();
}

struct Dialog {
    const char* name;
    std::function<void(Bench&)> open;
    const char* field;  ///< that has the focus; empty: a button has it
};

const Dialog kDialogs[] = {
    {"Start", [](Bench& b) { b.panel.showStart(); }, "ID or path"},
    {"Save", [](Bench& b) { b.panel.showSave(); }, "Path"},
    {"Record", [](Bench& b) { b.panel.showRecord(); }, "Movie path"},
    {"Help", [](Bench& b) { b.panel.toggleHelp(); }, "Search the help"},
    {"Browse", [](Bench& b) { b.panel.askWhere("Save view", "a.view.json", [](const std::string&) {}); }, "File name"},
    {"Quit", [](Bench& b) { b.panel.askToQuit("Labels are not saved."); }, ""},
    {"Dropped", [](Bench& b) { b.panel.askToOpen({"sample:glucose"}); }, ""},
};

void lendDialogs(PanelHost& host) {
    host.browses = true;
    host.saveDialog = nullptr;
    host.record = [](const RecordingWish&, const std::vector<PictureDescription>&) {};
    host.recording = [] { return RecordingState(); };
}

TEST(DialogKeys, AreNeverThePictures) {
    for (const Dialog& dialog : kDialogs) {
        Bench b("sample:dna", kUsual, 1, PanelHand::mouse, sampleSources(), lendDialogs);
        dialog.open(b);
        b.settle();
        const std::string before = savedViewJson(b.viewer.view());
        std::string typed;
        for (char c = '!'; c <= '~'; ++c) {
            const auto command = b.panel.input().type(static_cast<char32_t>(c));
            EXPECT_FALSE(command) << dialog.name << " lets " << c << " through";
            typed += c;
            pass(b, command);
        }
        for (const char c : std::string("abcdefghijklmnoprstuvwxyz")) {
            if (c == 'x' || c == 'z') continue;  // a field cuts, and takes back
            const auto command = b.panel.input().press(KeyEvent{static_cast<char32_t>(c), {false, true}});
            EXPECT_FALSE(command) << dialog.name << " lets Ctrl " << c << " through";
            pass(b, command);
        }
        for (const SpecialKey key : {SpecialKey::left, SpecialKey::home, SpecialKey::up, SpecialKey::f12})
            for (const bool down : {true, false}) {
                const auto command = b.panel.input().press(key, down);
                EXPECT_FALSE(command) << dialog.name;
                pass(b, command);
            }
        EXPECT_EQ(savedViewJson(b.viewer.view()), before) << dialog.name;
        EXPECT_TRUE(b.panel.panelOpen()) << dialog.name;
        EXPECT_TRUE(b.asked.empty()) << dialog.name;
        if (!*dialog.field) continue;
        const Control* field = nullptr;
        for (const Control& c : b.panel.controls())
            if (c.name == dialog.field) field = &c;
        ASSERT_TRUE(field) << dialog.name;
        EXPECT_EQ(field->value, typed) << dialog.name;
    }
}

TEST(DialogKeys, AFieldThatWaitsCostsNothing) {
    for (const Dialog& dialog : kDialogs) {
        Bench b("sample:dna", kUsual, 1, PanelHand::mouse, sampleSources(), lendDialogs);
        dialog.open(b);
        for (int i = 0; i < 30; ++i) b.frame();
        EXPECT_FALSE(b.panel.restless()) << dialog.name;
    }
}

TEST(DialogKeys, TheStartScreenHasThemToo) {
    Bench b("", kUsual);
    for (const char c : std::string("msh1")) pass(b, b.panel.input().type(static_cast<char32_t>(c)));
    b.settle();
    EXPECT_TRUE(b.panel.panelOpen());
    ASSERT_TRUE(b.find("ID or path"));
    EXPECT_EQ(b.find("ID or path")->value, "msh1");
}

TEST(DialogKeys, EscapeLeavesAndCtrlQQuits) {
    for (const Dialog& dialog : kDialogs) {
        Bench b("sample:dna", kUsual, 1, PanelHand::mouse, sampleSources(), lendDialogs);
        dialog.open(b);
        b.settle();
        EXPECT_EQ(b.panel.input().press(KeyEvent{U'q', {false, true}}), ViewerCommand::quit);
        EXPECT_EQ(b.panel.input().press(SpecialKey::escape, true), ViewerCommand::clearPicks) << dialog.name;
        EXPECT_TRUE(b.panel.closeTop()) << dialog.name;
        b.settle();
        EXPECT_EQ(b.panel.input().type(U'h'), ViewerCommand::hydrogens) << dialog.name;
    }
}

TEST(DialogKeys, ReturnTakesTheButtonThatLosesNothing) {
    int quits = 0;
    bool running = true;
    Bench b("sample:dna", kUsual, 1, PanelHand::mouse, sampleSources(), [&](PanelHost& host) {
        host.quit = [&] { ++quits; };
        host.saveAndQuit = [] {};
        host.recording = [&] {
            RecordingState state;
            state.running = running;
            return state;
        };
    });
    b.panel.askToQuit("The movie is still being recorded.");
    b.settle();
    EXPECT_TRUE(b.find("Keep finished frames and quit"));
    b.press(SpecialKey::enter);
    b.settle();
    EXPECT_EQ(quits, 0) << "it goes on recording";
    EXPECT_FALSE(b.panel.asksToQuit());
    b.panel.askToQuit("The movie is still being recorded.");
    b.settle();
    b.click("Keep finished frames and quit");
    EXPECT_EQ(quits, 1);
}

TEST(DialogKeys, DroppedFilesReplaceOrJoin) {
    for (const char* answer : {"Replace", "Add", "Cancel"}) {
        Bench b("sample:dna", kUsual);
        b.panel.askToOpen({"sample:glucose"});
        b.settle();
        b.click(answer);
        b.settle();
        const InputOptions& input = b.viewer.document()->view.input;
        EXPECT_EQ(input.path, answer == std::string("Replace") ? "sample:glucose" : "sample:dna");
        EXPECT_EQ(input.further.size(), answer == std::string("Add") ? 1u : 0u);
    }
}

}  // namespace
}  // namespace nacre::app::test
