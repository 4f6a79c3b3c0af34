#include <gtest/gtest.h>

#include "app/viewer/loader.h"
#include "app/viewer/presets.h"
#include "tests/molecule/build_molecule.h"
#include "tests/molecule/build_peptide.h"

namespace nacre::app {
namespace {

TEST(FirstLook, LargeProteinsAreCartoons) {
    SavedView view;
    firstLook(test::chainOf(201, -57, -47), view);
    EXPECT_EQ(view.look.style, Style::cartoon);
    EXPECT_EQ(view.look.color, Coloring(ColorScheme::chainCarbons));
    SavedView small;
    firstLook(test::chainOf(200, -57, -47), small);
    EXPECT_EQ(small.look, RepresentationOptions());
}

TEST(FirstLook, PredictionsShowTheirConfidence) {
    Molecule molecule = test::chainOf(20, -57, -47);
    molecule.file.confidence = true;
    SavedView view;
    firstLook(molecule, view);
    EXPECT_EQ(view.look.style, Style::cartoon);
    EXPECT_EQ(view.look.color, Coloring(ColorScheme::plddt));
    Molecule ligand = test::MoleculeText().residue("LIG").atom("C", "C", {}).molecule;
    ligand.file.confidence = true;
    SavedView other;
    firstLook(ligand, other);
    EXPECT_EQ(other.look, RepresentationOptions());
}

TEST(FirstLook, WhatWasAskedForStays) {
    const Molecule protein = test::chainOf(300, -57, -47);
    SavedView styled, colored, ruled;
    styled.look.style = Style::licorice;
    colored.look.color = ColorScheme::chain;
    ruled.look.rules.push_back({Rule::Action::hide, parseSelection("resi 5"), {}, {}});
    for (SavedView view : {styled, colored, ruled}) {
        const RepresentationOptions before = view.look;
        firstLook(protein, view);
        EXPECT_EQ(view.look, before);
    }
}

TEST(FirstLook, IsOfWhatIsOpenedNotOfWhatIsReadAgain) {
    const Sources sources{[](const SavedView&) { return test::chainOf(300, -57, -47); },
                          [](const Molecule&, const SavedView&) { return Representation(); }};
    Loader loader(sources, {});
    SavedView view;
    view.input = "protein.pdb";
    loader.open(view);
    loader.wait();
    EXPECT_EQ(loader.take().value().view.look.style, Style::cartoon);
    loader.read(view);
    loader.wait();
    EXPECT_FALSE(loader.take().value().view.look.style);
}

}  // namespace
}  // namespace nacre::app
