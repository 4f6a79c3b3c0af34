// The panel under fingers: what they hit is large enough, and lists go on when they are let go.

#include <set>

#include "app/panel/theme.h"
#include "app/picture/appearance_values.h"
#include "tests/panel/panel_bench.h"

namespace nacre::app::test {
namespace {

constexpr PixelSize kPhone{360, 640};

/// Every control is at least as high and as wide as a finger, as the platforms ask for.
void expectHit(const Bench& b, const std::string& state) {
    const double least = kFingerPoints * b.scale - 0.5;
    std::size_t looked = 0;
    for (const Control& c : b.panel.controls()) {
        if (c.role == "text" || c.role == "status" || c.role == "sequence") continue;
        ++looked;
        EXPECT_GE(c.bottom - c.top, least) << state << ": " << c.role << " \"" << c.name << "\"";
        EXPECT_GE(c.right - c.left, least) << state << ": " << c.role << " \"" << c.name << "\"";
    }
    EXPECT_GT(looked, 0u) << state;
}

TEST(Fingers, HitEveryControl) {
    for (const double scale : {1.0, 2.6}) {
        Bench b("sample:dna", kPhone, scale, PanelHand::fingers, sampleSources(), [](PanelHost& host) {
            host.record = [](const RecordingWish&, const std::vector<PictureDescription>&) {};
        });
        expectHit(b, "menu");
        b.panel.togglePanel();
        PictureDescription look = b.viewer.view();
        look.look.rules = {parseHide("resi 1"), parseShow("chain B=licorice")};
        look.words.labels.push_back(parseLabel("resi 3={residue}"));
        look.effects.contours.width = look.effects.halos.width = 3;
        look.effects.fog.range = Fog::Range::automatic;
        b.viewer.setLook(look, b.now);
        for (const std::string_view page : kPages) {
            b.panel.showPage(page);
            b.settle();
            expectHit(b, "page " + std::string(page));
        }
        for (const auto& show : {&Panel::showSave, &Panel::showStart, &Panel::showRecord, &Panel::toggleHelp}) {
            (b.panel.*show)();
            b.settle();
            expectHit(b, "a card");
            b.panel.closeTop();
        }
        b.viewer.reading().open("nothing.pdb", b.now);
        b.settle();
        expectHit(b, "an error");
    }
}

/// Where a text of the page stands, which moves with it. Not a number: nowhere
float findPlace(const Bench& b, const std::string& name) {
    for (const Control& c : b.panel.controls())
        if (c.name == name && c.window == "Nacre") return c.top;
    return std::nanf("");
}

TEST(Fingers, ALetGoListGlidesOnAndComesToRest) {
    Bench b("sample:dna", kPhone, 1, PanelHand::fingers);
    b.panel.togglePanel();
    b.settle();
    const auto place = [&] { return findPlace(b, "Background"); };
    const auto drag = [&](double to, bool rests) {
        const double x = 180, from = 600;
        EXPECT_TRUE(b.panel.input().touch({1, TouchPhase::began, {x, from}}));
        for (int i = 1; i <= 8; ++i) {
            b.panel.input().touch({1, TouchPhase::moved, {x, from + (to - from) * i / 8}});
            b.frame();
        }
        for (int i = 0; i < 20 && rests; ++i) b.frame();
        b.panel.input().touch({1, TouchPhase::ended, {x, to}});
        b.frame();
    };
    const float before = place();
    drag(500, false);
    const float letGo = place();
    EXPECT_NEAR(before - letGo, 100, 15) << "it goes with the finger";
    EXPECT_TRUE(b.panel.restless());
    for (int i = 0; i < 30; ++i) b.frame();
    const float glided = place();
    EXPECT_LT(glided, letGo - 40) << "and on, when it is let go";
    for (int i = 0; i < 300; ++i) b.frame();
    const float rested = place();
    b.frame();
    EXPECT_EQ(place(), rested);
    EXPECT_FALSE(b.panel.restless());
    // A finger that rests before it leaves stops it, and so does one that comes down.
    drag(540, true);
    const float still = place();
    for (int i = 0; i < 30; ++i) b.frame();
    EXPECT_EQ(place(), still);
    drag(560, false);
    b.panel.input().touch({2, TouchPhase::began, {180, 600}});
    b.frame();
    const float caught = place();
    for (int i = 0; i < 30; ++i) b.frame();
    EXPECT_EQ(place(), caught);
}

TEST(Fingers, TypeOnTheSystemsKeyboard) {
    std::pair<std::string, std::string> asked;
    Bench b("sample:dna", {1400, 1300}, 1, PanelHand::fingers, sampleSources(), [&](PanelHost& host) {
        host.askText = [&](const std::string& name, const std::string& text) { asked = {name, text}; };
        host.open = [&](const std::vector<std::string>& inputs, bool) { asked = {"opened", inputs.front()}; };
    });
    const auto tap = [&](const std::string& name) {
        const Control* c = b.find(name);
        ASSERT_TRUE(c) << name;
        const glm::dvec2 at((c->seenLeft + c->seenRight) / 2, (c->seenTop + c->seenBottom) / 2);
        b.panel.input().touch({1, TouchPhase::began, at});
        b.panel.input().touch({1, TouchPhase::ended, at});
        b.settle();
    };
    const auto type = [&](const std::string& name, const std::string& text) {
        b.panel.input().typed(name, text);
        b.settle();
    };
    b.panel.togglePanel();
    b.panel.showPage("Labels");
    b.settle();
    tap("Title");
    EXPECT_EQ(asked, std::pair(std::string("Title"), std::string()));
    type("Title", "DNA");
    EXPECT_EQ(b.viewer.view().words.title, "DNA");
    tap("Title");
    EXPECT_EQ(asked.second, "DNA") << "what stands there is gone on with";
    // A selection, live, and a rule of it that is edited.
    b.panel.showPage("Select");
    b.settle();
    tap("Selection");
    type("Selection", "chain A");
    EXPECT_GT(b.viewer.picking().selection().count, 200u);
    PictureDescription look = b.viewer.view();
    look.look.rules = {parseHide("chain A")};
    b.viewer.setLook(look, b.now);
    b.viewer.picking().select("");
    b.settle();
    tap("Hide chain A");
    tap("Atoms of the rule");
    EXPECT_EQ(asked.second, "chain A");
    type("Atoms of the rule", "resi 1");
    EXPECT_EQ(b.viewer.view().look.rules[0].selection.text, "resi 1");
    // What a field was typed for that is gone changes nothing.
    type("Title", "too late");
    b.panel.showPage("Labels");
    b.settle();
    EXPECT_EQ(b.viewer.view().words.title, "DNA");
    b.panel.showStart();
    b.settle();
    tap("ID or path");
    type("ID or path", "pdb:1BNA");
    EXPECT_EQ(asked, std::pair(std::string("opened"), std::string("pdb:1BNA")));
}

TEST(Fingers, AreToldListsByOtherNamesThanTabs) {
    Bench b("sample:dna", {1400, 1300}, 1, PanelHand::fingers);
    b.panel.togglePanel();
    b.settle();
    std::set<std::string> tabs;
    for (const Control& c : b.panel.controls())
        if (c.role == "tab") tabs.insert(c.name);
    EXPECT_EQ(tabs.size(), 5u);
    for (const std::string_view page : kPages) {
        b.panel.showPage(page);
        b.settle();
        for (const Control& c : b.panel.controls()) EXPECT_FALSE(c.role == "list" && tabs.contains(c.name)) << c.name;
    }
}

TEST(Fingers, ATapRightBehindAnotherIsOneOfItsOwn) {
    Bench b("sample:dna", {1400, 1300}, 1, PanelHand::fingers);
    b.panel.togglePanel();
    PictureDescription look = b.viewer.view();
    look.look.style = Style::surface;
    b.viewer.setLook(look, b.now);
    b.settle();
    const auto tap = [&](glm::dvec2 at) {
        b.panel.input().touch({1, TouchPhase::began, at});
        b.panel.input().touch({1, TouchPhase::ended, at});
    };
    // What a screen reader steps a slider by.
    const auto step = placeOfStep(b.panel.controls(), "Surface opacity", false);
    const Control* after = b.find("Perspective");
    ASSERT_TRUE(step && after);
    const glm::dvec2 at(after->left + 10, (after->seenTop + after->seenBottom) / 2);
    for (const bool frameBetween : {true, false}) {
        tap(*step);
        if (frameBetween) b.frame();
        tap(at);
        b.settle();
        const bool on = frameBetween;
        EXPECT_EQ(b.viewer.view().camera.projection, on ? Projection::perspective : Projection::orthographic);
        EXPECT_NEAR(b.viewer.view().look.surfaceOpacity, 0.91, 0.015) << "the slider did not follow the second tap";
    }
    // A double tap is two presses.
    tap(at);
    tap(at);
    b.settle();
    EXPECT_EQ(b.viewer.view().camera.projection, Projection::orthographic);
}

}  // namespace
}  // namespace nacre::app::test
