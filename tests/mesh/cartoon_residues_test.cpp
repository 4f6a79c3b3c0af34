// What of a molecule a cartoon is of: its residues, breaks, conformers, bases and bridges; and files of every kind.

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <set>
#include <string_view>

#include "engine/mesh/cartoon_trace.h"
#include "engine/molecule/read.h"
#include "tests/mesh/cartoon_makers.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

using test::all;
using test::alphaCarbons;
using test::cartoonOf;
using test::chainOf;
using test::expectSound;
using test::MoleculeText;
using test::zigzag;

TEST(CartoonResidues, ResiduesMeetHalfway) {
    const Molecule molecule = alphaCarbons({{0, 0, 0}, {0, 0, 3.8}, {0, 0, 7.6}});
    const Mesh mesh = cartoonOf(molecule);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const double z = mesh.positions[i].z, middle = 3.8 * mesh.atoms[i];
        EXPECT_GE(z, middle - 1.9 - (mesh.atoms[i] == 0 ? 1 : 1e-4));
        EXPECT_LE(z, middle + 1.9 + (mesh.atoms[i] == 2 ? 1 : 1e-4));
    }
}

TEST(CartoonResidues, AHiddenPartLeavesTheRestWhereItWas) {
    const Molecule molecule = chainOf(20, -57, -47);
    const auto secondary = secondaryStructure(molecule);
    std::vector<std::uint32_t> some;
    for (const std::uint32_t atom : drawnAtoms(molecule))
        if (molecule.atoms[atom].residue < 6 || molecule.atoms[atom].residue > 9) some.push_back(atom);
    const Mesh whole = cartoonOf(molecule, secondary), part = cartoon(molecule, some, secondary, {}, {});
    expectSound(part, molecule.atoms.size());
    std::set<std::tuple<float, float, float>> places;
    for (const glm::vec3& p : whole.positions) places.insert({p.x, p.y, p.z});
    for (std::size_t i = 0; i < part.positions.size(); ++i) {
        const glm::vec3& p = part.positions[i];
        EXPECT_TRUE(places.count({p.x, p.y, p.z}));
        const std::uint32_t residue = molecule.atoms[part.atoms[i]].residue;
        EXPECT_TRUE(residue < 6 || residue > 9);
    }
    EXPECT_EQ(atomsOfCartoon(molecule, some), some);
}

TEST(CartoonResidues, ChainsBreakWhereTheyDo) {
    Molecule molecule = chainOf(20, -57, -47);
    for (Atom& atom : molecule.atoms)
        if (atom.residue >= 10) atom.position += glm::vec3(0, 0, 6);
    EXPECT_EQ(cartoonTraces(molecule, drawnAtoms(molecule), {}).size(), 2u);
    const Mesh mesh = cartoonOf(molecule);
    expectSound(mesh, molecule.atoms.size());
    for (const glm::uvec3& t : mesh.triangles) EXPECT_LT(glm::distance(mesh.positions[t.x], mesh.positions[t.y]), 3);
    // Another chain is another trace, however near it is.
    Molecule two = chainOf(20, -57, -47);
    two.chains.push_back({"B"});
    for (std::size_t r = 10; r < 20; ++r) two.residues[r].chain = 1;
    EXPECT_EQ(cartoonTraces(two, drawnAtoms(two), {}).size(), 2u);
}

TEST(CartoonResidues, InsertedModifiedAndRightHandedResiduesGoOn) {
    Molecule molecule = chainOf(20, -57, -47);
    molecule.residues[7].name = Name("MSE");
    molecule.residues[8].name = Name("DAL");
    molecule.residues[9].number = molecule.residues[8].number;
    molecule.residues[9].insertionCode = 'A';
    for (std::uint32_t i = molecule.residues[7].firstAtom; i < molecule.residues[7].firstAtom + 4; ++i)
        molecule.atoms[i].hetero = true;
    const std::vector<Trace> traces = cartoonTraces(molecule, drawnAtoms(molecule), {});
    ASSERT_EQ(traces.size(), 1u);
    EXPECT_EQ(traces[0].residues.size(), 20u);
}

TEST(CartoonResidues, OneOfAlternateConformersIsDrawn) {
    const Molecule plain = zigzag(6);
    MoleculeText text;
    for (int i = 0; i < 6; ++i) {
        const glm::vec3 p = plain.atoms[i].position;
        text.residue("ALA", i + 1);
        if (i == 3)
            text.atom("CA", "C", p + glm::vec3(1, 0, 0), 'A', 0.3f).atom("CA", "C", p, 'B', 0.7f);
        else
            text.atom("CA", "C", p);
    }
    EXPECT_EQ(cartoonOf(text.molecule).positions, cartoonOf(plain).positions);
}

TEST(CartoonResidues, DisulphidesAreSticksOfTheirAtoms) {
    MoleculeText text;
    for (int i = 0; i < 6; ++i) {
        text.residue("CYS", i + 1).atom("CA", "C", {0, 0, 3.8 * i});
        if (i == 1) text.atom("CB", "C", {1.5, 0, 3.8}).atom("SG", "S", {2.5, 0, 5});
        if (i == 4) text.atom("CB", "C", {1.5, 0, 15.2}).atom("SG", "S", {2.5, 1.2, 6.5});
    }
    Molecule molecule = text.molecule;
    const std::size_t without = cartoonOf(molecule).triangles.size();
    molecule.bonds.push_back({3, 8});
    ASSERT_EQ(molecule.atoms[3].name, Name("SG"));
    ASSERT_EQ(molecule.atoms[8].name, Name("SG"));
    const Mesh mesh = cartoonOf(molecule);
    expectSound(mesh, molecule.atoms.size());
    EXPECT_GT(mesh.triangles.size(), without);
    for (const std::uint32_t atom : {2u, 3u, 7u, 8u})
        EXPECT_TRUE(std::count(mesh.atoms.begin(), mesh.atoms.end(), atom)) << atom;
    CartoonOptions off;
    off.disulfides = false;
    EXPECT_EQ(cartoonOf(molecule, off).triangles.size(), without);
}

TEST(CartoonResidues, BasesArePlatesOrRungs) {
    const Molecule dna = sampleMolecule("dna");
    CartoonOptions options;
    std::vector<std::size_t> triangles;
    for (const BaseForm form : {BaseForm::none, BaseForm::ladder, BaseForm::plates}) {
        options.bases = form;
        const Mesh mesh = cartoonOf(dna, options);
        expectSound(mesh, dna.atoms.size());
        triangles.push_back(mesh.triangles.size());
    }
    EXPECT_LT(triangles[0], triangles[1]);
    // A rod has round ends and one length of sides; a plate of n corners 2 (n - 2) + 2 n triangles. Each base has two
    // rods and a plate of 6 or 9 corners.
    const std::size_t rods = (triangles[1] - triangles[0]) / dna.residues.size();
    std::size_t plates = 0;
    for (const Residue& residue : dna.residues) {
        const std::string_view name = residue.name.view();
        plates += name == "DA" || name == "DG" ? 14 + 18 : 8 + 12;
    }
    EXPECT_EQ(triangles[2] - triangles[0], 2 * rods * dna.residues.size() + plates);
}

TEST(CartoonResidues, NucleotidesShowTheColourOfACarbon) {
    Molecule dna = sampleMolecule("dna");
    CartoonOptions options;
    options.bases = BaseForm::none;
    const auto namesOf = [&](const Mesh& mesh) {
        std::set<std::string_view> names;
        for (const std::uint32_t atom : mesh.atoms) names.insert(dna.atoms[atom].name.view());
        return names;
    };
    EXPECT_EQ(namesOf(cartoonOf(dna, options)), std::set<std::string_view>{"C4'"});  // of the first, without P, too
    for (Atom& atom : dna.atoms)
        if (atom.name.view().starts_with('C')) atom.name = Name("X");
    EXPECT_EQ(namesOf(cartoonOf(dna, options)), (std::set<std::string_view>{"O5'", "P"}));
}

TEST(CartoonResidues, WhatCannotBeDrawnIsLeftOut) {
    EXPECT_TRUE(cartoonOf(Molecule()).triangles.empty());
    EXPECT_TRUE(cartoonOf(sampleMolecule("buckyball")).triangles.empty());
    EXPECT_TRUE(atomsOfCartoon(sampleMolecule("glucose"), drawnAtoms(sampleMolecule("glucose"))).empty());

    const float nan = std::numeric_limits<float>::quiet_NaN(), huge = 1e30f;
    Molecule broken = chainOf(12, -57, -47);
    for (std::uint32_t i = broken.residues[5].firstAtom; i < broken.residues[6].firstAtom; ++i)
        broken.atoms[i].position = glm::vec3(nan, 0, huge);
    expectSound(cartoonOf(broken), broken.atoms.size());
    EXPECT_EQ(cartoonTraces(broken, drawnAtoms(broken), {}).size(), 2u);

    Molecule together = chainOf(12, -57, -47);
    for (Atom& atom : together.atoms) atom.position = {1, 2, 3};
    const Mesh balls = cartoonOf(together, all(together, SecondaryStructure::helix));
    expectSound(balls, together.atoms.size());
    EXPECT_FALSE(balls.triangles.empty());
}

TEST(CartoonResidues, OneResidueIsARodOrABall) {
    for (const Molecule& molecule : {chainOf(1, -57, -47), alphaCarbons({{1, 2, 3}})}) {
        const Mesh mesh = cartoonOf(molecule);
        expectSound(mesh, molecule.atoms.size());
        EXPECT_FALSE(mesh.triangles.empty());
        for (const std::uint32_t atom : mesh.atoms) EXPECT_EQ(molecule.atoms[atom].name, Name("CA"));
    }
}

TEST(CartoonResidues, FilesOfEveryKindAreSound) {
    NACRE_NEEDS_DATA();
    for (const char* name : {"1crn.pdb", "1bna.pdb", "1en2.pdb", "1bcu-icode.pdb", "2koc-rna-nmr.cif.gz",
                             "trna-4tra.pdb", "gfp-1ema.cif", "1pfe.cif.gz"}) {
        const Molecule molecule = readMoleculeFile(test::dataFile(name));
        const Mesh mesh = cartoonOf(molecule);
        SCOPED_TRACE(name);
        EXPECT_FALSE(mesh.triangles.empty());
        expectSound(mesh, molecule.atoms.size());
        // No spike: every vertex stands near an atom of its residue.
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            ASSERT_LT(glm::distance(mesh.positions[i], molecule.atoms[mesh.atoms[i]].position), 9);
    }
}

}  // namespace
}  // namespace nacre
