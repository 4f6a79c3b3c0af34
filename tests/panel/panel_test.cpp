// The panel on a screen that draws nothing: what stands where, whether all of it can be read, and what it does.

#include "app/panel/panel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/panel/theme.h"
#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "tests/support/test_data.h"

namespace nacre::app {
namespace {

class NoScreen : public Screen {
public:
    void setScene(const Representation&) override {}
    double advanceOcclusion(const RenderSettings&, const OcclusionPace&) override { return 1; }
    FrameOutcome present(const RenderSettings&, const WindowFrame&) override { return FrameOutcome::shown; }
    PixelSize windowSize() const override { return {1, 1}; }
    std::uint32_t atomAt(const RenderSettings&, double, double, double) override { return 1; }
};

Sources sources() {
    return {[](const SavedView& v) {
                if (!v.input.starts_with("sample:"))
                    throw Error("cannot read molecule", v.input, "No such file or directory");
                return sampleMolecule(v.input.substr(7));
            },
            [](const Molecule& m, const SavedView& v) { return represent(m, drawnAtoms(m, v.drawn), v.look); }};
}

struct Bench {
    NoScreen screen;
    Viewer viewer;
    Panel panel;
    PixelSize size;
    double scale, now = 100;
    std::vector<RecentFile> recent;
    std::vector<ViewerCommand> asked;

    Bench(const std::string& input, PixelSize points, double pixelsPerPoint = 1, PanelHand hand = PanelHand::mouse)
        : viewer(screen, sources(), viewOf(input), staying()),
          panel(pixelsPerPoint, host(), hand),
          size{static_cast<std::uint32_t>(points.width * pixelsPerPoint),
               static_cast<std::uint32_t>(points.height * pixelsPerPoint)},
          scale(pixelsPerPoint) {
        EXPECT_GT(panel.glyphs().width, 0u);
        viewer.resize(size, pixelsPerPoint, now);
        recent.push_back(
            {"/home/user/a rather long name of a structure.pdb", "a rather long name of a structure.pdb", 0, 0, {}});
        recent.push_back({"1bna.pdb", "1bna.pdb", 0, 0, {}});
        settle();
    }
    static ViewerOptions staying() {
        ViewerOptions options;
        options.errorsStay = true;
        return options;
    }
    static SavedView viewOf(const std::string& input) {
        SavedView v;
        v.input = input;
        return v;
    }
    PanelHost host() {
        PanelHost h;
        h.run = [this](ViewerCommand c) {
            asked.push_back(c);
            viewer.run(c, now);
        };
        h.openDialog = [] {};
        h.recent = [this]() -> const std::vector<RecentFile>& { return recent; };
        h.freeName = [](const char* extension) { return std::string("picture") + extension; };
        h.savePicture = [](const PictureWish&) {};
        h.copyPicture = [] {};
        h.statistics = [] { return std::string("a device\ntiles, 3 frames"); };
        h.lastView = "1bna.pdb";
        h.goOn = [] {};
        h.downloads = h.captures = true;
        return h;
    }
    void frame() {
        now += 1.0 / 60;
        viewer.update(now);
        panel.draw(viewer, size, now);
    }
    void settle() {
        for (int i = 0; i < 6; ++i) {
            viewer.waitForLoading();
            frame();
        }
    }
    const Control* find(const std::string& name, const std::string& role = "") {
        for (const Control& c : panel.controls())
            if (c.name == name && c.seen() && (role.empty() ? c.role != "text" : c.role == role)) return &c;
        return nullptr;
    }
    void clickAt(double x, double y) {
        panel.pointer({x, y});
        frame();
        panel.button(MouseButton::left, true);
        frame();
        panel.button(MouseButton::left, false);
        settle();
    }
    void click(const std::string& name) {
        const Control* c = find(name);
        ASSERT_TRUE(c) << name;
        clickAt((c->seenLeft + c->seenRight) / 2, (c->seenTop + c->seenBottom) / 2);
    }
    void press(SpecialKey key, Modifiers with = {}) {
        panel.key(key, true, with);
        frame();
        panel.key(key, false, with);
        frame();
    }
};

bool overlap(const Control& a, const Control& b) {
    const float x = std::min(a.right, b.right) - std::max(a.left, b.left),
                y = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    return x > 1.5f && y > 1.5f;
}

/// All words stand whole, side by side, and within what shows them. @returns controls that were looked at
std::size_t expectReadable(const Bench& b, const std::string& state) {
    const std::vector<Control>& all = b.panel.controls();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Control& c = all[i];
        const std::string what = state + ": " + c.role + " \"" + c.name + "\"";
        EXPECT_FALSE(c.cut) << what << " is cut short";
        EXPECT_NE(c.name, "") << what;
        if (c.seenBottom > c.seenTop) {
            EXPECT_GE(c.seenLeft, c.left - 0.5f) << what;
            EXPECT_LE(std::abs(c.seenRight - c.right) + std::abs(c.seenLeft - c.left), 1.5f) << what << " is clipped";
        }
        EXPECT_GE(c.left, 0) << what;
        EXPECT_LE(c.right, static_cast<float>(b.size.width) + 0.5f) << what;
        if (c.lines > 1.5f) {
            EXPECT_GE(static_cast<float>(c.name.size()) / c.lines, 8.0f) << what << " wraps after a few letters";
        }
        for (std::size_t k = i + 1; k < all.size(); ++k)
            EXPECT_FALSE(all[k].window == c.window && overlap(c, all[k])) << what << " and \"" << all[k].name << "\"";
    }
    return all.size();
}

constexpr PixelSize kUsual{1000, 720}, kNarrow{420, 760}, kTall{620, 1000}, kWide{1300, 420}, kSmall{360, 480};
constexpr Panel::Page kPages[] = {Panel::Page::look, Panel::Page::parts, Panel::Page::select, Panel::Page::labels,
                                  Panel::Page::more};

struct Place {
    PixelSize points;
    double scale;
    PanelHand hand;
};
constexpr Place kPlaces[] = {
    {kUsual, 1, PanelHand::mouse},    {kNarrow, 1, PanelHand::mouse},   {kTall, 1, PanelHand::mouse},
    {kWide, 1, PanelHand::mouse},     {kUsual, 2, PanelHand::mouse},    {kNarrow, 2, PanelHand::mouse},
    {kNarrow, 2, PanelHand::fingers}, {kWide, 1.5, PanelHand::fingers}, {kSmall, 1, PanelHand::fingers}};

std::string nameOf(const Place& p) {
    return std::to_string(p.points.width) + "x" + std::to_string(p.points.height) + " at " + std::to_string(p.scale) +
           (p.hand == PanelHand::fingers ? " for fingers" : "");
}

TEST(Panel, EveryPageIsReadableEverywhere) {
    for (const Place& place : kPlaces) {
        Bench b("sample:dna", place.points, place.scale, place.hand);
        if (!b.panel.panelOpen()) b.panel.togglePanel();
        for (const Panel::Page page : kPages) {
            b.panel.showPage(page);
            b.settle();
            EXPECT_GT(expectReadable(b, nameOf(place) + ", page " + std::to_string(static_cast<int>(page))), 12u);
        }
    }
}

TEST(Panel, EveryCardIsReadableEverywhere) {
    for (const Place& place : kPlaces) {
        const std::string where = nameOf(place);
        Bench b("sample:dna", place.points, place.scale, place.hand);
        b.panel.toggleHelp();
        b.settle();
        EXPECT_GT(expectReadable(b, where + ", help"), 10u);
        b.panel.toggleHelp();
        b.panel.showSave();
        b.settle();
        EXPECT_TRUE(b.find("Transparent background"));
        expectReadable(b, where + ", save");
        b.panel.closeTop();
        b.panel.showStart();
        b.settle();
        EXPECT_TRUE(b.find("Open a file ..."));
        expectReadable(b, where + ", start");
        b.panel.closeTop();
        b.viewer.open("nothing.pdb", b.now);
        b.settle();
        EXPECT_TRUE(b.find("Open another")) << where;
        expectReadable(b, where + ", error");
        Bench empty("", place.points, place.scale, place.hand);
        EXPECT_TRUE(empty.find("DNA")) << where;
        expectReadable(empty, where + ", empty");
    }
}

TEST(Panel, KeepsItsSizeAndLeavesTheMoleculeTheRest) {
    for (const Place& place : kPlaces) {
        Bench b("sample:dna", place.points, place.scale, place.hand);
        if (!b.panel.panelOpen()) b.panel.togglePanel();
        std::optional<glm::dvec2> pan;
        for (const Panel::Page page : kPages) {
            b.panel.showPage(page);
            b.settle();
            const View view = b.viewer.settings().view;
            if (!pan) pan = view.pan;
            EXPECT_EQ(view.pan, *pan) << nameOf(place);
            // The sphere about the molecule lies in the window, beside the panel.
            const double middle = view.width / 2.0 + view.pan.x * view.pixelsPerAngstrom,
                         r = view.radius * view.pixelsPerAngstrom;
            const double centre = view.height / 2.0 - view.pan.y * view.pixelsPerAngstrom;
            const glm::dvec2 low(middle - r, centre - r), high(middle + r, centre + r);
            EXPECT_GE(low.x, 0);
            EXPECT_LE(high.x, view.width);
            EXPECT_GE(low.y, 0);
            EXPECT_LE(high.y, view.height);
            for (const Control& c : b.panel.controls())
                EXPECT_FALSE(c.window == "Nacre" && c.seen() && c.seenLeft < high.x - 1 && c.seenRight > low.x + 1 &&
                             c.seenTop < high.y - 1 && c.seenBottom > low.y + 1)
                    << nameOf(place) << " " << c.name;
        }
        b.panel.togglePanel();
        b.settle();
        EXPECT_EQ(b.viewer.settings().view.pan, glm::dvec2(0));
    }
}

TEST(Panel, AListClosesOnEscapeAndOnAClickBeside) {
    for (const bool escape : {true, false}) {
        Bench b("sample:dna", kUsual);
        b.click("Colours");
        ASSERT_TRUE(b.find("Rainbow, start to end"));
        EXPECT_TRUE(b.panel.ownsKeys());
        if (escape)
            b.press(SpecialKey::escape);
        else
            b.clickAt(800, 300);
        b.settle();
        EXPECT_FALSE(b.find("Rainbow, start to end"));
        EXPECT_FALSE(b.panel.ownsKeys());
        EXPECT_EQ(b.viewer.view().look.color, Coloring(ColorScheme::element));
    }
}

TEST(Panel, AnErrorStaysUntilItIsRead) {
    Bench b("", kUsual);
    b.viewer.open("nothing.pdb", b.now);
    b.settle();
    b.now += 60;
    b.settle();
    ASSERT_TRUE(b.find("Close"));
    bool advised = false;
    for (const Control& c : b.panel.controls()) advised |= c.name.find("Check the name") != std::string::npos;
    EXPECT_TRUE(advised);
    b.click("Close");
    EXPECT_EQ(b.viewer.failure(), "");
    EXPECT_TRUE(b.find("DNA"));
}

TEST(Panel, KeysReachEveryControlAndPressIt) {
    Bench b("sample:dna", kUsual);
    b.panel.showPage(Panel::Page::parts);
    b.settle();
    std::vector<std::string> missed;
    for (const Control& c : b.panel.controls())
        if (c.role != "text" && c.enabled) missed.push_back(c.name);
    ASSERT_GT(missed.size(), 15u);
    for (int i = 0; i < 400 && !missed.empty(); ++i) {
        // Down the rows, round from the last to the first, and along each of them.
        b.press(i % 8 == 0 ? SpecialKey::tab : SpecialKey::right);
        if (i % 8 == 7)
            for (int k = 0; k < 7; ++k) b.press(SpecialKey::left);
        for (const Control& c : b.panel.controls())
            if (c.focused) std::erase(missed, c.name);
    }
    for (int i = 0; i < 40 && !missed.empty(); ++i) {  // and back
        b.press(SpecialKey::tab, {true, false});
        for (const Control& c : b.panel.controls())
            if (c.focused) std::erase(missed, c.name);
    }
    EXPECT_EQ(missed, std::vector<std::string>());
    EXPECT_TRUE(b.panel.ownsKeys());
    b.press(SpecialKey::escape);
    EXPECT_FALSE(b.panel.ownsKeys());
}

TEST(Panel, RowsOfPartsHideAndColour) {
    Bench b("sample:dna", kUsual);
    b.panel.showPage(Panel::Page::parts);
    b.settle();
    const std::size_t all = b.viewer.document()->scene.drawnAtoms;
    b.click("Hide Chain A");
    EXPECT_LT(b.viewer.document()->scene.drawnAtoms, all);
    b.click("Show Chain A");
    EXPECT_EQ(b.viewer.document()->scene.drawnAtoms, all);
    EXPECT_TRUE(b.viewer.view().look.rules.empty());
    b.click("Undo");
    EXPECT_LT(b.viewer.document()->scene.drawnAtoms, all);
    b.click("Colour of Chain B");
    b.click("Vermilion");
    ASSERT_EQ(b.viewer.view().look.rules.size(), 2u);
    EXPECT_EQ(b.viewer.view().look.rules.back().coloring, Coloring::uniform(IM_COL32(0xd5, 0x5e, 0, 255)));
}

TEST(Panel, ADragAcrossTheSequenceSelectsResidues) {
    Bench b("sample:dna", kUsual);
    b.panel.showPage(Panel::Page::parts);
    b.settle();
    b.click("Chain A");
    const Control* sequence = b.find("Sequence of Chain A");
    ASSERT_TRUE(sequence);
    const double y = sequence->top + 10, x = sequence->left + 40;
    b.panel.pointer({x + 13 * 2.5, y});
    b.frame();
    b.panel.button(MouseButton::left, true);
    b.frame();
    b.panel.pointer({x + 13 * 4.5, y});
    b.frame();
    b.panel.button(MouseButton::left, false);
    b.settle();
    EXPECT_EQ(b.viewer.selection().text, "chain A and resi 3-5");
    EXPECT_GT(b.viewer.selection().count, 50u);
    EXPECT_EQ(b.viewer.annotations().selected.size(), b.viewer.selection().count);
}

double luminance(const ImVec4& c) {
    const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(c.x) + 0.7152 * linear(c.y) + 0.0722 * linear(c.z);
}

double contrast(const ImVec4& a, const ImVec4& b) {
    const double x = luminance(a), y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

TEST(Panel, TextStandsOutFromWhatItStandsOn) {
    for (const Theme* theme : {&darkTheme(), &lightTheme()}) {
        for (const ImVec4* ground : {&theme->ground, &theme->raised, &theme->field, &theme->hovered}) {
            EXPECT_GE(contrast(theme->text, *ground), 7) << theme->dark;
            EXPECT_GE(contrast(theme->faint, *ground), 4.5) << theme->dark << " " << (ground - &theme->ground);
        }
        EXPECT_GE(contrast(theme->warning, theme->ground), 4.5);
        EXPECT_GE(contrast(theme->onAccent, theme->accent), 4.5);
        EXPECT_GE(contrast(theme->mark, theme->ground), 3);
        EXPECT_GE(contrast(theme->mark, theme->field), 3);
    }
}

}  // namespace
}  // namespace nacre::app
