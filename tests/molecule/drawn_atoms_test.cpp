#include "engine/molecule/drawn_atoms.h"

#include <gtest/gtest.h>

#include "engine/molecule/formats/format_table.h"
#include "tests/molecule/build_molecule.h"
#include "tests/molecule/text_file.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

using test::MoleculeText;
using Indices = std::vector<std::uint32_t>;

TEST(DrawnAtoms, LeaveOutWatersUnlessAsked) {
    MoleculeText text;
    for (const char* name : {"ALA", "HOH", "WAT", "H2O", "DOD", "SOL", "TIP", "TIP3", "TIP4", "SPC", "ZN"})
        text.residue(name).atom("O", "O", {});
    EXPECT_EQ(drawnAtoms(text.molecule), (Indices{0, 10}));
    EXPECT_EQ(drawnAtoms(text.molecule, {.water = true}).size(), 11u);
}

TEST(DrawnAtoms, LeaveOutHydrogensOnlyIfAsked) {
    MoleculeText text;
    text.residue("ALA").atom("CA", "C", {}).atom("HA", "H", {}).atom("DB", "D", {}).atom("HG", "Hg", {});
    EXPECT_EQ(drawnAtoms(text.molecule).size(), 4u);
    EXPECT_EQ(drawnAtoms(text.molecule, {.hydrogens = false}), (Indices{0, 3}));
}

TEST(DrawnAtoms, ShowTheConformerOfHighestMeanOccupancy) {
    MoleculeText text;
    text.residue("SER").atom("CA", "C", {});
    text.atom("CB", "C", {}, 'A', 0.3f).atom("CB", "C", {}, 'B', 0.7f);
    text.atom("OG", "O", {}, 'A', 0.9f).atom("OG", "O", {}, 'B', 0.6f);  // means: A 0.6, B 0.65
    EXPECT_EQ(drawnAtoms(text.molecule), (Indices{0, 2, 4}));
    text.molecule.atoms[1].occupancy = 0.6f;  // A 0.75
    EXPECT_EQ(drawnAtoms(text.molecule), (Indices{0, 1, 3}));
}

TEST(DrawnAtoms, ShowTheFirstInTheFileIfOccupanciesAreEqual) {
    MoleculeText text;
    text.residue("SER").atom("CB", "C", {}, 'B', 0.5f).atom("CB", "C", {}, 'A', 0.5f);
    EXPECT_EQ(drawnAtoms(text.molecule), (Indices{0}));
}

TEST(DrawnAtoms, ChooseAtEachPositionOnItsOwn) {
    MoleculeText text;
    text.residue("SER", 1).atom("CB", "C", {}, 'A', 0.6f).atom("CB", "C", {}, 'B', 0.4f);
    text.residue("SER", 1, 'A').atom("CB", "C", {}, 'A', 0.4f).atom("CB", "C", {}, 'B', 0.6f);
    text.residue("SER", -1).atom("CB", "C", {}, 'A', 0.4f).atom("CB", "C", {}, 'B', 0.6f);
    EXPECT_EQ(drawnAtoms(text.molecule), (Indices{0, 3, 5}));
}

TEST(DrawnAtoms, ChooseOneResidueWhereTheSequenceAlternates) {
    MoleculeText text;
    text.residue("GLY", 80).atom("CA", "C", {}, 'A', 0.4f);
    text.residue("SER", 80).atom("CA", "C", {}, 'B', 0.6f).atom("OG", "O", {}, 'B', 0.6f);
    EXPECT_EQ(drawnAtoms(text.molecule), (Indices{1, 2}));
}

TEST(DrawnAtoms, ShowAllConformersOrANamedOne) {
    MoleculeText text;
    text.residue("SER", 1).atom("CA", "C", {});
    text.atom("CB", "C", {}, 'A', 0.7f).atom("CB", "C", {}, 'B', 0.3f);
    text.residue("VAL", 2).atom("CG1", "C", {}, 'A', 0.4f).atom("CG1", "C", {}, 'C', 0.6f);
    using Mode = Altlocs::Mode;
    EXPECT_EQ(drawnAtoms(text.molecule), (Indices{0, 1, 4}));
    EXPECT_EQ(drawnAtoms(text.molecule, {.altlocs = {Mode::all, '\0'}}), (Indices{0, 1, 2, 3, 4}));
    EXPECT_EQ(drawnAtoms(text.molecule, {.altlocs = {Mode::letter, 'A'}}), (Indices{0, 1, 3}));
    EXPECT_EQ(drawnAtoms(text.molecule, {.altlocs = {Mode::letter, 'B'}}), (Indices{0, 2, 4}));  // C is the chosen one
    EXPECT_EQ(conformers(text.molecule, {}), (std::vector<Indices>{{0, 1, 4}, {0, 1, 3}, {0, 2, 4}}));
}

TEST(DrawnAtoms, AllConformersAreAllAtomsOfTheFile) {
    NACRE_NEEDS_DATA();
    const Molecule molecule = formatRow(Format::pdb).read("1o1z.pdb", test::readText(test::dataFile("1o1z.pdb")), {});
    EXPECT_EQ(drawnAtoms(molecule, {.water = true, .altlocs = {Altlocs::Mode::all, '\0'}}).size(), 2302u);
    EXPECT_LT(drawnAtoms(molecule, {.water = true}).size(), 2302u);
}

TEST(DrawnAtoms, AreNoDummies) {
    MoleculeText text;
    text.residue("LIG").atom("FE", "Fe", {}).atom("X", "X", {}).atom("Du", "Du", {}).atom("BB", "", {});
    EXPECT_EQ(drawnAtoms(text.molecule), (Indices{0, 3}));
}

TEST(DrawnAtoms, OfRealFiles) {
    NACRE_NEEDS_DATA();
    const auto drawn = [](const char* file) {
        return drawnAtoms(formatRow(Format::pdb).read(file, test::readText(test::dataFile(file)), {})).size();
    };
    EXPECT_EQ(drawn("1bna.pdb"), 486u);
    EXPECT_EQ(drawn("4hhb.pdb"), 4558u);  // 4779 less 221 waters
    EXPECT_EQ(drawn("1aon-groel.pdb.gz"), 58870u);
}

}  // namespace
}  // namespace nacre
