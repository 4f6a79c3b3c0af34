// What of a molecule a cartoon is of: its residues, breaks, conformers, bases and bridges; and files of every kind.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "engine/mesh/cartoon_trace.h"
#include "engine/molecule/read.h"
#include "tests/mesh/cartoon_makers.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

using test::all;
using test::alphaCarbons;
using test::buildChain;
using test::expectSound;
using test::makeCartoon;
using test::MoleculeText;
using test::zigzag;

TEST(CartoonResidues, ResiduesMeetHalfway) {
    const Molecule molecule = alphaCarbons({{0, 0, 0}, {0, 0, 3.8}, {0, 0, 7.6}});
    const Mesh mesh = makeCartoon(molecule);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const double z = mesh.positions[i].z, middle = 3.8 * mesh.atoms[i];
        EXPECT_GE(z, middle - 1.9 - (mesh.atoms[i] == 0 ? 1 : 1e-4));
        EXPECT_LE(z, middle + 1.9 + (mesh.atoms[i] == 2 ? 1 : 1e-4));
    }
}

TEST(CartoonResidues, AHiddenPartLeavesTheRestWhereItWas) {
    const Molecule molecule = buildChain(20, -57, -47);
    const auto secondary = secondaryStructure(molecule);
    std::vector<std::uint32_t> some;
    for (const std::uint32_t atom : drawnAtoms(molecule))
        if (molecule.atoms[atom].residue < 6 || molecule.atoms[atom].residue > 9) some.push_back(atom);
    const Mesh whole = makeCartoon(molecule, secondary), part = cartoon(molecule, some, secondary, {}, {});
    expectSound(part, molecule.atoms.size());
    std::set<std::tuple<float, float, float>> places;
    for (const glm::vec3& p : whole.positions) places.insert({p.x, p.y, p.z});
    for (std::size_t i = 0; i < part.positions.size(); ++i) {
        const glm::vec3& p = part.positions[i];
        EXPECT_TRUE(places.count({p.x, p.y, p.z}));
        const std::uint32_t residue = molecule.atoms[part.atoms[i]].residue;
        EXPECT_TRUE(residue < 6 || residue > 9);
    }
    EXPECT_EQ(atomsOfCartoon(molecule, some).drawn, some);
}

TEST(CartoonResidues, ChainsBreakWhereTheyDo) {
    Molecule molecule = buildChain(20, -57, -47);
    for (Atom& atom : molecule.atoms)
        if (atom.residue >= 10) atom.position += glm::vec3(0, 0, 6);
    EXPECT_EQ(cartoonTraces(molecule, drawnAtoms(molecule), {}).size(), 2u);
    const Mesh mesh = makeCartoon(molecule);
    expectSound(mesh, molecule.atoms.size());
    for (const glm::uvec3& t : mesh.triangles) EXPECT_LT(glm::distance(mesh.positions[t.x], mesh.positions[t.y]), 3);
    // Another chain is another trace, however near it is.
    Molecule two = buildChain(20, -57, -47);
    two.chains.push_back({"B"});
    for (std::size_t r = 10; r < 20; ++r) two.residues[r].chain = 1;
    EXPECT_EQ(cartoonTraces(two, drawnAtoms(two), {}).size(), 2u);
}

TEST(CartoonResidues, InsertedModifiedAndRightHandedResiduesGoOn) {
    Molecule molecule = buildChain(20, -57, -47);
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

/// A helix of 20 whose residues 8 to 10 are one, with atoms N1, CA1, ... as in GFP's chromophore, and a bond that
/// closes a ring of the first C and the third N.
Molecule fusedChain() {
    Molecule molecule = buildChain(20, -57, -47);
    for (std::uint32_t i = 0; i < molecule.atoms.size(); ++i) {
        const std::uint32_t first = i - i % 4;
        for (const auto& [a, b] : {std::pair(0u, 1u), std::pair(1u, 2u), std::pair(2u, 3u)})
            if (i == first) molecule.bonds.push_back({first + a, first + b});
        if (i == first && i > 0) molecule.bonds.push_back({first - 2, first});
    }
    for (std::uint32_t unit = 0; unit < 3; ++unit)
        for (std::uint32_t k = 0; k < 4; ++k) {
            Atom& atom = molecule.atoms[4 * (7 + unit) + k];
            atom.name = Name(std::string(atom.name.view()) + std::to_string(unit + 1));
            atom.residue = 7;
        }
    molecule.bonds.push_back({4 * 7 + 2, 4 * 9});
    molecule.residues[7].name = Name("CRO");
    molecule.residues[7].atomCount = 12;
    molecule.residues.erase(molecule.residues.begin() + 8, molecule.residues.begin() + 10);
    for (std::uint32_t i = 4 * 10; i < molecule.atoms.size(); ++i) molecule.atoms[i].residue -= 2;
    return molecule;
}

TEST(CartoonResidues, FusedResiduesGoOn) {
    const Molecule plain = buildChain(20, -57, -47), fused = fusedChain();
    const std::vector<Trace> traces = cartoonTraces(fused, drawnAtoms(fused), {});
    ASSERT_EQ(traces.size(), 1u);
    EXPECT_EQ(traces[0].points, cartoonTraces(plain, drawnAtoms(plain), {})[0].points);
    // As a helix it is that of its three residues.
    EXPECT_EQ(makeCartoon(fused, all(fused, SecondaryStructure::helix)).positions,
              makeCartoon(plain, all(plain, SecondaryStructure::helix)).positions);
    const CartoonAtoms atoms = atomsOfCartoon(fused, drawnAtoms(fused));
    EXPECT_EQ(atoms.drawn.size(), fused.atoms.size());
    ASSERT_EQ(atoms.beside.size(), 12u);
    EXPECT_EQ(atoms.beside.front(), 28u);
    // Without a bond to both neighbours it is no part of the chain.
    Molecule loose = fused;
    std::erase_if(loose.bonds, [](const Bond& bond) { return bond.a == 4 * 9 + 2 && bond.b == 4 * 10; });
    EXPECT_EQ(cartoonTraces(loose, drawnAtoms(loose), {}).size(), 2u);
}

TEST(CartoonResidues, TheTraceOfGfpPassesItsChromophore) {
    NACRE_NEEDS_DATA();
    const Molecule gfp = readMoleculeFile(test::dataFile("gfp-1ema.cif"));
    const std::vector<GuideTrace> traces = guideTraces(gfp);
    ASSERT_EQ(traces.size(), 1u);
    std::string passed;
    for (const std::uint32_t atom : traces[0].atoms)
        if (gfp.residues[gfp.atoms[atom].residue].name == Name("CRO"))
            passed += std::string(gfp.atoms[atom].name.view()) + " ";
    EXPECT_EQ(passed, "CA1 CA2 CA3 ");
    for (std::size_t i = 1; i < traces[0].atoms.size(); ++i)
        EXPECT_NEAR(glm::distance(gfp.atoms[traces[0].atoms[i - 1]].position, gfp.atoms[traces[0].atoms[i]].position),
                    i == 87 ? 2.95 : 3.8, 0.4)  // proline 89 is cis
            << i;
}

/// A copy whose residues are in another order; bonds follow them. @param order  of the file's residues @param backward
/// atoms, too
Molecule inOrder(const Molecule& molecule, const std::vector<std::uint32_t>& order, bool backward) {
    Molecule moved = molecule;
    moved.atoms.clear(), moved.residues.clear();
    std::vector<std::uint32_t> places(molecule.atoms.size());
    for (const std::uint32_t r : order) {
        Residue residue = molecule.residues[r];
        residue.firstAtom = static_cast<std::uint32_t>(moved.atoms.size());
        for (std::uint32_t i = 0; i < residue.atomCount; ++i) {
            const std::uint32_t from = molecule.residues[r].firstAtom + (backward ? residue.atomCount - 1 - i : i);
            places[from] = static_cast<std::uint32_t>(moved.atoms.size());
            moved.atoms.push_back(molecule.atoms[from]);
            moved.atoms.back().residue = static_cast<std::uint32_t>(moved.residues.size());
        }
        moved.residues.push_back(residue);
    }
    for (Bond& bond : moved.bonds) {
        const auto [a, b] = std::minmax(places[bond.a], places[bond.b]);
        bond.a = a, bond.b = b;
    }
    return moved;
}

TEST(CartoonResidues, NucleotidesStandInAnyOrderInTheFile) {
    const Molecule dna = sampleMolecule("dna");
    const auto collectPoints = [](const Molecule& molecule) {
        std::vector<std::vector<glm::dvec3>> points;
        for (const Trace& trace : cartoonTraces(molecule, drawnAtoms(molecule), {})) points.push_back(trace.points);
        std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a[0].x < b[0].x; });
        return points;
    };
    const auto count = static_cast<std::uint32_t>(dna.residues.size());
    std::vector<std::uint32_t> given(count), reversed, oddFirst, across;
    for (std::uint32_t i = 0; i < count; ++i) given[i] = i;
    reversed.assign(given.rbegin(), given.rend());
    for (const std::uint32_t odd : {1u, 0u})
        for (std::uint32_t i = odd; i < count; i += 2) oddFirst.push_back(i);
    for (std::uint32_t i = 0; i < count / 2; ++i) across.push_back(i), across.push_back(count - 1 - i);
    ASSERT_EQ(collectPoints(dna).size(), 2u);
    for (const auto& order : {given, reversed, oddFirst, across})
        for (const bool backward : {false, true}) {
            const Molecule moved = inOrder(dna, order, backward);
            EXPECT_EQ(collectPoints(moved), collectPoints(dna));
            expectSound(makeCartoon(moved), moved.atoms.size());
        }
}

TEST(CartoonResidues, ARingBeginsWithItsFirstResidue) {
    MoleculeText text;
    constexpr int kResidues = 10;
    constexpr double kStep = 2 * 3.14159265358979 / kResidues, kRadius = 6.1;
    for (int i = 0; i < kResidues; ++i) {
        const auto at = [&](double turn) {
            return glm::vec3(kRadius * std::cos(kStep * (i + turn)), kRadius * std::sin(kStep * (i + turn)), 0);
        };
        text.residue("GLY", i + 1).atom("N", "N", at(-0.35)).atom("CA", "C", at(0)).atom("C", "C", at(0.35));
    }
    for (std::uint32_t i = 0; i < kResidues; ++i) {
        const std::uint32_t next = (i + 1) % kResidues;
        text.molecule.bonds.push_back({std::min(3 * i + 2, 3 * next), std::max(3 * i + 2, 3 * next)});
    }
    const std::vector<Trace> traces = cartoonTraces(text.molecule, drawnAtoms(text.molecule), {});
    ASSERT_EQ(traces.size(), 1u);
    EXPECT_EQ(traces[0].residues.size(), std::size_t{kResidues});
    EXPECT_EQ(traces[0].residues[0], 0u);
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
    EXPECT_EQ(makeCartoon(text.molecule).positions, makeCartoon(plain).positions);
}

TEST(CartoonResidues, DisulphidesAreSticksOfTheirAtoms) {
    MoleculeText text;
    for (int i = 0; i < 6; ++i) {
        text.residue("CYS", i + 1).atom("CA", "C", {0, 0, 3.8 * i});
        if (i == 1) text.atom("CB", "C", {1.5, 0, 3.8}).atom("SG", "S", {2.5, 0, 5});
        if (i == 4) text.atom("CB", "C", {1.5, 0, 15.2}).atom("SG", "S", {2.5, 1.2, 6.5});
    }
    Molecule molecule = text.molecule;
    const std::size_t without = makeCartoon(molecule).triangles.size();
    molecule.bonds.push_back({3, 8});
    ASSERT_EQ(molecule.atoms[3].name, Name("SG"));
    ASSERT_EQ(molecule.atoms[8].name, Name("SG"));
    const Mesh mesh = makeCartoon(molecule);
    expectSound(mesh, molecule.atoms.size());
    EXPECT_GT(mesh.triangles.size(), without);
    for (const std::uint32_t atom : {2u, 3u, 7u, 8u}) EXPECT_TRUE(std::ranges::count(mesh.atoms, atom)) << atom;
    EXPECT_EQ(makeCartoon(molecule, CartoonOptions{.disulfides = false}).triangles.size(), without);
}

TEST(CartoonResidues, BasesArePlatesOrRungs) {
    const Molecule dna = sampleMolecule("dna");
    CartoonOptions options;
    std::vector<std::size_t> triangles;
    for (const BaseForm form : {BaseForm::none, BaseForm::ladder, BaseForm::plates, BaseForm::rings}) {
        options.bases = form;
        const Mesh mesh = makeCartoon(dna, options);
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
    // A sugar's ring has five corners more.
    EXPECT_EQ(triangles[3] - triangles[2], dna.residues.size() * (6 + 10));
}

TEST(CartoonResidues, SugarsArePlatesOfTheirRings) {
    const Molecule dna = sampleMolecule("dna");
    const Mesh mesh = makeCartoon(dna, CartoonOptions{.bases = BaseForm::rings});
    // Each ring atom is a corner of its residue's plates, in the ring's mean plane.
    for (const Atom& atom : dna.atoms) {
        const std::string_view name = atom.name.view();
        if (name != "C2'" && name != "C3'" && name != "O4'" && name != "C8" && name != "C6") continue;
        float nearest = 9;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            if (dna.atoms[mesh.atoms[i]].residue == atom.residue)
                nearest = std::min(nearest, glm::distance(mesh.positions[i], atom.position));
        EXPECT_LT(nearest, 0.5) << name;
    }
}

TEST(CartoonResidues, NucleotidesShowTheColourOfACarbon) {
    Molecule dna = sampleMolecule("dna");
    CartoonOptions options{.bases = BaseForm::none};
    const auto collectNames = [&](const Mesh& mesh) {
        std::set<std::string_view> names;
        for (const std::uint32_t atom : mesh.atoms) names.insert(dna.atoms[atom].name.view());
        return names;
    };
    EXPECT_EQ(collectNames(makeCartoon(dna, options)),
              std::set<std::string_view>{"C4'"});  // of the first, without P, too
    for (Atom& atom : dna.atoms)
        if (atom.name.view().starts_with('C')) atom.name = Name("X");
    EXPECT_EQ(collectNames(makeCartoon(dna, options)), (std::set<std::string_view>{"O5'", "P"}));
}

TEST(CartoonResidues, WhatCannotBeDrawnIsLeftOut) {
    EXPECT_TRUE(makeCartoon(Molecule()).triangles.empty());
    EXPECT_TRUE(makeCartoon(sampleMolecule("buckyball")).triangles.empty());
    EXPECT_TRUE(atomsOfCartoon(sampleMolecule("glucose"), drawnAtoms(sampleMolecule("glucose"))).drawn.empty());

    const float nan = std::numeric_limits<float>::quiet_NaN(), huge = 1e30f;
    Molecule broken = buildChain(12, -57, -47);
    for (std::uint32_t i = broken.residues[5].firstAtom; i < broken.residues[6].firstAtom; ++i)
        broken.atoms[i].position = glm::vec3(nan, 0, huge);
    expectSound(makeCartoon(broken), broken.atoms.size());
    EXPECT_EQ(cartoonTraces(broken, drawnAtoms(broken), {}).size(), 2u);

    Molecule together = buildChain(12, -57, -47);
    for (Atom& atom : together.atoms) atom.position = {1, 2, 3};
    const Mesh balls = makeCartoon(together, all(together, SecondaryStructure::helix));
    expectSound(balls, together.atoms.size());
    EXPECT_FALSE(balls.triangles.empty());
}

TEST(CartoonResidues, OneResidueIsARodOrABall) {
    for (const Molecule& molecule : {buildChain(1, -57, -47), alphaCarbons({{1, 2, 3}})}) {
        const Mesh mesh = makeCartoon(molecule);
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
        const Mesh mesh = makeCartoon(molecule);
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
