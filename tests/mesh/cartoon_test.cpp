// The forms of cartoons: where their curves go, how their sections lie, and that they are closed.

#include "engine/mesh/cartoon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>

#include "engine/mesh/cartoon_curve.h"
#include "engine/mesh/cartoon_trace.h"
#include "tests/mesh/cartoon_makers.h"

namespace nacre {
namespace {

using test::all;
using test::alphaCarbons;
using test::buildChain;
using test::expectSound;
using test::makeCartoon;
using test::zigzag;

/// An alpha helix of alpha carbons about the z axis: radius 2.3 Å, 100 degrees and 1.5 Å a residue.
Molecule helixOfAlphaCarbons(int residues) {
    std::vector<glm::vec3> places;
    for (int i = 0; i < residues; ++i) {
        const double turn = i * 100 * std::numbers::pi / 180;
        places.emplace_back(2.3 * std::cos(turn), 2.3 * std::sin(turn), 1.5 * i);
    }
    return alphaCarbons(places);
}

std::vector<Frame> collectFrames(const Molecule& molecule, SecondaryStructure kind,
                                 HelixForm form = HelixForm::ribbon) {
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
    const std::vector<Frame> frames = collectFrames(helixOfAlphaCarbons(20), SecondaryStructure::helix);
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
        const std::vector<Frame> frames = collectFrames(helixOfAlphaCarbons(20), SecondaryStructure::helix, form);
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
        const std::vector<Frame> frames = collectFrames(alphaCarbons(places), SecondaryStructure::helix, form);
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
    const std::vector<Frame> frames = collectFrames(zigzag(10), SecondaryStructure::strand);
    for (const Frame& frame : frames) {
        EXPECT_LT(std::hypot(frame.center.x, frame.center.y), 0.05);
        EXPECT_GT(std::abs(frame.side.x), 0.999);  // across the zigzag
    }
    expectNoFlips(frames, 0.999);
    // With carbonyls, which point to one side and the other by turns; real strands twist.
    for (const double phi : {-120.0, -135.0, -105.0}) {
        const std::vector<Frame> real = collectFrames(buildChain(12, phi, 130), SecondaryStructure::strand);
        expectNoFlips(real, 0.98);
        for (std::size_t k = 1; k < real.size(); ++k)
            EXPECT_GT(glm::dot(real[k].tangent, real[k - 1].tangent), 0.98) << phi << ' ' << k;
    }
}

TEST(Cartoon, ABulgeDoesNotTurnAStrandOver) {
    Molecule molecule = buildChain(12, -120, 130);
    // One carbonyl to the same side as its neighbours', as in a bulge.
    glm::vec3& o = molecule.atoms[6 * 4 + 3].position;
    o = 2.0f * molecule.atoms[6 * 4 + 2].position - o;
    expectNoFlips(collectFrames(molecule, SecondaryStructure::strand), 0.95);
}

/// Of the vertices farther than 0.9 Å from the line of a zigzag: how far along it they stand.
std::pair<double, double> measureHead(const Mesh& mesh) {
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
    const Mesh mesh = makeCartoon(molecule, secondary);
    expectSound(mesh, molecule.atoms.size());
    // The head is widest at the residue before the last, and beyond the last one there is nothing but coil.
    EXPECT_NEAR(measureHead(mesh).first, 3.3 * 5, 0.1);
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
    const Molecule molecule = buildChain(30, -57, -47);
    for (const HelixForm form : {HelixForm::ribbon, HelixForm::tube, HelixForm::cylinder})
        for (const bool putty : {false, true}) {
            const Mesh mesh = makeCartoon(molecule, CartoonOptions{.helices = form, .putty = putty});
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

TEST(Cartoon, PuttyIsWideWhereBFactorsAre) {
    std::vector<glm::vec3> places;
    for (int i = 0; i < 21; ++i) places.emplace_back(0, 0, 3.8 * i);
    Molecule molecule = alphaCarbons(places);
    CartoonOptions options{.putty = true};
    const auto radius = [&](double z) {
        double most = 0;
        for (const glm::vec3& p : makeCartoon(molecule, options).positions)
            if (std::abs(p.z - z) < 0.01) most = std::max(most, std::hypot<double>(p.x, p.y));
        return most;
    };
    EXPECT_NEAR(radius(3.8 * 10), 0.4, 1e-3);  // all alike
    for (std::size_t i = 0; i < 21; ++i) molecule.atoms[i].temperatureFactor = i == 10 ? 40.0f : i % 2 ? 10.0f : 30.0f;
    // mean 20.952, deviation 10.648: z = 1.789, -1.029 and 0.850.
    EXPECT_NEAR(radius(3.8 * 10), 1.043, 2e-3);
    EXPECT_NEAR(radius(3.8 * 5), 0.4 * 0.6, 1e-3);
    EXPECT_NEAR(radius(3.8 * 4), 0.680, 1e-3);
    options.tube = 0.2, options.tubePerTemperature = 0.1;
    EXPECT_NEAR(radius(3.8 * 10), 4.2, 1e-2);
    EXPECT_NEAR(radius(3.8 * 5), 1.2, 1e-2);
}

TEST(Cartoon, FoldsMayReachHalfAResidueFarther) {
    const Molecule molecule = zigzag(12);
    std::vector<SecondaryStructure> folds = all(molecule, SecondaryStructure::none);
    for (std::size_t i = 4; i < 8; ++i) folds[i] = SecondaryStructure::strand;
    const auto strand = [&](double overhang) {
        const Mesh mesh = makeCartoon(molecule, folds, CartoonOptions{.overhang = overhang});
        expectSound(mesh, molecule.atoms.size());
        std::pair<double, double> ends(1e9, -1e9);  // of what is wider than a coil
        for (const glm::vec3& p : mesh.positions)
            if (std::abs(p.x) > 0.5f || std::abs(p.y) > 1.5f)
                ends = {std::min<double>(ends.first, p.z), std::max<double>(ends.second, p.z)};
        return ends;
    };
    const auto [first, last] = strand(0);
    const auto [earlier, later] = strand(0.5);
    EXPECT_NEAR(first - earlier, 1.65, 0.5);
    EXPECT_NEAR(later - last, 1.65, 0.5);
    const Molecule helix = buildChain(30, -57, -47);
    for (const HelixForm form : {HelixForm::ribbon, HelixForm::tube, HelixForm::cylinder}) {
        expectSound(makeCartoon(helix, CartoonOptions{.helices = form, .overhang = 0.5}), helix.atoms.size());
    }
}

TEST(Cartoon, WidthsAreScaled) {
    const auto reach = [](CartoonOptions options, double scale) {
        options.scale = scale;
        const Molecule molecule = zigzag(12);
        Mesh mesh = makeCartoon(molecule, all(molecule, SecondaryStructure::none), options);
        expectSound(mesh, molecule.atoms.size());
        double x = 0;
        for (const glm::vec3& p : mesh.positions) x = std::max(x, std::abs(static_cast<double>(p.x)));
        return x;  // across the plane of the zigzag
    };
    EXPECT_NEAR(reach({}, 1), 0.25, 0.01);
    EXPECT_NEAR(reach({}, 3), 0.75, 0.03);
    CartoonOptions tube{.putty = true, .tube = 0.2};
    EXPECT_NEAR(reach(tube, 1), 0.2, 0.01);
    EXPECT_NEAR(reach(tube, 2), 0.4, 0.02);
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
                const Molecule molecule = alphaCarbons(places);
                const Mesh mesh = makeCartoon(molecule, all(molecule, kind), CartoonOptions{.helices = form});
                EXPECT_FALSE(mesh.triangles.empty());
                for (const glm::vec3& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1, 1e-4);
                for (const glm::vec3& p : mesh.positions) ASSERT_LT(glm::length(p), 60);
                EXPECT_EQ(test::openEdges(mesh), 0u);
            }
}

}  // namespace
}  // namespace nacre
