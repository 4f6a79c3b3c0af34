#include "engine/mesh/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "engine/error.h"
#include "engine/mesh/marching_cubes.h"
#include "engine/mesh/mesh_measures.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/element.h"
#include "engine/molecule/read.h"
#include "engine/molecule/residue_kind.h"
#include "engine/threads.h"
#include "tests/mesh/mesh_checks.h"
#include "tests/molecule/build_molecule.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

constexpr double kPi = std::numbers::pi;

Molecule carbons(const std::vector<glm::vec3>& places) {
    test::MoleculeText text;
    text.residue("LIG");
    for (const glm::vec3& place : places) text.atom("C", "C", place);
    return text.molecule;
}

Mesh makeSurface(const Molecule& molecule, const SurfaceOptions& options = {}) {
    return surface(molecule, drawnAtoms(molecule), options, {});
}

SurfaceOptions at(double resolution, double probe = 1.4, SurfaceKind kind = SurfaceKind::solventExcluded) {
    SurfaceOptions options{.kind = kind, .probe = probe, .resolution = resolution};
    return options;
}

void expectMeasures(const Mesh& mesh, double area, double volume, double share) {
    const MeshMeasures measures = measure(mesh);
    EXPECT_NEAR(measures.area, area, share * area);
    EXPECT_NEAR(measures.volume, volume, share * volume);
}

TEST(Surface, EveryCellIsCutSoThatItsFacesAgree) {
    // Around each face of each cell, what leaves one cell enters the other: no edge of a triangle that lies within a
    // face is used twice in the same sense.
    for (std::size_t inside = 0; inside < 256; ++inside) {
        std::size_t crossed = 0;
        for (const CellEdge& edge : cellEdges()) crossed += (inside >> edge.from & 1) != (inside >> edge.to & 1);
        std::set<int> used;
        for (const CellTriangle& triangle : cellTriangles()[inside])
            for (const std::uint8_t e : triangle) {
                const CellEdge edge = cellEdges()[e];
                EXPECT_NE(inside >> edge.from & 1, inside >> edge.to & 1);
                used.insert(e);
            }
        EXPECT_EQ(used.size(), crossed) << inside;
    }
}

TEST(Surface, AnAtomIsASphere) {
    const Molecule molecule = carbons({{10, -20, 30}});
    const double r = vanDerWaalsRadius(6);
    for (const double probe : {0.0, 1.4, 3.0}) {
        const Mesh mesh = makeSurface(molecule, at(0.15, probe));
        test::expectSound(mesh, 1);
        expectMeasures(mesh, 4 * kPi * r * r, 4 * kPi * r * r * r / 3, 0.005);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec3 way = mesh.positions[i] - molecule.atoms[0].position;
            ASSERT_NEAR(glm::length(way), r, 1e-3);
            ASSERT_GT(glm::dot(glm::normalize(way), mesh.normals[i]), 0.99999f);
        }
    }
    const double large = r + 1.4;
    expectMeasures(makeSurface(molecule, at(0.15, 1.4, SurfaceKind::solventAccessible)), 4 * kPi * large * large,
                   4 * kPi * large * large * large / 3, 0.005);
    expectMeasures(makeSurface(molecule, at(0.15, 0, SurfaceKind::gaussian)), 4 * kPi * r * r, 4 * kPi * r * r * r / 3,
                   0.005);
}

TEST(Surface, ASumOfGaussiansIsOneOnTheirSurface) {
    const Molecule dna = sampleMolecule("dna");
    const auto atoms = drawnAtoms(dna);
    const Mesh mesh = makeSurface(dna, at(0.6, 0, SurfaceKind::gaussian));
    for (std::size_t v = 0; v < mesh.positions.size(); v += 17) {
        const glm::dvec3 place(mesh.positions[v]);
        double all = 0, sum = 0, nearest = 1e9, own = 1e9;
        glm::dvec3 outwards(0);
        for (const std::uint32_t i : atoms) {
            const double r = vanDerWaalsRadius(dna.atoms[i].element);
            const glm::dvec3 way = place - glm::dvec3(dna.atoms[i].position);
            const double part = std::exp(1.5 * (1 - glm::dot(way, way) / (r * r)));
            all += part;
            nearest = std::min(nearest, glm::length(way) - r);
            if (i == mesh.atoms[v]) own = glm::length(way) - r;
            if (glm::length(way) > 2.5 * r) continue;  // where they end
            sum += part;
            outwards += way * (part / (r * r));
        }
        // A vertex keeps 0.012 Å away from the nodes of the grid.
        ASSERT_NEAR(all, 1, 0.04) << v;
        ASSERT_NEAR(sum, 1, 0.03) << v;
        ASSERT_GT(glm::dot(glm::normalize(outwards), glm::dvec3(mesh.normals[v])), 0.998) << v;
        ASSERT_NEAR(own, nearest, 0.02) << v;
    }
}

TEST(Surface, RadiiAreScaledAndMayBeOthers) {
    for (const SurfaceKind kind : {SurfaceKind::solventExcluded, SurfaceKind::gaussian}) {
        SurfaceOptions options = at(0.15, 1.4, kind);
        options.scale = 1.5;
        options.radius = [](Element) { return 2.0f; };
        expectMeasures(makeSurface(carbons({{10, -20, 30}}), options), 4 * kPi * 9, 4 * kPi * 9, 0.005);
    }
}

/// Two carbons `apart` along x, and a probe that rolls around between them: a body of revolution of two parts of
/// spheres and one of a torus.
void expectPair(double apart, double probe) {
    const double r = vanDerWaalsRadius(6), reach = r + probe, half = apart / 2;
    const double ring = std::sqrt(reach * reach - half * half), contact = half * probe / reach;
    ASSERT_GT(ring, probe);  // else the torus meets itself
    const double phi = std::asin(half / reach);
    const double area =
        2 * 2 * kPi * r * r * (1 + half / reach) + 2 * 2 * kPi * probe * (ring * phi - probe * std::sin(phi));
    double volume = 0;
    constexpr int kSlices = 20000;
    for (int i = 0; i < kSlices; ++i) {
        const double x = (i + 0.5) / kSlices * (half + r);
        const double y = x < contact ? ring - std::sqrt(probe * probe - x * x)
                                     : std::sqrt(std::max(r * r - (x - half) * (x - half), 0.0));
        volume += 2 * kPi * y * y * (half + r) / kSlices;
    }
    const float x = static_cast<float>(half);
    const Mesh mesh = makeSurface(carbons({{-x, 0, 0}, {x, 0, 0}}), at(0.15, probe));
    SCOPED_TRACE(std::to_string(apart) + " Å, probe " + std::to_string(probe));
    test::expectSound(mesh, 2);
    expectMeasures(mesh, area, volume, 0.005);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        if (std::abs(mesh.positions[i].x) > 0.05f) {
            EXPECT_EQ(mesh.atoms[i], mesh.positions[i].x > 0 ? 1u : 0u);
        }
}

TEST(Surface, TheProbeRollsBetweenTwoAtoms) {
    for (const double apart : {0.8, 1.5, 2.5, 3.6}) expectPair(apart, 1.4);
    expectPair(3.0, 2.5);
}

TEST(Surface, TheProbeStopsBetweenThreeAtoms) {
    // Corners of a triangle of 4.4 Å: the probe touches all three, from either side, and cannot pass. In the middle
    // the surface is where that probe is nearest: 1.4 Å below its centre.
    const double side = 4.4, reach = vanDerWaalsRadius(6) + 1.4;
    const double out = side / std::sqrt(3.0), height = std::sqrt(reach * reach - out * out);
    ASSERT_GT(height, 1.4);
    std::vector<glm::vec3> places;
    for (int i = 0; i < 3; ++i)
        places.emplace_back(out * std::cos(2 * kPi * i / 3), out * std::sin(2 * kPi * i / 3), 0);
    const Mesh mesh = makeSurface(carbons(places), at(0.1));
    test::expectSound(mesh, 3);
    std::size_t found = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 p(mesh.positions[i]);
        if (std::hypot(p.x, p.y) > 0.2) continue;
        ++found;
        const glm::dvec3 center(0, 0, p.z > 0 ? height : -height);
        EXPECT_NEAR(glm::distance(p, center), 1.4, 2e-3);
        EXPECT_GT(glm::dot(glm::normalize(center - p), glm::dvec3(mesh.normals[i])), 0.9999);
    }
    EXPECT_GT(found, 5u);
}

TEST(Surface, CavitiesAreKeptOrDropped) {
    // A ball of carbons of radius 3.55 Å: within it there is room for a water, and no way in.
    const Molecule ball = sampleMolecule("buckyball");
    SurfaceOptions options = at(0.3);
    const Mesh both = makeSurface(ball, options);
    options.cavities = false;
    const Mesh outer = makeSurface(ball, options);
    test::expectSound(both, ball.atoms.size());
    test::expectSound(outer, ball.atoms.size());
    const auto parts = [](const Mesh& mesh) {
        const auto of = meshParts(mesh);
        return *std::max_element(of.begin(), of.end()) + 1;
    };
    EXPECT_EQ(parts(both), 2u);
    EXPECT_EQ(parts(outer), 1u);
    EXPECT_GT(measure(outer).volume, measure(both).volume + 10);
    for (const glm::vec3& p : outer.positions) EXPECT_GT(glm::length(p), 4);
}

TEST(Surface, ThreadsAndPlacesChangeNothing) {
    Molecule dna = sampleMolecule("dna");
    setThreadsPerTask(1);
    const Mesh a = makeSurface(dna, at(0.7));
    setThreadsPerTask(4);
    const Mesh b = makeSurface(dna, at(0.7));
    setThreadsPerTask(0);
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.atoms, b.atoms);
    test::expectSound(a, dna.atoms.size());
    // Vertices of neighbouring blocks are one: nothing stands twice at a place.
    const auto welded = test::weldedVertices(a);
    std::size_t twice = 0;
    for (std::uint32_t i = 0; i < welded.size(); ++i) twice += welded[i] != i;
    EXPECT_EQ(twice, 0u);
    // Relative to its atoms the grid stays, wherever they are.
    for (Atom& atom : dna.atoms) atom.position += glm::vec3(512, -256, 64);
    const Mesh moved = surface(dna, drawnAtoms(dna), at(0.7), {512, -256, 64});
    EXPECT_EQ(moved.triangles.size(), a.triangles.size());
    EXPECT_NEAR(measure(moved).volume, measure(a).volume, 1e-3 * measure(a).volume);
}

/// Closed; slivers at creases may look inwards.
void expectCreased(const Mesh& mesh) {
    EXPECT_EQ(test::openEdges(mesh), 0u);
    double inward = 0, area = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
        const glm::vec3 way = glm::cross(b - a, c - a);
        area += glm::length(way);
        if (glm::dot(way, mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z]) < 0) inward += glm::length(way);
    }
    EXPECT_LT(inward, 0.005 * area);
}

// Crambin's (1CRN) with radii C 1.70, N 1.55, O 1.52, S 1.80 and a probe of 1.4 Å, by programs that are not ours:
// `freesasa -L -O -n 1000` (2.1.2, Debian's; Lee and Richards), and SciPy 1.10's exact distance transform from the
// nodes outside, counted and cut by scikit-image's marching cubes on grids of 0.2, 0.15 and 0.1 Å (volumes 4804, 4769,
// 4725, areas 2290.5, 2293.3, 2300.4), and drawn on in a straight line to no grid at all.
constexpr double kFreesasaArea = 2971.30, kEdtVolume = 4647, kEdtArea = 2309;

TEST(Surface, CrambinsIsWhatOthersFind) {
    NACRE_NEEDS_DATA();
    const Molecule crambin = readMoleculeFile(test::dataFile("1crn.pdb"));
    // That of the probe's centre has creases, which have vertices of their own.
    for (const double resolution : {0.2, 0.4, 0.0}) {
        const Mesh accessible = makeSurface(crambin, at(resolution, 1.4, SurfaceKind::solventAccessible));
        EXPECT_NEAR(measure(accessible).area, kFreesasaArea, 0.01 * kFreesasaArea) << resolution;
        expectCreased(accessible);
    }
    const Mesh excluded = makeSurface(crambin, at(0.3));
    EXPECT_NEAR(measure(excluded).volume, kEdtVolume, 0.01 * kEdtVolume);
    EXPECT_NEAR(measure(excluded).area, kEdtArea, 0.01 * kEdtArea);
    test::expectSound(excluded, crambin.atoms.size());
    // As it comes, without a word about the grid.
    expectMeasures(makeSurface(crambin), kEdtArea, kEdtVolume, 0.01);
}

/// As they come, beside the areas and volumes that BALL 1.5 (Debian's libball1.5-dev: calculateSESArea() and
/// calculateSESVolume() of analyticalSES.h, after Connolly, no grid) has of the same spheres and a probe of 1.4 Å.
TEST(Surface, OfProteinsAndDnaIsWhatAnotherProgramFinds) {
    NACRE_NEEDS_DATA();
    for (const auto& [name, atoms, area, volume] : {std::tuple{"1crn.pdb", 327u, 2319.02, 4664.37},
                                                    {"1bna.cif", 486u, 3495.00, 5841.51},
                                                    {"trna-4tra.pdb", 1652u, 11262.65, 20240.44},
                                                    {"4hhb.pdb", 4384u, 27513.48, 66271.64}}) {
        SCOPED_TRACE(name);
        const Molecule molecule = readMoleculeFile(test::dataFile(name));
        const std::vector<ResidueKind> kinds = residueKinds(molecule);
        std::vector<std::uint32_t> chain = drawnAtoms(molecule);
        std::erase_if(chain, [&](std::uint32_t atom) {
            const ResidueKind kind = kinds[molecule.atoms[atom].residue];
            return kind != ResidueKind::protein && kind != ResidueKind::nucleic;
        });
        EXPECT_EQ(chain.size(), atoms);
        expectMeasures(surface(molecule, chain, {}, {}), area, volume, 0.01);
    }
}

/// The area that is open of spheres about some atoms, by places spread evenly over each (A. Shrake and J. A. Rupley, J.
/// Mol. Biol. 79 (1973) 351).
double openArea(const Molecule& molecule, std::span<const std::uint32_t> atoms, double probe) {
    constexpr int kPlaces = 1000;
    double area = 0;
    for (const std::uint32_t i : atoms) {
        const glm::dvec3 center(molecule.atoms[i].position);
        const double radius = vanDerWaalsRadius(molecule.atoms[i].element) + probe;
        std::vector<glm::dvec4> near;
        for (const std::uint32_t j : atoms) {
            const double reach = vanDerWaalsRadius(molecule.atoms[j].element) + probe;
            const glm::dvec3 other(molecule.atoms[j].position);
            if (i != j && glm::distance(center, other) < radius + reach) near.emplace_back(other, reach);
        }
        int open = 0;
        for (int k = 0; k < kPlaces; ++k) {
            const double z = 1 - (2 * k + 1.0) / kPlaces, turn = k * kPi * (3 - std::sqrt(5.0));
            const double across = std::sqrt(1 - z * z);
            const glm::dvec3 place = center + radius * glm::dvec3(across * std::cos(turn), across * std::sin(turn), z);
            open += std::ranges::none_of(
                near, [&](const glm::dvec4& ball) { return glm::distance(place, glm::dvec3(ball)) < ball.w; });
        }
        area += 4 * kPi * radius * radius * open / kPlaces;
    }
    return area;
}

TEST(Surface, ThatOfTheProbesCentreAndThatOfTheAtomsHaveTheAreaOfTheirSpheres) {
    for (const char* name : {"dna", "glucose", "buckyball"}) {
        const Molecule molecule = sampleMolecule(name);
        const std::vector<std::uint32_t> atoms = drawnAtoms(molecule);
        for (const double probe : {0.7, 1.4, 2.0}) {
            if (name == std::string("buckyball") && probe != 1.4)
                continue;  // whose sixty spheres nearly meet in a point
            SCOPED_TRACE(name + std::string(", probe ") + std::to_string(probe));
            const Mesh mesh = makeSurface(molecule, at(0, probe, SurfaceKind::solventAccessible));
            const double area = openArea(molecule, atoms, probe);
            EXPECT_NEAR(measure(mesh).area, area, (probe == 1.4 ? 0.01 : 0.02) * area);
            expectCreased(mesh);
            // Every vertex is on the sphere of its atom.
            for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
                const Atom& atom = molecule.atoms[mesh.atoms[i]];
                ASSERT_NEAR(glm::distance(mesh.positions[i], atom.position), vanDerWaalsRadius(atom.element) + probe,
                            1e-3);
            }
        }
        const double bare = openArea(molecule, atoms, 0);
        EXPECT_NEAR(measure(makeSurface(molecule, at(0, 0))).area, bare, 0.04 * bare) << name;
    }
}

TEST(Surface, WhatCannotBeMadeIsNot) {
    EXPECT_TRUE(makeSurface(Molecule()).triangles.empty());
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Mesh one = makeSurface(carbons({{nan, 0, 0}, {1, 2, 3}}));
    test::expectSound(one, 2);
    EXPECT_FALSE(one.triangles.empty());
    // Atoms upon one another, in a line, on a square of which four spheres meet at points, and far apart.
    const std::vector<std::vector<glm::vec3>> odd = {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
                                                     {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},
                                                     {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {3, 3, 0}},
                                                     {{0, 0, 0}, {1e5f, 0, 0}, {0, -1e5f, 1e5f}}};
    for (const auto& places : odd)
        for (const double probe : {0.0, 1.4, 10.0})
            for (const SurfaceKind kind : {SurfaceKind::solventExcluded, SurfaceKind::gaussian}) {
                const Mesh mesh = makeSurface(carbons(places), at(0.5, probe, kind));
                if (probe > 0) test::expectSound(mesh, places.size());
                EXPECT_EQ(test::openEdges(mesh), 0u);  // in the crevices of bare spheres triangles may look inwards
                EXPECT_FALSE(mesh.triangles.empty());
                for (const glm::vec3& p : mesh.positions) {
                    float nearest = 1e9f;
                    for (const glm::vec3& place : places) nearest = std::min(nearest, glm::distance(p, place));
                    ASSERT_LT(nearest, 2.8f);  // no spike
                }
            }
    // Too much is refused before it is made.
    std::vector<glm::vec3> many;
    for (int i = 0; i < 200'000; ++i) many.emplace_back(4 * (i % 60), 4 * (i / 60 % 60), 4 * (i / 3600));
    EXPECT_THROW(makeSurface(carbons(many), at(0.1)), Error);
}

TEST(Surface, ResolutionGoesWithTheAtoms) {
    for (const SurfaceKind kind : {SurfaceKind::solventExcluded, SurfaceKind::gaussian}) {
        EXPECT_EQ(surfaceResolution(10, kind), 0.4);
        EXPECT_GT(surfaceResolution(60'000, kind), 0.6);
        EXPECT_EQ(surfaceResolution(10'000'000, kind), kCoarsestSurface);
    }
}

}  // namespace
}  // namespace nacre
