// What stands where in the panel, and whether all of it can be read.

#include <cmath>

#include "app/panel/theme.h"
#include "tests/panel/panel_bench.h"

namespace nacre::app::test {
namespace {

bool overlap(const Control& a, const Control& b) {
    const float x = std::min(a.right, b.right) - std::max(a.left, b.left),
                y = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    return x > 1.5f && y > 1.5f;
}

}  // namespace

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

namespace {

struct Place {
    PixelSize points;
    double scale;
    PanelHand hand;
};
constexpr Place kPlaces[] = {{kUsual, 1, PanelHand::mouse},    {kNarrow, 1, PanelHand::mouse},
                             {kTall, 1, PanelHand::mouse},     {kWide, 1, PanelHand::mouse},
                             {kUsual, 2, PanelHand::mouse},    {kNarrow, 2, PanelHand::mouse},
                             {kNarrow, 2, PanelHand::fingers}, {kWide, 1.5, PanelHand::fingers},
                             {kSmall, 1, PanelHand::fingers},  {{210, 380}, 2, PanelHand::mouse}};

std::string describePlace(const Place& p) {
    return std::to_string(p.points.width) + "x" + std::to_string(p.points.height) + " at " + std::to_string(p.scale) +
           (p.hand == PanelHand::fingers ? " for fingers" : "");
}

TEST(Panel, EveryPageIsReadableEverywhere) {
    for (const Place& place : kPlaces) {
        Bench b("sample:dna", place.points, place.scale, place.hand);
        if (!b.panel.panelOpen()) b.panel.togglePanel();
        for (const std::string_view page : kPages) {
            b.panel.showPage(page);
            b.settle();
            EXPECT_GT(expectReadable(b, describePlace(place) + ", page " + std::string(page)), 12u);
        }
    }
}

TEST(Panel, EveryCardIsReadableEverywhere) {
    for (const Place& place : kPlaces) {
        const std::string where = describePlace(place);
        Bench b("sample:dna", place.points, place.scale, place.hand, sampleSources(), [](PanelHost& host) {
            host.record = [](const RecordingWish&, const std::vector<PictureDescription>&) {};
            host.browses = true;
        });
        b.panel.toggleHelp();
        b.settle();
        EXPECT_GT(expectReadable(b, where + ", help"), 10u);
        b.panel.toggleHelp();
        b.panel.showSave();
        b.settle();
        EXPECT_TRUE(b.find("Transparent background"));
        expectReadable(b, where + ", save");
        b.panel.closeTop();
        b.panel.keepView(b.viewer);
        b.panel.keepView(b.viewer);
        b.panel.showRecord();
        b.settle();
        EXPECT_TRUE(b.find("Record movie", "text"));
        expectReadable(b, where + ", film");
        b.click("Motion");
        b.click("Keyframes");
        b.settle();
        expectReadable(b, where + ", film of views");
        b.panel.closeTop();
        b.panel.showStart();
        b.settle();
        EXPECT_TRUE(b.find("Open a file ..."));
        expectReadable(b, where + ", start");
        b.click("Open a file ...");
        EXPECT_TRUE(b.find("Current folder"));
        b.panel.closeTop();
        b.panel.closeTop();
        PictureDescription look = b.viewer.view();
        look.words.title = "mine";
        b.viewer.setLook(look, b.now);
        b.panel.askToQuit("The movie is still being recorded. 2 keyframes were not recorded.");
        b.settle();
        EXPECT_TRUE(b.find("Save view and quit"));
        expectReadable(b, where + ", quit");
        b.panel.closeTop();
        b.viewer.reading().open("nothing.pdb", b.now);
        b.settle();
        EXPECT_TRUE(b.find("Open another")) << where;
        expectReadable(b, where + ", error");
        Bench empty("", place.points, place.scale, place.hand);
        const std::vector<Control>& all = empty.panel.controls();  // low ones scroll
        EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const Control& c) { return c.name == "DNA"; })) << where;
        expectReadable(empty, where + ", empty");
    }
}

TEST(Panel, KeepsItsSizeAndLeavesTheMoleculeTheRest) {
    for (const Place& place : kPlaces) {
        Bench b("sample:dna", place.points, place.scale, place.hand);
        if (!b.panel.panelOpen()) b.panel.togglePanel();
        std::optional<glm::dvec2> pan;
        for (const std::string_view page : kPages) {
            b.panel.showPage(page);
            b.settle();
            const View view = b.viewer.frames().settings().view;
            if (!pan) pan = view.pan;
            EXPECT_EQ(view.pan, *pan) << describePlace(place);
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
                    << describePlace(place) << " " << c.name;
        }
        b.panel.togglePanel();
        b.settle();
        EXPECT_EQ(b.viewer.frames().settings().view.pan, glm::dvec2(0));
    }
}

TEST(Panel, TheMoleculeStandsBesideTheLegend) {
    const auto right = [](const Bench& b) {  // of the sphere about it, pixels
        const View view = b.viewer.frames().settings().view;
        return view.width / 2.0 + (view.pan.x + view.radius) * view.pixelsPerAngstrom;
    };
    const auto showLegend = [](Bench& b, bool shown) {
        PictureDescription look = b.viewer.view();
        look.words.legend = shown;
        b.viewer.setLook(look, b.now);
        b.settle();
    };
    for (const double scale : {1.0, 2.0}) {
        Bench b("sample:dna", kNarrow, scale);
        const double alone = right(b);
        showLegend(b, true);
        ASSERT_FALSE(b.viewer.words().placed().legends.empty());
        // A swatch, a letter and the margin are no less than two ems.
        EXPECT_LT(right(b), b.size.width - 2 * b.viewer.words().size());
        const View fitted = b.viewer.frames().settings().view;
        EXPECT_GT(fitted.width / 2.0 + (fitted.pan.x - fitted.radius) * fitted.pixelsPerAngstrom, 0);
        b.settle();
        EXPECT_EQ(b.viewer.frames().settings().view.pan, fitted.pan) << "it comes to rest there";
        showLegend(b, false);
        EXPECT_EQ(right(b), alone);
    }
    Bench wide("sample:dna", kWide);
    const double alone = right(wide);
    showLegend(wide, true);
    EXPECT_EQ(right(wide), alone) << "they do not meet";
}

TEST(Panel, NarrowWindowsHaveLargeTargetsAndKeepTheTabs) {
    for (const double scale : {1.0, 2.0}) {
        Bench b("sample:dna", {400, 800}, scale);
        const auto tops = [&] {
            std::vector<float> places;
            for (const Control& c : b.panel.controls())
                if (c.role == "tab") places.push_back(c.seenTop);
            return places;
        };
        const std::vector<float> before = tops();
        ASSERT_EQ(before.size(), kPages.size());
        for (const Control& c : b.panel.controls())
            if (c.seen() && c.window == "Nacre" && c.role == "choice") {
                EXPECT_GE(c.bottom - c.top, 44 * scale) << c.name;
            }
        const Control* style = b.find("Spacefill");
        ASSERT_TRUE(style);
        b.panel.input().pointer({(style->left + style->right) / 2, (style->top + style->bottom) / 2});
        for (int i = 0; i < 5; ++i) b.panel.input().wheel(-3), b.settle();
        EXPECT_EQ(tops(), before) << "the page scrolls beneath them";
        EXPECT_FALSE(b.find("Spacefill"));
        for (const Control& c : b.panel.controls())
            if (c.role == "tab") {
                EXPECT_GE(c.bottom - c.top, 44 * scale) << c.name;
                EXPECT_GE(c.right - c.left, 44 * scale) << c.name;
            }
    }
    // A wide window keeps its small ones.
    Bench wide("sample:dna", kUsual);
    EXPECT_LT(wide.find("Spacefill")->bottom - wide.find("Spacefill")->top, 44);
}

TEST(Panel, TextGrowsToTwiceItsSize) {
    Bench plain("sample:dna", kUsual), twice("sample:dna", kUsual, 1, PanelHand::mouse, sampleSources(), {}, 200);
    const Control *small = plain.find("Spacefill"), *large = twice.find("Spacefill");
    ASSERT_TRUE(small && large);
    EXPECT_NEAR((large->bottom - large->top) / (small->bottom - small->top), 2, 0.1);
    for (const std::string_view page : kPages) {
        twice.panel.showPage(page);
        twice.settle();
        expectReadable(twice, "text of 200 %, page " + std::string(page));
        ASSERT_TRUE(twice.find(std::string(page), "tab")) << "tabs are in view";
    }
    // What is pressed is where it is seen.
    twice.panel.showPage("Look");
    twice.settle();
    twice.click("Licorice");
    EXPECT_EQ(twice.viewer.view().look.style, Style::licorice);
}

TEST(Panel, DialogsHaveTheirAnswersAtTheLowerRight) {
    Bench b("sample:dna", kUsual);
    b.panel.askToOpen({"a.pdb"});
    b.settle();
    const Control *cancel = b.find("Cancel"), *add = b.find("Add"), *replace = b.find("Replace");
    ASSERT_TRUE(cancel && add && replace);
    EXPECT_LT(cancel->right, add->left);
    EXPECT_LT(add->right, replace->left);
    float right = 0;
    for (const Control& c : b.panel.controls())
        if (c.window == "Dropped") right = std::max(right, c.right);
    EXPECT_NEAR(replace->right, right, 1);
    EXPECT_TRUE(replace->focused) << "the emphasised one";
}

TEST(Panel, ADarkCanvasGoesWithTheDarkTheme) {
    Bench b("sample:dna", kUsual);
    const std::array<float, 4> white{1, 1, 1, 1};
    b.panel.setBrightness(Panel::Brightness::light);
    b.settle();
    b.panel.setDarkCanvas(true);
    b.settle();
    EXPECT_EQ(b.viewer.view().background, white) << "the theme is light";
    b.panel.setBrightness(Panel::Brightness::dark);
    b.settle();
    EXPECT_LT(b.viewer.view().background[0], 0.1f);
    b.panel.setBrightness(Panel::Brightness::light);
    b.settle();
    EXPECT_EQ(b.viewer.view().background, white);
    PictureDescription look = b.viewer.view();
    look.background = {0.9f, 0.8f, 0.7f, 1};
    b.viewer.setLook(look, b.now);
    b.panel.setBrightness(Panel::Brightness::dark);
    b.settle();
    EXPECT_EQ(b.viewer.view().background, look.background) << "one that the user chose stays";
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
}  // namespace nacre::app::test
