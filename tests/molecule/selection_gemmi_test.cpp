// The same selections in gemmi's syntax, evaluated by gemmi on its own reading of the file.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#define USE_STD_SNPRINTF  // Debian's gemmi comes without the stb that it prints numbers with otherwise

#include <gemmi/gz.hpp>
#include <gemmi/pdb.hpp>
#include <gemmi/select.hpp>

#include "engine/molecule/read.h"
#include "engine/molecule/selection/selection.h"
#include "tests/support/test_data.h"
#include "tests/support/written_files.h"

namespace nacre {
namespace {

struct Expressions {
    const char* file;
    const char* ours;
    const char* gemmis;
};
void PrintTo(const Expressions& pair, std::ostream* out) { *out << pair.file << ": " << pair.ours; }

std::size_t countOfGemmi(const std::string& path, const std::string& text) {
    gemmi::Structure structure = gemmi::read_pdb(gemmi::MaybeGzipped(path));
    const gemmi::Selection selection(text);
    std::size_t count = 0;
    for (gemmi::Chain& chain : selection.chains(structure.models.at(0)))
        for (gemmi::Residue& residue : selection.residues(chain))
            for (gemmi::Atom& atom : selection.atoms(residue)) {
                (void)atom;
                ++count;
            }
    return count;
}

class SameAsGemmi : public testing::TestWithParam<Expressions> {};

TEST_P(SameAsGemmi, InCount) {
    const bool written = std::string(GetParam().file).rfind("own/", 0) == 0;
    if (written) {
        NACRE_NEEDS_WRITTEN_FILES();
    } else {
        NACRE_NEEDS_DATA();
    }
    const std::string path = written ? test::writtenFile(GetParam().file) : test::dataFile(GetParam().file);
    const std::vector<bool> set = selectAtoms(readMoleculeFile(path), parseSelection(GetParam().ours));
    const std::size_t expected = countOfGemmi(path, GetParam().gemmis);
    EXPECT_GT(expected, 0u) << "the case shows nothing";
    EXPECT_EQ(static_cast<std::size_t>(std::count(set.begin(), set.end(), true)), expected);
}

INSTANTIATE_TEST_SUITE_P(
    Selection, SameAsGemmi,
    testing::Values(Expressions{"4hhb.pdb", "chain A", "//A"}, Expressions{"4hhb.pdb", "chain A+C", "//A,C"},
                    Expressions{"4hhb.pdb", "not chain A", "//!A"}, Expressions{"4hhb.pdb", "resn HEM", "(HEM)"},
                    Expressions{"4hhb.pdb", "resn HEM+HIS and name N*", "(HEM,HIS)/N,NA,NB,NC,ND,NE2,ND1"},
                    Expressions{"4hhb.pdb", "name CA", "CA[C]"}, Expressions{"4hhb.pdb", "elem FE", "[FE]"},
                    Expressions{"4hhb.pdb", "not elem C+N", "[!C,N]"},
                    Expressions{"4hhb.pdb", "chain B and resi 10-20", "//B/10-20"},
                    Expressions{"4hhb.pdb", "chain B and resi 10 and name CA", "//B/10-10/CA"},
                    Expressions{"3pqr.pdb", "altloc A", "*:A"}, Expressions{"3pqr.pdb", "altloc ''", "*:"},
                    Expressions{"1en2.pdb", "altloc A+B", "*:A,B"},
                    Expressions{"1bcu-icode.pdb", "resi 60A", "60.A-60.A"},
                    Expressions{"1bcu-icode.pdb", "resi 60", "60-60"},
                    Expressions{"1bcu-icode.pdb", "resi 60-61", "60.*-61.*"},
                    Expressions{"1bcu-icode.pdb", "chain H and resi 60B-61", "//H/60.B-61.*"},
                    Expressions{"1igy.pdb.gz", "chain B and resi 80-90", "//B/80.*-90.*"},
                    Expressions{"1aon-groel.pdb.gz", "chain A+N and name CA and resn GLY+ALA", "//A,N/(GLY,ALA)/CA"},
                    Expressions{"nucleosome-1kx5.pdb.gz", "elem P and resi 1-20", "1-20/[P]"},
                    Expressions{"own/dna.pdb", "chain A", "//A"}, Expressions{"own/dna.pdb", "not chain A", "//!A"},
                    Expressions{"own/dna.pdb", "resn DA+DT and name N*", "(DA,DT)/N1,N3,N6,N7,N9"},
                    Expressions{"own/dna.pdb", "chain B and resi 14-20", "//B/14-20"},
                    Expressions{"own/dna.pdb", "not elem C+N", "[!C,N]"},
                    Expressions{"own/dna.pdb", "elem P and resi 1-20", "1-20/[P]"}));

}  // namespace
}  // namespace nacre
