#include "engine/mesh/cartoon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <set>

#include "engine/mesh/cartoon_curve.h"
#include "engine/mesh/cartoon_trace.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/kabsch_sander.h"
#include "engine/molecule/read.h"
#include "tests/mesh/mesh_checks.h"
#include "tests/molecule/build_molecule.h"
#include "tests/molecule/build_peptide.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

using test::chainOf;
using test::expectSound;
using test::MoleculeText;

std::vector<SecondaryStructure> all(const Molecule& molecule, SecondaryStructure kind) {
    return std::vector<SecondaryStructure>(molecule.residues.size(), kind);
}

Mesh cartoonOf(const Molecule& molecule, const std::vector<SecondaryStructure>& secondary,
               const CartoonOptions& options = {}) {
    return cartoon(molecule, drawnAtoms(molecule), secondary, options, {});
}

Mesh cartoonOf(const Molecule& molecule, const CartoonOptions& options = {}) {
    return cartoonOf(molecule, secondaryStructure(molecule), options);
}

/// Alpha carbons alone, one residue each.
Molecule alphaCarbons(const std::vector<glm::vec3>& places) {
    MoleculeText text;
    int number = 0;
    for (const glm::vec3& place : places) text.residue("ALA", ++number).atom("CA", "C", place);
    return text.molecule;
}

/// An alpha helix of alpha carbons about the z axis: radius 2.3 Å, 100 degrees and 1.5 Å a residue.
Molecule helixOfAlphaCarbons(int residues) {
    std::vector<glm::vec3> places;
    for (int i = 0; i < residues; ++i) {
        const double turn = i * 100 * std::numbers::pi / 180;
        places.emplace_back(2.3 * std::cos(turn), 2.3 * std::sin(turn), 1.5 * i);
    }
    return alphaCarbons(places);
}

/// A strand along z whose alpha carbons zigzag along y.
Molecule zigzag(int residues) {
    std::vector<glm::vec3> places;
    for (int i = 0; i < residues; ++i) places.emplace_back(0, i % 2 ? 0.9 : -0.9, 3.3 * i);
    return alphaCarbons(places);
}

std::vector<Frame> framesOf(const Molecule& molecule, SecondaryStructure kind, HelixForm form = HelixForm::ribbon) {
    const std::vector<Trace> traces = cartoonTraces(molecule, drawnAtoms(molecule), all(molecule, kind));
    EXPECT_EQ(traces.size(), 1u);
    return cartoonFrames(traces[0], foldRuns(traces[0]), form, false, 8);
}

void expectNoFlips(const std::vector<Frame>& frames, double least) {
    for (std::size_t k = 1; k < frames.size(); ++k) {
        EXPECT_GT(glm::dot(frames[k].side, frames[k - 1].side), least) << k;
        EXPECT_NEAR(glm::dot(frames[k].side, frames[k].tangent), 0, 1e-9);
        EXPECT_NEAR(glm::length(frames[k].side), 1, 1e-9);
    }
}

TEST(Cartoon, HelicesAreRoundAndLieAlongTheirAxis) {
    const std::vector<Frame> frames = framesOf(helixOfAlphaCarbons(20), SecondaryStructure::helix);
    for (std::size_t k = 16; k + 16 < frames.size(); ++k) {
        const glm::dvec3& c = frames[k].center;
        EXPECT_NEAR(std::hypot(c.x, c.y), 2.3, 0.03) << k;
        EXPECT_NEAR(c.z, 1.5 * static_cast<double>(k) / 8, 0.05) << k;
        // The face looks away from the axis; the band climbs by 20 degrees.
        EXPECT_GT(std::abs(frames[k].normal.x * c.x + frames[k].normal.y * c.y) / 2.3, 0.99) << k;
        EXPECT_NEAR(std::abs(frames[k].side.z), 0.936, 0.02) << k;
    }
    expectNoFlips(frames, 0.9);
}

TEST(Cartoon, TubesAndCylindersFollowTheAxis) {
    for (const HelixForm form : {HelixForm::tube, HelixForm::cylinder}) {
        const std::vector<Frame> frames = framesOf(helixOfAlphaCarbons(20), SecondaryStructure::helix, form);
        for (const Frame& frame : frames) EXPECT_LT(std::hypot(frame.center.x, frame.center.y), 0.25);
        EXPECT_NEAR(frames.front().center.z, 0, 0.3);
        EXPECT_NEAR(frames.back().center.z, 1.5 * 19, 0.3);
    }
}

TEST(Cartoon, ACylinderIsStraightWhereATubeBends) {
    // A helix on an arc of radius 80 Å: 29 Å long, 1.3 Å out of the straight.
    std::vector<glm::vec3> places;
    for (int i = 0; i < 20; ++i) {
        const double turn = i * 100 * std::numbers::pi / 180, bend = 1.5 * i / 80;
        const double out = 80 + 2.3 * std::cos(turn);
        places.emplace_back(out * std::cos(bend), 2.3 * std::sin(turn), out * std::sin(bend));
    }
    const auto bow = [&](HelixForm form) {
        const std::vector<Frame> frames = framesOf(alphaCarbons(places), SecondaryStructure::helix, form);
        const glm::dvec3 a = frames.front().center, b = frames.back().center, along = glm::normalize(b - a);
        double most = 0;
        for (const Frame& frame : frames) most = std::max(most, glm::length(glm::cross(frame.center - a, along)));
        return most;
    };
    EXPECT_GT(bow(HelixForm::tube), 1.0);
    EXPECT_LT(bow(HelixForm::cylinder), 1e-6);
}

TEST(Cartoon, HelicesWithoutAResidueBetweenAreTwoSolids) {
    Molecule molecule = helixOfAlphaCarbons(24);
    for (std::size_t i = 12; i < 24; ++i) {  // the second half turned to lie along x
        glm::vec3& p = molecule.atoms[i].position;
        p = glm::vec3(p.z - 16.5f, p.y, 17.5f - p.x);
    }
    const auto secondary = all(molecule, SecondaryStructure::helix);
    const std::vector<Trace> traces = cartoonTraces(molecule, drawnAtoms(molecule), secondary);
    ASSERT_EQ(traces.size(), 1u);
    const std::vector<FoldRun> runs = splitAtKinks(traces[0], foldRuns(traces[0]));
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_NEAR(runs[0].last, 11, 1);
    EXPECT_EQ(runs[1].first, runs[0].last + 1);
    // One that only bends stays one.
    EXPECT_EQ(splitAtKinks(cartoonTraces(helixOfAlphaCarbons(24), drawnAtoms(molecule), secondary)[0],
                           {{SecondaryStructure::helix, 0, 23}})
                  .size(),
              1u);
}

TEST(Cartoon, StrandsLieFlatAndNeverFlip) {
    // Without carbonyls, by the zigzag of the alpha carbons.
    const std::vector<Frame> frames = framesOf(zigzag(10), SecondaryStructure::strand);
    for (const Frame& frame : frames) {
        EXPECT_LT(std::hypot(frame.center.x, frame.center.y), 0.05);
        EXPECT_GT(std::abs(frame.side.x), 0.999);  // across the zigzag
    }
    expectNoFlips(frames, 0.999);
    // With carbonyls, which point to one side and the other by turns; real strands twist.
    for (const double phi : {-120.0, -135.0, -105.0}) {
        const std::vector<Frame> real = framesOf(chainOf(12, phi, 130), SecondaryStructure::strand);
        expectNoFlips(real, 0.98);
        for (std::size_t k = 1; k < real.size(); ++k)
            EXPECT_GT(glm::dot(real[k].tangent, real[k - 1].tangent), 0.98) << phi << ' ' << k;
    }
}

TEST(Cartoon, ABulgeDoesNotTurnAStrandOver) {
    Molecule molecule = chainOf(12, -120, 130);
    // One carbonyl to the same side as its neighbours', as in a bulge.
    glm::vec3& o = molecule.atoms[6 * 4 + 3].position;
    o = 2.0f * molecule.atoms[6 * 4 + 2].position - o;
    expectNoFlips(framesOf(molecule, SecondaryStructure::strand), 0.95);
}

/// Of the vertices farther than 0.9 Å from the line of a zigzag: how far along it they stand.
std::pair<double, double> headOf(const Mesh& mesh) {
    double first = 1e9, last = -1e9, widest = 0;
    for (const glm::vec3& p : mesh.positions) widest = std::max(widest, std::abs(static_cast<double>(p.x)));
    for (const glm::vec3& p : mesh.positions)
        if (std::abs(p.x) > widest * 0.8f) first = std::min<double>(first, p.z), last = std::max<double>(last, p.z);
    return {first, last};
}

TEST(Cartoon, ArrowsEndAtTheLastResidue) {
    Molecule molecule = zigzag(9);
    std::vector<SecondaryStructure> secondary(9, SecondaryStructure::none);
    for (int i = 2; i <= 6; ++i) secondary[i] = SecondaryStructure::strand;
    const Mesh mesh = cartoonOf(molecule, secondary);
    expectSound(mesh, molecule.atoms.size());
    // The head is widest at the residue before the last, and beyond the last one there is nothing but coil.
    EXPECT_NEAR(headOf(mesh).first, 3.3 * 5, 0.1);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3& p = mesh.positions[i];
        const bool strand = p.z > 3.3 * 2 - 0.05 && p.z < 3.3 * 6 - 0.05;
        EXPECT_TRUE(strand || std::abs(p.x) < 0.27f) << p.z;
    }
    double tip = 0;
    for (const glm::vec3& p : mesh.positions)
        if (std::abs(p.z - 3.3 * 6) < 0.02) tip = std::max<double>(tip, std::abs(p.x));
    EXPECT_NEAR(tip, 0.25, 0.01);
}

TEST(Cartoon, EveryFormIsClosedAndBelongsToResidues) {
    const Molecule molecule = chainOf(30, -57, -47);
    for (const HelixForm form : {HelixForm::ribbon, HelixForm::tube, HelixForm::cylinder})
        for (const bool putty : {false, true}) {
            CartoonOptions options;
            options.helices = form;
            options.putty = putty;
            const Mesh mesh = cartoonOf(molecule, options);
            expectSound(mesh, molecule.atoms.size());
            std::set<std::uint32_t> owners(mesh.atoms.begin(), mesh.atoms.end());
            EXPECT_EQ(owners.size(), molecule.residues.size());
            for (const std::uint32_t atom : owners) EXPECT_EQ(molecule.atoms[atom].name, Name("CA"));
            for (const glm::uvec3& t : mesh.triangles) {
                EXPECT_EQ(mesh.atoms[t.x], mesh.atoms[t.y]);
                EXPECT_EQ(mesh.atoms[t.x], mesh.atoms[t.z]);
            }
        }
}

TEST(Cartoon, ResiduesMeetHalfway) {
    const Molecule molecule = alphaCarbons({{0, 0, 0}, {0, 0, 3.8}, {0, 0, 7.6}});
    const Mesh mesh = cartoonOf(molecule);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const double z = mesh.positions[i].z, middle = 3.8 * mesh.atoms[i];
        EXPECT_GE(z, middle - 1.9 - (mesh.atoms[i] == 0 ? 1 : 1e-4));
        EXPECT_LE(z, middle + 1.9 + (mesh.atoms[i] == 2 ? 1 : 1e-4));
    }
}

TEST(Cartoon, AHiddenPartLeavesTheRestWhereItWas) {
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

TEST(Cartoon, ChainsBreakWhereTheyDo) {
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

TEST(Cartoon, InsertedModifiedAndRightHandedResiduesGoOn) {
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

TEST(Cartoon, OneOfAlternateConformersIsDrawn) {
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

TEST(Cartoon, DisulphidesAreSticksOfTheirAtoms) {
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

TEST(Cartoon, BasesArePlatesOrRungs) {
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

TEST(Cartoon, PuttyIsWideWhereBFactorsAre) {
    std::vector<glm::vec3> places;
    for (int i = 0; i < 21; ++i) places.emplace_back(0, 0, 3.8 * i);
    Molecule molecule = alphaCarbons(places);
    CartoonOptions options;
    options.putty = true;
    const auto radius = [&](double z) {
        double most = 0;
        for (const glm::vec3& p : cartoonOf(molecule, options).positions)
            if (std::abs(p.z - z) < 0.01) most = std::max(most, std::hypot<double>(p.x, p.y));
        return most;
    };
    EXPECT_NEAR(radius(3.8 * 10), 0.4, 1e-3);  // all alike
    for (std::size_t i = 0; i < 21; ++i) molecule.atoms[i].temperatureFactor = i == 10 ? 40.0f : i % 2 ? 10.0f : 30.0f;
    // mean 20.952, deviation 10.648: z = 1.789, -1.029 and 0.850.
    EXPECT_NEAR(radius(3.8 * 10), 1.043, 2e-3);
    EXPECT_NEAR(radius(3.8 * 5), 0.4 * 0.6, 1e-3);
    EXPECT_NEAR(radius(3.8 * 4), 0.680, 1e-3);
}

TEST(Cartoon, WhatCannotBeDrawnIsLeftOut) {
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

TEST(Cartoon, OneResidueIsARodOrABall) {
    for (const Molecule& molecule : {chainOf(1, -57, -47), alphaCarbons({{1, 2, 3}})}) {
        const Mesh mesh = cartoonOf(molecule);
        expectSound(mesh, molecule.atoms.size());
        EXPECT_FALSE(mesh.triangles.empty());
        for (const std::uint32_t atom : mesh.atoms) EXPECT_EQ(molecule.atoms[atom].name, Name("CA"));
    }
}

TEST(Cartoon, StraightOrTurningBackItStaysWhole) {
    // Collinear points, a chain that goes back upon itself, and corners of 90 degrees, in every structure.
    std::vector<glm::vec3> line, back, corners;
    for (int i = 0; i < 12; ++i) {
        line.emplace_back(3.8f * static_cast<float>(i), 0, 0);
        back.emplace_back(i % 2 ? 3.8f : 0, 0, 0);
        corners.emplace_back(3.8f * static_cast<float>(i / 2), 3.8f * static_cast<float>((i + 1) / 2), 0);
    }
    for (const auto& places : {line, back, corners})
        for (const auto kind : {SecondaryStructure::none, SecondaryStructure::helix, SecondaryStructure::strand})
            for (const HelixForm form : {HelixForm::ribbon, HelixForm::tube, HelixForm::cylinder}) {
                CartoonOptions options;
                options.helices = form;
                const Molecule molecule = alphaCarbons(places);
                const Mesh mesh = cartoonOf(molecule, all(molecule, kind), options);
                EXPECT_FALSE(mesh.triangles.empty());
                for (const glm::vec3& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1, 1e-4);
                for (const glm::vec3& p : mesh.positions) ASSERT_LT(glm::length(p), 60);
                EXPECT_EQ(test::openEdges(mesh), 0u);
            }
}

TEST(Cartoon, FilesOfEveryKindAreSound) {
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
