// Style::ellipsoids in a scene.

#include "engine/scene/build/atom_ellipsoids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gemmi/symmetry.hpp>
#include <gemmi/unitcell.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <set>

#include "engine/molecule/displacement.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/element.h"
#include "engine/molecule/read.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/color/colors.h"
#include "engine/scene/view/camera.h"
#include "tests/reference/displacements.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

Representation ellipsoidScene(const Molecule& m, double probability = 50, const std::string& assembly = "") {
    RepresentationOptions look{.style = Style::ellipsoids};
    look.sizes.probability = probability;
    look.assembly = assembly;
    return represent(m, drawnAtoms(m), look);
}

Molecule smallCrystal() { return readMoleculeFile(test::dataFile("small/core-867861.cif")); }

/// The quadric's value at a point: 1 on the surface of the tensor itself.
double quadricAt(const Displacement& u, const glm::dvec3& fromCenter) {
    return glm::dot(fromCenter, glm::inverse(tensorMatrix(u)) * fromCenter);
}

TEST(AtomEllipsoids, HoldTheirAtomsWithTheProbability) {
    NACRE_NEEDS_DATA();
    const Molecule m = smallCrystal();
    for (const double percent : {50.0, 90.0}) {
        const Representation r = ellipsoidScene(m, percent);
        const double square = percent == 50 ? 1.5382 * 1.5382 : 6.251;  // chi-square with three degrees of freedom
        std::set<std::uint32_t> atoms;
        ASSERT_FALSE(r.triangles.empty());
        for (std::size_t i = 0; i < r.triangles.size(); i += 37) {
            const Triangle& t = r.triangles[i];
            for (const std::uint32_t v : {t.a, t.b, t.c}) {
                const std::uint32_t atom = r.meshLooks[r.meshVertices[v].look].atom - 1;
                atoms.insert(atom);
                const glm::dvec3 at = glm::dvec3(decodePosition(r.meshVertices[v], t.step())) + r.center -
                                      glm::dvec3(m.atoms[atom].position);
                ASSERT_NEAR(quadricAt(m.displacements[atom], at), square, 2e-3 * square);
            }
        }
        for (const std::uint32_t atom : drawnAtoms(m))
            EXPECT_EQ(atoms.contains(atom), m.displacements[atom].stated()) << m.atoms[atom].name.view();
        EXPECT_TRUE(std::ranges::all_of(r.meshes, [](const MeshRun& mesh) { return mesh.closed; }));
    }
}

TEST(AtomEllipsoids, AllOfThemAreInTheirScene) {
    NACRE_NEEDS_DATA();
    const Representation r = ellipsoidScene(smallCrystal(), 99);
    for (const Triangle& t : r.triangles)
        EXPECT_LE(glm::length(glm::dvec3(decodePosition(r.meshVertices[t.a], t.step()))), r.radius + 1e-4);
}

/// By symmetry of the file's fractional frame: beta' = W beta W^T (Trueblood et al., Acta Cryst. A52 (1996) 770).
TEST(AtomEllipsoids, CopiesBySymmetryTurn) {
    const std::string text =
        "data_x\n_cell_length_a 6\n_cell_length_b 6\n_cell_length_c 9\n_cell_angle_alpha 90\n_cell_angle_beta 90\n"
        "_cell_angle_gamma 120\nloop_\n_symmetry_equiv_pos_as_xyz\nx,y,z\n-y,x-y,z+1/3\n-x+y,-x,z+2/3\n"
        "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\nSi1 0.4 0.1 0.2\n"
        "loop_\n_atom_site_aniso_label\n_atom_site_aniso_U_11\n_atom_site_aniso_U_22\n_atom_site_aniso_U_33\n"
        "_atom_site_aniso_U_12\n_atom_site_aniso_U_13\n_atom_site_aniso_U_23\nSi1 0.02 0.05 0.09 0.01 0.02 -0.01\n";
    const Molecule m = readMolecule("a.cif", text);
    const Representation r = ellipsoidScene(m, 50, "unit-cell");
    gemmi::UnitCell cell;
    cell.set(6, 6, 9, 90, 90, 120);
    const double lengths[3] = {cell.ar, cell.br, cell.cr};
    const double u[3][3] = {{0.02, 0.01, 0.02}, {0.01, 0.05, -0.01}, {0.02, -0.01, 0.09}};
    ASSERT_EQ(r.copies.triangles.size(), 1u);
    std::set<int> met;
    for (const std::uint32_t copy : r.copies.lists[r.copies.triangles[0].list]) {
        const glm::dmat4x3& motion = r.copies.transforms[copy];
        const glm::dvec3 center = motion * glm::dvec4(glm::dvec3(m.atoms[0].position) - r.center, 1);
        // The operation that this copy is: the one whose turn its motion has.
        int found = -1;
        glm::dmat3 expected(0.0);
        int number = 0;
        for (const char* triplet : {"x,y,z", "-y,x-y,z+1/3", "-x+y,-x,z+2/3"}) {
            const gemmi::Op operation = gemmi::parse_triplet(triplet);
            glm::dmat3 w(0.0), beta(0.0), edges(0.0);
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) {
                    w[j][i] = double(operation.rot[i][j]) / gemmi::Op::DEN;
                    beta[j][i] = u[i][j] * lengths[i] * lengths[j];
                    edges[j][i] = cell.orth.mat[i][j];
                }
            const glm::dmat3 turn = edges * w * glm::inverse(edges);
            double apart = 0;
            for (int j = 0; j < 3; ++j) apart += glm::distance(turn[j], motion[j]);
            if (apart < 1e-6) {
                found = number;
                expected = edges * (w * beta * glm::transpose(w)) * glm::transpose(edges);
            }
            ++number;
        }
        ASSERT_GE(found, 0);
        met.insert(found);
        for (std::size_t i = 0; i < r.triangles.size(); i += 7) {
            const glm::dvec3 at =
                motion * glm::dvec4(decodePosition(r.meshVertices[r.triangles[i].a], r.triangles[i].step()), 1);
            ASSERT_NEAR(quadricAt(toDisplacement(expected), at - center), 1.5382 * 1.5382, 5e-3);
        }
    }
    EXPECT_EQ(met.size(), 3u);
}

TEST(AtomEllipsoids, OtherAtomsAreSpheres) {
    Molecule m = sampleMolecule("glucose");
    m.displacements.resize(m.atoms.size());
    for (Atom& atom : m.atoms) atom.temperatureFactor = 0;
    std::vector<std::uint32_t> heavy;
    for (std::uint32_t i = 0; i < m.atoms.size(); ++i)
        if (!isHydrogen(m.atoms[i].element)) heavy.push_back(i);
    m.displacements[heavy[0]] = {0.04f, 0.03f, 0.02f, 0, 0, 0};
    m.displacements[heavy[1]] = {0.04f, 0.03f, -0.02f, 0, 0, 0};
    m.atoms[heavy[1]].temperatureFactor = m.atoms[heavy[2]].temperatureFactor = 7.8957f;  // U = 0.1 Å^2
    const Representation r = ellipsoidScene(m);
    for (std::size_t i = 0; i < r.spheres.size(); ++i) {
        const std::uint32_t atom = r.sphereLooks[i].atom - 1;
        const double radius = atom == heavy[0]                       ? 0.8 * 1.5382 * std::sqrt(0.02)
                              : atom == heavy[1] || atom == heavy[2] ? 1.5382 * std::sqrt(0.1)
                                                                     : 0.1;
        EXPECT_NEAR(r.spheres[i].radius, radius, 1e-4) << atom;
    }
    EXPECT_EQ(r.spheres.size(), m.atoms.size());
    ASSERT_EQ(r.warnings.size(), 3u);
    EXPECT_EQ(r.warnings[0], "1 atom has no anisotropic displacement: a sphere of its B factor is drawn");
    EXPECT_EQ(r.warnings[1],
              "1 atom has a displacement tensor that is not positive definite: a sphere of its B factor is drawn");
    EXPECT_EQ(r.warnings[2],
              std::to_string(heavy.size() - 3) + " atoms have no displacement and no B factor: small balls are drawn");
    // Bonds are thin, and single.
    EXPECT_EQ(r.cylinders.size(), m.bonds.size());
    for (const Cylinder& stick : r.cylinders) EXPECT_NEAR(stick.radius, 0.06, 1e-6);
}

Representation seenFrom(const Molecule& m, const glm::dvec4& viewer) {
    return represent(m, drawnAtoms(m),
                     {.style = Style::ellipsoids, .ellipsoids = EllipsoidForm::octants, .viewer = viewer});
}

/// Areas of an ellipsoid's octants towards a direction, by the triangles of its mesh; by the signs of its axes.
std::array<double, 8> areasTowards(const Representation& r, const Molecule& m, std::uint32_t atom,
                                   const glm::dvec3& way) {
    std::array<double, 8> areas{};
    const auto axes = *displacementAxes(m.displacements[atom]);
    for (const Triangle& t : r.triangles) {
        if (r.meshLooks[r.meshVertices[t.a].look].atom != atom + 1) continue;
        const auto at = [&](std::uint32_t v) {
            return glm::dvec3(decodePosition(r.meshVertices[v], t.step())) + r.center -
                   glm::dvec3(m.atoms[atom].position);
        };
        const glm::dvec3 a = at(t.a), b = at(t.b), c = at(t.c), middle = (a + b + c) / 3.0;
        std::size_t octant = 0;
        for (std::size_t i = 0; i < 3; ++i)
            if (glm::dot(middle, axes[i]) < 0) octant |= std::size_t{1} << i;
        areas[octant] += glm::dot(glm::cross(b - a, c - a), way) / 2;
    }
    return areas;
}

TEST(CutEllipsoids, LackTheOctantWithTheLargestAreaTowardsTheViewer) {
    const Molecule m = test::glucoseWithTensors();
    const Representation whole = ellipsoidScene(m);
    for (const glm::dvec4& viewer :
         {glm::dvec4(0, 0, 1, 0), glm::dvec4(-0.6, 0.7, 0.2, 0), glm::dvec4(whole.center + glm::dvec3(3, -6, 4), 1)}) {
        const Representation r = seenFrom(m, viewer);
        ASSERT_EQ(r.meshes.size(), 1u);
        EXPECT_TRUE(r.meshes[0].closed);
        EXPECT_EQ(r.center, whole.center);
        std::set<std::size_t> met;
        for (std::uint32_t atom = 0; atom < m.atoms.size(); ++atom) {
            if (!m.displacements[atom].stated()) continue;
            const glm::dvec3 way = glm::normalize(glm::dvec3(viewer) - viewer.w * glm::dvec3(m.atoms[atom].position));
            const auto before = areasTowards(whole, m, atom, way);
            const std::size_t cut = static_cast<std::size_t>(std::ranges::max_element(before) - before.begin());
            met.insert(cut);
            EXPECT_EQ(facingOctants(m, viewer)[atom], cut);
            const auto axes = *displacementAxes(m.displacements[atom]);
            for (const Triangle& t : r.triangles) {
                if (r.meshLooks[r.meshVertices[t.a].look].atom != atom + 1) continue;
                glm::dvec3 middle(0);
                for (const std::uint32_t v : {t.a, t.b, t.c})
                    middle += (glm::dvec3(decodePosition(r.meshVertices[v], t.step())) + r.center -
                               glm::dvec3(m.atoms[atom].position)) /
                              3.0;
                double least = 1;
                for (std::size_t i = 0; i < 3; ++i)
                    least = std::min(least,
                                     glm::dot(middle, axes[i]) / glm::dot(axes[i], axes[i]) * (cut >> i & 1 ? -1 : 1));
                ASSERT_LT(least, 1e-3) << "nothing is left of the octant";
            }
        }
        EXPECT_GE(met.size(), 2u);
    }
    EXPECT_EQ(facingOctants(m, {0, 0, 1, 0}).back(), kNoOctant) << "a hydrogen";
}

TEST(CutEllipsoids, ShowNeitherBallsNorEndsOfBonds) {
    const Molecule m = test::glucoseWithTensors();
    const glm::dvec4 viewer(0.3, -0.5, 0.8, 0);
    const Representation whole = ellipsoidScene(m), r = seenFrom(m, viewer);
    for (std::size_t i = 0; i < r.spheres.size(); ++i) {
        const bool stated = m.displacements[r.sphereLooks[i].atom - 1].stated();
        EXPECT_EQ(r.spheres[i].radius, stated ? kCutBall : whole.spheres[i].radius);
    }
    ASSERT_EQ(r.cylinders.size(), whole.cylinders.size());
    const AtomEllipsoids ellipsoids(m, 50, viewer);
    std::size_t through = 0, inside = 0;
    for (std::size_t i = 0; i < r.cylinders.size(); ++i) {
        const auto end = [&](std::uint32_t atom, const glm::vec3& at, const glm::vec3& center) {
            if (!m.displacements[atom].stated()) {
                EXPECT_EQ(at, center);
                return;
            }
            const glm::dvec3 off = glm::dvec3(at) + r.center - glm::dvec3(m.atoms[atom].position);
            if (glm::length(off) < 1e-5) {
                ++through;
                return;
            }
            ++inside;
            EXPECT_NEAR(quadricAt(m.displacements[atom], off), 0.64 * 1.5382 * 1.5382, 1e-3);
            const auto axes = *ellipsoids.axes(atom);
            const glm::dvec3 signs = *ellipsoids.cut(atom);
            double least = 1;
            for (std::size_t k = 0; k < 3; ++k)
                least = std::min(least, glm::dot(axes[k], off) * signs[static_cast<int>(k)]);
            EXPECT_LT(least, 0) << "outside the cut";
        };
        end(r.cylinderLooks[i].atomA - 1, r.cylinders[i].a, whole.cylinders[i].a);
        end(r.cylinderLooks[i].atomB - 1, r.cylinders[i].b, whole.cylinders[i].b);
    }
    EXPECT_GE(through, 1u);
    EXPECT_GE(inside, 10u);
}

/// Copies by a threefold screw axis, an inversion and a translation, each seen from its own side.
TEST(CutEllipsoids, OfCopiesFaceTheViewerInEachCopy) {
    Molecule m = test::glucoseWithTensors();
    m.subchains = {"A"};
    m.assemblies = {{"1", "", {{{}, {0}}}}};
    for (const glm::vec3& shift : {glm::vec3(0), glm::vec3(30, 0, 0)})
        for (const float side : {1.0f, -1.0f})
            for (const double degrees : {0.0, 120.0, 240.0}) {
                const glm::mat3 turn = glm::mat3(rotationMatrix({0, 0, degrees})) * side;
                m.assemblies[0].parts[0].transforms.emplace_back(turn[0], turn[1], turn[2], shift);
            }
    RepresentationOptions look{.style = Style::ellipsoids,
                               .assembly = "1",
                               .ellipsoids = EllipsoidForm::octants,
                               .viewer = glm::dvec4(0.48, -0.6, 0.64, 0)};
    const Representation r = represent(m, drawnAtoms(m), look);
    const glm::dvec3 toViewer(*look.viewer);
    std::size_t copies = 0;
    EXPECT_EQ(r.copies.triangles.size(), 6u) << "one per rotation";
    for (const PrimitiveRun& run : r.copies.triangles)
        for (const std::uint32_t copy : r.copies.lists[run.list]) {
            const glm::dmat4x3& motion = r.copies.transforms[copy];
            ++copies;
            std::size_t inCut = 0, towards = 0;
            for (std::size_t i = run.first; i < std::size_t{run.first} + run.count; ++i) {
                const Triangle& t = r.triangles[i];
                const std::uint32_t atom = r.meshLooks[r.meshVertices[t.a].look].atom - 1;
                const glm::dvec3 center = motion * glm::dvec4(glm::dvec3(m.atoms[atom].position) - r.center, 1);
                glm::dvec3 middle(0);
                for (const std::uint32_t v : {t.a, t.b, t.c})
                    middle += (motion * glm::dvec4(decodePosition(r.meshVertices[v], t.step()), 1) - center) / 3.0;
                double least = 1;
                for (const glm::dvec3& own : *displacementAxes(m.displacements[atom])) {
                    const glm::dvec3 axis = motion * glm::dvec4(own, 0);
                    least = std::min(
                        least, glm::dot(middle, axis) / glm::dot(axis, axis) * (glm::dot(toViewer, axis) < 0 ? -1 : 1));
                }
                inCut += least > 1e-3;
                towards += least > -1e-3;
            }
            EXPECT_EQ(inCut, 0u) << copy;
            EXPECT_GT(towards, 100u) << "faces";
        }
    EXPECT_EQ(copies, 12u);
    for (std::size_t i = 0; i < r.cylinders.size(); ++i) {  // their ends do not show in any copy
        const std::uint32_t atom = r.cylinderLooks[i].atomA - 1;
        if (!m.displacements[atom].stated()) continue;
        const glm::dvec3 off = glm::dvec3(r.cylinders[i].a) + r.center - glm::dvec3(m.atoms[atom].position);
        EXPECT_NEAR(quadricAt(m.displacements[atom], off), 0.64 * 1.5382 * 1.5382, 1e-3);
    }
}

TEST(CutEllipsoids, NeedAViewer) {
    const Molecule m = test::glucoseWithTensors();
    RepresentationOptions look{.style = Style::ellipsoids, .ellipsoids = EllipsoidForm::octants};
    EXPECT_EQ(represent(m, drawnAtoms(m), look).triangles.size(), ellipsoidScene(m).triangles.size());
    EXPECT_TRUE(drawsOctants(look));
    look.style = Style::licorice;
    EXPECT_FALSE(drawsOctants(look));
    look.rules.emplace_back().style = Style::ellipsoids;
    EXPECT_TRUE(drawsOctants(look));
    look.ellipsoids = EllipsoidForm::bands;
    EXPECT_FALSE(drawsOctants(look));
    EXPECT_EQ(faceColor(packedColor(0x406080)), packedColor(0xcfd7df));
}

TEST(AtomEllipsoids, BandsStandOutFromTheColorOfTheirAtom) {
    Molecule m = sampleMolecule("glucose");
    m.displacements.assign(m.atoms.size(), {0.04f, 0.03f, 0.02f, 0, 0, 0});
    const Representation r = ellipsoidScene(m);
    std::map<std::uint32_t, std::set<std::uint32_t>> colors;
    for (const SphereLook& look : r.meshLooks) colors[look.atom].insert(look.color);
    ASSERT_EQ(colors.size(), m.atoms.size());
    for (const auto& [atom, both] : colors) EXPECT_EQ(both.size(), 2u);
    EXPECT_EQ(bandColor(packedColor(0xffffff)), packedColor(0x4c4c4c));
    EXPECT_EQ(bandColor(packedColor(0x000000)), packedColor(0x7f7f7f));
}

}  // namespace
}  // namespace nacre
