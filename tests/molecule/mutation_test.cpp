// Thousands of damaged files, always the same ones: each is a molecule or an Error, and nothing else.
#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "tests/molecule/expect_error.h"
#include "tests/molecule/gsd_writer.h"
#include "tests/support/test_data.h"
#include "tests/support/written_files.h"

namespace nacre {
namespace {

std::string readBeginning(const std::string& path, std::size_t bytes = std::string::npos) {
    std::ifstream file(path, std::ios::binary);
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

/// A file of the data folder.
struct DataFile {
    const char* name;
    std::size_t bytes;  ///< of its beginning
    int rounds;
};

/// Files of one format: one that the build makes, so that the format is judged everywhere, and those of the data folder
/// where there is one.
struct Mutated {
    const char* written;
    std::vector<DataFile> data;
};

class Mutation : public testing::TestWithParam<Mutated> {};

TEST_P(Mutation, IsAMoleculeOrAnError) {
    NACRE_NEEDS_WRITTEN_FILES();
    const Mutated& given = GetParam();
    const std::string path = test::writtenFile(given.written);
    expectMoleculeOrError(path, readBeginning(path), 500);
    if (!test::dataFolder()) return;
    for (const DataFile& file : given.data) {
        SCOPED_TRACE(file.name);
        expectMoleculeOrError(file.name, readBeginning(test::dataFile(file.name), file.bytes), file.rounds);
    }
}

TEST(MutatedSeeds, AreMoleculesOrErrors) {
    for (const char* seed : {"water.psf", "water.prmtop", "water.top", "water.inpcrd", "water.data", "beads.lammpstrj",
                             "salt.poscar", "water.xsf", "water.txyz", "water.mae"}) {
        SCOPED_TRACE(seed);
        expectMoleculeOrError(seed, readBeginning(std::string(NACRE_SOURCE_DIR "/tests/fuzz/seeds/") + seed), 1500);
    }
    for (const bool packed : {false, true}) expectMoleculeOrError("a.gsd", test::gsdBytes(packed), 1500);
}

constexpr std::size_t kWhole = 1 << 20;

INSTANTIATE_TEST_SUITE_P(
    Formats, Mutation,
    testing::Values(Mutated{"obabel/glucose.pdb", {{"1en2.pdb", 40000, 1500}}},
                    Mutated{
                        "gemmi/glucose.cif",
                        {{"small/hem-ccd.cif", kWhole, 2000}, {"1crn.cif", 30000, 1500}, {"1stp-v5.cif", kWhole, 200}}},
                    Mutated{"gemmi/glucose.cif.gz", {{"1crn.cif.gz", kWhole, 1000}}},
                    Mutated{"obabel/glucose_core.cif", {{"small/core-867861.cif", kWhole, 500}}},
                    Mutated{"gemmi/glucose.json", {{"1pfe.mmjson.json", kWhole, 300}}},
                    Mutated{"own/dna.bcif", {{"1j59.bcif.gz", kWhole, 300}}},
                    Mutated{"own/dna.mmtf", {{"1crn.mmtf", kWhole, 2000}, {"1bna.mmtf", kWhole, 2000}}},
                    Mutated{"obabel/glucose.sdf", {{"small/tyr.sdf", kWhole, 3000}}},
                    Mutated{"rdkit/glucose_v3000.sdf", {{"small/v3000-ngl.sdf", kWhole, 3000}}},
                    Mutated{"obabel/glucose.mol2",
                            {{"small/adrenalin.mol2", kWhole, 3000}, {"small/ligs3d-multi.mol2", kWhole, 500}}},
                    Mutated{"obabel/glucose.cml", {{"small/ferrocene.cml", kWhole, 3000}}},
                    Mutated{"obabel/glucose.gro", {{"1crn.gro", kWhole, 1500}}},
                    Mutated{"obabel/glucose.pqr", {{"3pqr.pqr", 30000, 1000}}},
                    Mutated{"obabel/buckyball.pdbqt", {{"small/dxc.pdbqt", kWhole, 1000}}},
                    Mutated{"obabel/glucose.txyz", {}}, Mutated{"obabel/glucose.mae", {}},
                    Mutated{"obabel/glucose.lmp", {}},
                    Mutated{"rdkit/glucose.xyz", {{"small/multi-frame.xyz", kWhole, 3000}}}),
    [](const auto& test) {
        std::string name = test.param.written;
        for (char& c : name)
            if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
        return name;
    });

}  // namespace
}  // namespace nacre
