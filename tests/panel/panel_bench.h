#pragma once
// The panel on a screen that draws nothing, with a hand that clicks and types.

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "app/input/read_input.h"
#include "app/panel/panel.h"
#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"

namespace nacre::app::test {

class NoScreen : public Screen {
public:
    void setScene(Representation) override {}
    double advanceOcclusion(const RenderSettings&, const OcclusionPace&) override { return 1; }
    FrameOutcome present(const RenderSettings&, const WindowFrame&) override { return FrameOutcome::shown; }
    PixelSize windowSize() const override { return {1, 1}; }
    std::uint32_t atomAt(const RenderSettings&, double, double, double) override { return 1; }
};

inline Sources sampleSources() {
    return {[](const PictureDescription& v) {
        const auto sample = [](const std::string& input) {
            if (!input.starts_with("sample:")) throw Error("cannot read molecule", input, "No such file or directory");
            return sampleMolecule(input.substr(7));
        };
        if (v.input.further.empty()) return sample(v.input.path);
        std::vector<Molecule> all{sample(v.input.path)};
        for (const FurtherInput& further : v.input.further) all.push_back(sample(further.path));
        const InputOptions input = makeInput(v);
        const auto join = input.conformations ? joinConformations : joinInputs;
        return join(input, std::move(all), [](const std::string&) {});
    }};
}

struct Bench {
    NoScreen screen;
    Viewer viewer;
    Panel panel;
    PixelSize size;
    double scale, now = 100;
    std::vector<RecentFile> recent;
    std::vector<ViewerCommand> asked;

    /// @param lend  to the panel, besides what every shell does
    Bench(const std::string& input, PixelSize points, double pixelsPerPoint = 1, PanelHand hand = PanelHand::mouse,
          const Sources& sources = sampleSources(), const std::function<void(PanelHost&)>& lend = {},
          int textPercent = 100)
        : viewer(screen, sources, makeView(input), staying()),
          panel(pixelsPerPoint, host(lend), hand, textPercent),
          size{static_cast<std::uint32_t>(points.width * pixelsPerPoint),
               static_cast<std::uint32_t>(points.height * pixelsPerPoint)},
          scale(pixelsPerPoint) {
        EXPECT_GT(panel.glyphs().width, 0u);
        viewer.frames().resize(size, pixelsPerPoint, now);
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
    static PictureDescription makeView(const std::string& input) {
        PictureDescription v;
        v.input.path = input;
        return v;
    }
    PanelHost host(const std::function<void(PanelHost&)>& lend) {
        PanelHost h;
        h.run = [this](ViewerCommand c) {
            asked.push_back(c);
            viewer.run(c, now);
        };
        h.openDialog = [] {};
        h.open = [this](const std::vector<std::string>& inputs, bool beside) { viewer.open(inputs, beside, now); };
        h.recent = [this]() -> const std::vector<RecentFile>& { return recent; };
        h.freeName = [](const char* extension) { return std::string("picture") + extension; };
        h.savePicture = [](const PictureWish&) {};
        h.copyPicture = [] {};
        h.saveAndQuit = [] {};
        h.statistics = [] { return std::string("a device\ntiles, 3 frames"); };
        h.lastView = "1bna.pdb";
        h.goOn = [] {};
        h.downloads = h.captures = true;
        h.saveDialog = [](const std::string&, const std::string&, const PathChosen&) {};
        h.fontWith = [](const std::vector<char32_t>&) {
            return FontFile{"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"};
        };
        if (lend) lend(h);
        return h;
    }
    void frame() {
        now += 1.0 / 60;
        viewer.playback().wait();
        viewer.update(now);
        panel.draw(viewer, size, now);
    }
    void settle() {
        for (int i = 0; i < 6; ++i) {
            viewer.reading().loader().wait();
            frame();
        }
    }
    const Control* find(const std::string& name, const std::string& role = "") {
        for (const Control& c : panel.controls())
            if (c.name == name && c.seen() && (role.empty() ? c.role != "text" : c.role == role)) return &c;
        return nullptr;
    }
    void clickAt(double x, double y) {
        panel.input().pointer({x, y});
        frame();
        panel.input().button(MouseButton::left, true);
        frame();
        panel.input().button(MouseButton::left, false);
        settle();
    }
    void click(const std::string& name) {
        const Control* c = find(name);
        ASSERT_TRUE(c) << name;
        clickAt((c->seenLeft + c->seenRight) / 2, (c->seenTop + c->seenBottom) / 2);
    }
    void press(SpecialKey key, Modifiers with = {}) {
        panel.input().key(key, true, with);
        frame();
        panel.input().key(key, false, with);
        frame();
    }
};

inline constexpr PixelSize kUsual{1000, 720}, kNarrow{420, 760}, kTall{620, 1000}, kWide{1300, 420}, kSmall{360, 480};
inline const std::vector<std::string_view> kPages = Panel::pages();

/// All words of a panel stand whole, side by side, and within what shows them. @returns controls that were looked at
std::size_t expectReadable(const Bench& b, const std::string& state);

}  // namespace nacre::app::test
