// What is used wrongly or cannot be read ends with an exit code and one line, and leaves no file.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/cli/options.h"
#include "tests/cli/error_line.h"

namespace nacre {
namespace {

using test::expectOneErrorLine;
using test::nacreIn;
using test::Outcome;
using test::TemporaryFolder;

TEST(CommandLine, UsedWronglyItExitsWithTwoAndOneLineAndNoFile) {
    for (const char* arguments : {"", "frob", "render sample:dna -o a.png --frob", "plan --caps voodoo"}) {
        const TemporaryFolder folder;
        const Outcome outcome = nacreIn(folder, arguments);
        EXPECT_EQ(outcome.code, 2);
        expectOneErrorLine(outcome);
        EXPECT_EQ(folder.count(), 0u);
    }
}

/// Words as a shell takes a line apart that knows single quotes alone.
std::vector<std::string> shellWords(const std::string& line) {
    std::vector<std::string> words;
    bool inWord = false, quoted = false;
    for (const char c : line) {
        if (c == ' ' && !quoted) {
            inWord = false;
            continue;
        }
        if (!inWord) words.emplace_back();
        inWord = true;
        if (c == '\'')
            quoted = !quoted;
        else
            words.back() += c;
    }
    return words;
}

/// What main() turns into exit code 2 and one line.
class WrongUsage : public testing::TestWithParam<const char*> {};

TEST_P(WrongUsage, IsOneLine) {
    const std::vector<std::string> words = shellWords(std::string("nacre ") + GetParam());
    std::vector<const char*> pointers;
    for (const std::string& word : words) pointers.push_back(word.c_str());
    try {
        app::parseCommandLine(static_cast<int>(pointers.size()), pointers.data());
        FAIL() << "was taken";
    } catch (const app::UsageError& error) {
        EXPECT_GT(std::string(error.what()).size(), 10u);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
}

INSTANTIATE_TEST_SUITE_P(
    CommandLine, WrongUsage,
    testing::Values(
        "", "plan --caps voodoo", "plan --caps mali --device 0", "plan --caps mali --size 0x1", "frob", "--frob",
        "render", "render sample:dna", "render -o a.png", "render sample:dna -o", "render sample:dna -o a.bmp",
        "render sample:dna -o a", "render sample:dna -o a.png --frob", "render sample:dna -o a.png --assembly",
        "render sample:dna -o a.png --assembly ''", "render sample:dna -o a.png --show A=licorice",
        "render sample:dna -o a.png --show all", "render sample:dna -o a.png --show all=hologram",
        "render sample:dna -o a.png --hide 'chain A and'", "render sample:dna -o a.png --hide",
        "render sample:dna -o a.png --color-by chain", "render sample:dna -o a.png --color-by all=mauve-ish",
        "render sample:dna -o a.png --color transparent", "render sample:dna -o a.png --encoded-format r16f",
        "render sample:dna -o a.png --model every", "render sample:dna -o a.png --debug plate",
        "render sample:dna -o a.png --debug patches --occlusion off",
        "render sample:dna -o a.png --debug occlusion --occlusion off",
        "render sample:dna -o a.png --debug depth --supersample 2", "render sample:dna -o a.png --memory 0",
        "render sample:dna -o a.png --transient maybe", "render sample:dna -o a.png --model 0",
        "render sample:dna -o a.png --size 0x5", "render sample:dna -o a.png --size 32769x5",
        "render sample:dna -o a.png --size nanxnan", "render sample:dna -o a.png --size 32768x32768 --supersample 3",
        "render sample:dna -o a.png --width 9000mm", "render sample:dna -o a.jpg --depth 16",
        "render sample:dna -o a.png --depth 12", "render sample:dna -o a.webp --size 16384x5",
        "render sample:dna -o a.png --width 85pt", "render sample:dna -o a.png --dpi 0",
        "render sample:dna -o a.png --size 10x10 --size 20x20", "render sample:dna -o a.png --size",
        "render sample:dna -o a.png --style hologram", "render sample:dna -o a.png --color mauve-ish",
        "render sample:dna -o a.png --rotate 1,2", "render sample:dna -o a.png --rotate nan,0,0",
        "render sample:dna -o a.png --zoom 0", "render sample:dna -o a.png --zoom nan",
        "render sample:dna -o a.png --zoom -1", "render sample:dna -o a.png --zoom inf",
        "render sample:dna -o a.png --projection fisheye", "render sample:dna -o a.png --fov 0.5",
        "render sample:dna -o a.png --fov 121", "render sample:dna -o a.png --fov nan",
        "render sample:dna -o a.png --occlusion 0", "render sample:dna -o a.png --occlusion 4097",
        "render sample:dna -o a.png --background blueish", "render sample:dna -o a.png --background '#12'",
        "render sample:dna -o a.png --lighting maybe", "render sample:dna -o a.png --legend onn",
        "render sample:dna -o a.png --supersample 0", "render sample:dna -o a.png --supersample 9",
        "render sample:dna -o a.png --supersample 1.5", "render sample:dna -o a.png --water yes",
        "render sample:dna -o a.png --hydrogens no", "render sample:dna -o a.png --format dcd",
        "render sample:dna -o a.png --layers a.png", "render sample:dna -o a.exr --layers ./a.exr",
        "render sample:dna -o a.png --stats a.png", "render sample:dna -o a.png --stats ''",
        "render sample:dna -o a.png --device ''", "render sample:dna -o a.png --visibility best",
        "render sample:dna -o a.png --prepass 1", "render sample:dna -o a.png --merge no",
        "render sample:dna -o a.png --capture a.png", "render sample:dna -o a.png --capture a",
        "render a.rdc -o a.png --capture ./a.rdc", "info", "info --frob sample:dna", "devices extra",
        "--version info sample:dna"));

struct Failure {
    const char* arguments;
    const char* says;
};
void PrintTo(const Failure& failure, std::ostream* out) { *out << failure.arguments; }
class Failing : public testing::TestWithParam<Failure> {};

TEST_P(Failing, ExitsWithOneAndOneLineAndNoFile) {
    const TemporaryFolder folder;
    const Outcome outcome = nacreIn(folder, GetParam().arguments);
    EXPECT_EQ(outcome.code, 1);
    expectOneErrorLine(outcome);
    EXPECT_NE(outcome.err.find(GetParam().says), std::string::npos) << outcome.err;
    EXPECT_EQ(folder.count(), 0u);
}

INSTANTIATE_TEST_SUITE_P(
    CommandLine, Failing,
    testing::Values(Failure{"render none.pdb -o a.png", "none.pdb"},
                    Failure{"render none.pdb -o a.png --layers l.exr --stats s.json", "none.pdb"},
                    Failure{"render sample:unobtainium -o a.png", "unobtainium"},
                    Failure{"render sample:dna -o missing/a.png", "missing/a.png"},
                    Failure{"render sample:dna -o a.png --layers missing/l.exr", "missing/l.exr"},
                    Failure{"render sample:dna -o a.png --stats missing/s.json", "missing/s.json"},
                    Failure{"render sample:dna -o /proc/a.png", "/proc/a.png"},
                    Failure{"render - --format pdb -o a.png", "standard input"}, Failure{"info none.pdb", "none.pdb"},
                    Failure{"info . --json", "."}, Failure{"render sample:dna --format pdb -o a.png", "--format"},
                    Failure{"render sample:dna --model 2 -o a.png", "one model"},
                    Failure{"render sample:dna --assembly 1 -o a.png", "states no assemblies"},
                    Failure{"render sample:dna -o a.png --device no-such-device", "no-such-device"}));

}  // namespace
}  // namespace nacre
