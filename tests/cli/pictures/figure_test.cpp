// `nacre figure`: panels of one camera, at the resolution of print.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <memory>
#include <vector>

#include "tests/support/run_program.h"

namespace nacre::app {
namespace {

using test::nacreDone;
using test::nacreIn;
using test::Outcome;
using test::TemporaryFolder;

struct DrawnFigure {
    int width = 0, height = 0;
    double dpi = 0;
    std::vector<unsigned char> rgb;
    std::array<int, 3> at(int x, int y) const {
        const std::size_t i =
            3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
        return {rgb[i], rgb[i + 1], rgb[i + 2]};
    }
    /// Pixels of a rectangle that are not white.
    int inkIn(int left, int top, int right, int bottom) const {
        int ink = 0;
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) ink += at(x, y) != std::array{255, 255, 255};
        return ink;
    }
};

DrawnFigure drawFigure(const TemporaryFolder& folder, const std::string& panels, const std::string& options) {
    std::ofstream(folder / "p.jsonl") << panels;
    nacreDone(folder, "figure p.jsonl -o f.png -q --cache off --occlusion off " + options);
    DrawnFigure figure;
    const std::unique_ptr<OIIO::ImageInput> file = OIIO::ImageInput::open(folder / "f.png");
    if (!file) return figure;
    const OIIO::ImageSpec& spec = file->spec();
    figure.width = spec.width;
    figure.height = spec.height;
    figure.dpi = static_cast<double>(spec.get_float_attribute("XResolution"));
    if (spec.get_string_attribute("ResolutionUnit") == "cm") figure.dpi *= 2.54;
    figure.rgb.resize(3 * spec.image_pixels());
    EXPECT_TRUE(file->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, figure.rgb.data()));
    return figure;
}

/// Two atoms 6 Å apart, alone in a chain each; the second file lacks an atom and is smaller.
void writeAtoms(const TemporaryFolder& folder) {
    std::ofstream(folder / "a.xyz") << "3\na\nO 0 0 0\nO 6 0 0\nN 0 9 0\n";
    std::ofstream(folder / "b.xyz") << "2\nb\nO 0 0 0\nO 6 0 0\n";
}

TEST(Figure, PanelsHaveOneScaleAndOneCentre) {
    const TemporaryFolder folder;
    writeAtoms(folder);
    const DrawnFigure figure = drawFigure(
        folder, "{\"input\": \"a.xyz\"}\n{\"input\": \"b.xyz\"}\n{\"input\": \"a.xyz\", \"hide\": [\"elem N\"]}\n",
        "--size 200x160 --style spacefill --letters off --lighting off");
    constexpr int kGap = 25;  // 6 points at 300 dots per inch
    ASSERT_EQ(figure.width, 2 * 200 + kGap);
    ASSERT_EQ(figure.height, 2 * 160 + kGap);
    EXPECT_NEAR(figure.dpi, 300, 0.5);
    EXPECT_EQ(figure.inkIn(200, 0, 200 + kGap, figure.height), 0);
    EXPECT_EQ(figure.inkIn(200 + kGap, 160 + kGap, figure.width, figure.height), 0);  // there are three
    // The oxygens stand at the same pixels of each panel.
    int red = 0, other = 0, blue = 0;
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 200; ++x) {
            const auto first = figure.at(x, y);
            const bool oxygen = first[0] > first[2] + 50, nitrogen = first[2] > first[0] + 50;
            blue += nitrogen;
            if (!oxygen) continue;
            ++red;
            other += figure.at(200 + kGap + x, y) != first;
            other += figure.at(x, 160 + kGap + y) != first;
        }
    EXPECT_GT(red, 1000);
    EXPECT_GT(blue, 500);
    EXPECT_EQ(other, 0);
    EXPECT_EQ(figure.inkIn(0, 160 + kGap, 200, figure.height), figure.inkIn(200 + kGap, 0, figure.width, 160));
}

TEST(Figure, HasLettersAndOneScaleBar) {
    const TemporaryFolder folder;
    writeAtoms(folder);
    const std::string panels = "{\"input\": \"b.xyz\"}\n{\"input\": \"b.xyz\"}\n";
    const std::string options = "--size 240x240 --zoom 0.5 --gap 0 --columns 1 ";
    const DrawnFigure plain = drawFigure(folder, panels, options + "--letters off");
    ASSERT_EQ(plain.width, 240);
    ASSERT_EQ(plain.height, 480);
    for (const int top : {0, 240}) EXPECT_EQ(plain.inkIn(0, top, 40, top + 40), 0);
    const DrawnFigure small = drawFigure(folder, panels, options),
                      capital = drawFigure(folder, panels, options + "--letters A");
    for (const int top : {0, 240}) {
        EXPECT_GT(small.inkIn(0, top, 40, top + 40), 10);
        EXPECT_GT(capital.inkIn(0, top, 40, top + 40), small.inkIn(0, top, 40, top + 40));
    }
    const DrawnFigure bar = drawFigure(folder, panels, options + "--letters off --scale-bar angstrom");
    EXPECT_EQ(bar.inkIn(120, 180, 240, 240), plain.inkIn(120, 180, 240, 240));
    EXPECT_GT(bar.inkIn(120, 420, 240, 480), plain.inkIn(120, 420, 240, 480) + 50);
}

TEST(Figure, APanelMayTurnButNotScale) {
    const TemporaryFolder folder;
    writeAtoms(folder);
    const DrawnFigure figure =
        drawFigure(folder, "{\"input\": \"b.xyz\"}\n{\"input\": \"b.xyz\", \"rotate\": \"0,0,90\"}\n",
                   "--size 200x200 --gap 0 --letters off --lighting off");
    const auto extent = [&](int left, bool across) {
        int first = 200, last = 0;
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 200; ++x) {
                if (figure.at(left + x, y) == std::array{255, 255, 255}) continue;
                first = std::min(first, across ? x : y);
                last = std::max(last, across ? x : y);
            }
        return last - first + 1;
    };
    EXPECT_GT(extent(0, true), extent(0, false) + 40);
    EXPECT_EQ(extent(0, true), extent(200, false));
    EXPECT_EQ(extent(0, false), extent(200, true));
}

/// Columns of a rectangle that have ink of one of two colours.
int redColumns(const DrawnFigure& figure, int left, int right, int bottom) {
    int columns = 0;
    for (int x = left; x < right; ++x)
        for (int y = 0; y < bottom; ++y)
            if (const auto at = figure.at(x, y); at[0] > at[2] + 50) {
                ++columns;
                break;
            }
    return columns;
}

TEST(Figure, NoPanelIsCropped) {
    const TemporaryFolder folder;
    writeAtoms(folder);
    // The second panel's balls are larger, the third's molecule reaches farther, the fourth is seen from another side.
    const DrawnFigure figure = drawFigure(
        folder,
        "{\"input\": \"b.xyz\", \"ball-scale\": 0.2, \"style\": \"ball-and-stick\"}\n{\"input\": \"b.xyz\"}\n"
        "{\"input\": \"a.xyz\"}\n{\"input\": \"a.xyz\", \"rotate\": [0, 0, 45]}\n",
        "--size 200x200 --gap 0 --letters off --style spacefill --columns 4");
    ASSERT_EQ(figure.width, 800);
    for (int panel = 0; panel < 4; ++panel) {
        const int left = 200 * panel;
        EXPECT_GT(figure.inkIn(left, 0, left + 200, 200), 30);
        EXPECT_EQ(figure.inkIn(left, 0, left + 2, 200) + figure.inkIn(left + 198, 0, left + 200, 200), 0) << panel;
        EXPECT_EQ(figure.inkIn(left, 0, left + 200, 2) + figure.inkIn(left, 198, left + 200, 200), 0) << panel;
    }
}

TEST(Figure, OptionsOfAllPanelsGiveOneCamera) {
    const TemporaryFolder folder;
    writeAtoms(folder);
    for (const char* side : {"--rotate 0,0,30", "--orient principal", "--zoom-to 'elem O' --uncover off"}) {
        const DrawnFigure figure =
            drawFigure(folder, "{\"input\": \"a.xyz\"}\n{\"input\": \"a.xyz\", \"hide\": [\"elem N\"]}\n",
                       std::string("--size 200x160 --gap 0 --style spacefill --letters off --lighting off ") + side);
        int red = 0, other = 0;
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 200; ++x) {
                const auto first = figure.at(x, y), second = figure.at(200 + x, y);
                if (second[0] <= second[2] + 50) continue;
                ++red;
                other += second != first && first[2] <= first[0] + 50;  // nitrogen may be in front
            }
        EXPECT_GT(red, 500) << side;
        EXPECT_EQ(other, 0) << side;
    }
}

TEST(Figure, ACloseUpKeepsTheScaleUnlessItsLineHasOne) {
    const TemporaryFolder folder;
    writeAtoms(folder);
    const std::string options = "--size 240x240 --gap 0 --columns 3 --letters off --lighting off --style spacefill ";
    const std::string panels =
        "{\"input\": \"a.xyz\"}\n{\"input\": \"a.xyz\", \"zoom-to\": \"id 1\", \"hide\": [\"id 2\"]}\n"
        "{\"input\": \"a.xyz\", \"zoom-to\": \"id 1\", \"zoom\": 1, \"hide\": [\"id 2\"]}\n";
    const DrawnFigure figure = drawFigure(folder, panels, options + "--uncover off");
    const double both = redColumns(figure, 0, 240, 240), one = redColumns(figure, 240, 480, 240);
    EXPECT_NEAR(both, 2 * one, 2);
    // 95 % of the side for a ball of oxygen with 3 Å around it.
    constexpr double kRadius = 1.52;
    EXPECT_NEAR(redColumns(figure, 480, 720, 240), 0.95 * 240 * kRadius / (kRadius + 3), 2);
    EXPECT_LT(one, 70);
    // A bar for each scale.
    const DrawnFigure bars = drawFigure(folder, panels, options + "--uncover off --scale-bar angstrom");
    for (const int left : {0, 240, 480}) {
        const int more = bars.inkIn(left + 120, 200, left + 240, 240) - figure.inkIn(left + 120, 200, left + 240, 240);
        EXPECT_EQ(more > 0, left > 0) << left << ": " << more;
    }
}

TEST(Figure, FaultsNameTheLine) {
    const TemporaryFolder folder;
    writeAtoms(folder);
    const auto error = [&](const std::string& panels) {
        std::ofstream(folder / "p.jsonl") << panels;
        const Outcome outcome = nacreIn(folder, "figure p.jsonl -o f.png -q");
        EXPECT_EQ(outcome.code, 1);
        EXPECT_FALSE(std::filesystem::exists(folder / "f.png"));
        return outcome.err;
    };
    EXPECT_NE(error("{\"input\": \"b.xyz\"}\n{\"input\": \"b.xyz\", \"stile\": 1}\n").find("line 2"),
              std::string::npos);
    EXPECT_NE(error("").find("no panels"), std::string::npos);
    EXPECT_NE(error("{\"input\": \"b.xyz\"}\n{\"input\": \"b.xyz\", \"size\": \"90x90\"}\n").find("different sizes"),
              std::string::npos);
}

}  // namespace
}  // namespace nacre::app
