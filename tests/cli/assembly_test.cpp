// Assemblies by the program itself, from a file with REMARK 350.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace nacre::test {
namespace {

constexpr const char* kTwoAssemblies =
    "REMARK 350 BIOMOLECULE: 1\n"
    "REMARK 350 AUTHOR DETERMINED BIOLOGICAL UNIT: TRIMERIC\n"
    "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n"
    "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n"
    "REMARK 350   BIOMT1   2  1.000000  0.000000  0.000000       10.00000\n"
    "REMARK 350   BIOMT2   2  0.000000  1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000        0.00000\n"
    "REMARK 350 BIOMOLECULE: 2\n"
    "REMARK 350 APPLY THE FOLLOWING TO CHAINS: B\n"
    "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n"
    "ATOM      1  C   GLY A   1       0.000   0.000   0.000  1.00  0.00           C\n"
    "ATOM      2  O   GLY A   1       1.200   0.000   0.000  1.00  0.00           O\n"
    "ATOM      3  C   GLY B   1       0.000   6.000   0.000  1.00  0.00           C\n"
    "END\n";

class AssemblyOption : public testing::Test {
protected:
    AssemblyOption() { std::ofstream(folder / "two.pdb") << kTwoAssemblies; }
    nlohmann::json stats(const std::string& options) {
        nacreDone(folder, "render two.pdb -o a.png --occlusion off --size 64x64 --stats s.json " + options);
        return nlohmann::json::parse(readContents(folder / "s.json"));
    }
    const TemporaryFolder folder;
};

TEST_F(AssemblyOption, DrawsCopiesOfWhatItMentions) {
    const auto plain = stats(""), first = stats("--assembly 1"), second = stats("--assembly 2");
    EXPECT_EQ(plain["atoms"]["drawn"], 3);
    EXPECT_EQ(plain["atoms"]["copies"], 1);
    EXPECT_EQ(first["atoms"]["drawn"], 4);
    EXPECT_EQ(first["atoms"]["submitted"], 4);
    EXPECT_EQ(first["atoms"]["copies"], 2);
    EXPECT_EQ(first["bonds"]["drawn"], 2);
    EXPECT_NEAR(first["view"]["center"][0], 5.6, 1e-6);
    EXPECT_EQ(second["atoms"]["drawn"], 1);
    EXPECT_NEAR(second["view"]["center"][1], 6, 1e-6);
}

TEST_F(AssemblyOption, ThatIsNotThereIsAnErrorThatNamesThoseThatAre) {
    const Outcome outcome = nacreIn(folder, "render two.pdb -o a.png --assembly 3");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("cannot draw assembly: 3: the file has no such assembly; it has 1, 2"),
              std::string::npos)
        << outcome.err;
    EXPECT_EQ(folder.count(), 1u);
}

TEST_F(AssemblyOption, CanBeReadOffInfo) {
    const auto json = nlohmann::json::parse(nacreIn(folder, "info two.pdb --json").out).at(0);
    ASSERT_EQ(json["assembly_list"].size(), 2u);
    EXPECT_EQ(json["assembly_list"][0]["id"], "1");
    EXPECT_EQ(json["assembly_list"][0]["copies"], 2);
    EXPECT_EQ(json["assembly_list"][0]["atoms"], 4);
    EXPECT_NE(nacreIn(folder, "info two.pdb").out.find("--assembly 2: 1 copy, 1 atoms"), std::string::npos);
}

}  // namespace
}  // namespace nacre::test
