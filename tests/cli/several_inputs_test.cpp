// Several INPUTs in one picture: names, fits, colours.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "app/picture/input_names.h"
#include "app/picture/saved_view.h"
#include "engine/error.h"
#include "engine/molecule/text.h"
#include "engine/scene/color/colors.h"
#include "tests/support/run_program.h"
#include "tests/support/test_data.h"

namespace nacre::app {
namespace {

using test::nacreDone;
using test::nacreIn;
using test::Outcome;
using test::readContents;
using test::TemporaryFolder;

const std::string kBeside = " -o a.png --size 64x64 --occlusion off --cache off --zoom 1";

TEST(SeveralInputs, AMapAmongThemIsThatOfTheStructure) {
    const TemporaryFolder folder;
    std::ofstream map(folder / "m.dx");
    map << "object 1 class gridpositions counts 4 4 4\norigin -8 -8 -8\ndelta 5 0 0\ndelta 0 5 0\ndelta 0 0 5\n"
           "object 2 class gridconnections counts 4 4 4\n"
           "object 3 class array type double rank 0 items 64 data follows\n";
    for (int i = 0; i < 64; ++i) map << i % 7 << '\n';
    map.close();
    const auto drawn = [&](const std::string& inputs) {
        nacreDone(folder, "render " + inputs + kBeside);
        return readContents(folder / "a.png");
    };
    const std::string named = drawn("sample:dna --map m.dx");
    EXPECT_NE(named, drawn("sample:dna"));
    EXPECT_EQ(drawn("sample:dna m.dx"), named);
}

TEST(SeveralInputs, HaveNames) {
    InputOptions input;
    for (const char* text : {"receptor=a.pdb", "data/1crn.cif.gz", "sample:dna", "1crn.pdb", "-"})
        addInput(input, text);
    EXPECT_EQ(input.path, "a.pdb");
    EXPECT_EQ(input.further[0].path, "data/1crn.cif.gz");
    EXPECT_EQ(inputNames(input), (std::vector<std::string>{"receptor", "1crn", "dna", "1crn_2", "input"}));
    Selection selection = parseSelection("/receptor or (/dna+input and chain A)");
    nameInputs(inputNames(input), selection);
    EXPECT_EQ(selection.steps[0].test, SelectionTest::model);
    EXPECT_EQ(selection.steps[0].numbers[0].first, 1);
    EXPECT_EQ(selection.steps[1].numbers[1].first, 5);
    EXPECT_EQ(selection.steps[2].test, SelectionTest::chain) << "a chain stays one";
}

TEST(SeveralInputs, AreOnePicture) {
    const TemporaryFolder folder;
    nacreDone(folder, "render sample:glucose a=sample:buckyball --stats s.json" + kBeside);
    EXPECT_NE(readContents(folder / "s.json").find("\"read\": 84"), std::string::npos)
        << readContents(folder / "s.json");
    const std::string together = readContents(folder / "a.png");
    nacreDone(folder, "render sample:glucose a=sample:buckyball --hide /a --style ball-and-stick" + kBeside);
    const std::string hidden = readContents(folder / "a.png");
    EXPECT_NE(hidden, together);
    nacreDone(folder, "render sample:glucose --style ball-and-stick" + kBeside);
    EXPECT_EQ(readContents(folder / "a.png"), hidden) << "what is named is what is hidden";
}

TEST(SeveralInputs, StandInASavedView) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "there");
    std::ofstream(folder / "there/water.xyz") << "3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n";
    std::ofstream(folder / "there/both.json")
        << R"({"input": "sample:glucose", "name": "g", "further-inputs": [{"input": "water.xyz", "name": "w"}],
              "fits": [["/w and elem O+H", "/g"]], "style": "ball-and-stick", "water": "show",
              "rules": [{"color-by": "/w=#ff8000"}, {"show": "/w=spacefill"}]})";
    const std::string look =
        " --style ball-and-stick --water show --color-by /w=#ff8000 --show /w=spacefill --color element";
    const Outcome refused = nacreIn(folder, "render --view there/both.json" + kBeside);
    EXPECT_EQ(refused.code, 1) << "a fit is tried, and has too few pairs";
    EXPECT_NE(refused.err.find("cannot fit: /w and elem O+H"), std::string::npos) << refused.err;
    std::string text = readContents(folder / "there/both.json");
    text.replace(text.find("\"fits\""), text.find("\"style\"") - text.find("\"fits\""), "");
    std::ofstream(folder / "there/both.json") << text;
    nacreDone(folder, "render --view there/both.json" + kBeside);
    const std::string byView = readContents(folder / "a.png");
    // The same by words; the colours that keep molecules apart lie below those of the view.
    nacreDone(folder, "render g=sample:glucose w=there/water.xyz" + look + kBeside);
    EXPECT_EQ(readContents(folder / "a.png"), byView);
    nacreDone(folder, "render g=sample:glucose" + look + kBeside);
    EXPECT_NE(readContents(folder / "a.png"), byView);
    for (const char* bad : {R"({"input": "a", "further-inputs": [{"name": "b"}]})", R"({"further-inputs": {}})",
                            R"({"name": "a b"})", R"({"further-inputs": [{"input": "b", "name": "x/y"}]})",
                            R"({"fits": [["all"]]})", R"({"further-inputs": [{"input": "b", "format": "pdb"}]})"})
        EXPECT_THROW(parseSavedView(bad, "view"), Error) << bad;
}

TEST(SeveralInputs, AreColouredApartUnlessAsked) {
    const TemporaryFolder folder;
    const std::string two = "render sample:buckyball b=sample:buckyball";
    nacreDone(folder, two + " --hide /buckyball" + kBeside);
    const std::string apart = readContents(folder / "a.png");
    nacreDone(folder, two + " --hide /b" + kBeside);
    EXPECT_NE(readContents(folder / "a.png"), apart) << "the second has carbons of its own colour";
    nacreDone(folder, two + " --hide /buckyball --color white" + kBeside);
    const std::string white = readContents(folder / "a.png");
    nacreDone(folder, two + " --hide /b --color white" + kBeside);
    EXPECT_EQ(readContents(folder / "a.png"), white);
}

/// A chain of eight atoms, turned, shifted, and with every second residue bent by a tenth of an Å.
std::string turned(double angle, double bend) {
    std::string text;
    for (int i = 0; i < 8; ++i) {
        const double x = 3.0 * i, y = i * i % 5 + (i % 2 ? bend : 0), z = i * i * i % 7;
        text += formatted("ATOM  %5d  CA  %s A%4d    %8.3f%8.3f%8.3f  1.00  0.00           C\n", i + 1,
                          i % 3 ? "ALA" : "GLY", i + 1, std::cos(angle) * x - std::sin(angle) * y + 5,
                          std::sin(angle) * x + std::cos(angle) * y - 9, z + 2);
    }
    return text + "END\n";
}

/// TM-align 20240303: 139 pairs of residues, RMSD 1.41 Å, TM-scores 0.90417 and 0.87557.
TEST(SeveralInputs, AreAlignedByStructure) {
    NACRE_NEEDS_DATA();
    const TemporaryFolder folder;
    const std::string file = test::dataFile("4hhb.pdb");
    const Outcome outcome = nacreDone(folder, "render a=" + file + " b=" + file +
                                                  " --align '/a and chain A' '/b and chain B' --style line" + kBeside);
    EXPECT_NE(outcome.err.find("(chain A on B): 139 pairs of residues"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("TM-score 0.904 by the 141 residues"), std::string::npos) << outcome.err;
    const Outcome none = nacreIn(folder, "render a=" + file + " b=sample:dna --align /a /b" + kBeside);
    EXPECT_NE(none.code, 0);
    EXPECT_NE(none.err.find("its longest chain has 0 alpha carbons"), std::string::npos) << none.err;
}

TEST(SeveralInputs, HaveColorsThatTheChainsOfTheFirstDoNotHave) {
    RepresentationOptions look{.color = ColorScheme::element};
    colorApart({"a", "b", "c"}, look);
    ASSERT_EQ(look.rules.size(), 2u);
    for (const Rule& rule : look.rules)
        for (std::size_t chain = 0; chain < 4; ++chain)
            EXPECT_NE(rule.coloring, Coloring::elementWithCarbons(kindColor(chain, kChainPalette)));
    EXPECT_NE(look.rules[0].coloring, look.rules[1].coloring);
}

TEST(OneInput, WithoutACellIsDrawnWithAWarning) {
    const TemporaryFolder folder;
    const Outcome outcome = nacreDone(folder, "render sample:glucose --cell on" + kBeside);
    EXPECT_NE(outcome.err.find("the file states no unit cell or box"), std::string::npos) << outcome.err;
}

TEST(SeveralInputs, AreLaidOntoEachOther) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.pdb") << turned(0, 0);
    std::ofstream(folder / "b.pdb") << turned(1.2, 0);
    const Outcome same = nacreDone(folder, "render a.pdb b.pdb --fit /b /a --style spacefill --color white" + kBeside);
    EXPECT_EQ(same.err, "nacre: fit of /b onto /a (chain A on A): 8 pairs of atoms, RMSD 0.000 Å\n");
    const std::string together = readContents(folder / "a.png");
    nacreDone(folder, "render a.pdb --style spacefill --color white" + kBeside);
    // Both are where the first is; they differ by what a PDB file rounds.
    EXPECT_NEAR(static_cast<double>(readContents(folder / "a.png").size()), static_cast<double>(together.size()), 200);
    std::ofstream(folder / "c.pdb") << turned(0.7, 0.5);
    const Outcome bent = nacreDone(folder, "render --fit /c /a a.pdb c.pdb --fit 'name CA and /a' /c" + kBeside);
    // By numpy's SVD (Kabsch's way) from the same numbers.
    EXPECT_NE(bent.err.find("8 pairs of atoms, RMSD 0.242 Å"), std::string::npos) << bent.err;
    EXPECT_EQ(bent.err.find("no sense"), std::string::npos) << bent.err;
    // Other residues in other places, which BLOSUM62 pairs, or which have nothing in common; and the same residues, in
    // places that say otherwise.
    const auto named = [](const char* alanine, const char* glycine) {
        std::string text = turned(0, 3);
        for (std::size_t at; (at = text.find("ALA")) != std::string::npos;) text.replace(at, 3, alanine);
        for (std::size_t at; (at = text.find("GLY")) != std::string::npos;) text.replace(at, 3, glycine);
        return text;
    };
    std::ofstream(folder / "d.pdb") << turned(0, 30);
    std::ofstream(folder / "e.pdb") << named("SER", "ASN");
    std::ofstream(folder / "f.pdb") << named("TRP", "LYS");
    const Outcome far = nacreIn(folder, "render a.pdb d.pdb --fit /d /a" + kBeside),
                  unlike = nacreIn(folder, "render d.pdb e.pdb --fit /d /e" + kBeside),
                  strange = nacreIn(folder, "render d.pdb f.pdb --fit /d /f" + kBeside);
    EXPECT_NE(strange.err.find("fewer than three of its atoms have a counterpart"), std::string::npos) << strange.err;
    EXPECT_NE(far.err.find("may make no sense: 8 of 8 residues have a counterpart"), std::string::npos) << far.err;
    EXPECT_NE(unlike.err.find("may make no sense: 0 of 8 residues have a counterpart"), std::string::npos)
        << unlike.err;
}

TEST(SeveralInputs, FitWhatGemmiAndNumpyFit) {
    NACRE_NEEDS_DATA();
    const TemporaryFolder folder;
    const std::string file = test::dataFile("4hhb.pdb");
    const auto fit = [&](const std::string& moving, const std::string& fixed) {
        return nacreIn(folder, "render a=" + file + " b=" + file + " --fit '/b and chain " + moving +
                                   "' '/a and chain " + fixed + "'" + kBeside)
            .err;
    };
    // By numpy's SVD over the same CA atoms; B and A by gemmi's alignment of their sequences, as in matched_atoms.h.
    EXPECT_NE(fit("C and name CA", "A and name CA").find("141 pairs of atoms, RMSD 0.297 Å"), std::string::npos);
    EXPECT_NE(fit("D and name CA", "B and name CA").find("146 pairs of atoms, RMSD 0.364 Å"), std::string::npos);
    // Whole chains without their haems and waters, by PyMOL's `align`.
    EXPECT_NE(fit("A", "C").find("1069 pairs of atoms, RMSD 0.618 Å; 904 pairs, RMSD 0.240 Å without 165 outliers"),
              std::string::npos)
        << fit("A", "C");
}

TEST(SeveralInputs, RefuseWhatCannotBeInOneLine) {
    const TemporaryFolder folder;
    const struct {
        const char* arguments;
        int code;
        const char* says;
    } cases[] = {
        {"render sample:dna --fit /a /b", 2, "name two"},
        {"render sample:dna b=sample:dna --fit /b", 2, "--fit"},
        {"render sample:dna b=sample:dna --fit '/b or /dna' /dna", 1, "several INPUTs"},
        {"render sample:dna b=sample:dna --fit '/b and chain A' '/b and chain B'", 1, "same INPUT"},
        {"render sample:dna b=sample:glucose --fit '/b and name C1' /dna", 1, "fewer than three"},
        {"render sample:dna b=sample:glucose --fit '/b and chain Q' /dna", 1, "no atoms"},
        {"render sample:dna none.pdb", 1, "none.pdb"},
        {"render a=sample:dna a=sample:glucose", 2, "two INPUTs have the name 'a'"},
        {"render sample:dna dna=sample:glucose", 2, "two INPUTs have the name 'dna'"},
        {"render - -", 2, "standard input"},
        {"render sample:dna b=sample:dna --assembly 1", 2, "--assembly is for one INPUT"},
        {"movie sample:dna b=sample:dna --models", 2, "one INPUT"},
    };
    for (const auto& c : cases) {
        const std::string output = std::string(c.arguments).rfind("movie", 0) == 0 ? " -o m.gif" : kBeside;
        const Outcome outcome = nacreIn(folder, c.arguments + output);
        EXPECT_EQ(outcome.code, c.code) << c.arguments << outcome.err;
        EXPECT_NE(outcome.err.find(c.says), std::string::npos) << c.arguments << ": " << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
    EXPECT_EQ(folder.count(), 0u);
}

}  // namespace
}  // namespace nacre::app
