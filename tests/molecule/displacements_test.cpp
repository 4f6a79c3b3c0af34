// Anisotropic displacements, beside gemmi's reading of the same files.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <string>

#include "engine/molecule/displacement.h"

#define USE_STD_SNPRINTF  // Debian's gemmi comes without the stb that it prints numbers with otherwise

#include <gemmi/cif.hpp>
#include <gemmi/gz.hpp>
#include <gemmi/interop.hpp>
#include <gemmi/mmcif.hpp>
#include <gemmi/pdb.hpp>
#include <gemmi/smcif.hpp>

#include "engine/molecule/join_models.h"
#include "engine/molecule/read.h"
#include "engine/molecule/text.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

constexpr double kTensorError = 2e-5;  // Å^2: files state four digits

void expectTensor(const Displacement& ours, const gemmi::SMat33<double>& theirs, const std::string& what) {
    EXPECT_NEAR(ours.u11, theirs.u11, kTensorError) << what;
    EXPECT_NEAR(ours.u22, theirs.u22, kTensorError) << what;
    EXPECT_NEAR(ours.u33, theirs.u33, kTensorError) << what;
    EXPECT_NEAR(ours.u12, theirs.u12, kTensorError) << what;
    EXPECT_NEAR(ours.u13, theirs.u13, kTensorError) << what;
    EXPECT_NEAR(ours.u23, theirs.u23, kTensorError) << what;
}

std::size_t statedIn(const Molecule& m) {
    return static_cast<std::size_t>(std::count_if(m.displacements.begin(), m.displacements.end(),
                                                  [](const Displacement& u) { return u.stated(); }));
}

/// Compares each atom of gemmi's first model with ours of the same place.
void expectAsGemmiReads(const Molecule& m, gemmi::Structure structure) {
    using Place = std::tuple<std::string, int, std::string, char>;
    std::map<Place, Displacement> ours;
    ASSERT_EQ(m.displacements.size(), m.atoms.size());
    for (std::size_t i = 0; i < m.atoms.size(); ++i) {
        const Atom& atom = m.atoms[i];
        const Residue& residue = m.residues[atom.residue];
        ours[{m.chains[residue.chain].name, residue.number, std::string(atom.name.view()), atom.alternate}] =
            m.displacements[i];
    }
    std::size_t stated = 0;
    for (const gemmi::Chain& chain : structure.models.at(0).chains)
        for (const gemmi::Residue& residue : chain.residues)
            for (const gemmi::Atom& atom : residue.atoms) {
                const Place place{chain.name, *residue.seqid.num, atom.name, atom.altloc};
                ASSERT_TRUE(ours.contains(place)) << atom.name;
                expectTensor(ours[place], atom.aniso.scaled(1.0), chain.name + residue.str() + atom.name);
                stated += atom.aniso.nonzero();
            }
    EXPECT_EQ(statedIn(m), stated);
    EXPECT_GT(stated, 100u);
}

TEST(Displacements, OfAPdbFileAreThoseThatGemmiReads) {
    NACRE_NEEDS_DATA();
    const std::string path = test::dataFile("interactions/1xdn.pdb.gz");
    expectAsGemmiReads(readMoleculeFile(path), gemmi::read_pdb(gemmi::MaybeGzipped(path)));
}

TEST(Displacements, OfAnMmcifFileAreThoseThatGemmiReads) {
    NACRE_NEEDS_DATA();
    const std::string path = test::dataFile("1pfe.cif.gz");
    gemmi::cif::Document document = gemmi::cif::read(gemmi::MaybeGzipped(path));
    expectAsGemmiReads(readMoleculeFile(path), gemmi::make_structure_from_block(document.blocks.at(0)));
}

/// gemmi turns a Cartesian tensor into the file's.
TEST(Displacements, OfASmallMoleculeAreTurnedIntoTheAxesOfPositions) {
    NACRE_NEEDS_DATA();
    const std::string path = test::dataFile("small/core-867861.cif");
    const Molecule m = readMoleculeFile(path);
    const gemmi::cif::Document document = gemmi::cif::read_file(path);
    const gemmi::SmallStructure crystal = gemmi::make_small_structure_from_block(document.blocks.at(0));
    std::map<std::string, Displacement> ours;
    ASSERT_EQ(m.displacements.size(), m.atoms.size());
    for (std::size_t i = 0; i < m.atoms.size(); ++i) ours[std::string(m.atoms[i].name.view())] = m.displacements[i];
    std::size_t stated = 0;
    for (const gemmi::SmallStructure::Site& site : crystal.sites) {
        const Displacement& u = ours.at(site.label);
        gemmi::Atom atom;
        atom.aniso = {u.u11, u.u22, u.u33, u.u12, u.u13, u.u23};
        if (!site.aniso.nonzero()) {
            EXPECT_FALSE(u.stated()) << site.label;
            continue;
        }
        ++stated;
        const gemmi::SMat33<double> file = gemmi::atom_to_site(atom, crystal.cell).aniso;
        expectTensor(
            {float(file.u11), float(file.u22), float(file.u33), float(file.u12), float(file.u13), float(file.u23)},
            site.aniso, site.label);
    }
    EXPECT_GT(stated, 60u);
    EXPECT_EQ(statedIn(m), stated);
}

/// The definition in the CIF dictionary: the exponents of structure factors agree.
TEST(Displacements, GiveTheExponentsOfTheDictionary) {
    const std::string text =
        "data_x\n_cell_length_a 5.1\n_cell_length_b 7.3\n_cell_length_c 9.9\n_cell_angle_alpha 81\n"
        "_cell_angle_beta 103\n_cell_angle_gamma 117\nloop_\n_atom_site_label\n_atom_site_fract_x\n"
        "_atom_site_fract_y\n_atom_site_fract_z\nC1 0.1 0.2 0.3\nC2 0.5 0.5 0.5\nLongLabel10A 0 0 0\n"
        "LongLabel10B 0.3 0 0\nloop_\n_atom_site_aniso_label\n";
    const std::string u = "0.021(2) 0.034 0.055 -0.004 0.011 0.007",
                      b = "1.658094 2.684532 4.342626 -0.315827 0.868525 0.552698";
    const auto columns = [](const std::string& kind) {
        std::string names;
        for (const char* which : {"11", "22", "33", "12", "13", "23"})
            names += "_atom_site_aniso_" + kind + "_" + which + "\n";
        return names;
    };
    gemmi::UnitCell cell;
    cell.set(5.1, 7.3, 9.9, 81, 103, 117);
    const double parts[3][3] = {{0.021, -0.004, 0.011}, {-0.004, 0.034, 0.007}, {0.011, 0.007, 0.055}};
    const double lengths[3] = {cell.ar, cell.br, cell.cr};
    for (const std::string& rows : {columns("U") + "C1 " + u + "\nLongLabel10B " + u + "\nC9 " + u,
                                    columns("B") + "C1 " + b + "\nLongLabel10B " + b + "\nC2 ? ? ? ? ? ?"}) {
        const Molecule m = readMolecule("a.cif", text + rows + "\n");
        ASSERT_EQ(m.displacements.size(), 4u);
        EXPECT_FALSE(m.displacements[1].stated() || m.displacements[2].stated());
        for (const std::size_t atom : {0u, 3u})
            for (const auto& [h, k, l] : {std::tuple(1, 0, 0), {0, 2, 0}, {0, 0, 3}, {1, -2, 3}, {-4, 1, 1}}) {
                const int index[3] = {h, k, l};
                double expected = 0;
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < 3; ++j) expected += parts[i][j] * index[i] * index[j] * lengths[i] * lengths[j];
                glm::dvec3 s(0);  // the rows of the fractionalising matrix are the reciprocal axes
                for (int i = 0; i < 3; ++i)
                    for (int axis = 0; axis < 3; ++axis) s[axis] += index[i] * cell.frac.mat[i][axis];
                EXPECT_NEAR(glm::dot(s, tensorMatrix(m.displacements[atom]) * s), expected, 1e-6) << h << k << l;
            }
        EXPECT_EQ(std::count_if(m.notes.begin(), m.notes.end(),
                                [](const ReadNote& note) { return note.what == "anisotropic displacements"; }),
                  1);
    }
}

TEST(Displacements, OfMmcifFollowTheNumbersOfAtoms) {
    const std::string text =
        "data_x\nloop_\n_atom_site_anisotrop.id\n_atom_site_anisotrop.B[1][1]\n_atom_site_anisotrop.B[2][2]\n"
        "_atom_site_anisotrop.B[3][3]\n_atom_site_anisotrop.B[1][2]\n_atom_site_anisotrop.B[1][3]\n"
        "_atom_site_anisotrop.B[2][3]\n7 7.8957 15.7914 23.6871 0.78957 0 -0.78957\n8 1 1 1 0 0 ?\n"
        "loop_\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
        "6 C 0 0 0\n7 C 1.5 0 0\n8 O 3 0 0\n";
    const Molecule m = readMolecule("a.cif", text);
    ASSERT_EQ(m.displacements.size(), 3u);
    EXPECT_FALSE(m.displacements[0].stated() || m.displacements[2].stated());
    expectTensor(m.displacements[1], {0.1, 0.2, 0.3, 0.01, 0, -0.01}, "B");
}

/// Small molecules as above: their tensors as columns of _atom_site, as U and as beta = 2 pi^2 a*_i a*_j U_ij.
TEST(Displacements, OfTheTableOfAtomsAreThoseOfTheirOwnTable) {
    const std::string cell =
        "data_x\n_cell_length_a 5.1\n_cell_length_b 7.3\n_cell_length_c 9.9\n_cell_angle_alpha 81\n"
        "_cell_angle_beta 103\n_cell_angle_gamma 117\nloop_\n_atom_site_label\n_atom_site_fract_x\n"
        "_atom_site_fract_y\n_atom_site_fract_z\n";
    const auto tags = [](const std::string& kind) {
        std::string names;
        for (const char* which : {"11", "22", "33", "12", "13", "23"})
            names += "_atom_site_aniso_" + kind + "_" + which + "\n";
        return names;
    };
    gemmi::UnitCell unit;
    unit.set(5.1, 7.3, 9.9, 81, 103, 117);
    const double u[6] = {0.021, 0.034, 0.055, -0.004, 0.011, 0.007}, lengths[3] = {unit.ar, unit.br, unit.cr};
    const int axes[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
    std::string ofU, ofBeta;
    for (int i = 0; i < 6; ++i) {
        ofU += " " + std::to_string(u[i]);
        ofBeta += formatted(" %.9f", 19.7392088 * lengths[axes[i][0]] * lengths[axes[i][1]] * u[i]);
    }
    const Molecule own =
        readMolecule("a.cif", cell + "C1 0.1 0.2 0.3\nC2 0.5 0.5 0.5\nloop_\n_atom_site_aniso_label\n" + tags("U") +
                                  "C1" + ofU + "\n");
    ASSERT_EQ(statedIn(own), 1u);
    const Displacement& expected = own.displacements[0];
    for (const auto& [kind, numbers] : {std::pair(std::string("U"), ofU), {"beta", ofBeta}}) {
        const Molecule m =
            readMolecule("a.cif", cell + tags(kind) + "C1 0.1 0.2 0.3" + numbers + "\nC2 0.5 0.5 0.5 ? ? ? ? ? ?\n");
        ASSERT_EQ(m.displacements.size(), 2u) << kind;
        expectTensor(m.displacements[0],
                     {expected.u11, expected.u22, expected.u33, expected.u12, expected.u13, expected.u23}, kind);
        EXPECT_FALSE(m.displacements[1].stated());
        EXPECT_TRUE(
            std::ranges::none_of(m.notes, [](const ReadNote& n) { return n.what == "anisotropic displacements"; }));
    }
}

TEST(Displacements, OfMmcifMayStandInTheTableOfAtoms) {
    const std::string text =
        "data_x\nloop_\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
        "_atom_site.Cartn_z\n_atom_site.aniso_U[1][1]\n_atom_site.aniso_U[2][2]\n_atom_site.aniso_U[3][3]\n"
        "_atom_site.aniso_U[1][2]\n_atom_site.aniso_U[1][3]\n_atom_site.aniso_U[2][3]\n"
        "6 C 0 0 0 ? ? ? ? ? ?\n7 C 1.5 0 0 0.1 0.2 0.3 0.01 0 -0.01\n8 O 3 0 0 0.1 0.2 0.3 0.01 0 ?\n";
    const Molecule m = readMolecule("a.cif", text);
    ASSERT_EQ(m.displacements.size(), 3u);
    EXPECT_FALSE(m.displacements[0].stated() || m.displacements[2].stated());
    expectTensor(m.displacements[1], {0.1, 0.2, 0.3, 0.01, 0, -0.01}, "U");
    const auto note =
        std::ranges::find_if(m.notes, [](const ReadNote& n) { return n.what == "anisotropic displacements"; });
    ASSERT_NE(note, m.notes.end());
    EXPECT_EQ(note->count, 1);
}

TEST(Displacements, OfPdbBelongToTheAtomBefore) {
    const auto atom = [](int serial, const char* name, const char* x) {
        return formatted("ATOM  %5d  %-3s LIG A   1    %8s   0.000   0.000  1.00 10.00           C\n", serial, name, x);
    };
    const auto aniso = [](int serial, const char* name) {
        return formatted("ANISOU%5d  %-3s LIG A   1     1000   2000   3000    100   -200    300       C\n", serial,
                         name);
    };
    const Molecule m = readMolecule("a.pdb", atom(1, "C1", "0.000") + atom(2, "C2", "1.500") + aniso(2, "C2") +
                                                 atom(3, "C3", "?") + aniso(3, "C3") + atom(4, "C4", "4.500"));
    ASSERT_EQ(m.displacements.size(), 3u);
    EXPECT_FALSE(m.displacements[0].stated() || m.displacements[2].stated());
    expectTensor(m.displacements[1], {0.1, 0.2, 0.3, 0.01, -0.02, 0.03}, "C2");
    EXPECT_TRUE(readMolecule("a.pdb", atom(1, "C1", "0.000")).displacements.empty());
    // Joined to files without them, each atom keeps its own.
    const Molecule other = readMolecule("b.pdb", atom(1, "C1", "9.000"));
    const Molecule both = joinModels("both", {other, m, other}, 100);
    ASSERT_EQ(both.displacements.size(), 5u);
    EXPECT_EQ(statedIn(both), 1u);
    EXPECT_TRUE(both.displacements[2].stated());
}

/// Quantiles of chi-square with three degrees of freedom, from printed tables.
TEST(Displacements, TheScaleIsTheQuantileOfTheChiDistribution) {
    EXPECT_NEAR(probabilityScale(50), 1.5382, 5e-5);
    for (const auto& [percent, square] : {std::pair(1.0, 0.115),
                                          {5.0, 0.352},
                                          {10.0, 0.584},
                                          {50.0, 2.366},
                                          {90.0, 6.251},
                                          {95.0, 7.815},
                                          {99.0, 11.345}})
        EXPECT_NEAR(probabilityScale(percent) * probabilityScale(percent), square, 6e-4) << percent;
}

TEST(Displacements, AxesAreThoseOfTheTensor) {
    // Known axes: the tensor is put together from them.
    const glm::dmat3 turn(glm::normalize(glm::dvec3(1, 2, 2)), glm::normalize(glm::dvec3(2, 1, -2)),
                          glm::normalize(glm::dvec3(2, -2, 1)));
    const glm::dmat3 own(0.09, 0, 0, 0, 0.04, 0, 0, 0, 0.01);
    const auto axes = displacementAxes(toDisplacement(turn * own * glm::transpose(turn)));
    ASSERT_TRUE(axes);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(glm::length((*axes)[static_cast<std::size_t>(i)]), std::sqrt(own[i][i]), 1e-6);
        EXPECT_NEAR(std::abs(glm::dot(glm::normalize((*axes)[static_cast<std::size_t>(i)]), turn[i])), 1, 1e-6);
    }
    EXPECT_GT(glm::dot(glm::cross((*axes)[0], (*axes)[1]), (*axes)[2]), 0);
    EXPECT_FALSE(displacementAxes({0.02f, 0.02f, -0.01f, 0, 0, 0}));
    EXPECT_FALSE(displacementAxes({0.02f, 0.02f, 0.02f, 0.03f, 0, 0}));
    EXPECT_FALSE(displacementAxes({0.02f, 0.02f, 0, 0, 0, 0}));
}

TEST(Displacements, TurnWithTheirAtoms) {
    Molecule m;
    m.atoms.resize(2);
    m.displacements = {{0.01f, 0.02f, 0.03f, 0.004f, 0.005f, 0.006f}, {}};
    // A quarter turn about z takes x to y, y to -x.
    const glm::dmat3 quarter(0, 1, 0, -1, 0, 0, 0, 0, 1);
    turnDisplacement(m, 0, quarter);
    turnDisplacement(m, 1, quarter);
    expectTensor(m.displacements[0], {0.02, 0.01, 0.03, -0.004, -0.006, 0.005}, "turned");
    EXPECT_FALSE(m.displacements[1].stated());
}

}  // namespace
}  // namespace nacre
