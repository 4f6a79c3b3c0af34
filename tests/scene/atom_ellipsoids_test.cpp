// Style::ellipsoids in a scene.

#include "engine/scene/build/atom_ellipsoids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <gemmi/symmetry.hpp>
#include <gemmi/unitcell.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <set>

#include "engine/molecule/displacement.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/element.h"
#include "engine/molecule/read.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/color/colors.h"
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

/// The atoms that are ellipsoids, with their spheres' numbers.
std::map<std::uint32_t, std::size_t> ellipsoidsOf(const Representation& r) {
    std::map<std::uint32_t, std::size_t> found;
    for (std::size_t i = 0; i < r.spheres.size(); ++i)
        if (r.ellipsoid(i)) found[r.sphereLooks[i].atom - 1] = i;
    return found;
}

TEST(AtomEllipsoids, HoldTheirAtomsWithTheProbability) {
    NACRE_NEEDS_DATA();
    const Molecule m = smallCrystal();
    for (const double percent : {50.0, 90.0}) {
        const Representation r = ellipsoidScene(m, percent);
        EXPECT_TRUE(r.triangles.empty());
        const double square = percent == 50 ? 1.5382 * 1.5382 : 6.251;  // chi-square with three degrees of freedom
        const std::map<std::uint32_t, std::size_t> found = ellipsoidsOf(r);
        for (const std::uint32_t atom : drawnAtoms(m))
            EXPECT_EQ(found.contains(atom), m.displacements[atom].stated()) << m.atoms[atom].name.view();
        for (const auto& [atom, i] : found) {
            const EllipsoidRows& rows = *r.ellipsoid(i);
            EXPECT_NEAR(glm::length(rows.axes()[0]), r.spheres[i].radius, 1e-5);
            EXPECT_LE(glm::length(rows.axes()[1]), r.spheres[i].radius * (1 + 1e-6f));
            for (const glm::vec3& normal :
                 {glm::vec3(0, 0, 1), glm::vec3(0.6f, -0.8f, 0), glm::vec3(-0.48f, 0.6f, 0.64f)}) {
                const glm::dvec3 at(rows.place(normal));
                EXPECT_NEAR(quadricAt(m.displacements[atom], at), square, 1e-4 * square);
                EXPECT_NEAR(glm::length(rows.toUnit(at)), 1, 1e-5);
                const glm::dvec3 gradient = glm::inverse(tensorMatrix(m.displacements[atom])) * at;
                EXPECT_NEAR(glm::dot(glm::normalize(gradient), glm::dvec3(normal)), 1, 1e-5);
                EXPECT_NEAR(glm::dot(rows.gradient(rows.toUnit(at)), normal), 1, 1e-5);
            }
        }
    }
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
    ASSERT_EQ(r.copies.spheres.size(), 1u);
    std::set<int> met;
    for (const std::uint32_t copy : r.copies.lists[r.copies.spheres[0].list]) {
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
        for (const glm::vec3& normal : {glm::vec3(1, 0, 0), glm::vec3(0, 0.6f, 0.8f), glm::vec3(-0.48f, 0.6f, 0.64f)}) {
            const glm::dvec3 at = motion * glm::dvec4(r.pointOfBall(0, normal), 1);
            ASSERT_NEAR(quadricAt(toDisplacement(expected), at - center), 1.5382 * 1.5382, 1e-3);
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
        const double radius = atom == heavy[0]                       ? 1.5382 * std::sqrt(0.04)
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

TEST(CutEllipsoids, BondsEndInside) {
    const Molecule m = test::glucoseWithTensors();
    const Representation whole = ellipsoidScene(m),
                         r = represent(m, drawnAtoms(m),
                                       {.style = Style::ellipsoids, .ellipsoids = EllipsoidForm::octants});
    EXPECT_TRUE(r.cutsOctants);
    EXPECT_FALSE(whole.cutsOctants);
    ASSERT_EQ(r.cylinders.size(), whole.cylinders.size());
    std::size_t inside = 0;
    for (std::size_t i = 0; i < r.cylinders.size(); ++i) {
        const auto end = [&](std::uint32_t atom, const glm::vec3& at, const glm::vec3& center) {
            if (!m.displacements[atom].stated()) {
                EXPECT_EQ(at, center);
                return;
            }
            ++inside;
            const glm::dvec3 off = glm::dvec3(at) + r.center - glm::dvec3(m.atoms[atom].position);
            EXPECT_NEAR(quadricAt(m.displacements[atom], off), 0.64 * 1.5382 * 1.5382, 1e-3);
        };
        end(r.cylinderLooks[i].atomA - 1, r.cylinders[i].a, whole.cylinders[i].a);
        end(r.cylinderLooks[i].atomB - 1, r.cylinders[i].b, whole.cylinders[i].b);
    }
    EXPECT_GE(inside, 10u);
}

TEST(AtomEllipsoids, BandsStandOutFromTheColorOfTheirAtom) {
    EXPECT_EQ(bandColor(packedColor(0xffffff)), packedColor(0x4c4c4c));
    EXPECT_EQ(bandColor(packedColor(0x000000)), packedColor(0x7f7f7f));
}

}  // namespace
}  // namespace nacre
