#include "app/picture/words.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/annotation/placed_words.h"
#include "app/picture/saved_view.h"
#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "tests/support/error_text.h"

namespace nacre::app {
namespace {

struct Dna {
    Molecule molecule = sampleMolecule("dna");
    Representation scene = represent(molecule, drawnAtoms(molecule, {}), {});

    PlacedWords placed(const char* label) const {
        Words words;
        words.labels.push_back(parseLabel(label));
        return placeWords(words, molecule, scene);
    }
};

std::string catchFault(const std::function<void()>& call) {
    return test::errorText<std::exception>([&] { call(); });
}

TEST(Words, LabelsAreDividedWhereASelectionStands) {
    const Label label = parseLabel("chain A and b >= 5=x=y");
    EXPECT_EQ(label.selection.text, "chain A and b >= 5");
    EXPECT_EQ(label.text, "x=y");
    EXPECT_EQ(labelText(label), "chain A and b >= 5=x=y");
    EXPECT_EQ(parseLabel(labelText(label)), label);
    EXPECT_NE(catchFault([] { parseLabel("chain A"); }).find("SELECTION=TEXT"), std::string::npos);
    EXPECT_NE(catchFault([] { parseLabel("chain A="); }).find("no text"), std::string::npos);
    EXPECT_NE(catchFault([] { parseLabel("chian A=x"); }).find("did you mean 'chain'"), std::string::npos);
    EXPECT_NE(catchFault([] { parseLabel("all={residu}"); }).find("{residue}"), std::string::npos);
    EXPECT_NE(catchFault([] { parseLabel("all={residu}"); }).find("did you mean 'residue'"), std::string::npos);
    EXPECT_NE(catchFault([] { parseLabel("all={residue"); }).find("not closed"), std::string::npos);
}

TEST(Words, TheFinestFieldSaysWhatALabelIsFor) {
    const Dna dna;
    EXPECT_EQ(dna.placed("chain A=strand").labels.size(), 1u);
    EXPECT_EQ(dna.placed("all=strand {chain}").labels.size(), 2u);
    EXPECT_EQ(dna.placed("all=strand {chain}").labels[1].text, "strand B");
    const PlacedWords residues = dna.placed("chain A and resi 2-4={residue}{number} ({letter})");
    ASSERT_EQ(residues.labels.size(), 3u);
    EXPECT_EQ(residues.labels[0].text, "DG2 (G)");
    EXPECT_FALSE(residues.labels[0].ofAtom);
    const PlacedWords atoms = dna.placed("chain A and resi 2 and name O5'+P={element} {atom} {id}");
    ASSERT_EQ(atoms.labels.size(), 2u);
    EXPECT_EQ(dna.placed("id 7={element}_{id}^{{number}+}").labels.at(0).text.substr(1), "_{7}^{1+}");
    EXPECT_EQ(atoms.labels[1].text.substr(0, 8), "O O5′ ");  // a prime, of three bytes
    EXPECT_TRUE(atoms.labels[0].ofAtom);
    // It stands at the middle of what it names.
    glm::dvec3 middle(0);
    for (const Atom& atom : dna.molecule.atoms) middle += glm::dvec3(atom.position);
    middle = middle / static_cast<double>(dna.molecule.atoms.size()) - dna.scene.center;
    EXPECT_NEAR(glm::distance(dna.placed("all=DNA").labels[0].at, middle), 0, 1e-3);
}

TEST(Words, AtomsDrawnAsLinesAreLabelledAndMeasured) {
    Molecule molecule = sampleMolecule("dna");
    RepresentationOptions lines{.style = Style::line};
    const Representation scene = represent(molecule, drawnAtoms(molecule, {}), lines);
    Words words;
    words.labels.push_back(parseLabel("chain A and resi 2 and name P={atom}"));
    words.measures.push_back(parseMeasure("chain A and resi 2 and name P, chain A and resi 3 and name P"));
    const PlacedWords placed = placeWords(words, molecule, scene);
    ASSERT_EQ(placed.labels.size(), 1u);
    const std::vector<bool> phosphorus = selectAtoms(molecule, words.labels[0].selection);
    const auto atom = std::find(phosphorus.begin(), phosphorus.end(), true) - phosphorus.begin();
    const glm::dvec3 place(molecule.atoms[static_cast<std::size_t>(atom)].position);
    EXPECT_LT(glm::distance(placed.labels[0].at + scene.center, place), 1e-4);
    EXPECT_EQ(placed.measures.size(), 1u);
}

TEST(Words, WhatCannotBeSaidIsAnError) {
    const Dna dna;
    EXPECT_EQ(catchFault([&] { dna.placed("resn XYZ=x"); }), "cannot label: resn XYZ: the molecule has no such atoms");
    EXPECT_NE(catchFault([&] { dna.placed("all={atom}"); }).find("more than the limit of 400"), std::string::npos);
    Words words;
    words.measures.push_back(parseMeasure("resi 3,id 5"));
    EXPECT_NE(catchFault([&] { placeWords(words, dna.molecule, dna.scene); }).find("where one is needed"),
              std::string::npos);
    words.measures = {parseMeasure("id 5,5")};
    EXPECT_EQ(catchFault([&] { placeWords(words, dna.molecule, dna.scene); }),
              "cannot measure: id 5: it is the same atom as the one before");
    EXPECT_NE(catchFault([] { parseMeasure("id 5"); }).find("two atoms"), std::string::npos);
    EXPECT_NE(catchFault([] { parseMeasure("1,2,3,4,5"); }).find("two atoms"), std::string::npos);
    EXPECT_NE(catchFault([] { parseMeasure("1,,3"); }), "");
    EXPECT_NE(catchFault([] { parseScaleBar("inch"); }).find("angstrom"), std::string::npos);
}

TEST(Words, MeasuresAreThoseOfTheWindow) {
    const Dna dna;
    Words words;
    for (const char* text :
         {"1,2", "1,2,3", "1,2,3,4", "chain A and resi 1 and name C1',chain B and resi 24 and name C1'"})
        words.measures.push_back(parseMeasure(text));
    const PlacedWords placed = placeWords(words, dna.molecule, dna.scene);
    ASSERT_EQ(placed.measures.size(), 4u);
    char distance[32];
    std::snprintf(distance, sizeof distance, "%.2f Å",
                  static_cast<double>(glm::distance(dna.molecule.atoms[0].position, dna.molecule.atoms[1].position)));
    EXPECT_EQ(placed.measures[0].text, distance);
    EXPECT_NE(placed.measures[1].text.find("°"), std::string::npos);
    EXPECT_EQ(placed.measures[2].points.size(), 4u);
    EXPECT_EQ(placed.measures[3].of, words.measures[3].text);
    EXPECT_EQ(placed.measures[3].atoms, "DC 1 C1' to DG 24 C1'");
}

TEST(Words, MarkupRaisesAndLowers) {
    using Runs = std::vector<TextRun>;
    EXPECT_EQ(parseMarkup("H_2O"), (Runs{{"H", 0}, {"2", -1}, {"O", 0}}));
    EXPECT_EQ(parseMarkup("Ca^{2+}"), (Runs{{"Ca", 0}, {"2+", 1}}));
    EXPECT_EQ(parseMarkup("\\alpha-helix \\AA"), (Runs{{"α-helix Å", 0}}));
    EXPECT_EQ(parseMarkup("C\\alphaH of \\eta x"), (Runs{{"CαH of η x", 0}}));
    EXPECT_EQ(parseMarkup("a\\_b\\\\"), (Runs{{"a_b\\", 0}}));
    EXPECT_EQ(parseMarkup("x_β"), (Runs{{"x", 0}, {"β", -1}}));
    EXPECT_NE(catchFault([] { parseMarkup("a_"); }), "");
    EXPECT_NE(catchFault([] { parseMarkup("a_{b"); }), "");
    EXPECT_NE(catchFault([] { parseMarkup("\\alhpa"); }).find("'alpha'"), std::string::npos);
}

TEST(Words, TravelInASavedView) {
    PictureDescription view;
    view.words.labels = {parseLabel("chain A={residue}_{x}")};
    view.words.measures = {parseMeasure("3,7"), parseMeasure("id 1,id 2,id 3")};
    view.words.title = "B-DNA";
    view.words.scaleBar = ScaleBar::nanometre;
    view.words.legend = true;
    view.words.size = 31.5;
    view.words.color = std::array<float, 3>{1, 0, 0};
    view.look.palette = Palette::muted;
    const PictureDescription back = parseSavedView(savedViewJson(view), "v");
    EXPECT_EQ(back.words, view.words);
    EXPECT_EQ(back.look.palette, Palette::muted);
    EXPECT_THROW(parseSavedView(R"({"labels": ["all={foo}"]})", "v"), Error);
    EXPECT_THROW(parseSavedView(R"({"labels": "all=x"})", "v"), Error);
    EXPECT_EQ(savedViewJson({}).find("title"), std::string::npos);
}

}  // namespace
}  // namespace nacre::app
