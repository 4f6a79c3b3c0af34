// Pictures for two eyes: each eye's pixels are those of one camera, and depth appears where geometry puts it.

#include "app/drawing/stereo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "app/drawing/drawing.h"
#include "app/picture/options.h"
#include "engine/error.h"
#include "engine/molecule/read.h"
#include "engine/srgb.h"

namespace nacre::app {
namespace {

using StereoOptions = std::vector<std::pair<const char*, const char*>>;

class StereoTest : public testing::Test {
protected:
    PictureDescription described(const StereoOptions& options) const {
        PictureDescription picture;
        picture.input.path = "sample:dna";
        picture.input.cache = "off";
        picture.size = {160, 120};
        picture.occlusion.directions = 8;
        for (const auto& [key, value] : options) setOption(option(key), value, picture);
        return picture;
    }
    void prepare(const StereoOptions& options) { drawing.prepare(molecule, described(options)); }
    Picture draw(const StereoOptions& options) {
        prepare(options);
        return drawing.draw(canvas);
    }
    LayerPicture layers(const StereoOptions& options) {
        prepare(options);
        drawing.show(canvas);
        return drawing.layers(canvas.renderer);
    }

    const Molecule molecule = sampleMolecule("dna");
    Canvas canvas{DeviceOptions{}};
    Drawing drawing;
};

/// One channel of a rectangle.
template <typename T>
std::vector<T> part(const std::vector<T>& all, std::uint32_t wide, std::size_t channels, PictureRect r) {
    std::vector<T> found;
    for (std::uint32_t y = r.y; y < r.y + r.height; ++y) {
        const auto row = all.begin() + static_cast<std::ptrdiff_t>(channels * (std::size_t{y} * wide + r.x));
        found.insert(found.end(), row, row + static_cast<std::ptrdiff_t>(channels * r.width));
    }
    return found;
}

TEST_F(StereoTest, EachEyeHasThePixelsOfASinglePicture) {
    struct Case {
        const char* mode;
        const char* eyeSize;
        PictureRect left, right;
    };
    const Case cases[] = {{"side-by-side", "80x120", {0, 0, 80, 120}, {80, 0, 80, 120}},
                          {"cross-eyed", "80x120", {80, 0, 80, 120}, {0, 0, 80, 120}},
                          {"top-bottom", "160x60", {0, 0, 160, 60}, {0, 60, 160, 60}}};
    const std::pair<const char*, const char*> looks[] = {
        {"style", "spacefill"}, {"style", "cartoon"}, {"shadow", "0.7"}, {"label", "chain A and resi 2={residue}"}};
    for (const Case& c : cases)
        for (const auto& look : looks) {
            SCOPED_TRACE(std::string(c.mode) + " " + look.second);
            const Picture both = draw({{"stereo", c.mode}, look});
            const LayerPicture bothLayers = layers({{"stereo", c.mode}, look});
            ASSERT_EQ(both.width, 160u);
            ASSERT_EQ(both.height, 120u);
            for (const auto& [eye, rect] : {std::pair{"left", c.left}, {"right", c.right}}) {
                const StereoOptions alone{{"stereo", eye}, {"size", c.eyeSize}, look};
                // Labels of the right eye keep the sides that the left eye's have.
                if (look.first != std::string("label") || eye == std::string("left")) {
                    EXPECT_EQ(part(both.rgba, 160, 4, rect), draw(alone).rgba) << eye;
                }
                const LayerPicture single = layers(alone);
                EXPECT_EQ(part(bothLayers.id, 160, 1, rect), single.id) << eye;
                EXPECT_EQ(part(bothLayers.z, 160, 1, rect), single.z) << eye;
                EXPECT_EQ(part(bothLayers.normal, 160, 3, rect), single.normal) << eye;
            }
        }
}

TEST_F(StereoTest, AnEyeSeesAsACameraThatStandsThere) {
    prepare({{"projection", "perspective"}});
    const View middle = drawing.settings.view;
    const glm::dvec3 center = drawing.run.center;
    constexpr double kApart = 6;
    const double screen = middle.eyeDistance * 0.9;
    const LayerPicture seen =
        layers({{"stereo", "left"}, {"eye-distance", "6"}, {"screen-distance", std::to_string(screen).c_str()}});
    // The same camera by options that know no eyes: another centre, and an image plane that is shifted back.
    PictureDescription moved = described({{"projection", "perspective"}});
    const double aside = -kApart / 2;
    moved.camera.center = center + glm::transpose(middle.rotation) * glm::dvec3(aside, 0, 0);
    moved.camera.eyeDistance = middle.eyeDistance;
    moved.camera.scale = ViewScale{ViewScale::Unit::pixelsPerAngstrom, middle.pixelsPerAngstrom};
    moved.camera.pan = {aside * middle.eyeDistance / screen, 0};
    Drawing other;
    other.prepare(molecule, moved);
    ASSERT_NEAR(other.settings.view.eyeDistance, middle.eyeDistance, 1e-9);
    other.show(canvas);
    const LayerPicture there = other.layers(canvas.renderer);
    std::size_t differ = 0;
    for (std::size_t i = 0; i < there.id.size(); ++i) differ += there.id[i] != seen.id[i] ? 1 : 0;
    EXPECT_LE(differ, there.id.size() / 1000);  // rays that graze an edge, by rounding
    EXPECT_GT(std::ranges::count_if(there.id, [](std::uint32_t id) { return id > 0; }), 1000);
}

/// Mean column of an atom's pixels; negative: there are few.
double meanColumn(const LayerPicture& layers, std::uint32_t id) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < layers.id.size(); ++i)
        if (layers.id[i] == id) sum += static_cast<double>(i % layers.width) + 0.5, ++count;
    return count < 200 ? -1 : sum / count;
}

TEST_F(StereoTest, DisparityIsThatOfParallelEyes) {
    // Three atoms beside each other, so that nothing hides them, at 12, 10 and 8 Å from the eyes.
    const Molecule three = readMolecule("three.xyz", "3\nthree\nC -2.6 0 -2\nC 0 0 0\nC 2.6 0 2\n", {});
    const auto eyeLayers = [&](const char* eye, const char* screen) {
        PictureDescription picture = described({{"stereo", eye},
                                                {"size", "600x400"},
                                                {"style", "ball-and-stick"},
                                                {"eye-distance", "0.8"},
                                                {"screen-distance", screen},
                                                {"center", "0,0,0"},
                                                {"scale", "8A"}});
        picture.camera.eyeDistance = 10;
        drawing.forget();
        drawing.prepare(three, picture);
        drawing.show(canvas);
        return drawing.layers(canvas.renderer);
    };
    for (const char* screen : {"10", "8", "12"}) {
        const LayerPicture left = eyeLayers("left", screen), right = eyeLayers("right", screen);
        const View& view = drawing.settings.view;
        ASSERT_NEAR(view.eyeDistance, 10, 1e-9);
        for (int i = -1; i <= 1; ++i) {
            const auto id = static_cast<std::uint32_t>(i + 2);
            const double distance = 10 - 2 * i;
            const double wanted =
                0.8 * view.eyeDistance * view.pixelsPerAngstrom * (1 / std::stod(screen) - 1 / distance);
            ASSERT_GT(meanColumn(left, id), 0);
            const double disparity = meanColumn(right, id) - meanColumn(left, id);
            EXPECT_NEAR(disparity, wanted, 0.35) << "at " << distance << ", screen at " << screen;
            if (distance < std::stod(screen)) {
                EXPECT_LT(disparity, -5);  // crossed: in front of the screen
            }
        }
    }
}

TEST_F(StereoTest, ALabelHasTheDepthOfItsAtom) {
    prepare({});
    std::size_t front = 0;  // the atom that is nearest to the viewer
    const auto atomHeight = [&](std::size_t i) { return molecule.atoms[i].position.z; };
    for (std::size_t i = 0; i < molecule.atoms.size(); ++i)
        if (atomHeight(i) > atomHeight(front)) front = i;
    const std::string text = "id " + std::to_string(front + 1) + "=X";
    const StereoOptions label{
        {"label", text.c_str()}, {"text-size", "12"}, {"eye-distance", "8"}, {"style", "licorice"}};
    const auto columnOfInk = [&](const char* eye) {
        StereoOptions with = label, without{{"eye-distance", "8"}, {"style", "licorice"}};
        with.emplace_back("stereo", eye), without.emplace_back("stereo", eye);
        const Picture plain = draw(without), labelled = draw(with);
        double sum = 0, weight = 0;
        for (std::size_t i = 0; i < plain.rgba.size(); i += 4) {
            const double ink = std::abs(static_cast<double>(labelled.rgba[i] - plain.rgba[i]));
            sum += ink * static_cast<double>(i / 4 % plain.width), weight += ink;
        }
        EXPECT_GT(weight, 1);
        return sum / weight;
    };
    const double disparity = columnOfInk("right") - columnOfInk("left");
    const View& view = drawing.settings.view;
    const glm::dvec3 v = view.rotation * (glm::dvec3(molecule.atoms[front].position) - drawing.run.center);
    const double wanted = 8 * view.pixelsPerAngstrom * (1 - view.eyeDistance / (view.eyeDistance - v.z));
    ASSERT_GT(std::abs(wanted), 2);
    EXPECT_NEAR(disparity, wanted, 1.5);
}

TEST_F(StereoTest, OrthographicScenesGetAPerspectiveAndSaySo) {
    prepare({});
    const View ortho = drawing.settings.view;
    prepare({{"stereo", "anaglyph"}});
    EXPECT_EQ(drawing.settings.view.projection, Projection::perspective);
    EXPECT_NEAR(drawing.settings.view.pixelsPerAngstrom, ortho.pixelsPerAngstrom, 0.1 * ortho.pixelsPerAngstrom);
    EXPECT_TRUE(drawing.warnings.empty());
    Drawing other;
    other.prepare(molecule, described({{"stereo", "anaglyph"}, {"projection", "ortho"}}));
    ASSERT_EQ(other.warnings.size(), 1u);
    EXPECT_NE(other.warnings[0].find("perspective"), std::string::npos) << other.warnings[0];
}

/// The matrices by Dubois's formula of the spectra in his paper: least squares of what both filters pass.
TEST(Anaglyph, ItsMatricesAreDuboiss) {
    using glm::dmat3;
    // Rows X, Y, Z; columns red, green and blue: of the left filter, the right filter, and the display (CRT).
    const dmat3 left =
        glm::transpose(dmat3(5.42327, .807004, .047325, 2.70972, .50201, .0250529, .0000550941, .000411221, .00240686));
    const dmat3 right =
        glm::transpose(dmat3(.180431, 1.6395, 2.00309, .448214, 6.31551, 1.35757, .289201, 2.3925, 11.062));
    const dmat3 display =
        glm::transpose(dmat3(11.6638, 8.3959, 4.65843, 7.10807, 16.6845, 2.45008, .527874, 3.79124, 24.0604));
    const dmat3 inverse = glm::inverse(glm::transpose(left) * left + glm::transpose(right) * right);
    dmat3 ofLeft = inverse * glm::transpose(left) * display, ofRight = inverse * glm::transpose(right) * display;
    for (int row = 0; row < 3; ++row) {
        double white = 0;
        for (int column = 0; column < 3; ++column) white += ofLeft[column][row] + ofRight[column][row];
        for (int column = 0; column < 3; ++column) {
            const auto at = [&](const AnaglyphMatrix& m) {
                return static_cast<double>(m[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]);
            };
            EXPECT_NEAR(at(kAnaglyphLeft), ofLeft[column][row] / white, 2e-5) << row << column;
            EXPECT_NEAR(at(kAnaglyphRight), ofRight[column][row] / white, 2e-5) << row << column;
        }
    }
}

TEST(Anaglyph, WorksInLinearLight) {
    const Stereo stereo{Stereo::Mode::anaglyph, {}, {}};
    const auto one = [](float r, float g, float b) { return Picture{1, 1, {r, g, b, 1}}; };
    const Picture white = joinEyes(stereo, {1, 1}, {one(1, 1, 1), one(1, 1, 1)});
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(white.rgba[c], 1, 1e-4);
    const Picture grey = joinEyes(stereo, {1, 1}, {one(.5f, .5f, .5f), one(.5f, .5f, .5f)});
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(grey.rgba[c], .5, 1e-4);
    // White to the left eye alone passes the red filter; to the right one, the cyan filter.
    const Picture red = joinEyes(stereo, {1, 1}, {one(1, 1, 1), one(0, 0, 0)});
    EXPECT_GT(red.rgba[0], 0.99f);
    EXPECT_LT(std::max(red.rgba[1], red.rgba[2]), 0.01f);
    const Picture cyan = joinEyes(stereo, {1, 1}, {one(0, 0, 0), one(1, 1, 1)});
    EXPECT_LT(cyan.rgba[0], 0.01f);
    EXPECT_GT(std::min(cyan.rgba[1], cyan.rgba[2]), 0.99f);
}

TEST_F(StereoTest, AnAnaglyphHasNoLayers) {
    prepare({{"stereo", "anaglyph"}});
    drawing.show(canvas);
    EXPECT_THROW(drawing.layers(canvas.renderer), Error);
}

}  // namespace
}  // namespace nacre::app
