#include "app/annotation/layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <tuple>

#include "app/annotation/painter.h"
#include "app/annotation/visual_text.h"
#include "engine/molecule/read.h"
#include "engine/scene/palettes.h"
#include "tests/support/color_difference.h"

namespace nacre::app {
namespace {

constexpr std::array<float, 4> kWhite{1, 1, 1, 1}, kBlack{0, 0, 0, 1}, kNothing{0, 0, 0, 0};

View square(std::uint32_t side) { return viewOf(Camera{}, 10, side, side); }

double widthOf(const std::string& text, double size) { return 0.6 * size * static_cast<double>(text.size()); }

struct Box {
    double left, top, right, bottom;
};
Box boxOf(const TextMark& t) {
    return {t.at.x, t.at.y - 0.76 * t.size, t.at.x + widthOf(t.text, t.size), t.at.y + 0.24 * t.size};
}

double bottomOf(const Box& box, const glm::dvec2& at) {
    return glm::distance(glm::clamp(at, glm::dvec2(box.left, box.top), glm::dvec2(box.right, box.bottom)), at);
}

TEST(WordLayout, TheMoleculeStandsBesideTitleLegendAndScaleBar) {
    const std::vector<glm::dvec4> ball{{0, 0, 0, 10}};
    for (const auto& [width, height, zoom] : {std::tuple{400u, 400u, 1.0}, {600u, 300u, 1.0}, {300u, 500u, 0.9}}) {
        Camera camera;
        camera.zoom = zoom;
        const View view = viewOf(camera, 10, width, height);
        PlacedWords words;
        EXPECT_EQ(besideWords(view, words, 14, ball, zoom, widthOf).pixelsPerAngstrom, view.pixelsPerAngstrom);
        words.title = "A title that is long";
        words.scaleBar = ScaleBar::angstrom;
        words.legends = {{"all", "chain", {}, {}, 0}};
        for (int i = 0; i < 9; ++i) words.legends[0].entries.push_back({"chain " + std::to_string(i), 0xff0000ff});
        const View beside = besideWords(view, words, 14, ball, zoom, widthOf);
        EXPECT_LE(beside.pixelsPerAngstrom, view.pixelsPerAngstrom * (1 + 1e-9));
        EXPECT_GT(beside.pixelsPerAngstrom, view.pixelsPerAngstrom * 0.6);
        const glm::dvec2 at =
            glm::dvec2(width, height) / 2.0 + glm::dvec2(beside.pan.x, -beside.pan.y) * beside.pixelsPerAngstrom;
        const double radius = 10 * beside.pixelsPerAngstrom;
        EXPECT_GE(std::min(at.x, at.y), radius);
        EXPECT_LE(at.x + radius, width);
        EXPECT_LE(at.y + radius, height);
        const Marks marks = layOut(words, beside, 14, {}, kWhite, widthOf);
        for (const TextMark& text : marks.texts) EXPECT_GE(bottomOf(boxOf(text), at), radius) << text.text;
        // What goes beyond the usual size is asked for.
        camera.zoom = 2 * zoom;
        const View large = besideWords(viewOf(camera, 10, width, height), words, 14, ball, 2 * zoom, widthOf);
        EXPECT_GT(large.pixelsPerAngstrom, 1.5 * beside.pixelsPerAngstrom);
    }
    PlacedWords bar;
    bar.scaleBar = ScaleBar::nanometre;  // a corner has room for it
    const View view = square(400);
    EXPECT_EQ(besideWords(view, bar, 10, ball, 1, widthOf).pixelsPerAngstrom, view.pixelsPerAngstrom);
}

TEST(WordLayout, LabelsStandOnTheirAnchorsWhileThereIsRoomAndNeverOverlap) {
    PlacedWords words;
    words.labels = {{{0, 0, 0}, "alone", false, 1}};
    const Marks one = layOut(words, square(400), 16, {}, kWhite, widthOf);
    ASSERT_EQ(one.texts.size(), 1u);
    const Box box = boxOf(one.texts[0]);
    EXPECT_NEAR((box.left + box.right) / 2, 200, 1e-6);
    EXPECT_NEAR((box.top + box.bottom) / 2, 200, 1e-6);
    EXPECT_TRUE(one.lines.empty());
    // Twenty at nearly the same place: all are there, apart, inside, and lines lead to those that moved.
    words.labels.clear();
    for (int i = 0; i < 20; ++i)
        words.labels.push_back({{0.1 * i, 0.05 * i, 0}, "label" + std::to_string(i), true, 0.3});
    words.title = "A title";
    words.scaleBar = ScaleBar::angstrom;
    const Marks many = layOut(words, square(400), 14, {}, kWhite, widthOf);
    EXPECT_EQ(many.crowded, 0u);
    ASSERT_EQ(many.texts.size(), 22u);
    for (std::size_t i = 0; i < many.texts.size(); ++i) {
        const Box a = boxOf(many.texts[i]);
        EXPECT_TRUE(a.left >= 0 && a.top >= 0 && a.right <= 400 && a.bottom <= 400) << many.texts[i].text;
        for (std::size_t j = 0; j < i; ++j) {
            const Box b = boxOf(many.texts[j]);
            EXPECT_FALSE(a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
                << many.texts[i].text << " on " << many.texts[j].text;
        }
    }
    EXPECT_GT(many.discs.size(), 5u);
    // Where there is no room for all, none is set over another.
    for (int i = 0; i < 300; ++i) words.labels.push_back({{0, 0, 0}, "crowd", false, 1});
    EXPECT_GT(layOut(words, square(400), 14, {}, kWhite, widthOf).crowded, 50u);
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
        const Box box = boxOf(marks.texts.at(0));
        std::size_t count = 0;
        for (const glm::dvec3& place : label.named.places) {
            const glm::dvec2 at(200 + place.x * view.pixelsPerAngstrom, 200 - place.y * view.pixelsPerAngstrom);
            if (bottomOf(box, at) < 0.9 * view.pixelsPerAngstrom) ++count;
        }
        return count;
    };
    const Marks beside = layOut(words, view, 14, {}, kWhite, widthOf);
    EXPECT_EQ(covered(beside), 0u);
    EXPECT_TRUE(beside.lines.empty()) << "it is near enough";
    // A chain wears its name.
    for (glm::dvec3& place : words.labels[0].named.places) place *= 7.0;
    const Box box = boxOf(layOut(words, view, 14, {}, kWhite, widthOf).texts.at(0));
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

std::vector<std::string> textsOf(const Marks& marks) {
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
        Camera camera;
        camera.projection = projection;
        const View front = viewOf(camera, r.radius, 300, 300);
        EXPECT_EQ(textsOf(layOut(words, front, 12, {}, kWhite, widthOf)), one);
        camera.rotationDegrees = {0, 180, 0};
        EXPECT_EQ(textsOf(layOut(words, viewOf(camera, r.radius, 300, 300), 12, {}, kWhite, widthOf)), Texts{"behind"});
        camera.rotationDegrees = {0, 60, 0};
        EXPECT_EQ(textsOf(layOut(words, viewOf(camera, r.radius, 300, 300), 12, {}, kWhite, widthOf)), both);
        // What a plane cuts away hides nothing.
        Clip clip;
        clip.near = 0;
        EXPECT_EQ(textsOf(layOut(words, front, 12, {}, kWhite, widthOf, clip)), both);
    }
    const View front = viewOf(Camera{}, r.radius, 300, 300);
    Representation same;
    EXPECT_EQ(textsOf(layOut(twoInARow(same, true), front, 12, {}, kWhite, widthOf)), both);
    words.sight.reset();
    EXPECT_EQ(textsOf(layOut(words, front, 12, {}, kWhite, widthOf)), both);
    // A stick hides, and so does a mesh; a bond of its own atom does not.
    r.spheres.resize(1);
    r.sphereLooks.resize(1);
    r.cylinders = {{{-5, 0, 0}, 3, {5, 0, 0}, 0}};
    r.cylinderLooks = {{0, 0, 7, 7}};
    words.sight = std::make_shared<const LabelSight>(r);
    EXPECT_EQ(textsOf(layOut(words, front, 12, {}, kWhite, widthOf)), one);
    r.cylinderLooks = {{0, 0, 1, 1}};
    words.sight = std::make_shared<const LabelSight>(r);
    EXPECT_EQ(textsOf(layOut(words, front, 12, {}, kWhite, widthOf)), both);
    r.cylinders.clear();
    r.cylinderLooks.clear();
    appendMesh(
        {{{-9, -9, 0}, {9, -9, 0}, {0, 12, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {0, 0, 0}, {{0, 1, 2}}}, {},
        [](std::uint32_t) {
            return SphereLook{0, 9};
        },
        r);
    words.sight = std::make_shared<const LabelSight>(r);
    EXPECT_EQ(textsOf(layOut(words, front, 12, {}, kWhite, widthOf)), one);
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
            Camera camera;
            camera.rotationDegrees = {0, 3.0 * frame, 0};
            const View view = viewOf(camera, r.radius, 500, 500);
            const Marks marks = layOut(words, view, 14, {}, kWhite, widthOf, {}, remembers ? &memory : nullptr);
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
        const Marks marks = layOut(words, view, 20, {}, kWhite, widthOf);
        ASSERT_EQ(marks.texts.size(), 1u);
        EXPECT_EQ(marks.texts[0].text, text);
        const LineMark& bar = marks.lines.back();
        EXPECT_NEAR(glm::distance(bar.points[0], bar.points[1]), 2 * view.pixelsPerAngstrom, 1e-9);
    }
}

TEST(WordLayout, MeasuresJoinTheirAtomsByDashes) {
    PlacedWords words;
    words.measures = {{{{-5, 0, 0}, {5, 0, 0}}, "10.00 Å"}};
    const View view = square(400);
    const Marks marks = layOut(words, view, 16, {}, kWhite, widthOf);
    ASSERT_GT(marks.lines.size(), 5u);
    EXPECT_NEAR(marks.lines.front().points.front().x, 200 - 5 * view.pixelsPerAngstrom, 1e-6);
    for (const LineMark& dash : marks.lines) EXPECT_NEAR(dash.points[0].y, 200, 1e-6);
    ASSERT_EQ(marks.texts.size(), 1u);
    EXPECT_LT(boxOf(marks.texts[0]).bottom, 200);  // beside the line, not on it
    // Out of the picture it is not said.
    words.measures[0].points = {{500, 0, 0}, {510, 0, 0}};
    EXPECT_TRUE(layOut(words, view, 16, {}, kWhite, widthOf).texts.empty());
}

TEST(WordLayout, LegendsShowKindsAndRamps) {
    PlacedWords words;
    words.legends = {
        {"all", "chain", {{"A", packedColor(0xff0000)}, {"B", packedColor(0x00ff00)}}, Palette::automatic, 0},
        {"ligand", "b-factor", {{"10 or less", 1}, {"20", 2}, {"30", 3}}, Palette::viridis, 3}};
    const Marks marks = layOut(words, square(600), 16, {}, kWhite, widthOf);
    std::string all;
    for (const TextMark& text : marks.texts) all += text.text + "|";
    EXPECT_EQ(all, "Chain|A|B|B factor (Å²), ligand|30|20|10 or less|");
    EXPECT_EQ(marks.discs.size(), 2u);
    ASSERT_EQ(marks.ramps.size(), 3u);
    EXPECT_EQ(marks.ramps.front().colors.front(), paletteColor(Palette::viridis, 1));
    EXPECT_EQ(marks.ramps.back().colors.back(), paletteColor(Palette::viridis, 0));
    EXPECT_NEAR(marks.ramps[0].high.y, marks.ramps[1].low.y, 1e-9);
    // Behind it all, a backing.
    ASSERT_EQ(marks.backs.size(), 1u);
    for (const TextMark& text : marks.texts) {
        const Box box = boxOf(text);
        EXPECT_TRUE(box.left > marks.backs[0].low.x && box.right < marks.backs[0].high.x &&
                    box.top > marks.backs[0].low.y && box.bottom < marks.backs[0].high.y && marks.backs[0].high.x < 600)
            << text.text;
    }
    // A list that is too long says so.
    words.legends[0].entries.assign(500, {"X", 7});
    const Marks cut = layOut(words, square(600), 16, {}, kWhite, widthOf);
    EXPECT_NE(cut.texts.back().text.size(), 0u);
    bool more = false;
    for (const TextMark& text : cut.texts) more |= text.text.find(" more") != std::string::npos;
    EXPECT_TRUE(more);
}

TEST(WordLayout, InkStandsOutFromTheBackground) {
    PlacedWords words;
    words.title = "T";
    EXPECT_EQ(layOut(words, square(99), 0, {}, kWhite, widthOf).color, packedColor(0x1c1e22));
    EXPECT_EQ(layOut(words, square(99), 0, {}, kNothing, widthOf).color, packedColor(0x1c1e22));
    EXPECT_EQ(layOut(words, square(99), 0, {}, kBlack, widthOf).color, packedColor(0xf4f5f6));
    const Marks yellow = layOut(words, square(99), 0, std::array<float, 3>{1, 1, 0}, kWhite, widthOf);
    EXPECT_EQ(yellow.color, packedColor(0xffff00));
    EXPECT_EQ(yellow.halo, packedColor(0x101114));
}

Picture filled(std::uint32_t side, float value, float alpha) {
    Picture picture{side, side, {}};
    for (std::uint32_t i = 0; i < side * side; ++i)
        picture.rgba.insert(picture.rgba.end(), {value, value, value, alpha});
    return picture;
}

PlacedWords someWords() {
    PlacedWords words;
    words.title = "Cα of H_2O′";
    words.labels = {{{1, 2, 0}, "label", false, 1}};
    words.measures = {{{{-5, -3, 0}, {2, -3, 0}, {4, 0, 2}}, "99.9°"}};
    words.scaleBar = ScaleBar::angstrom;
    words.legends = {{"all", "b-factor", {{"1", 1}, {"2", 2}, {"3", 3}}, Palette::viridis, 3}};
    return words;
}

/// Sum of ink, of 1 a black pixel.
double inkOf(const Picture& picture) {
    double sum = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) sum += 1.0 - static_cast<double>(picture.rgba[i]);
    return sum;
}

TEST(WordPainter, DrawsTheSameInBandsAsAtOnce) {
    const WordPainter painter;
    const auto width = [&](const std::string& text, double size) { return painter.widthOf(text, size); };
    const Marks marks = layOut(someWords(), square(300), 18, {}, kWhite, width);
    Picture whole = filled(300, 1, 1), bands = whole;
    painter.paint(marks, whole.rgba.data(), 300, 0, 300);
    for (std::uint32_t row = 0; row < 300; row += 37)
        painter.paint(marks, bands.rgba.data() + std::size_t{row} * 1200, 300, row, std::min(37u, 300 - row));
    EXPECT_EQ(whole.rgba, bands.rgba);
    EXPECT_GT(inkOf(whole), 500);
}

TEST(WordPainter, IsSharpAtAnySize) {
    // The ink of a word grows with the square of its size, and its edges stay a pixel wide.
    const WordPainter painter;
    const auto drawn = [&](double size) {
        Picture picture = filled(1200, 1, 1);
        Marks marks;
        marks.texts = {{{20, 600}, size, "Hα"}};
        marks.haloWidth = 0;
        painter.paint(marks, picture.rgba.data(), 1200, 0, 1200);
        return picture;
    };
    const double small = inkOf(drawn(100)), large = inkOf(drawn(400));
    EXPECT_NEAR(large / small, 16, 0.8);
    std::size_t partly = 0, fully = 0;
    const Picture picture = drawn(400);
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
        partly += picture.rgba[i] > 0.01f && picture.rgba[i] < 0.99f;
        fully += picture.rgba[i] <= 0.01f;
    }
    EXPECT_LT(static_cast<double>(partly), 0.12 * static_cast<double>(fully));
}

TEST(WordPainter, LeavesRightAlphaWhereNothingWas) {
    const WordPainter painter;
    Picture over = filled(200, 1, 1), clear = filled(200, 0, 0);
    painter.paint(someWords(), square(200), 14, {}, kNothing, over);
    painter.paint(someWords(), square(200), 14, {}, kNothing, clear);
    double most = 0;
    for (std::size_t i = 0; i < clear.rgba.size(); i += 4) {
        EXPECT_LE(clear.rgba[i], clear.rgba[i + 3] + 1e-5f);
        EXPECT_LE(clear.rgba[i + 3], 1.0f + 1e-5f);
        most = std::max(most, static_cast<double>(clear.rgba[i + 3]));
    }
    EXPECT_NEAR(most, 1, 1e-3);
}

TEST(WordPainter, KnowsTheSignsOfTheField) {
    const WordPainter painter;
    const double box = painter.widthOf("\xef\xbf\xbd", 100);  // what stands for a sign that is missing
    for (const char* sign : {"α", "Ω", "′", "″", "Å", "°", "−", "→", "²", "₂"}) {
        EXPECT_GT(painter.widthOf(sign, 100), 15) << sign;
        EXPECT_LT(painter.widthOf(sign, 100), box + 5) << sign;
    }
    EXPECT_NEAR(painter.widthOf("HH", 100), 2 * painter.widthOf("H", 100), 1e-9);
    EXPECT_LT(painter.widthOf("AV", 100), painter.widthOf("A", 100) + painter.widthOf("V", 100));  // kerning
    EXPECT_EQ(painter.widthOf("", 100), 0);
}

/// What the built-in font has not comes from another, at an em's size; that is opened once, and only when needed.
TEST(WordPainter, ForeignScriptsComeFromAnotherFont) {
    std::vector<std::vector<char32_t>> asked;
    const WordPainter painter([&](const std::vector<char32_t>& characters) {
        asked.push_back(characters);
        return systemFontWith(characters);
    });
    const auto drawn = [&](const WordPainter& by, const char* text) {
        Picture picture = filled(64, 1, 1);
        Marks marks;
        marks.texts = {{{8, 48}, 40, text}};
        by.paint(marks, picture.rgba.data(), 64, 0, 64);
        return picture.rgba;
    };
    const WordPainter alone(FindFont{});
    painter.widthOf("Hα′", 40);
    EXPECT_TRUE(asked.empty());
    EXPECT_EQ(drawn(alone, "蛋"), drawn(alone, "白")) << "boxes";
    EXPECT_EQ(drawn(alone, "Ab"), drawn(painter, "Ab"));
    if (!systemFontWith({U'蛋'}) || drawn(painter, "蛋") == drawn(alone, "蛋")) GTEST_SKIP() << "no Chinese font here";
    EXPECT_NE(drawn(painter, "蛋"), drawn(painter, "白"));
    EXPECT_EQ(asked.size(), 1u) << "the font that has one has the other";
    EXPECT_NEAR(painter.widthOf("蛋白", 40), 80, 1) << "each fills an em";
    EXPECT_EQ(painter.widthOf("\U0010fffd", 40), alone.widthOf("\U0010fffd", 40)) << "nobody has it";
}

TEST(WordPainter, RightToLeftRunsFromTheRight) {
    const WordPainter painter;
    const auto ink = [&](const char* text) {
        Picture picture = filled(160, 1, 1);
        Marks marks;
        marks.texts = {{{8, 90}, 40, text}};
        painter.paint(marks, picture.rgba.data(), 160, 0, 160);
        return picture.rgba;
    };
    if (visualText("\u05d0\u05d1") == "\u05d0\u05d1") GTEST_SKIP() << "built without FriBidi";
    // Alef and bet: written with marks that force the order, they look as without, the other way round.
    EXPECT_EQ(ink("\u05d0\u05d1"), ink("\u202d\u05d1\u05d0\u202c"));
    EXPECT_NE(ink("\u05d0\u05d1"), ink("\u05d1\u05d0"));
}

/// Letters on anything: at least 4.5:1 beside the halo, as WCAG 2.1 asks of text.
TEST(WordPainter, AHaloKeepsTextReadable) {
    const WordPainter painter;
    for (const float ground : {0.0f, 0.2f, 0.5f, 1.0f}) {
        Picture picture = filled(120, ground, 1);
        PlacedWords words;
        words.labels = {{{0, 0, 0}, "HHHH", false, 1}};
        painter.paint(words, square(120), 24, {}, kWhite, picture);
        double darkest = 1, lightest = 0;
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
            darkest = std::min(darkest, static_cast<double>(picture.rgba[i]));
            lightest = std::max(lightest, static_cast<double>(picture.rgba[i]));
        }
        EXPECT_GT((lightest + 0.05) / (darkest + 0.05), 4.5) << ground;
    }
}

TEST(WordPainter, ABackingKeepsLegendsReadable) {
    const WordPainter painter;
    for (const float ground : {0.0f, 0.2f, 0.5f, 1.0f}) {
        Picture picture = filled(300, ground, 1);
        PlacedWords words;
        words.legends = {{"all", "chain", {{"A", packedColor(0xff0000)}}, Palette::automatic, 0}};
        const Marks marks = painter.layOut(words, square(300), 20, {}, kWhite);
        painter.paint(words, square(300), 20, {}, kWhite, picture);
        ASSERT_EQ(marks.backs.size(), 1u);
        const auto x = static_cast<std::size_t>(marks.backs[0].low.x) + 2;
        const auto y = static_cast<std::size_t>(marks.backs[0].low.y) + 2;
        const double ink = 0.013, back = static_cast<double>(picture.rgba[4 * (300 * y + x)]);  // linear
        EXPECT_GT((back + 0.05) / (ink + 0.05), 7) << ground;
    }
}

}  // namespace
}  // namespace nacre::app
