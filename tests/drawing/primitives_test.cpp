// Primitives as a file or an option has them.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "app/drawing/cell_frame.h"
#include "app/drawing/drawing.h"
#include "app/input/primitives_file.h"
#include "app/picture/options.h"
#include "engine/error.h"
#include "engine/molecule/read.h"
#include "tests/support/error_text.h"

namespace nacre::app {
namespace {

Primitives primitivesIn(const std::string& json) {
    return readPrimitives(json, "a.json", [](const std::string&) { return glm::dvec3(7, 8, 9); });
}

TEST(CellFrame, HasTheEdgesOfTheCellAboutTheAtoms) {
    Molecule molecule = sampleMolecule("glucose");
    EXPECT_TRUE(cellFrame(molecule).empty());
    for (Atom& atom : molecule.atoms) atom.position += glm::vec3(100, 0, 0);
    molecule.file.cell = {30, 40, 50, 90, 120, 90};  // monoclinic: c leans back along a by 50 cos 120 = -25
    const Primitives frame = cellFrame(molecule);
    ASSERT_EQ(frame.lines.size(), 12u);
    double length = 0;
    for (const Primitives::Line& line : frame.lines) length += glm::distance(line.a, line.b);
    EXPECT_NEAR(length, 4 * (30 + 40 + 50), 1e-3);
    ASSERT_EQ(frame.labels.size(), 3u);
    EXPECT_EQ(frame.labels[2].text, "c");
    // The atoms' middle is in the fourth cell along a.
    const glm::dvec3 corner = frame.lines[0].a, middle = glm::dvec3(molecule.atoms[0].position);
    EXPECT_LT(std::abs(std::remainder(corner.x, 5)), 1e-3);
    EXPECT_LT(glm::distance(middle, corner), 65);
    EXPECT_NEAR(frame.labels[2].at.x - corner.x, -1.04 * 25, 1e-3);
    EXPECT_NEAR(frame.labels[2].at.z - corner.z, 1.04 * 25 * std::sqrt(3), 1e-3);
    // A box begins where its file says.
    molecule.file.box = {glm::vec3(10, 0, 0), glm::vec3(0, 20, 0), glm::vec3(0, 0, 30)};
    molecule.file.boxOrigin = {-5, 1, 2};
    EXPECT_EQ(cellFrame(molecule).lines[0].a, glm::dvec3(-5, 1, 2));
    EXPECT_EQ(cellFrame(molecule).lines[0].b, glm::dvec3(5, 1, 2));
}

TEST(PrimitivesFile, HasEveryKind) {
    const Primitives p = primitivesIn(R"([
        {"kind": "line", "from": [0, 0, 0], "to": "chain A", "width": 2, "dash": 0.5, "color": "red", "note": "a line"},
        {"kind": "tube", "from": [0, 0, 0], "to": [1, 0, 0], "radius": 0.3, "opacity": 0.5, "dash": [1, 2]},
        {"kind": "arrow", "from": [0, 0, 0], "direction": [0, 2, 0], "radius": 0.2, "heads": "both"},
        {"kind": "sphere", "center": [1, 2, 3], "radius": 2, "color": "#102030"},
        {"kind": "ellipsoid", "center": [1, 2, 3], "radii": [1, 2, 3]},
        {"kind": "ellipse", "center": [0, 0, 0], "major": [2, 0, 0], "minor": [0, 1, 0], "end": 90},
        {"kind": "box", "min": [0, 0, 0], "max": [2, 4, 6], "faces": false, "edges": "blue", "edge_radius": 0.1},
        {"kind": "mesh", "vertices": [0, 0, 0, 1, 0, 0, 0, 1, 0], "triangles": [[0, 1, 2]], "colors": ["red"]},
        {"kind": "label", "at": [1, 1, 1], "text": "C\\alpha", "size": 2, "color": "green"}])");
    ASSERT_EQ(p.lines.size(), 2u);
    EXPECT_EQ(p.lines[0].b, glm::dvec3(7, 8, 9)) << "a selection is a place";
    EXPECT_EQ(p.lines[0].radius, 0);
    EXPECT_EQ(p.lines[0].look.color, 0xff0000ffu);
    EXPECT_EQ(p.notes.at(p.lines[0].look.note - 1), "a line");
    EXPECT_EQ(p.lines[1].look.opacity, 0.5);
    EXPECT_EQ(p.lines[1].dashes.gap, 2);
    ASSERT_EQ(p.arrows.size(), 1u);
    EXPECT_EQ(p.arrows[0].to, glm::dvec3(0, 2, 0));
    EXPECT_TRUE(p.arrows[0].headAtFrom && p.arrows[0].headAtTo);
    EXPECT_EQ(p.balls.at(0).look.color, 0xff302010u);
    EXPECT_EQ(p.ellipsoids.at(0).axes[2], glm::dvec3(0, 0, 3));
    EXPECT_NEAR(p.ellipses.at(0).end, 1.5708, 1e-4);
    EXPECT_EQ(p.boxes.at(0).center, glm::dvec3(1, 2, 3));
    EXPECT_FALSE(p.boxes.at(0).faces) << "edges alone";
    EXPECT_EQ(p.meshes.at(0).looks.size(), 1u);
    EXPECT_EQ(p.labels.at(0).text, "C\\alpha");
}

TEST(PrimitivesFile, TellsWhatIsWrongAndWhere) {
    const std::pair<const char*, const char*> wrong[] = {
        {"[\n{\"kind\": \"sphere\",\n]", "line 3"},
        {R"([{"kind": "sphere", "center": [0, 0, 0]}, {"kind": "shpere"}])", "primitive 2: \"kind\""},
        {R"([{"kind": "shpere"}])", "did you mean 'sphere'"},
        {R"([{"kind": "sphere", "centre": [0, 0, 0]}])", "\"center\" is missing"},
        {R"([{"kind": "sphere", "center": [0, 0, 0], "radios": 2}])",
         "there is no \"radios\" (did you mean 'radius'?)"},
        {R"([{"kind": "sphere", "center": [0, 0]}])", "\"center\": expected three numbers"},
        {R"([{"kind": "sphere", "center": [0, 0, 0], "radius": -1}])", "\"radius\": expected a number"},
        {R"([{"kind": "sphere", "center": [0, 0, 0], "color": "rde"}])", "\"color\""},
        {R"([{"kind": "mesh", "vertices": [0, 0, 0], "triangles": [0, 0, 1]}])", "from 0 to 0"},
        {R"([{"kind": "mesh", "vertices": [0, 0], "triangles": []}])", "in threes"},
        {"5", "a list of primitives"},
        {"[{\"kind\": 5E5555}]", "a number is too large: '5E5555'"},
        {"", "not valid JSON"}};
    for (const auto& [json, why] : wrong) {
        test::expectThrows([&] { primitivesIn(json); }, why);
    }
    EXPECT_THROW(primitivesIn(std::string(1000, '[')), Error);
}

TEST(PrimitivesOption, TakesAFileOrJsonOnOneLine) {
    PictureDescription d;
    setOption(option("primitives"), "scene.json", d);
    setOption(option("primitives"), "[ {\"kind\":\n \"sphere\"} ]", d);
    EXPECT_EQ(option("primitives").value.print(d), "scene.json\n[{\"kind\":\"sphere\"}]");
    EXPECT_THROW(setOption(option("primitives"), "[oops", d), std::invalid_argument);
}

TEST(PrimitivesOption, DrawsBesideAMoleculeAndWithoutOne) {
    Canvas canvas{DeviceOptions{}};
    PictureDescription d;
    d.input.path = "sample:dna";
    d.input.cache = "off";
    d.size = {64, 64};
    d.occlusion.directions = 0;
    const Molecule dna = sampleMolecule("dna");
    Drawing drawing;
    drawing.prepare(dna, d);
    const Picture plain = drawing.draw(canvas);
    setOption(option("primitives"), R"([{"kind":"box","center":"all","size":[30,30,50],"opacity":0.3},
                                        {"kind":"label","at":"all","text":"here"}])",
              d);
    drawing.prepare(dna, d);
    const int scenes = drawing.counts().scenes;
    const Picture boxed = drawing.draw(canvas);
    EXPECT_NE(boxed.rgba, plain.rgba);
    EXPECT_EQ(drawing.words.labels.size(), 1u);
    setOption(option("primitives"), R"([{"kind":"sphere","center":"all","radius":12}])", d);
    drawing.prepare(dna, d);
    EXPECT_EQ(drawing.counts().scenes, scenes) << "the molecule stays as it is";
    EXPECT_NE(drawing.draw(canvas).rgba, boxed.rgba);

    Drawing alone;
    PictureDescription empty = d;
    option("primitives").value.parse("", empty);
    setOption(option("primitives"), R"([{"kind":"sphere","center":[100,0,0],"radius":5}])", empty);
    alone.prepare(Molecule(), empty);
    EXPECT_NEAR(alone.settings.view.radius, 5, 1e-9);
    const Picture ball = alone.draw(canvas);
    const std::size_t middle = 4 * (32 * 64 + 32);
    EXPECT_NE(ball.rgba[middle], ball.rgba[0]) << "the view is of the ball";
}

}  // namespace
}  // namespace nacre::app
