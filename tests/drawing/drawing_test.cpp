// A description that differs from the last one has only those parts of the work done again that differ.

#include "app/drawing/drawing.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/input/map_input.h"
#include "app/picture/options.h"
#include "engine/error.h"
#include "engine/molecule/read.h"

namespace nacre::app {
namespace {

class DrawingTest : public testing::Test {
protected:
    DrawingTest() {
        picture.input.path = "sample:dna";
        picture.input.cache = "off";
        picture.size = {64, 48};
        picture.occlusion.directions = 8;
        picture.look.style = Style::cartoon;
    }
    Picture drawn() {
        drawing.prepare(molecule, picture);
        return drawing.draw(canvas);
    }
    /// Draws by one that has drawn nothing yet, on a canvas of such drawings: TwoShareACanvas says what comes of that.
    Picture anew() {
        Drawing fresh;
        fresh.prepare(molecule, picture);
        return fresh.draw(other_);
    }
    void set(std::string_view key, const std::string& value) { setOption(option(key), value, picture); }

    const Molecule molecule = sampleMolecule("dna");
    PictureDescription picture;
    Canvas canvas{DeviceOptions{}};
    Drawing drawing;

private:
    Canvas other_{DeviceOptions{}};
};

TEST_F(DrawingTest, ViewShadingAndWordsBuildNoSceneAndNoBake) {
    drawn();
    ASSERT_EQ(drawing.counts().scenes, 1);
    ASSERT_EQ(drawing.counts().uploads, 1);
    const std::pair<const char*, const char*> changes[] = {
        {"rotate", "10,20,30"}, {"zoom", "1.5"},   {"size", "80x60"},      {"projection", "perspective"},
        {"fog", "auto"},        {"contours", "2"}, {"background", "navy"}, {"lighting", "off"},
        {"title", "DNA"},       {"legend", "on"},  {"axes", "on"},         {"label", "chain A and resi 1={residue}"}};
    for (const auto& [key, value] : changes) {
        set(key, value);
        const Picture again = drawn();
        EXPECT_EQ(drawing.counts().scenes, 1) << key;
        EXPECT_EQ(drawing.counts().uploads, 1) << key;  // without which what is baked stays
        EXPECT_EQ(again.rgba, anew().rgba) << key;
    }
}

TEST_F(DrawingTest, WhatIsDrawnOtherwiseIsBuiltAnew) {
    drawn();
    int scenes = 1;
    const std::pair<const char*, const char*> changes[] = {
        {"style", "licorice"}, {"color", "chain"}, {"hide", "chain B"}, {"hydrogens", "hide"}, {"zoom-to", "chain A"}};
    for (const auto& [key, value] : changes) {
        set(key, value);
        EXPECT_EQ(drawn().rgba, anew().rgba) << key;
        EXPECT_EQ(drawing.counts().scenes, ++scenes) << key;
        EXPECT_EQ(drawing.counts().uploads, scenes) << key;
    }
    // What hides the target depends on the view.
    set("rotate", "0,90,0");
    EXPECT_EQ(drawn().rgba, anew().rgba);
    EXPECT_EQ(drawing.counts().scenes, ++scenes);
}

TEST_F(DrawingTest, AnotherColourSchemeUploadsColoursAndKeepsTheBake) {
    for (const char* style : {"cartoon", "spacefill", "licorice", "surface"}) {
        set("style", style);
        set("color", "element");
        drawn();
        const double baked = canvas.renderer.stats().bakeMilliseconds;
        int colors = drawing.counts().colors;
        for (const char* scheme : {"chain", "residue", "#ff8000"}) {
            set("color", scheme);
            EXPECT_EQ(drawn().rgba, anew().rgba) << style << " " << scheme;
            EXPECT_EQ(drawing.counts().colors, ++colors) << style << " " << scheme;
            EXPECT_EQ(canvas.renderer.stats().bakeMilliseconds, baked) << style << " " << scheme;
        }
    }
    const int colors = drawing.counts().colors;
    set("surface-opacity", "0.5");
    EXPECT_EQ(drawn().rgba, anew().rgba);
    EXPECT_EQ(drawing.counts().colors, colors) << "translucent surfaces hide no light";
}

TEST_F(DrawingTest, WhatFailedOnceFailsAgainAndLeavesNothingBehind) {
    const Picture before = drawn();
    const PictureDescription good = picture;
    for (const auto& [key, value] : {std::pair("zoom-to", "resn ZZZ"), {"hide", "all"}}) {
        set(key, value);
        EXPECT_THROW(drawn(), Error) << key;
        EXPECT_THROW(drawn(), Error) << key << ", the same once more";
        picture = good;
        EXPECT_EQ(drawn().rgba, before.rgba) << key;
    }
}

TEST_F(DrawingTest, TwoShareACanvas) {
    const Picture first = drawn();
    Drawing other;
    PictureDescription elsewhere = picture;
    elsewhere.look.style = Style::spacefill;
    other.prepare(molecule, elsewhere);
    other.draw(canvas);
    EXPECT_EQ(drawing.draw(canvas).rgba, first.rgba);
    EXPECT_EQ(drawing.counts().scenes, 1);
    EXPECT_EQ(drawing.counts().uploads, 2);
}

/// A ball of density about the origin, under a name.
void keepBall(const std::string& name) {
    constexpr int kNodes = 33;
    std::vector<float> values;
    for (int i = 0; i < kNodes * kNodes * kNodes; ++i) {
        const glm::vec3 at(i % kNodes - 16, i / kNodes % kNodes - 16, i / kNodes / kNodes - 16);
        values.push_back(16 - std::sqrt(glm::dot(at, at)));
    }
    keepMap(name, std::make_shared<const DensityMap>(mapOfValues(name, glm::ivec3(kNodes),
                                                                 {glm::dvec3(kNodes), glm::dvec3(90)}, glm::dvec3(-16),
                                                                 false, std::move(values))));
}

TEST_F(DrawingTest, ALevelMakesContoursAndNoScene) {
    keepBall("ball");
    set("map", "ball");
    set("map-style", "mesh");
    set("map-level", "6");
    const Picture first = drawn();
    ASSERT_EQ(drawing.counts().scenes, 1);
    for (const auto& [key, value] : {std::pair{"map-level", "12"},
                                     {"map-style", "dots"},
                                     {"map-color", "red"},
                                     {"map-around", "resi 1,9"},
                                     {"map-width", "3"}}) {
        if (option(key).kind == Option::Kind::list) set(key, "");
        set(key, value);
        const int uploads = drawing.counts().uploads;
        const Picture again = drawn();
        EXPECT_EQ(drawing.counts().scenes, 1) << key;
        EXPECT_EQ(drawing.counts().uploads, uploads + 1) << key;
        EXPECT_NE(again.rgba, first.rgba) << key;
        EXPECT_EQ(again.rgba, anew().rgba) << key;
    }
}

TEST(LoneCrystal, IsDrawnFromNearUnlessTheMapsPartIsGiven) {
    constexpr int kNodes = 10;
    std::vector<float> values(kNodes * kNodes * kNodes);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i % 7);
    keepMap("lone.ccp4",
            std::make_shared<const DensityMap>(mapOfValues(
                "lone.ccp4", glm::ivec3(kNodes), {glm::dvec3(100), glm::dvec3(90)}, {}, true, std::move(values))));
    PictureDescription picture;
    picture.input.path = "lone.ccp4";
    picture.maps.files = {"lone.ccp4"};
    Drawing near;
    near.prepare(Molecule(), picture);
    EXPECT_NEAR(near.run.zoom, near.radius() / (1.2 * kMapReachOfFocus), 1e-6);
    const std::size_t wires = near.maps().shown.wires.size();
    near.prepare(Molecule(), picture);
    EXPECT_EQ(near.counts().scenes, 1) << "nothing differs";
    picture.given.insert("map-around");
    Drawing whole;
    whole.prepare(Molecule(), picture);
    EXPECT_LT(whole.run.zoom, 0.5 * near.run.zoom);
    EXPECT_GT(whole.maps().shown.wires.size(), 10 * wires);
}

TEST_F(DrawingTest, MapsGoWithTheFocusOfTheCamera) {
    keepBall("ball");
    set("map", "ball");
    set("map-style", "dots");
    set("map-level", "10");
    set("map-around", "focus,6");
    set("zoom", "1");
    const Picture first = drawn();
    set("pan", "3,0");
    const Picture moved = drawn();
    EXPECT_EQ(drawing.counts().scenes, 1);
    EXPECT_EQ(moved.rgba, anew().rgba);
    EXPECT_NE(moved.rgba, first.rgba);
}

TEST_F(DrawingTest, ASurfaceInTheColoursOfAMapIsBuiltAnewWithAnother) {
    keepBall("ball");
    set("style", "surface");
    const Picture plain = drawn();
    set("surface-color-from", "ball:0..16");
    const Picture first = drawn();
    EXPECT_NE(first.rgba, plain.rgba);
    EXPECT_EQ(first.rgba, anew().rgba);
    set("surface-color-from", "ball:0..16:plasma");
    EXPECT_NE(drawn().rgba, first.rgba);
    set("surface-color-from", "none");
    EXPECT_EQ(drawn().rgba, plain.rgba);
    set("style", "licorice");
    set("surface-color-from", "ball");
    drawn();
    EXPECT_EQ(drawing.warnings, std::vector<std::string>{"--surface-color-from changes nothing: no surface is drawn"});
}

TEST_F(DrawingTest, ContoursAndSlicesHaveALegend) {
    keepBall("ball");
    set("map", "ball");
    set("map-slice", "b,0.25");
    set("legend", "on");
    drawn();
    ASSERT_EQ(drawing.run.legends.size(), drawing.scene().legends.size() + 1);
    EXPECT_EQ(drawing.run.legends.back().scheme, "ball");
    EXPECT_EQ(drawing.words.legends.size(), drawing.run.legends.size());
}

TEST_F(DrawingTest, MapsAreDrawnWhereEveryAtomIsHidden) {
    keepBall("ball");
    set("map", "ball");
    set("hide", "all");
    const Picture surface = drawn();
    const auto covered = [](const Picture& p) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < p.rgba.size(); i += 4) count += p.rgba[i] < 0.99f;
        return count;
    };
    EXPECT_GT(covered(surface), 30u);
    set("map", "");
    EXPECT_THROW(drawn(), Error);
}

TEST(Axes, AreThoseOfTheCellWhereItIsDrawn) {
    const Molecule crystal = readMolecule(
        "a.cif",
        "data_x\n_cell_length_a 5\n_cell_length_b 9\n_cell_length_c 8\n_cell_angle_alpha 90\n_cell_angle_beta 120\n"
        "_cell_angle_gamma 90\nloop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n"
        "_atom_site_fract_z\nC1 0.1 0.2 0.3\n");
    for (const auto& [cell, names] : {std::pair("off", "xyz"), std::pair("on", "abc")}) {
        PictureDescription picture;
        for (const auto& [key, value] : {std::pair("axes", "on"), std::pair("cell", cell)})
            setOption(option(key), value, picture);
        Drawing drawing;
        drawing.prepare(crystal, picture);
        std::string shown;
        for (const PlacedAxis& axis : drawing.words.axes) shown += axis.name;
        EXPECT_EQ(shown, names);
        // c leans back by the obtuse angle beta.
        EXPECT_NEAR(glm::dot(drawing.words.axes.at(0).way, drawing.words.axes.at(2).way),
                    names == std::string("abc") ? -0.5 : 0, 1e-6);
    }
}

}  // namespace
}  // namespace nacre::app
