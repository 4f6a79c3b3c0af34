// What is told of the panel to those who do not see it.

#include "app/panel/controls.h"

#include <set>
#include <sstream>

#include "tests/panel/panel_bench.h"

namespace nacre::app::test {
namespace {

/// A name each, a value where there is one to tell, and none twice where both can be pressed.
void expectTold(const Bench& b, const std::string& state) {
    std::set<std::string> pressed;
    for (const Control& c : b.panel.controls()) {
        const std::string what = state + ": " + c.role + " \"" + c.name + "\"";
        EXPECT_FALSE(c.role.empty()) << what;
        EXPECT_FALSE(c.name.empty()) << what;
        EXPECT_FALSE(c.window.empty()) << what;
        const bool valued = c.role == "switch" || c.role == "choice" || c.role == "colour" || c.role == "list" ||
                            c.role == "heading" || c.role == "slider";
        EXPECT_TRUE(!valued || !c.value.empty()) << what;
        if (c.role == "text" || c.role == "status" || c.role == "choice") continue;
        EXPECT_TRUE(pressed.insert(c.window + "/" + c.role + "/" + c.name).second) << what << " is there twice";
    }
    EXPECT_GT(pressed.size(), 3u) << state;
}

TEST(Controls, EveryOneHasARoleANameAndAValue) {
    for (const PanelHand hand : {PanelHand::mouse, PanelHand::fingers}) {
        Bench b("sample:dna", kUsual, 1, hand);
        if (!b.panel.panelOpen()) b.panel.togglePanel();
        PictureDescription look = b.viewer.view();
        look.look.rules = {Rule{Rule::Action::hide, parseSelection("resi 1"), {}, {}},
                           Rule{Rule::Action::hide, parseSelection("resi 2"), {}, {}}};
        b.viewer.setLook(look, b.now);
        for (const std::string_view page : kPages) {
            b.panel.showPage(page);
            b.settle();
            expectTold(b, "page " + std::string(page));
        }
        b.panel.showSave();
        b.settle();
        expectTold(b, "save");
        b.panel.closeTop();
        b.panel.showStart();
        b.settle();
        expectTold(b, "start");
    }
}

TEST(Controls, ATableOfThemIsText) {
    Bench b("sample:dna", kUsual);
    const std::vector<Control>& all = b.panel.controls();
    const auto seen = std::count_if(all.begin(), all.end(), [](const Control& c) { return c.seen(); });
    std::istringstream lines(controlLines(all));
    std::string line, spin;
    std::ptrdiff_t count = 0;
    for (; std::getline(lines, line); ++count) {
        EXPECT_EQ(std::count(line.begin(), line.end(), '\t'), 7) << line;
        if (line.find("\tSpin\t") != std::string::npos) spin = line;
    }
    EXPECT_EQ(count, seen);
    EXPECT_TRUE(spin.starts_with("button\tSpin\t\t1\t")) << spin;
    Control odd;
    odd.role = "field";
    odd.name = "two\nlines\tof it";
    EXPECT_EQ(controlLines({odd}), "");  // nothing of it is seen
    odd.seenRight = 20.4f, odd.seenBottom = 9.6f;
    EXPECT_EQ(controlLines({odd}), "field\ttwo lines of it\t\t1\t0\t0\t20\t10\n");
}

}  // namespace
}  // namespace nacre::app::test
