#include "app/annotation/layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <tuple>

#include "engine/molecule/read.h"
#include "engine/scene/color/palettes.h"
#include "tests/annotation/paper.h"

namespace nacre::app {
namespace {

constexpr std::array<float, 4> kBlack{0, 0, 0, 1};

struct Box {
    double left, top, right, bottom;
};
Box markBox(const TextMark& t) {
    return {t.at.x, t.at.y - 0.76 * t.size, t.at.x + measureWidth(t.text, t.size), t.at.y + 0.24 * t.size};
}

double distanceTo(const Box& box, const glm::dvec2& at) {
    return glm::distance(glm::clamp(at, glm::dvec2(box.left, box.top), glm::dvec2(box.right, box.bottom)), at);
}

TEST(WordLayout, TheMoleculeStandsBesideTitleLegendAndScaleBar) {
    const std::vector<glm::dvec4> ball{{0, 0, 0, 10}};
    for (const auto& [width, height, zoom] : {std::tuple{400u, 400u, 1.0}, {600u, 300u, 1.0}, {300u, 500u, 0.9}}) {
        Camera camera{.zoom = zoom};
        const View view = makeView(camera, 10, width, height);
        PlacedWords words;
        EXPECT_EQ(besideWords(view, words, 14, ball, zoom, measureWidth).pixelsPerAngstrom, view.pixelsPerAngstrom);
        words.title = "A title that is long";
        words.scaleBar = ScaleBar::angstrom;
        words.legends = {{"all", "chain", {}, {}, 0}};
        for (int i = 0; i < 9; ++i) words.legends[0].entries.push_back({"chain " + std::to_string(i), 0xff0000ff});
        const View beside = besideWords(view, words, 14, ball, zoom, measureWidth);
        EXPECT_LE(beside.pixelsPerAngstrom, view.pixelsPerAngstrom * (1 + 1e-9));
        EXPECT_GT(beside.pixelsPerAngstrom, view.pixelsPerAngstrom * 0.6);
        const glm::dvec2 at =
            glm::dvec2(width, height) / 2.0 + glm::dvec2(beside.pan.x, -beside.pan.y) * beside.pixelsPerAngstrom;
        const double radius = 10 * beside.pixelsPerAngstrom;
        EXPECT_GE(std::min(at.x, at.y), radius);
        EXPECT_LE(at.x + radius, width);
        EXPECT_LE(at.y + radius, height);
        const Marks marks = layOut(words, beside, 14, {}, kWhite, measureWidth);
        for (const TextMark& text : marks.texts) EXPECT_GE(distanceTo(markBox(text), at), radius) << text.text;
        // What goes beyond the usual size is asked for.
        camera.zoom = 2 * zoom;
        const View large = besideWords(makeView(camera, 10, width, height), words, 14, ball, 2 * zoom, measureWidth);
        EXPECT_GT(large.pixelsPerAngstrom, 1.5 * beside.pixelsPerAngstrom);
    }
    PlacedWords bar;
    bar.scaleBar = ScaleBar::nanometre;  // a corner has room for it
    const View view = square(400);
    EXPECT_EQ(besideWords(view, bar, 10, ball, 1, measureWidth).pixelsPerAngstrom, view.pixelsPerAngstrom);
}

TEST(WordLayout, LabelsStandOnTheirAnchorsWhileThereIsRoomAndNeverOverlap) {
    PlacedWords words;
    words.labels = {{{0, 0, 0}, "alone", false, 1}};
    const Marks one = layOut(words, square(400), 16, {}, kWhite, measureWidth);
    ASSERT_EQ(one.texts.size(), 1u);
    const Box box = markBox(one.texts[0]);
    EXPECT_NEAR((box.left + box.right) / 2, 200, 1e-6);
    EXPECT_NEAR((box.top + box.bottom) / 2, 200, 1e-6);
    EXPECT_TRUE(one.lines.empty());
    // Twenty at nearly the same place: all are there, apart, inside, and lines lead to those that moved.
    words.labels.clear();
    for (int i = 0; i < 20; ++i)
        words.labels.push_back({{0.1 * i, 0.05 * i, 0}, "label" + std::to_string(i), true, 0.3});
    words.title = "A title";
    words.scaleBar = ScaleBar::angstrom;
    const Marks many = layOut(words, square(400), 14, {}, kWhite, measureWidth);
    EXPECT_EQ(many.crowded, 0u);
    ASSERT_EQ(many.texts.size(), 22u);
    for (std::size_t i = 0; i < many.texts.size(); ++i) {
        const Box a = markBox(many.texts[i]);
        EXPECT_TRUE(a.left >= 0 && a.top >= 0 && a.right <= 400 && a.bottom <= 400) << many.texts[i].text;
        for (std::size_t j = 0; j < i; ++j) {
            const Box b = markBox(many.texts[j]);
            EXPECT_FALSE(a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
                << many.texts[i].text << " on " << many.texts[j].text;
        }
    }
    EXPECT_GT(many.discs.size(), 5u);
    // Where there is no room for all, none is set over another.
    for (int i = 0; i < 300; ++i) words.labels.push_back({{0, 0, 0}, "crowd", false, 1});
    EXPECT_GT(layOut(words, square(400), 14, {}, kWhite, measureWidth).crowded, 50u);
}

TEST(WordLayout, LabelsInSpaceAreClipped) {
    PlacedWords words;
    words.labels = {{{-3, 0, 4}, "near", false, 0}, {{3, 0, -4}, "far", false, 0}, {{0, 3, -4}, "atom", true, 0.3}};
    words.labels[0].size = words.labels[1].size = 1;
    const auto shown = [&](const Clip& clip) {
        std::string texts;
        for (const TextMark& text : layOut(words, square(400), 14, {}, kWhite, measureWidth, clip).texts)
            texts += text.text + " ";
        return texts;
    };
    EXPECT_EQ(shown({}).size(), std::string("near far atom ").size());
    EXPECT_EQ(shown({-5, 0}).find("far"), std::string::npos);
    EXPECT_NE(shown({-5, 0}).find("near"), std::string::npos);
    EXPECT_EQ(shown({0, 5}).find("near"), std::string::npos);
    EXPECT_NE(shown({0, 1}).find("atom"), std::string::npos);
}

TEST(WordLayout, LabelsInSpaceHaveASideABackgroundAndATether) {
    PlacedWords words;
    words.labels = {{{0, 0, 0}, "name", false, 0}};
    words.labels[0].size = 1;
    const double em = square(400).pixelsPerAngstrom;
    const auto laidOut = [&](const Primitives::LabelPlate& plate) {
        words.labels[0].plate = plate;
        return layOut(words, square(400), 14, {}, kWhite, measureWidth);
    };
    const auto lowest = [](const PlateMark& mark, std::size_t part) {
        return std::ranges::max(mark.parts.at(part), {}, &glm::dvec2::y).y;
    };
    EXPECT_TRUE(laidOut({}).plates.empty());
    const Marks centred = laidOut({.tether = 2, .color = 7, .background = true});
    ASSERT_EQ(centred.plates.size(), 1u);
    EXPECT_EQ(centred.plates[0].color, 7u);
    ASSERT_EQ(centred.plates[0].parts.size(), 1u) << "no wedge to a label on its point";
    EXPECT_NEAR(lowest(centred.plates[0], 0), 200 + 0.8 * em, 1e-6);
    const Box middle = markBox(centred.texts.at(0));
    EXPECT_NEAR((middle.left + middle.right) / 2, 200, 1e-6);
    // Beside the point, to the right; and above, two em away.
    EXPECT_NEAR(markBox(laidOut({.side = {1, 0}}).texts.at(0)).left, 200, 1e-6);
    const Marks above = laidOut({.side = {0, 1}, .tether = 2, .background = true});
    ASSERT_EQ(above.plates.at(0).parts.size(), 2u);
    EXPECT_NEAR(lowest(above.plates[0], 0), 200 - 2 * em, 1e-6);
    EXPECT_NEAR(lowest(above.plates[0], 1), 200, 1e-6) << "the wedge ends at the point";
    const Marks corner = laidOut({.side = {-1, -1}, .tether = 2});
    ASSERT_EQ(corner.plates.at(0).parts.size(), 2u) << "two halves of a wedge, without a background";
    EXPECT_NEAR(markBox(corner.texts.at(0)).right, 200 - 1.3 * em, 1e-6);
    words.labels.push_back(words.labels[0]);
    words.labels[1].at.z = 5;  // nearer
    words.labels[1].plate.color = 9;
    EXPECT_EQ(laidOut({.color = 7, .background = true}).plates.at(1).color, 9u);
}

TEST(WordLayout, LabelsOfGroupsStandBesideTheirAtoms) {
    PlacedWords words;
    PlacedLabel label{{0, 0, 0}, "ligand", false, 1};
    for (int i = 0; i < 6; ++i) {
        label.named.places.emplace_back(std::cos(i * 1.047), std::sin(i * 1.047), 0);
        label.named.radii.push_back(0.9);
    }
    words.labels = {label};
    const View view = square(400);
    const auto covered = [&](const Marks& marks) {
        const Box box = markBox(marks.texts.at(0));
        std::size_t count = 0;
        for (const glm::dvec3& place : label.named.places) {
            const glm::dvec2 at(200 + place.x * view.pixelsPerAngstrom, 200 - place.y * view.pixelsPerAngstrom);
            if (distanceTo(box, at) < 0.9 * view.pixelsPerAngstrom) ++count;
        }
        return count;
    };
    const Marks beside = layOut(words, view, 14, {}, kWhite, measureWidth);
    EXPECT_EQ(covered(beside), 0u);
    EXPECT_TRUE(beside.lines.empty()) << "it is near enough";
    // A chain wears its name.
    for (glm::dvec3& place : words.labels[0].named.places) place *= 7.0;
    const Box box = markBox(layOut(words, view, 14, {}, kWhite, measureWidth).texts.at(0));
    EXPECT_NEAR((box.left + box.right) / 2, 200, 1e-6);
}

TEST(LabelSights, OfVeryManyCopiesAreNotTaken) {
    const Molecule m = sampleMolecule("glucose");
    Representation r = represent(m, std::vector<std::uint32_t>{0}, {Style::spacefill, ColorScheme::element});
    Words words;
    words.labels = {parseLabel("id 1=one")};
    words.seenOnly = true;
    r.copies.transforms = {glm::dmat4x3(1.0)};
    r.copies.lists = {{0}};
    r.copies.spheres = {{0, 1, 0, {}, 2}};
    EXPECT_NE(placeWords(words, m, r).sight, nullptr);
    r.copies.lists[0].resize((1 << 25) + 1);
    EXPECT_EQ(placeWords(words, m, r).sight, nullptr);
}

/// Two balls in a row to the viewer, with their labels.
PlacedWords twoInARow(Representation& r, bool oneResidue = false) {
    Molecule m = sampleMolecule("glucose");
    m.atoms.resize(2);
    m.bonds.clear();
    m.residues.push_back(m.residues[0]);
    m.residues[0].atomCount = m.residues[1].atomCount = 1;
    m.residues[1].firstAtom = m.atoms[1].residue = 1;
    if (oneResidue) {
        m.residues.resize(1);
        m.residues[0].atomCount = 2;
        m.atoms[1].residue = 0;
    }
    m.atoms[0].position = {0, 0, -4};
    m.atoms[1].position = {0, 0, 4};
    r = represent(m, std::vector<std::uint32_t>{0, 1}, {Style::spacefill, ColorScheme::element});
    Words words;
    words.labels = {parseLabel("id 1=behind"), parseLabel("id 2=before")};
    words.seenOnly = true;
    return placeWords(words, m, r);
}

std::vector<std::string> listTexts(const Marks& marks) {
    std::vector<std::string> texts;
    for (const TextMark& text : marks.texts) texts.push_back(text.text);
    std::sort(texts.begin(), texts.end());
    return texts;
}

TEST(WordLayout, LabelsOfWhatLiesBehindAtomsAreLeftOut) {
    using Texts = std::vector<std::string>;
    const Texts one{"before"}, both{"before", "behind"};
    Representation r;
    PlacedWords words = twoInARow(r);
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        Camera camera{.projection = projection};
        const View front = makeView(camera, r.radius, 300, 300);
        EXPECT_EQ(listTexts(layOut(words, front, 12, {}, kWhite, measureWidth)), one);
        camera.rotationDegrees = {0, 180, 0};
        EXPECT_EQ(listTexts(layOut(words, makeView(camera, r.radius, 300, 300), 12, {}, kWhite, measureWidth)),
                  Texts{"behind"});
        camera.rotationDegrees = {0, 60, 0};
        EXPECT_EQ(listTexts(layOut(words, makeView(camera, r.radius, 300, 300), 12, {}, kWhite, measureWidth)), both);
        // What a plane cuts away hides nothing.
        EXPECT_EQ(listTexts(layOut(words, front, 12, {}, kWhite, measureWidth, Clip{.near = 0})), both);
    }
    const View front = makeView(Camera{}, r.radius, 300, 300);
    Representation same;
    EXPECT_EQ(listTexts(layOut(twoInARow(same, true), front, 12, {}, kWhite, measureWidth)), both);
    words.sight.reset();
    EXPECT_EQ(listTexts(layOut(words, front, 12, {}, kWhite, measureWidth)), both);
    // A stick hides, and so does a mesh; a bond of its own atom does not.
    r.spheres.resize(1);
    r.sphereLooks.resize(1);
    r.cylinders = {{{-5, 0, 0}, 3, {5, 0, 0}, 0}};
    r.cylinderLooks = {{0, 0, 7, 7}};
    words.sight = std::make_shared<const LabelSight>(r);
    EXPECT_EQ(listTexts(layOut(words, front, 12, {}, kWhite, measureWidth)), one);
    r.cylinderLooks = {{0, 0, 1, 1}};
    words.sight = std::make_shared<const LabelSight>(r);
    EXPECT_EQ(listTexts(layOut(words, front, 12, {}, kWhite, measureWidth)), both);
    r.cylinders.clear();
    r.cylinderLooks.clear();
    appendMesh(
        {{{-9, -9, 0}, {9, -9, 0}, {0, 12, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {0, 0, 0}, {{0, 1, 2}}}, {},
        [](std::uint32_t) {
            return SphereLook{0, 9};
        },
        r);
    words.sight = std::make_shared<const LabelSight>(r);
    EXPECT_EQ(listTexts(layOut(words, front, 12, {}, kWhite, measureWidth)), one);
}

TEST(WordLayout, LabelsStayWithWhatTheyNameFromPictureToPicture) {
    const Molecule m = sampleMolecule("dna");
    std::vector<std::uint32_t> atoms(m.atoms.size());
    std::iota(atoms.begin(), atoms.end(), 0u);
    const Representation r = represent(m, atoms, {Style::spacefill, ColorScheme::element});
    Words asked;
    asked.labels = {parseLabel("name P={residue}{number}")};
    const PlacedWords words = placeWords(asked, m, r);
    // Of how many labels the place beside what they name changed by more than two ems, over a turn.
    const auto jumps = [&](bool remembers) {
        WordMemory memory;
        std::map<std::string, glm::dvec2> before;
        int count = 0;
        for (int frame = 0; frame < 120; ++frame) {
            const View view = makeView(Camera{.rotationDegrees = {0, 3.0 * frame, 0}}, r.radius, 500, 500);
            const Marks marks = layOut(words, view, 14, {}, kWhite, measureWidth, {}, remembers ? &memory : nullptr);
            std::map<std::string, glm::dvec2> now;
            for (const PlacedLabel& label : words.labels) {
                const glm::dvec3 v = view.rotation * label.at;
                const glm::dvec2 anchor(250 + v.x * view.pixelsPerAngstrom, 250 - v.y * view.pixelsPerAngstrom);
                for (const TextMark& text : marks.texts)
                    if (text.text == label.text) now[label.text] = text.at - anchor;
            }
            for (const auto& [text, at] : now) count += before.contains(text) && glm::distance(at, before[text]) > 28;
            before = std::move(now);
        }
        return count;
    };
    const int alone = jumps(false), remembered = jumps(true);
    EXPECT_GT(alone, 30);
    EXPECT_LE(remembered * 5, alone) << remembered << " and " << alone;
}

TEST(WordLayout, TheScaleBarIsAsLongAsItSays) {
    PlacedWords words;
    for (const auto& [unit, text] : {std::pair(ScaleBar::angstrom, "2 Å"), std::pair(ScaleBar::nanometre, "0.2 nm")}) {
        words.scaleBar = unit;
        const View view = square(800);
        const Marks marks = layOut(words, view, 20, {}, kWhite, measureWidth);
        ASSERT_EQ(marks.texts.size(), 1u);
        EXPECT_EQ(marks.texts[0].text, text);
        const LineMark& bar = marks.lines.back();
        EXPECT_NEAR(glm::distance(bar.points[0], bar.points[1]), 2 * view.pixelsPerAngstrom, 1e-9);
    }
}

/// Where a mark of one letter stands: its middle, from the middle of the cross, y up.
glm::dvec2 findLetter(const Marks& marks, const char* name, const glm::dvec2& middle) {
    for (const TextMark& text : marks.texts)
        if (text.text == name)
            return (text.at + glm::dvec2(measureWidth(name, text.size) / 2, -0.27 * text.size) - middle) *
                   glm::dvec2(1, -1);
    ADD_FAILURE() << name;
    return {};
}

TEST(WordLayout, TheAxesTurnWithTheView) {
    PlacedWords words;
    words.axes = makeAxes({});
    constexpr double kEm = 20;
    glm::dvec2 middle(0);
    const auto laid = [&](const glm::dvec3& degrees) {
        Camera camera{.rotationDegrees = degrees};
        const Marks marks = layOut(words, makeView(camera, 10, 600, 400), kEm, {}, kWhite, measureWidth);
        EXPECT_EQ(marks.texts.size(), 3u);
        EXPECT_EQ(marks.shapes.size(), 6u);  // a shaft and a head each
        for (const ShapeMark& shape : marks.shapes)
            for (const glm::dvec2& corner : shape.corners) {
                EXPECT_TRUE(corner.x > 0 && corner.y < 400);
                EXPECT_LT(glm::distance(corner, glm::dvec2(0, 400)), 0.45 * 400);
            }
        return marks;
    };
    // The shaft of an axis towards the viewer is a circle about the middle.
    const Marks straight = laid({0, 0, 0});
    EXPECT_EQ(straight.shapes.back().color, kAxisColors[2]) << "z is in front";
    for (const glm::dvec2& corner : straight.shapes.back().corners)
        middle += corner / static_cast<double>(straight.shapes.back().corners.size());
    EXPECT_GT(findLetter(straight, "x", middle).x, 2 * kEm);
    EXPECT_NEAR(findLetter(straight, "x", middle).y, 0, 0.3 * kEm);
    EXPECT_GT(findLetter(straight, "y", middle).y, 2 * kEm);
    EXPECT_NEAR(findLetter(straight, "y", middle).x, 0, 0.3 * kEm);
    EXPECT_LT(glm::length(findLetter(straight, "z", middle)), kEm);
    // A quarter turn about y, right-handed: z to the right, x away from the viewer.
    const Marks turned = laid({0, 90, 0});
    EXPECT_GT(findLetter(turned, "z", middle).x, 2 * kEm);
    EXPECT_GT(findLetter(turned, "y", middle).y, 2 * kEm);
    EXPECT_LT(glm::length(findLetter(turned, "x", middle)), kEm);
    EXPECT_EQ(turned.shapes.front().color, kAxisColors[0]) << "x is behind";
    // The molecule finds the same room from any side.
    const std::vector<glm::dvec4> ball{{0, 0, 0, 10}};
    std::optional<glm::dvec2> pan;
    for (int i = 0; i < 50; ++i) {
        const View view = makeView(Camera{.rotationDegrees = {37.0 * i, 61.0 * i, 11.0 * i}}, 10, 400, 400);
        const View beside = besideWords(view, words, kEm, ball, 1, measureWidth);
        EXPECT_NEAR(glm::distance(pan.value_or(beside.pan), beside.pan), 0, 1e-6);
        pan = beside.pan;
    }
}

TEST(WordLayout, TheAxesOfACellFollowItsEdges) {
    // A monoclinic cell, beta 120 degrees: c leans back over a.
    const std::array<glm::dvec3, 3> cell{glm::dvec3(5, 0, 0), {0, 9, 0}, {-4, 0, 4 * std::sqrt(3.0)}};
    const std::vector<PlacedAxis> axes = makeAxes(cell);
    ASSERT_EQ(axes.size(), 3u);
    EXPECT_EQ(axes[0].name + axes[1].name + axes[2].name, "abc");
    EXPECT_NEAR(glm::dot(axes[0].way, axes[2].way), -0.5, 1e-12);
    for (const PlacedAxis& axis : axes) EXPECT_NEAR(glm::length(axis.way), 1, 1e-12);
}

TEST(WordLayout, MeasuresJoinTheirAtomsByDashes) {
    PlacedWords words;
    words.measures = {{{{-5, 0, 0}, {5, 0, 0}}, "10.00 Å"}};
    const View view = square(400);
    const Marks marks = layOut(words, view, 16, {}, kWhite, measureWidth);
    ASSERT_GT(marks.lines.size(), 5u);
    EXPECT_NEAR(marks.lines.front().points.front().x, 200 - 5 * view.pixelsPerAngstrom, 1e-6);
    for (const LineMark& dash : marks.lines) EXPECT_NEAR(dash.points[0].y, 200, 1e-6);
    ASSERT_EQ(marks.texts.size(), 1u);
    EXPECT_LT(markBox(marks.texts[0]).bottom, 200);  // beside the line, not on it
    // Out of the picture it is not said.
    words.measures[0].points = {{500, 0, 0}, {510, 0, 0}};
    EXPECT_TRUE(layOut(words, view, 16, {}, kWhite, measureWidth).texts.empty());
}

TEST(WordLayout, LegendsNamePartsInWords) {
    PlacedWords words;
    words.legends = {{"all", "#bec4c8", {{"#bec4c8", packedColor(0xbec4c8)}}, Palette::automatic, 0},
                     {"byres (within 4 of (mainligand))", "element", {{"C", 1}}, Palette::automatic, 0}};
    std::string all;
    for (const TextMark& text : layOut(words, square(600), 16, {}, kWhite, measureWidth).texts) all += text.text + "|";
    EXPECT_EQ(all, "Element, residues within 4 Å of the ligand|C|");
}

TEST(WordLayout, LegendsShowKindsAndRamps) {
    PlacedWords words;
    words.legends = {
        {"all", "chain", {{"A", packedColor(0xff0000)}, {"B", packedColor(0x00ff00)}}, Palette::automatic, 0},
        {"ligand", "b-factor", {{"10 or less", 1}, {"20", 2}, {"30", 3}}, Palette::viridis, 3}};
    const Marks marks = layOut(words, square(600), 16, {}, kWhite, measureWidth);
    std::string all;
    for (const TextMark& text : marks.texts) all += text.text + "|";
    EXPECT_EQ(all, "Chain|A|B|B factor (Å²), ligand|30|10 or less|");
    EXPECT_EQ(marks.discs.size(), 2u);
    ASSERT_EQ(marks.ramps.size(), 3u);
    EXPECT_EQ(marks.ramps.front().colors.front(), paletteColor(Palette::viridis, 1));
    EXPECT_EQ(marks.ramps.back().colors.back(), paletteColor(Palette::viridis, 0));
    EXPECT_NEAR(marks.ramps[0].high.y, marks.ramps[1].low.y, 1e-9);
    // Behind it all, a backing.
    ASSERT_EQ(marks.backs.size(), 1u);
    for (const TextMark& text : marks.texts) {
        const Box box = markBox(text);
        EXPECT_TRUE(box.left > marks.backs[0].low.x && box.right < marks.backs[0].high.x &&
                    box.top > marks.backs[0].low.y && box.bottom < marks.backs[0].high.y && marks.backs[0].high.x < 600)
            << text.text;
    }
    // A list that is too long says so.
    words.legends[0].entries.assign(500, {"X", 7});
    const Marks cut = layOut(words, square(600), 16, {}, kWhite, measureWidth);
    EXPECT_NE(cut.texts.back().text.size(), 0u);
    bool more = false;
    for (const TextMark& text : cut.texts) more |= text.text.find(" more") != std::string::npos;
    EXPECT_TRUE(more);
}

TEST(WordLayout, PaleDiscsOfALegendHaveABorder) {
    PlacedWords words;
    words.legends = {{"all",
                      "chain",
                      {{"A", packedColor(0xf4f4e6)}, {"B", packedColor(0x2060a0)}, {"C", packedColor(0x0a0a0a)}},
                      Palette::automatic,
                      0}};
    for (const bool dark : {false, true}) {
        const Marks marks = layOut(words, square(600), 16, {}, dark ? kBlack : kWhite, measureWidth);
        ASSERT_EQ(marks.discs.size(), 3u);
        EXPECT_EQ(marks.discs[0].ring != 0, !dark);
        EXPECT_EQ(marks.discs[1].ring, 0u);
        EXPECT_EQ(marks.discs[2].ring != 0, dark);
        EXPECT_LT(marks.discs[dark ? 2 : 0].inner(), marks.discs[1].inner());
    }
}

TEST(WordLayout, LegendsOfManyClassesLeaveMostOfThePicture) {
    for (const auto& [width, height] : {std::pair{600u, 600u}, {420u, 300u}, {1000u, 700u}})
        for (const std::size_t classes : {5u, 20u, 26u, 60u, 300u}) {
            PlacedWords words;
            words.legends = {{"all", "chain", {}, {}, 0}};
            for (std::size_t i = 0; i < classes; ++i)
                words.legends[0].entries.push_back({"chain " + std::to_string(i), 0xff0000ff});
            const Marks marks = layOut(words, makeView(Camera{}, 10, width, height), 15, {}, kWhite, measureWidth);
            double left = width, low = 0;
            for (const BackMark& back : marks.backs)
                left = std::min(left, back.low.x), low = std::max(low, back.high.y);
            EXPECT_GT(left, 0.6 * width) << classes << " in " << width;
            EXPECT_LE(low, height) << classes << " in " << width;
            if (classes > 5) continue;
            EXPECT_EQ(marks.discs.size(), classes) << "all are there";
        }
    // Before one is left out, the words become smaller.
    PlacedWords words;
    words.legends = {{"all", "chain", {}, {}, 0}};
    for (std::size_t i = 0; i < 40; ++i) words.legends[0].entries.push_back({std::to_string(i), 0xff0000ff});
    const Marks marks = layOut(words, square(600), 15, {}, kWhite, measureWidth);
    EXPECT_EQ(marks.discs.size(), 40u);
    EXPECT_GE(marks.texts.front().size, 0.6 * 15);
}

TEST(WordLayout, InkStandsOutFromTheBackground) {
    PlacedWords words;
    words.title = "T";
    EXPECT_EQ(layOut(words, square(99), 0, {}, kWhite, measureWidth).color, packedColor(0x1c1e22));
    EXPECT_EQ(layOut(words, square(99), 0, {}, kNothing, measureWidth).color, packedColor(0x1c1e22));
    EXPECT_EQ(layOut(words, square(99), 0, {}, kBlack, measureWidth).color, packedColor(0xf4f5f6));
    const Marks yellow = layOut(words, square(99), 0, std::array<float, 3>{1, 1, 0}, kWhite, measureWidth);
    EXPECT_EQ(yellow.color, packedColor(0xffff00));
    EXPECT_EQ(yellow.halo, packedColor(0x101114));
}

}  // namespace
}  // namespace nacre::app
