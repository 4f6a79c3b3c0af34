// Whatever atoms there are, meshes of them are whole: molecules by chance, from what files hold to what no file should.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

#include "engine/mesh/cartoon.h"
#include "engine/mesh/surface.h"
#include "engine/molecule/drawn_atoms.h"
#include "tests/mesh/mesh_checks.h"
#include "tests/molecule/build_peptide.h"

namespace nacre {
namespace {

using Dice = std::mt19937;

double between(Dice& dice, double low, double high) {
    return low + (high - low) * static_cast<double>(dice()) / static_cast<double>(Dice::max());
}

/// Residues with some of their atoms, along a chain that goes as it likes.
Molecule anyMolecule(Dice& dice) {
    static constexpr std::array kNames{"ALA", "CYS", "GLY", "PRO", "MSE", "DAL", "DA", "U", "PSU", "HOH", "LIG"};
    static constexpr std::array kAtoms{"N",   "CA", "C",  "O",  "CB", "SG", "P",  "O5'", "C4'", "C3'", "O3'",
                                       "C1'", "N1", "C2", "N3", "C4", "C5", "C6", "N7",  "C8",  "N9"};
    Molecule molecule =
        dice() % 2 ? test::buildChain(static_cast<int>(dice() % 12), between(dice, -180, 180), between(dice, -180, 180))
                   : Molecule();
    test::MoleculeText text;
    text.molecule = molecule;
    const double step = std::array{0.0, 0.4, 1.5, 3.8, 100.0}[dice() % 5];
    glm::vec3 place(0);
    const unsigned residues = dice() % 16;
    for (unsigned r = 0; r < residues; ++r) {
        text.residue(kNames[dice() % kNames.size()], static_cast<int>(100 + (dice() % 4 ? r : r / 2)));
        for (const char* name : kAtoms) {
            if (dice() % 3 == 0) continue;
            for (int axis = 0; axis < 3; ++axis) place[axis] += static_cast<float>(between(dice, -step, step) / 3);
            text.atom(name, name[0] == 'S' ? "S" : std::string(1, name[0]), place, dice() % 8 ? '\0' : 'B');
        }
        place.x += static_cast<float>(step);
    }
    molecule = text.molecule;
    for (Atom& atom : molecule.atoms) {
        atom.temperatureFactor = static_cast<float>(between(dice, -10, 1e3));
        if (dice() % 200 == 0) atom.position.y = std::numeric_limits<float>::quiet_NaN();
        if (dice() % 200 == 0) atom.position.x = std::numeric_limits<float>::infinity();
        if (dice() % 300 == 0) atom.position *= 1e4f;
    }
    for (unsigned i = 0; i < 4 && molecule.atoms.size() > 1; ++i) {
        const auto a = static_cast<std::uint32_t>(dice() % molecule.atoms.size());
        const auto b = static_cast<std::uint32_t>(dice() % molecule.atoms.size());
        if (a != b) molecule.bonds.push_back({std::min(a, b), std::max(a, b)});
    }
    return molecule;
}

void expectWhole(const Mesh& mesh, std::size_t atoms) {
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.atoms.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) ASSERT_TRUE(std::isfinite(mesh.positions[i][axis]));
        ASSERT_NEAR(glm::length(mesh.normals[i]), 1, 1e-3);
        ASSERT_LT(mesh.atoms[i], atoms);
    }
    for (const glm::uvec3& t : mesh.triangles) ASSERT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
    EXPECT_EQ(test::openEdges(mesh), 0u);
    Mesh coarse = mesh;
    for (const MeshLevel& level : mesh.coarser) {
        coarse.triangles = level.triangles;
        for (const glm::uvec3& t : level.triangles) ASSERT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
        EXPECT_EQ(test::openEdges(coarse), 0u) << level.error;
    }
}

TEST(AnyAtoms, MakeWholeMeshes) {
    const char* wanted = std::getenv("NACRE_MESH_ROUNDS");  // more of them by hand
    const unsigned rounds = wanted ? static_cast<unsigned>(std::atoi(wanted)) : 40;
    for (unsigned round = 0; round < rounds && !::testing::Test::HasFailure(); ++round) {
        SCOPED_TRACE(round);
        Dice dice(round);
        const Molecule molecule = anyMolecule(dice);
        std::vector<SecondaryStructure> secondary;
        for (std::size_t r = 0; r < molecule.residues.size(); ++r)
            secondary.push_back(static_cast<SecondaryStructure>(r % 5 ? (round + r / 6) % 3 : dice() % 3));
        const std::vector<std::uint32_t> atoms = drawnAtoms(molecule, {true, true});
        CartoonOptions fold;
        fold.helices = static_cast<HelixForm>(dice() % 3);
        fold.bases = static_cast<BaseForm>(dice() % 3);
        fold.putty = dice() % 4 == 0;
        expectWhole(cartoon(molecule, atoms, secondary, fold, {1, 2, 3}), molecule.atoms.size());
        SurfaceOptions skin;
        skin.kind = static_cast<SurfaceKind>(dice() % 3);
        skin.probe = std::array{0.0, 0.3, 1.4, 5.0}[dice() % 4];
        skin.resolution = between(dice, 0.6, 1.2);
        skin.cavities = dice() % 2;
        expectWhole(surface(molecule, atoms, skin, {1, 2, 3}), molecule.atoms.size());
    }
}

}  // namespace
}  // namespace nacre
