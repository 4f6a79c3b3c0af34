// Events that come faster than frames are drawn: none is lost, and each goes where those before it have led.

#include "app/panel/panel_input.h"
#include "tests/panel/panel_bench.h"

namespace nacre::app::test {
namespace {

/// A shell's way of handing events on, and what of them was the viewer's.
struct Shell {
    Bench& b;
    InputQueue queue;
    std::string letters = {};

    void add(InputQueue::Kind kind, std::function<void()> handle) {
        queue.add(b.panel.input(), kind, std::move(handle));
    }
    void click(const std::string& name) {
        const Control* c = b.find(name);
        ASSERT_TRUE(c) << name;
        const glm::dvec2 at((c->seenLeft + c->seenRight) / 2, (c->seenTop + c->seenBottom) / 2);
        add(InputQueue::Kind::pointer, [this, at] { b.panel.input().pointer(at); });
        for (const bool down : {true, false})
            add(InputQueue::Kind::pointer, [this, down] { b.panel.input().button(MouseButton::left, down); });
    }
    void press(SpecialKey key) {
        for (const bool down : {true, false})
            add(InputQueue::Kind::key, [this, key, down] {
                if (b.panel.input().ownsKeys() || !down) b.panel.input().key(key, down);
            });
    }
    void type(const std::string& text) {
        for (const char letter : text)
            add(InputQueue::Kind::key, [this, letter] {
                if (b.panel.input().ownsKeys())
                    b.panel.input().character(static_cast<unsigned char>(letter));
                else
                    letters += letter;
            });
    }
    /// Frames come only now.
    void drawFrames() {
        for (int i = 0; i < 100 && (b.panel.restless() || !queue.empty()); ++i) {
            b.frame();
            queue.frameDrawn(b.panel.input());
        }
        EXPECT_TRUE(queue.empty());
    }
};

TEST(InputQueue, PressesWithoutHoldBetweenTwoFramesAllCount) {
    Bench b("sample:dna", kUsual);
    b.panel.showPage("Labels");
    b.settle();
    Shell shell{b, {}};
    shell.click("Title");
    shell.type("abcdefgh");
    for (int i = 0; i < 6; ++i) shell.press(SpecialKey::backspace);
    shell.type("z");
    shell.drawFrames();
    EXPECT_EQ(b.viewer.view().words.title, "abz");
    EXPECT_EQ(shell.letters, "");
}

TEST(InputQueue, KeysGoWhereThoseBeforeThemHaveLed) {
    Bench b("sample:dna", kUsual);
    b.panel.showPage("Labels");
    b.settle();
    Shell shell{b, {}};
    shell.type("m");
    shell.click("Title");
    shell.type("ab");
    for (const SpecialKey key : {SpecialKey::left, SpecialKey::left, SpecialKey::right}) shell.press(key);
    shell.type("-");
    shell.press(SpecialKey::enter);
    shell.type("v");
    shell.click("Colour legend");
    shell.drawFrames();
    EXPECT_EQ(b.viewer.view().words.title, "a-b");
    EXPECT_EQ(shell.letters, "mv");
    EXPECT_TRUE(b.viewer.view().words.legend);
}

TEST(InputQueue, AKeyThatRepeatsCountsEachTime) {
    Bench b("sample:dna", kUsual);
    b.panel.showPage("Labels");
    b.settle();
    Shell shell{b, {}};
    shell.click("Title");
    shell.type("abcdefgh");
    for (int i = 0; i < 3; ++i)
        shell.add(InputQueue::Kind::key, [&] { b.panel.input().key(SpecialKey::backspace, true); });
    shell.add(InputQueue::Kind::key, [&] { b.panel.input().key(SpecialKey::backspace, false); });
    shell.drawFrames();
    EXPECT_EQ(b.viewer.view().words.title, "abcde");
}

}  // namespace
}  // namespace nacre::app::test
