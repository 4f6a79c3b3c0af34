// Items that one line of a file has wrong, or a format states in an unusual way: read, or left out and told.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <glm/geometric.hpp>
#include <string>
#include <thread>
#include <vector>

#include "engine/molecule/chemistry/drawn_orders.h"
#include "engine/molecule/crystal.h"
#include "engine/molecule/element.h"
#include "engine/molecule/residue_kind.h"
#include "engine/molecule/text.h"
#include "engine/molecule/trajectory/trajectory.h"
#include "engine/volume/read_map.h"
#include "tests/molecule/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace nacre {
namespace {

/// A row of the list of what was read; the count is 0 if there is none.
ReadNote findNote(const Molecule& molecule, ReadAction action, std::string_view what) {
    for (const ReadNote& note : listReadNotes(molecule, drawnOrders(molecule)))
        if (note.action == action && note.what == what) return note;
    return {};
}

std::string symbols(const Molecule& molecule) {
    std::string text;
    for (const Atom& atom : molecule.atoms)
        text += (text.empty() ? "" : " ") + std::string(atom.element == 0 ? "?" : elementSymbol(atom.element));
    return text;
}

// PQR

TEST(OddPqr, LinesWithUnusableCoordinatesAreLeftOut) {
    const std::string first = "ATOM 1 C LIG A 1 0.0 0.0 0.0 0.1 1.7\n", last = "ATOM 3 C LIG A 1 2.0 0.0 0.0 0.1 1.7\n";
    for (const char* odd : {"ATOM 2 C LIG A 1 bad 2.0 3.0 0.1 1.7\n", "ATOM 2 C LIG A 1 1.0 ****** 3.0 0.1 1.7\n",
                            "ATOM      2  C   LIG A   1   bad   2.000   3.000   0.1000  1.7000\n",
                            "ATOM 2 C LIG 1 bad 2.0 3.0 0.1 1.7\n", "ATOM 2 C LIG A 1 2.0 3.0 0.1 1.7\n",
                            "ATOM      2  C   LIG A   1      xx.xxx   2.000   3.000  0.1000 1.7000\n"}) {
        SCOPED_TRACE(odd);
        const Molecule read = readMolecule("a.pqr", first + odd + last);
        ASSERT_EQ(read.atoms.size(), 2u);
        EXPECT_FLOAT_EQ(read.atoms[1].position.x, 2);
        const ReadNote note = findNote(read, ReadAction::leftOut, "atoms");
        EXPECT_EQ(note.count, 1);
        EXPECT_EQ(note.line, 2u);
    }
}

TEST(OddPqr, NumbersThatTouchWithoutColumns) {
    const Molecule read = readMolecule("a.pqr", "ATOM 1 C LIG A 1 10.5-20.25-30.125 0.1 1.7\n");
    EXPECT_EQ(read.atoms[0].position, glm::vec3(10.5f, -20.25f, -30.125f));
    EXPECT_FLOAT_EQ(read.radii[0], 1.7f);
}

TEST(OddPqr, AminoAcidsOfFourLetters) {
    for (const auto& [name, letter] : {std::pair("NALA", 'A'),
                                       {"CALA", 'A'},
                                       {"HISE", 'H'},
                                       {"HISH", 'H'},
                                       {"NHIE", 'H'},
                                       {"CCYX", 'C'},
                                       {"LYSH", 'K'},
                                       {"ASPH", 'D'}}) {
        SCOPED_TRACE(name);
        EXPECT_EQ(aminoAcidLetter(Name(name)), letter);
        const Molecule one = readMolecule("a.pqr", std::string("ATOM 1 CA ") + name + " A 1 0.0 0.0 0.0 0.1 1.7\n");
        EXPECT_EQ(residueKinds(one)[0], ResidueKind::protein);
        EXPECT_EQ(one.atoms[0].element, 6);
    }
    EXPECT_EQ(aminoAcidLetter(Name("NXYZ")), '\0');
    EXPECT_EQ(aminoAcidLetter(Name("CHOL")), '\0');
}

// PDB

TEST(OddPdb, LinesThatLongSerialNumbersPush) {
    const std::string usual = "ATOM  99999  OW  SOL A   1      60.551  26.671 103.023  1.00  2.00           O\n";
    const struct {
        const char* line;
        const char* name;
        int number;
        int serial;
    } kPushed[] = {
        {"ATOM  100000  OW  SOL A   2      61.551  26.671 103.023  1.00  3.00           O\n", "OW", 2, 100000},
        {"ATOM  100000  OW  SOL A  22      61.551  26.671 103.023  1.00  3.00           O\n", "OW", 22, 100000},
        {"ATOM  100000 HG11 VAL A   2      61.551  26.671 103.023  1.00  3.00           H\n", "HG11", 2, 100000},
        {"ATOM  1000000  OW  SOL A   2      61.551  26.671 103.023  1.00  3.00           O\n", "OW", 2, 1000000},
        {"HETATM100000  OW  SOL A   2      61.551  26.671 103.023  1.00  3.00           O\n", "OW", 2, 100000},
        {"ATOM  100000 OW  SOL A   2      61.551  26.671 103.023  1.00  3.00           O\n", "OW", 2, 100000},
        {"ATOM  1000001HG1 VAL A   2      61.551  26.671 103.023  1.00  3.00           H\n", "1HG1", 2, 100000},
    };
    for (const auto& given : kPushed) {
        SCOPED_TRACE(given.line);
        const Molecule read = readMolecule("a.pdb", usual + given.line);
        ASSERT_EQ(read.atoms.size(), 2u);
        EXPECT_EQ(read.atoms[1].position, glm::vec3(61.551f, 26.671f, 103.023f));
        EXPECT_EQ(read.atoms[1].name.view(), given.name);
        EXPECT_EQ(read.residues[1].number, given.number);
        EXPECT_EQ(read.chains.size(), 1u);
        EXPECT_FLOAT_EQ(read.atoms[1].temperatureFactor, 3);
        const Molecule bonded = readMolecule(
            "a.pdb", std::string(given.line) +
                         "ATOM      5  C   LIG A   3      61.551  26.671 104.223  1.00  3.00           C\n" +
                         "CONECT    5 " + std::to_string(given.serial) + "\n");
        EXPECT_EQ(bonded.residues[0].number, given.number);
        EXPECT_EQ(bonded.file.conectUniquePairs, 1) << "of the serial number";
    }
}

/// Carbons in a row, 1.5 Å apart, and CONECT records.
std::string rowOfCarbons(int count, double step, const std::string& conect) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += formatted("HETATM%5d  C%-2d LIG A   1    %8.3f   0.000   0.000  1.00  0.00           C\n", i + 1, i + 1,
                          step * i);
    }
    return text + conect;
}

TEST(OddPdb, ConectOverDistancesThatNoBondHas) {
    const Molecule read = readMolecule("a.pdb", rowOfCarbons(8, 1.5, "CONECT    1    2    6\nCONECT    6    1\n"));
    EXPECT_EQ(read.bonds.size(), 7u) << "neighbours alone";
    const ReadNote note = findNote(read, ReadAction::leftOut, "bonds");
    EXPECT_EQ(note.count, 1) << "each stands with both of its atoms";
    EXPECT_EQ(note.line, 9u);
    EXPECT_NE(note.why.find("distance"), std::string::npos);
    EXPECT_EQ(read.file.conectUniquePairs, 2) << "the file states";
    // Of another model.
    const std::string models = "MODEL        1\n" + rowOfCarbons(4, 1.5, "") + "ENDMDL\nMODEL        2\n" +
                               rowOfCarbons(2, 25, "") + rowOfCarbons(2, 1.5, "") + "ENDMDL\nCONECT    1    2\n";
    EXPECT_EQ(readMolecule("a.pdb", models).bonds.size(), 3u);
    for (const Bond& bond : readMolecule("a.pdb", models, {.model = 2}).bonds)
        EXPECT_NE(bond.source, BondSource::file) << "25 Å";
    // Beads have no nearer neighbours.
    const Molecule beads = readMolecule("a.pdb", rowOfCarbons(4, 8, "CONECT    1    2\nCONECT    2    3\n"));
    EXPECT_EQ(beads.bonds.size(), 2u);
    EXPECT_EQ(findNote(beads, ReadAction::leftOut, "bonds").count, 0);
}

TEST(OddPdb, ConectOfLongSerialNumbers) {
    const std::string atoms =
        "HETATM99999  C1  LIG A   1       0.000   0.000   0.000  1.00  0.00           C\n"
        "HETATM100000 C2  LIG A   1       1.500   0.000   0.000  1.00  0.00           C\n";
    for (const char* conect : {"CONECT 99999 100000\n", "CONECT100000 99999\n"}) {
        SCOPED_TRACE(conect);
        EXPECT_EQ(readMolecule("a.pdb", atoms + conect).file.conectUniquePairs, 1);
    }
    const Molecule own = readMolecule("a.pdb", atoms + "CONECT9999999999\n");
    EXPECT_EQ(findNote(own, ReadAction::leftOut, "bonds").why, "CONECT of an atom to itself");
}

TEST(OddPdb, LinesThatNothingReadsAreTold) {
    const std::string atom = "ATOM      1  C1  LIG A   1       0.000   0.000   0.000  1.00  0.00           C\n";
    const Molecule read = readMolecule(
        "a.pdb", atom + "SIGUIJ    1  C1  LIG A   1      100    100    100      0      0      0       C\n" + atom +
                     "ATOM\t2\tC2\tLIG\tA\t1\t1.5\t0.0\n");
    EXPECT_EQ(findNote(read, ReadAction::unused, "standard deviations").count, 1);
    EXPECT_EQ(findNote(read, ReadAction::leftOut, "atoms").line, 4u);
}

TEST(OddPdb, ChainsOfAlphaCarbonsAreJoined) {
    std::string text;
    for (int i = 0; i < 8; ++i) {
        text += formatted("ATOM  %5d  CA  ALA A%4d    %8.3f   0.000   0.000  1.00  0.00           C\n", i + 1,
                          i + (i > 3 ? 5 : 1), 3.8 * i + (i > 3 ? 12.0 : 0.0));
    }
    const Molecule chain = readMolecule("a.pdb", text);
    EXPECT_EQ(chain.bonds.size(), 6u) << "but not across the gap";
    EXPECT_EQ(symbols(chain), "C C C C C C C C");
}

TEST(OddPdb, BeadsAreNoBoronAndNoTungsten) {
    for (const char* name : {"B", "W"}) {
        SCOPED_TRACE(name);
        std::string xyz = "5\n\n", pdb;
        for (int i = 0; i < 5; ++i) {
            xyz += std::string(name) + " " + std::to_string(4.7 * i) + " 0 0\n";
            pdb += formatted("ATOM  %5d  %s   BEA A%4d    %8.3f   0.000   0.000  1.00  0.00\n", i + 1, name, i + 1,
                             4.7 * i);
        }
        for (const auto& [file, text] : {std::pair("a.xyz", xyz), std::pair("a.pdb", pdb)}) {
            const Molecule beads = readMolecule(file, text);
            EXPECT_EQ(symbols(beads), "? ? ? ? ?");
            EXPECT_NEAR(vanDerWaalsRadius(beads.atoms[0]), 2.35, 1e-3) << "half of the distance";
            EXPECT_EQ(findNote(beads, ReadAction::guessed, "coarse grains").count, 5);
            EXPECT_EQ(findNote(beads, ReadAction::read, "radii").count, 0) << "the file states none";
        }
    }
    // A cluster of tungsten: 2.74 Å; diborane's borons have hydrogens.
    EXPECT_EQ(symbols(readMolecule("a.xyz", "4\n\nW 0 0 0\nW 2.74 0 0\nW 0 2.74 0\nW 0 0 2.74\n")), "W W W W");
    EXPECT_EQ(symbols(readMolecule("a.xyz", "5\n\nB 0 0 0\nB 9 0 0\nB 0 9 0\nB 0 0 9\nH 1.2 0 0\n")), "B B B B H");
}

// Numbers that touch

TEST(NumbersThatTouch, InEachFormat) {
    const glm::vec3 expected(-5.1f, -103.25f, 7.5f);
    const struct {
        const char *name, *text;
    } kTouching[] = {
        {"a.xsf", "ATOMS\n6 -5.100-103.250 7.5\n"},
        {"b.xsf", "CRYSTAL\nPRIMVEC\n9 0 0\n0 9 0\n0 0 9\nPRIMCOORD\n1 1\n6 -5.100-103.250 7.500 0.1 0.1 0.1\n"},
        {"a.txyz", "1 a\n1 C -5.100-103.250 7.500 1\n"},
        {"POSCAR", "a\n1\n9 0 0\n0 9 0\n0 0 9\nC\n1\nCartesian\n-5.100-103.250 7.500\n"},
        {"a.mol2",
         "@<TRIPOS>MOLECULE\na\n1 0\nSMALL\nUSER_CHARGES\n@<TRIPOS>ATOM\n1 C-1 -5.100-103.250 7.5 C.3 1 LIG-2 0.1\n"},
        {"a.lammpstrj",
         "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n"
         "ITEM: ATOMS id element x y z\n1 C -5.100-103.250 7.500\n"},
        {"a.data", "LAMMPS\n\n1 atoms\n\nMasses\n\n1 12.011\n\nAtoms # full\n\n1 1 1 0.5 -5.100-103.250 7.500\n"},
        {"a.xyz", "1\n\nC -5.100-103.250 7.500 0.1\n"},
        {"b.xyz", "1\n\nC -5.100-103.2507.500\n"},
    };
    for (const auto& file : kTouching) {
        SCOPED_TRACE(file.name);
        const Molecule read = readMolecule(file.name, file.text);
        ASSERT_EQ(read.atoms.size(), 1u);
        EXPECT_EQ(read.atoms[0].position, expected);
        EXPECT_EQ(read.atoms[0].element, 6);
    }
}

TEST(NumbersThatTouch, ShowTheirEnds) {
    EXPECT_EQ(numbersApart("1.2345-6.789012.3456"), "1.2345 -6.7890 12.3456");
    EXPECT_EQ(numbersApart("-5.1E-018-5.1E-018"), "-5.1E-018 -5.1E-018");
    EXPECT_EQ(numbersApart("1.5-100"), "1.5-100") << "an exponent without its letter";
    EXPECT_EQ(numbersApart("1.5-2.5+3."), "1.5 -2.5 +3.");
    EXPECT_EQ(numbersApart("1.0E-021.5E-02"), "1.0E-02 1.5E-02");
    EXPECT_EQ(numbersApart("C1-2 1.5 A.B-3.4"), "C1-2 1.5 A.B-3.4") << "names";
    EXPECT_EQ(numbersApart("1.2.3"), "1.2.3") << "not certain";
    EXPECT_EQ(parseNumber("1.5-100"), 1.5e-100);
    EXPECT_EQ(parseNumber("1-100"), std::nullopt);
}

TEST(NumbersThatTouch, LostCoordinatesOfAmberNameTheRemedy) {
    test::expectError("a.rst7",
                      "two\n    2\n   0.0000000   0.0000000   0.0000000   1.0000000   0.0000000************\n",
                      {"(line 3)", "too wide for its columns", "iwrap=1"});
}

// The list of what was read

TEST(ReadingList, RadiiAreReadWhereTheFileStatesThem) {
    const std::string box = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n";
    const Molecule sized =
        readMolecule("a.lammpstrj", box + "ITEM: ATOMS id type x y z radius\n1 1 0 0 0 0.5\n2 1 1 0 0 0.7\n");
    EXPECT_EQ(findNote(sized, ReadAction::read, "radii").count, 2);
    const Molecule plain = readMolecule("a.lammpstrj", box + "ITEM: ATOMS id type x y z\n1 1 0 0 0\n2 1 1 0 0\n");
    EXPECT_EQ(findNote(plain, ReadAction::read, "radii").count, 0);
    EXPECT_EQ(findNote(plain, ReadAction::guessed, "radii of grains").count, 2);
    const Molecule spheres = readMolecule("a.data", "LAMMPS\n\n1 atoms\n\nAtoms # sphere\n\n1 1 3.0 1.0 0 0 0\n");
    EXPECT_FLOAT_EQ(spheres.atoms[0].radius, 1.5f) << "half of the diameter";
    EXPECT_EQ(findNote(spheres, ReadAction::read, "radii").count, 1);
    const Molecule unnamed =
        readMolecule("a.rst7",
                     "three\n    3\n   0.0000000   0.0000000   0.0000000   1.0000000   0.0000000   0.0000000\n"
                     "   2.0000000   0.0000000   0.0000000\n"
                     "   0.1000000   0.1000000   0.1000000   0.1000000   0.1000000   0.1000000\n"
                     "   0.1000000   0.1000000   0.1000000\n");
    EXPECT_EQ(findNote(unnamed, ReadAction::read, "radii").count, 0);
    EXPECT_EQ(findNote(unnamed, ReadAction::guessed, "radii").count, 3);
    EXPECT_EQ(findNote(unnamed, ReadAction::unused, "velocities").count, 3);
}

TEST(ReadingList, UnusableProperties) {
    const Molecule data = readMolecule(
        "a.data", "LAMMPS\n\n2 atoms\n\nMasses\n\n1 12.011\n\nAtoms # charge\n\n1 1 xx 0 0 0\n2 1 0.5 1 0 0\n");
    EXPECT_EQ(findNote(data, ReadAction::leftOut, "partial charges").line, 11u);
    const Molecule mol2 = readMolecule("a.mol2",
                                       "@<TRIPOS>MOLECULE\na\n1 0\nSMALL\nUSER_CHARGES\n@<TRIPOS>ATOM\n"
                                       "1 C 0 0 0 C.3 1 LIG xx\n");
    EXPECT_EQ(findNote(mol2, ReadAction::leftOut, "partial charges").line, 7u);
    const Molecule mae = readMolecule("a.mae",
                                      "f_m_ct {\n s_m_title\n :::\n a\n m_atom[2] {\n  i_m_atomic_number\n"
                                      "  r_m_x_coord\n  r_m_y_coord\n  r_m_z_coord\n  r_m_charge1\n  :::\n"
                                      "  1 6 0 0 0 xx\n  2 6 1.5 0 0 0.25\n  :::\n }\n}\n");
    EXPECT_EQ(findNote(mae, ReadAction::leftOut, "partial charges").line, 12u);
    EXPECT_EQ(mae.partialCharges, (std::vector<float>{0, 0.25f}));
    const std::string head =
        "data_a\nloop_\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
        "_atom_site.occupancy\n_atom_site.pdbx_formal_charge\n";
    EXPECT_EQ(findNote(readMolecule("a.cif", head + "C 0 0 0 xx ?\n"), ReadAction::leftOut, "numbers").line, 9u);
    EXPECT_EQ(findNote(readMolecule("a.cif", head + "C 0 0 0 1 xx\n"), ReadAction::leftOut, "formal charges").line, 9u);
    EXPECT_EQ(findNote(readMolecule("a.cif", head + "C 0 0 0 1 0\n"), ReadAction::leftOut, "formal charges").count, 0);
}

TEST(ReadingList, HeadersThatAnnounceOtherCounts) {
    const std::string atoms = "Masses\n\n1 12.011\n\nAtoms # atomic\n\n1 1 0 0 0\n2 1 1.5 0 0\n";
    const Molecule fewer = readMolecule("a.data", "LAMMPS\n\n5 atoms\n\n" + atoms);
    EXPECT_EQ(findNote(fewer, ReadAction::leftOut, "atoms").count, 3);
    EXPECT_EQ(findNote(fewer, ReadAction::leftOut, "atoms").line, 3u);
    const Molecule more = readMolecule("a.data", "LAMMPS\n\n1 atoms\n\n" + atoms);
    EXPECT_EQ(more.atoms.size(), 2u);
    EXPECT_FALSE(more.warnings.empty());
    EXPECT_TRUE(readMolecule("a.data", "LAMMPS\n\n2 atoms\n\n" + atoms).warnings.empty());
    const auto mae = [](const char* count) {
        return readMolecule("a.mae", std::string("f_m_ct {\n s_m_title\n :::\n a\n m_atom[") + count +
                                         "] {\n  i_m_atomic_number\n  r_m_x_coord\n  r_m_y_coord\n  r_m_z_coord\n"
                                         "  :::\n  1 6 0 0 0\n  2 6 1.5 0 0\n  :::\n }\n}\n");
    };
    EXPECT_EQ(findNote(mae("4"), ReadAction::leftOut, "atoms").count, 2);
    EXPECT_FALSE(mae("1").warnings.empty());
    EXPECT_TRUE(mae("2").warnings.empty());
}

TEST(ReadingList, WhatNothingShows) {
    const Molecule extended =
        readMolecule("a.xyz",
                     "1\nLattice=\"9 0 0 0 9 0 0 0 9\" Properties=species:S:1:pos:R:3:velo:R:3:forces:R:3:foo:R:1\n"
                     "C 0 0 0 1 1 1 2 2 2 3\n");
    EXPECT_EQ(findNote(extended, ReadAction::unused, "velocities").count, 1);
    EXPECT_EQ(findNote(extended, ReadAction::unused, "forces").count, 1);
    EXPECT_EQ(findNote(extended, ReadAction::unused, "further columns").count, 1);
    EXPECT_TRUE(extended.warnings.empty()) << "nothing that a picture lacks";
    EXPECT_EQ(readActionName(ReadAction::unused), "left out");
    EXPECT_EQ(findNote(readMolecule("a.xyz", "1\n\nC 0 0 0 1 1\n"), ReadAction::unused, "further columns").count, 2);
    const Molecule contcar = readMolecule(
        "CONTCAR", "a\n1\n9 0 0\n0 9 0\n0 0 9\nC\n1\nSelective dynamics\nDirect\n0 0 0 T T F\n\n0.1 0.2 0.3\n");
    EXPECT_EQ(findNote(contcar, ReadAction::unused, "velocities").count, 1);
    EXPECT_EQ(findNote(contcar, ReadAction::unused, "flags of selective dynamics").count, 1);
    const Molecule xdatcar = readMolecule(
        "XDATCAR", "a\n1\n9 0 0\n0 9 0\n0 0 9\nC\n1\nDirect configuration= 1\n0 0 0\nDirect configuration= 2\n0 0 0\n");
    EXPECT_EQ(findNote(xdatcar, ReadAction::unused, "velocities").count, 0);
    EXPECT_EQ(findNote(readMolecule("a.xsf", "ATOMS\nC 0 0 0 1 1 1\n"), ReadAction::unused, "forces").count, 1);
    const std::string gro = "t\n1\n    1LIG      C    1   0.000   0.000   0.000";
    EXPECT_EQ(
        findNote(readMolecule("a.gro", gro + "  0.1000  0.1000  0.1000\n1 1 1\n"), ReadAction::unused, "velocities")
            .count,
        1);
    EXPECT_EQ(findNote(readMolecule("a.gro", gro + "\n1 1 1\n"), ReadAction::unused, "velocities").count, 0);
}

TEST(ReadingList, GuessedOrders) {
    // Ethene: 1.33 Å.
    const Molecule ethene = readMolecule("a.xyz",
                                         "6\n\nC 0 0 0.6650\nC 0 0 -0.6650\nH 0 0.9229 1.2327\nH 0 -0.9229 1.2327\n"
                                         "H 0 0.9229 -1.2327\nH 0 -0.9229 -1.2327\n");
    EXPECT_EQ(findNote(ethene, ReadAction::guessed, "bond orders").count, 5);
}

TEST(ReadingList, LinesOfUnusableCells) {
    const Molecule pdb =
        readMolecule("a.pdb", "CRYST1   xx.000   20.000   20.000  90.00  90.00  90.00 P 1\n" + rowOfCarbons(1, 1, ""));
    EXPECT_EQ(findNote(pdb, ReadAction::leftOut, "unit cells").line, 1u);
    const Molecule cif = readMolecule("a.cif",
                                      "data_a\n_cell.length_a xx\n_cell.length_b 9\n_cell.length_c 9\n"
                                      "_cell.angle_alpha 90\n_cell.angle_beta 90\n_cell.angle_gamma 90\nloop_\n"
                                      "_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
                                      "_atom_site.Cartn_z\nC 0 0 0\n");
    EXPECT_EQ(findNote(cif, ReadAction::leftOut, "unit cells").line, 2u);
    const Molecule flat = readMolecule("a.xyz", "1\nLattice=\"9 0 0 9 0 0 0 0 9\"\nC 0 0 0\n");
    EXPECT_EQ(findNote(flat, ReadAction::leftOut, "periodic boxes").line, 2u);
    test::expectError("small.cif",
                      "data_a\n_cell_length_a ?\n_cell_length_b 1\nloop_\n_atom_site_label\n_atom_site_fract_x\n"
                      "_atom_site_fract_y\n_atom_site_fract_z\nC1 0 0 0\n",
                      {"(line 2)", "_cell_length_a"});
}

TEST(ReadingList, LinesOfConnections) {
    const auto read = [](const char* x, const char* atom) {
        return readMolecule("a.cif", std::string("data_a\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
                                                 "_atom_site.label_comp_id\n_atom_site.label_asym_id\n"
                                                 "_atom_site.label_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
                                                 "_atom_site.Cartn_z\nS SG CYS A 7 0 0 0\nC CB CYS A 7 -1.8 0 0\n"
                                                 "C C1 LIG B . ") +
                                         x + " 0 0\nC C2 LIG B . " + x +
                                         " 1.5 0\nloop_\n_struct_conn.id\n_struct_conn.conn_type_id\n"
                                         "_struct_conn.ptnr1_label_asym_id\n_struct_conn.ptnr1_label_comp_id\n"
                                         "_struct_conn.ptnr1_label_seq_id\n_struct_conn.ptnr1_label_atom_id\n"
                                         "_struct_conn.ptnr2_label_asym_id\n_struct_conn.ptnr2_label_comp_id\n"
                                         "_struct_conn.ptnr2_label_seq_id\n_struct_conn.ptnr2_label_atom_id\n"
                                         "c1 covale A CYS 7 SG B LIG . " +
                                         atom + "\n");
    };
    EXPECT_EQ(findNote(read("1.8", "C1"), ReadAction::leftOut, "connections").count, 0);
    EXPECT_EQ(findNote(read("1.8", "C9"), ReadAction::leftOut, "connections").line, 26u);
    const Molecule far = read("21.8", "C1");
    EXPECT_EQ(findNote(far, ReadAction::leftOut, "connections").line, 26u);
    EXPECT_EQ(far.bonds.size(), 2u) << "none of 21.8 Å";
}

// HDF5

TEST(OddHdf5, DamagedFilesPrintNothing) {
    // The library prints the errors of each thread that has not asked it to be silent.
    const std::string damaged = std::string("\x89HDF\r\n\x1a\n") + std::string(200, '\1');
    const auto refuse = [&] { EXPECT_THROW(readMolecule("a.h5md", damaged), Error); };
    refuse();
    testing::internal::CaptureStderr();
    std::thread(refuse).join();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// Crystals and boxes

TEST(Boxes, RepeatAlongSomeAxes) {
    const auto box = [](const char* pbc) {
        return readMolecule("a.xyz", std::string("1\nLattice=\"4 0 0 0 5 0 0 0 30\" pbc=\"") + pbc + "\"\nC 0 0 0\n");
    };
    const Molecule slab = box("T T F");
    EXPECT_EQ(slab.file.boxRepeats, (std::array{true, true, false}));
    ASSERT_EQ(slab.assemblies.size(), 1u);
    EXPECT_EQ(slab.assemblies[0].id, "3x3x1");
    EXPECT_EQ(slab.assemblies[0].parts[0].transforms.size(), 9u);
    for (const glm::dmat4x3& copy : crystalCopies(slab, {-1, -1, -1}, {1, 1, 1})) EXPECT_EQ(copy[3].z, 0);
    EXPECT_EQ(crystalCopies(slab, {-1, -1, -1}, {1, 1, 1}).size(), 9u);
    const Molecule none = box("F F F");
    EXPECT_TRUE(none.file.box.has_value()) << "is stated";
    EXPECT_EQ(none.file.boxRepeats, (std::array{false, false, false}));
    EXPECT_TRUE(none.assemblies.empty());
    EXPECT_THROW(crystalCopies(none, {-1, -1, -1}, {1, 1, 1}), Error);
    EXPECT_EQ(box("1 0 1").file.boxRepeats, (std::array{true, false, true}));
    EXPECT_EQ(box("True, True, False").file.boxRepeats, (std::array{true, true, false}));
    EXPECT_EQ(readMolecule("a.xyz", "1\nLattice=\"4 0 0 0 5 0 0 0 30\"\nC 0 0 0\n").assemblies[0].id, "3x3x3");
    const Molecule dump = readMolecule("a.lammpstrj",
                                       "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp ff\n0 9\n"
                                       "0 9\n0 9\nITEM: ATOMS id element x y z\n1 C 1 1 1\n");
    EXPECT_EQ(dump.file.boxRepeats, (std::array{true, true, false}));
    const Molecule xsf = readMolecule("a.xsf", "SLAB\nPRIMVEC\n9 0 0\n0 9 0\n0 0 9\nPRIMCOORD\n1 1\nC 0 0 0\n");
    EXPECT_EQ(xsf.file.boxRepeats, (std::array{true, true, false}));
}

TEST(Boxes, TrajectoriesWrapAlongThoseAlone) {
    const test::TemporaryFolder folder;
    const std::string path = folder / "slab.xyz";
    const std::string frame = "1\nLattice=\"4 0 0 0 5 0 0 0 30\" pbc=\"T T F\"\nC 0 0 0\n";
    std::FILE* const file = std::fopen(path.c_str(), "w");
    ASSERT_TRUE(file);
    std::fputs((frame + frame).c_str(), file);
    std::fclose(file);
    const TrajectoryFrame first = openTrajectory(path)->read(0);
    ASSERT_TRUE(first.box.has_value());
    EXPECT_EQ((*first.box)[1], glm::vec3(0, 5, 0));
    EXPECT_EQ((*first.box)[2], glm::vec3(0));
}

std::string crystalOfCml(const std::string& symmetry) {
    std::string text = "<molecule><crystal>";
    for (const char* name : {"a", "b", "c"}) text += std::string("<scalar title=\"") + name + "\">4</scalar>";
    for (const char* name : {"alpha", "beta", "gamma"})
        text += std::string("<scalar title=\"") + name + "\">90</scalar>";
    return text + symmetry +
           "</crystal><atomArray><atom id=\"a\" elementType=\"C\" xFract=\"0.1\" yFract=\"0.2\" zFract=\"0.3\"/>"
           "<atom id=\"b\" elementType=\"O\" xFract=\"0\" yFract=\"0\" zFract=\"0\"/></atomArray></molecule>";
}

TEST(Boxes, SymmetryOfCml) {
    // A centre of symmetry: the carbon has two places, the oxygen on the centre one.
    const std::string inverse =
        "<symmetry spaceGroup=\"P -1\"><transform3>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</transform3>"
        "<transform3>-1 0 0 0 0 -1 0 0 0 0 -1 0 0 0 0 1</transform3></symmetry>";
    for (const std::string& symmetry : {inverse, std::string("<symmetry spaceGroup=\"P -1\"/>")}) {
        const Molecule crystal = readMolecule("a.cml", crystalOfCml(symmetry));
        ASSERT_EQ(crystal.atoms.size(), 2u);
        EXPECT_LT(glm::distance(crystal.atoms[0].position, glm::vec3(0.4f, 0.8f, 1.2f)), 1e-5f);
        EXPECT_EQ(crystal.file.spaceGroup, "P -1");
        ASSERT_EQ(crystal.assemblies.size(), 1u);
        EXPECT_EQ(crystal.assemblies[0].id, "unit-cell");
        std::size_t atoms = 0;
        for (const AssemblyPart& part : crystal.assemblies[0].parts)
            for (const std::uint32_t subchain : part.subchains)
                for (const Residue& residue : crystal.residues)
                    if (residue.subchain == subchain) atoms += residue.atomCount * part.transforms.size();
        EXPECT_EQ(atoms, 3u);
    }
    // Another molecule of the file has no part in it.
    const Molecule two =
        readMolecule("a.cml", "<cml>" + crystalOfCml(inverse) +
                                  "<molecule><atomArray><atom id=\"x\" elementType=\"N\" x3=\"1\" y3=\"1\" "
                                  "z3=\"1\"/></atomArray></molecule></cml>");
    ASSERT_EQ(two.atoms.size(), 3u);
    const std::uint32_t nitrogen = two.residues[two.atoms[2].residue].subchain;
    for (const AssemblyPart& part : two.assemblies.at(0).parts)
        EXPECT_EQ(std::count(part.subchains.begin(), part.subchains.end(), nitrogen), 0);
    const Molecule odd = readMolecule(
        "a.cml", crystalOfCml("<symmetry spaceGroup=\"?\"><transform3>1 0 0 0.123</transform3></symmetry>"));
    EXPECT_EQ(findNote(odd, ReadAction::leftOut, "symmetry operations").count, 1);
    EXPECT_EQ(findNote(odd, ReadAction::leftOut, "space groups").count, 1);
    EXPECT_EQ(odd.assemblies[0].id, "3x3x3");
}

// Cubes

/// Eight values at the corners of a cube, all of one sign or of both. @param print  a value, with no blank before it
DensityMap makeCube(const char* format, double factor, double offset) {
    std::string text = "a\nb\n    1  -10.000000-100.000000-100.000000\n";
    for (const char* axis :
         {"1.000000    0.000000    0.000000", "0.000000    1.000000    0.000000", "0.000000    0.000000    1.000000"})
        text += std::string("    2    ") + axis + "\n";
    text += "    6    6.000000    0.000000    0.000000    0.000000\n";
    for (int i = 0; i < 8; ++i) {
        text += formatted(format, factor * (i + 1) + offset);
        if (i % 2 == 1) text += "\n";
    }
    return readMap("a.cube", text);
}

TEST(OddCubes, ValuesThatTouch) {
    for (const char* format : {"%13.5E", "%.5E", "%.6f", "%11.6f"}) {
        SCOPED_TRACE(format);
        const DensityMap map = makeCube(format, 0.125, 0);
        EXPECT_NEAR(map.statistics.max, 1, 1e-5);
        EXPECT_NEAR(map.statistics.mean, 0.5625, 1e-5);
        EXPECT_NEAR(map.origin.y, -52.9177, 1e-3) << "the header's numbers touch as well";
        EXPECT_FALSE(map.difference);
        ASSERT_EQ(map.notes.size(), 1u);
        EXPECT_EQ(map.notes[0].what, "atoms");
        EXPECT_EQ(map.notes[0].line, 7u);
    }
    EXPECT_NEAR(makeCube("%.5E", -0.125, 0).statistics.min, -1, 1e-5);
}

TEST(OddCubes, NegativeLobesAloneHaveALevel) {
    const DensityMap map = makeCube("%13.5E", -0.125, 0);
    EXPECT_TRUE(map.difference) << "drawn at the negative level as well";
    EXPECT_NEAR(levelOfTopShare(map, 0.25, true), 0.875, 1e-4) << "two of eight values reach as far";
    EXPECT_NEAR(levelOfTopShare(map, 0.25), -0.25, 1e-4);
    EXPECT_FALSE(makeCube("%13.5E", 0.125, -0.13).difference) << "a density that is a little below zero";
}

}  // namespace
}  // namespace nacre
