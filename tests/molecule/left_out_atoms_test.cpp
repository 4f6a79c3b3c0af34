// An atom without usable coordinates is left out with its bonds, and the rest of the file is read.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/molecule/expect_error.h"

namespace nacre {
namespace {

/// Three atoms, of which the second is the one left out, and bonds 1-2 and 1-3 where the format states bonds.
struct OddAtom {
    const char *name, *text;
    int line;
    bool bonds = true;
};

const OddAtom kOddAtoms[] = {
    {"columns.sdf",
     "a\n\n\n  3  2  0  0  0  0  0  0  0  0999 V2000\n"
     "    0.0000    0.0000    0.0000 O   0  0\n"
     "********************    0.0000 H   0  0\n"
     "   -0.2400    0.9300    0.0000 H   0  0\n"
     "  1  2  1  0\n  1  3  1  0\nM  CHG  2   2   1   3   1\nM  END\n$$$$\n",
     6},
    {"words.sdf",
     "a\n\n\n  3  2  0  0  0  0  0  0  0  0999 V2000\n0.0 0.0 0.0 O 0 0\nnan 0.0 0.0 H 0 0\n-0.24 0.93 0.0 H 0 3\n"
     "  1  2  1  0\n  1  3  1  0\nM  END\n$$$$\n",
     6},
    {"v3000.sdf",
     "a\n\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\nM  V30 COUNTS 3 2 0 0 0\nM  V30 BEGIN ATOM\n"
     "M  V30 10 O 0 0 0 0\nM  V30 20 H ? 0 0 0\nM  V30 30 H -0.24 0.93 0 0 CHG=1\nM  V30 END ATOM\n"
     "M  V30 BEGIN BOND\nM  V30 1 1 10 20\nM  V30 2 1 10 30\nM  V30 END BOND\nM  V30 END CTAB\nM  END\n",
     9},
    {"ids.mol2",
     "@<TRIPOS>MOLECULE\na\n 3 2\nSMALL\nUSER_CHARGES\n@<TRIPOS>ATOM\n1 O 0 0 0 O.3 1 HOH -0.8\n"
     "2 H1 inf 0 0 H 1 HOH 0.4\n3 H2 -0.24 0.93 0 H 1 HOH 0.5\n@<TRIPOS>BOND\n1 1 2 1\n2 1 3 1\n",
     8},
    {"short.mol2",
     "@<TRIPOS>MOLECULE\na\n 3 2\nSMALL\nUSER_CHARGES\n@<TRIPOS>ATOM\n1 O 0 0 0 O.3 1 HOH -0.8\n2 H1 1.0\n"
     "3 H2 -0.24 0.93 0 H 1 HOH 0.5\n@<TRIPOS>BOND\n1 1 2 1\n2 1 3 1\n",
     8},
    {"a.txyz", "3 a\n1 O 0 0 0 1 2 3\n2 H ****** 0 0 2 1\n3 H -0.24 0.93 0 2 1\n", 3},
    {"a.mae",
     "f_m_ct {\n s_m_title\n :::\n a\n m_atom[3] {\n  i_m_atomic_number\n  r_m_x_coord\n  r_m_y_coord\n"
     "  r_m_z_coord\n  :::\n  1 8 0 0 0\n  2 1 <> 0 0\n  3 1 -0.24 0.93 0\n  :::\n }\n m_bond[2] {\n  i_m_from\n"
     "  i_m_to\n  i_m_order\n  :::\n  1 1 2 1\n  2 1 3 1\n  :::\n }\n}\n",
     12},
    {"a.xsf", "CRYSTAL\nPRIMVEC\n9 0 0\n0 9 0\n0 0 9\nPRIMCOORD\n3 1\nO 0 0 0\nH ** 0 0\nH -0.24 0.93 0\n", 9, false},
    {"molecule.xsf", "ATOMS\n8 0 0 0\n1 ** 0 0\n1 -0.24 0.93 0\n", 3, false},
    {"POSCAR", "a\n1\n9 0 0\n0 9 0\n0 0 9\nO H\n1 2\nCartesian\n0 0 0\nnan 0 0\n-0.24 0.93 0\n", 10, false},
    {"a.xyz", "3\na\nO 0 0 0\nH 1.0\nH -0.24 0.93 0\n", 4, false},
    {"a.lammpstrj",
     "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n"
     "ITEM: ATOMS id element x y z\n1 O 0 0 0\n2 H nan 0 0\n3 H -0.24 0.93 0\n",
     11, false},
    {"a.data",
     "LAMMPS\n\n3 atoms\n2 bonds\n\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\nMasses\n\n1 16.0\n2 1.008\n\n"
     "Atoms # molecular\n\n1 1 1 0 0 0\n2 1 2 nan 0 0\n3 1 2 -0.24 0.93 0\n\nBonds\n\n1 1 1 2\n2 1 1 3\n",
     18},
};

TEST(LeftOutAtoms, TheRestOfTheFileIsRead) {
    for (const OddAtom& odd : kOddAtoms) {
        SCOPED_TRACE(odd.name);
        const Molecule water = readMolecule(odd.name, odd.text);
        ASSERT_EQ(water.atoms.size(), 2u);
        EXPECT_EQ(water.atoms[0].element, 8);
        EXPECT_EQ(water.atoms[1].element, 1);
        EXPECT_FLOAT_EQ(water.atoms[1].position.y, 0.93f);
        ASSERT_EQ(water.bonds.size(), 1u) << "stated or by distance";
        EXPECT_EQ(water.bonds[0].source, odd.bonds ? BondSource::file : BondSource::distance);
        const auto warns = [&](const std::string& text) {
            return std::find(water.warnings.begin(), water.warnings.end(), text) != water.warnings.end();
        };
        const std::string line = std::to_string(odd.line);
        EXPECT_TRUE(warns("left out 1 atom, line " + line + ": no usable coordinates"));
        if (odd.bonds) {
            const auto bonds = std::find_if(water.notes.begin(), water.notes.end(),
                                            [](const ReadNote& note) { return note.what == "bonds"; });
            ASSERT_NE(bonds, water.notes.end());
            EXPECT_EQ(bonds->count, 1);
        }
        if (!water.partialCharges.empty()) {
            EXPECT_EQ(water.partialCharges, (std::vector<float>{-0.8f, 0.5f}));
        }
    }
    EXPECT_EQ(readMolecule(kOddAtoms[0].name, kOddAtoms[0].text).atoms[1].charge, 1) << "M  CHG counts records";
}

TEST(LeftOutAtoms, ManyRefuseTheFileByTheFirst) {
    test::expectError("a.sdf",
                      "a\n\n\n  1  0  0  0  0  0  0  0  0  0999 V2000\n"
                      "       nan    0.0000    0.0000 O   0  0\nM  END\n",
                      {"(line 5)", "invalid x coordinate 'nan'"});
    test::expectError("POSCAR", "a\n1\n9 0 0\n0 9 0\n0 0 9\nO\n2\nDirect\n1e5 0 nan\nnan 0 0\n",
                      {"(line 9)", "invalid z"});
}

TEST(LeftOutAtoms, FarFractionalPositionsAreNotUsable) {
    const Molecule near = readMolecule("POSCAR", "a\n1\n90000 0 0\n0 9 0\n0 0 9\nO\n2\nDirect\n0.1 0 0\n100000 0 0\n");
    EXPECT_EQ(near.atoms.size(), 1u);
}

TEST(LeftOutAtoms, SentencesCountInSingularAndPlural) {
    const auto sentence = [](const char* what, std::int64_t count, std::uint64_t line = 0) {
        return describeNote({ReadAction::leftOut, what, "why", count, line});
    };
    EXPECT_EQ(sentence("radii", 1), "left out 1 radius: why");
    EXPECT_EQ(sentence("radii", 2), "left out 2 radii: why");
    EXPECT_EQ(sentence("radii of grains", 1, 7), "left out 1 radius of grains, line 7: why");
    EXPECT_EQ(sentence("periodic boxes", 1), "left out 1 periodic box: why");
    EXPECT_EQ(sentence("assemblies", 1), "left out 1 assembly: why");
    EXPECT_EQ(sentence("masses", 1), "left out 1 mass: why");
    EXPECT_EQ(sentence("data blocks", 3, 9), "left out 3 data blocks, the first on line 9: why");
}

}  // namespace
}  // namespace nacre
