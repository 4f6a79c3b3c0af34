// Coarser levels of cartoons: closed as the finest, fewer triangles each, and off by no more than they say.

#include "engine/mesh/mesh_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "engine/mesh/cartoon.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/kabsch_sander.h"
#include "engine/molecule/samples/samples.h"
#include "tests/mesh/mesh_checks.h"
#include "tests/molecule/build_peptide.h"

namespace nacre {
namespace {

/// Distance of a point from a triangle, squared: to its plane where it stands above it, else to its nearest edge.
double squareToTriangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double area = glm::dot(n, n);
    const auto inside = [&](const glm::dvec3& from, const glm::dvec3& to) {
        return glm::dot(glm::cross(to - from, p - from), n) >= 0;
    };
    if (area > 0 && inside(a, b) && inside(b, c) && inside(c, a)) {
        const double above = glm::dot(p - a, n);
        return above * above / area;
    }
    const auto toEdge = [&](const glm::dvec3& from, const glm::dvec3& to) {
        const glm::dvec3 along = to - from;
        const double t = std::clamp(glm::dot(p - from, along) / std::max(glm::dot(along, along), 1e-30), 0.0, 1.0);
        const glm::dvec3 off = p - from - along * t;
        return glm::dot(off, off);
    };
    return std::min({toEdge(a, b), toEdge(b, c), toEdge(c, a)});
}

/// The farthest that corners and middles of some triangles stand from others; of many triangles, of each fourth.
double farthest(const Mesh& mesh, const std::vector<glm::uvec3>& from, const std::vector<glm::uvec3>& to) {
    double most = 0;
    const auto at = [&](std::uint32_t v) { return glm::dvec3(mesh.positions[v]); };
    for (std::size_t i = 0; i<from.size(); i += from.size()> 400 ? 4 : 1) {
        const glm::uvec3& t = from[i];
        for (const glm::dvec3& p : {at(t.x), (at(t.x) + at(t.y) + at(t.z)) / 3.0, (at(t.x) + at(t.z)) / 2.0}) {
            double nearest = std::numeric_limits<double>::max();
            for (const glm::uvec3& other : to) {
                if (nearest <= std::max(most, 1e-6)) break;
                nearest = std::min(nearest, squareToTriangle(p, at(other.x), at(other.y), at(other.z)));
            }
            most = std::max(most, nearest);
        }
    }
    return std::sqrt(most);
}

struct LevelCase {
    const char* name;
    Molecule molecule;
    CartoonOptions options;
};

std::vector<LevelCase> levelCases() {
    CartoonOptions tubes, putty, ladder;
    tubes.helices = HelixForm::tube;
    putty.putty = true;
    ladder.bases = BaseForm::ladder;
    ladder.sides = 10;
    ladder.segments = 6;
    const Molecule dna = sampleDna();
    return {{"helix", test::buildChain(6, -57, -47), {}},
            {"strand", test::buildChain(6, -120, 130), {}},
            {"coil", test::buildChain(4, -75, 145), {}},
            {"tubes", test::buildChain(6, -57, -47), tubes},
            {"putty", test::buildChain(4, -60, -40), putty},
            {"DNA", dna, {}},
            {"ladder", dna, ladder}};
}

Mesh makeMesh(const LevelCase& c) {
    std::vector<SecondaryStructure> folds = secondaryStructure(c.molecule);
    if (c.name == std::string("strand")) std::fill(folds.begin(), folds.end(), SecondaryStructure::strand);
    std::vector<std::uint32_t> atoms = drawnAtoms(c.molecule);
    // Of the DNA two stretches of two pairs.
    std::erase_if(atoms, [&](std::uint32_t atom) {
        return c.molecule.residues.size() > 12 && c.molecule.atoms[atom].residue % 10 > 1;
    });
    return cartoon(c.molecule, atoms, folds, c.options, {});
}

TEST(MeshLevels, OfCartoonsAreClosedAndKeepWithinTheirError) {
    for (const LevelCase& c : levelCases()) {
        Mesh mesh = makeMesh(c);
        ASSERT_FALSE(mesh.triangles.empty()) << c.name;
        ASSERT_GE(mesh.coarser.size(), 3u) << c.name;
        std::size_t together = 0;
        for (const MeshLevel& level : mesh.coarser) together += level.triangles.size();
        EXPECT_LE(together, mesh.triangles.size()) << c.name;
        const std::vector<glm::uvec3> finest = mesh.triangles;
        std::size_t before = finest.size();
        for (const MeshLevel& level : mesh.coarser) {
            const std::string what = std::string(c.name) + " at " + std::to_string(level.error);
            const auto error = static_cast<double>(level.error);
            EXPECT_LE(level.triangles.size(), before) << what;
            before = level.triangles.size();
            EXPECT_LE(farthest(mesh, finest, level.triangles), error * 1.01) << what;
            EXPECT_LE(farthest(mesh, level.triangles, finest), error * 1.01) << what;
            mesh.triangles = level.triangles;
            EXPECT_EQ(test::openEdges(mesh), 0u) << what;
            EXPECT_GT(test::enclosedVolume(mesh), 0) << what;
        }
        EXPECT_LT(before, finest.size() / 4) << c.name;
    }
}

TEST(MeshLevels, PolygonsAreAsEvenAsTheirPointsLie) {
    for (const std::size_t count : {4u, 8u, 10u, 12u}) {
        const std::vector<Picks> polygons = makePolygons(count);
        EXPECT_EQ(polygons.back(), allPicks(count));
        for (const Picks& picks : polygons)
            for (std::size_t i = 0; i < picks.size(); ++i) {
                const std::size_t next = i + 1 < picks.size() ? picks[i + 1] : picks[0] + count;
                EXPECT_GE(next - picks[i], count / picks.size());
                EXPECT_LE(next - picks[i], (count + picks.size() - 1) / picks.size());
            }
    }
    // A square in a circle: 1 - sqrt(1/2) of the radius is left out; in an ellipse less than of either axis.
    EXPECT_EQ(circlePicks(12, 1, 0.3).size(), 4u);
    EXPECT_EQ(circlePicks(12, 1, 0.29).size(), 6u);
    EXPECT_EQ(circlePicks(12, 1, 0), allPicks(12));
}

}  // namespace
}  // namespace nacre
