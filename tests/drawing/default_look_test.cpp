#include "app/drawing/default_look.h"

#include <gtest/gtest.h>

#include "app/drawing/scenes.h"
#include "app/picture/options.h"
#include "tests/molecule/build_molecule.h"
#include "tests/molecule/build_peptide.h"

namespace nacre::app {
namespace {

PictureDescription pictureWith(std::initializer_list<std::pair<const char*, const char*>> options) {
    PictureDescription picture;
    for (const auto& [key, value] : options) setOption(option(key), value, picture);
    return picture;
}

/// What the picture shows of the molecule.
RepresentationOptions takenLook(const Molecule& molecule, const PictureDescription& picture) {
    RepresentationOptions look = picture.look;
    takeDefaultLook(molecule, drawnAtoms(molecule), picture, look);
    return look;
}

Molecule protein(int residues) { return test::buildChain(residues, -57, -47); }

TEST(DefaultLook, ProteinsAreCartoonsByChain) {
    const RepresentationOptions look = takenLook(protein(10), {});
    EXPECT_EQ(look.style, Style::cartoon);
    EXPECT_EQ(look.color, Coloring(ColorScheme::chainCarbons));
    EXPECT_EQ(takenLook(protein(9), {}), RepresentationOptions());  // a peptide
    EXPECT_EQ(buildScene(protein(10), {}).style, Style::cartoon);
    EXPECT_EQ(buildMovingScene(protein(10), {}).scene().style, Style::cartoon);
}

TEST(DefaultLook, AtomsWithoutBackboneAreNoCartoon) {
    test::MoleculeText text;
    for (int i = 0; i < 200; ++i) text.residue("GLY").atom("BB", "C", {4.f * static_cast<float>(i), 0, 0});
    EXPECT_EQ(takenLook(text.molecule, {}), RepresentationOptions());
}

TEST(DefaultLook, AtomsAreSeenInTheirDensity) {
    EXPECT_EQ(buildScene(protein(30), pictureWith({{"map", "a.mrc"}})).style, Style::licorice);
}

TEST(DefaultLook, PredictionsShowTheirConfidence) {
    Molecule molecule = protein(20);
    molecule.file.confidence = true;
    EXPECT_EQ(takenLook(molecule, {}).style, Style::cartoon);
    EXPECT_EQ(takenLook(molecule, {}).color, Coloring(ColorScheme::plddt));
    EXPECT_EQ(takenLook(molecule, pictureWith({{"color", "element"}})).color, Coloring(ColorScheme::element));
    Molecule ligand = test::MoleculeText().residue("LIG").atom("C", "C", {}).molecule;
    ligand.file.confidence = true;
    EXPECT_EQ(takenLook(ligand, {}), RepresentationOptions());
}

TEST(DefaultLook, StylesAndColoursThatAreGivenStay) {
    EXPECT_EQ(takenLook(protein(30), pictureWith({{"style", "licorice"}})).style, Style::licorice);
    for (const char* color : {"element", "chain"}) {
        const RepresentationOptions look = takenLook(protein(30), pictureWith({{"color", color}}));
        EXPECT_EQ(look.style, Style::cartoon);
        EXPECT_EQ(coloringText(look.color), color);
    }
}

// A line would end in the air beside a cartoon.
TEST(DefaultLook, InteractionsEndAtSticks) {
    const Molecule molecule = protein(30);
    const PictureDescription picture = pictureWith({{"interactions", "resi 15"}});
    const Representation scene = buildScene(molecule, picture);
    EXPECT_EQ(scene.style, Style::cartoon);
    EXPECT_GT(scene.cylinders.size(), buildScene(molecule, {}).cylinders.size());
}

TEST(DefaultLook, HiddenResiduesAreNotCounted) {
    EXPECT_FALSE(takenLook(protein(12), pictureWith({{"hide", "resi 1-3"}})).style);
    EXPECT_EQ(takenLook(protein(12), pictureWith({{"hide", "resi 1-2"}})).style, Style::cartoon);
}

}  // namespace
}  // namespace nacre::app
