// Thousands of damaged files, always the same ones: each is a molecule or an Error, and nothing else.
#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "tests/molecule/expect_error.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

std::string beginningOf(const std::string& name, std::size_t bytes) {
    std::ifstream file(test::dataFile(name), std::ios::binary);
    std::stringstream all;
    all << file.rdbuf();
    return all.str().substr(0, bytes);
}

std::string mutate(const std::string& original, std::mt19937& random) {
    const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
    static constexpr char kLikely[] = {'\n', ' ', '-', '9', '.', ';', '\'', '"', '?', '_', '\0', '\xff', '[', '{'};
    std::string text = original;
    for (std::size_t changes = 1 + below(12); changes > 0 && !text.empty(); --changes) {
        const std::size_t at = below(text.size());
        switch (below(5)) {
            case 0:
                text[at] = static_cast<char>(below(256));
                break;
            case 1:
                text[at] = kLikely[below(sizeof kLikely)];
                break;
            case 2:
                text.erase(at, 1 + below(40));
                break;
            case 3:
                text.insert(at, text, below(text.size()), below(60));
                break;
            default:
                if (below(8) == 0) text.resize(at);
        }
    }
    return text;
}

void expectMoleculeOrError(const std::string& name, const std::string& original, int rounds) {
    std::mt19937 random(20240607);
    int read = 0;
    for (int round = 0; round < rounds; ++round) {
        try {
            const Molecule molecule = readMolecule(name, mutate(original, random));
            ASSERT_FALSE(molecule.atoms.empty());
            for (const Bond& bond : molecule.bonds)
                ASSERT_TRUE(bond.a < bond.b && bond.b < molecule.atoms.size()) << round;
            ASSERT_LE(molecule.warnings.size(), 32u);
            ++read;
        } catch (const Error& error) {
            test::expectCleanMessage(error.what());
        }
    }
    EXPECT_GT(read, 0);
    EXPECT_LT(read, rounds);
}

struct Case {
    const char* file;
    std::size_t bytes;
    int rounds;
};

class Mutation : public testing::TestWithParam<Case> {};

TEST_P(Mutation, IsAMoleculeOrAnError) {
    NACRE_NEEDS_DATA();
    const Case& given = GetParam();
    expectMoleculeOrError(given.file, beginningOf(given.file, given.bytes), given.rounds);
}

INSTANTIATE_TEST_SUITE_P(Formats, Mutation,
                         testing::Values(Case{"1pfe.mmjson.json", 1 << 20, 300}, Case{"small/tyr.sdf", 1 << 20, 3000},
                                         Case{"small/v3000-ngl.sdf", 1 << 20, 3000},
                                         Case{"small/multi-frame.xyz", 1 << 20, 3000},
                                         Case{"small/hem-ccd.cif", 1 << 20, 2000}, Case{"1crn.cif", 30000, 1500},
                                         Case{"1crn.cif.gz", 1 << 20, 1000}, Case{"1en2.pdb", 40000, 1500},
                                         Case{"small/adrenalin.mol2", 1 << 20, 3000},
                                         Case{"small/ligs3d-multi.mol2", 1 << 20, 500}, Case{"3pqr.pqr", 30000, 1000},
                                         Case{"1crn.gro", 1 << 20, 1500}, Case{"small/dxc.pdbqt", 1 << 20, 1000},
                                         Case{"small/ferrocene.cml", 1 << 20, 3000}, Case{"1j59.bcif.gz", 1 << 20, 300},
                                         Case{"1crn.mmtf", 1 << 20, 2000}, Case{"1bna.mmtf", 1 << 20, 2000},
                                         Case{"1stp-v5.cif", 1 << 20, 200},
                                         Case{"small/core-867861.cif", 1 << 20, 500}),
                         [](const auto& test) {
                             std::string name = test.param.file;
                             for (char& c : name)
                                 if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                             return name;
                         });

}  // namespace
}  // namespace nacre
