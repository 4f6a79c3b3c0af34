// Selections by numbers, folds and sequences, words of other programs, and what is suggested for a word misspelt.

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/molecule/read.h"
#include "engine/molecule/selection/selection.h"
#include "engine/molecule/text.h"
#include "tests/molecule/expect_error.h"

namespace nacre {
namespace {

std::string line(int residue, const char* name, const char* chain, double x, double occupancy, double b) {
    return formatted("ATOM  %5d  CA  %s %s%4d    %8.3f%8.3f%8.3f%6.2f%6.2f           C\n", residue, name, chain,
                     residue, x, 0.0, 0.0, occupancy, b);
}

/// Seven residues 10 Å apart, a helix, a strand, two chains.
Molecule peptide() {
    const std::string text =
        "HELIX    1   1 GLY A    1  LEU A    2  1                                   2\n"
        "SHEET    1   A 1 LYS A   4  LYS A   4  0\n" +
        line(1, "GLY", "A", 0, 1, 10) + line(2, "LEU", "A", 10, 1, 20) + line(3, "ASN", "A", 20, 0.5, 30) +
        line(4, "LYS", "A", 30, 0.5, 40) + line(5, "ALA", "B", 40, 0.3, 50) + line(6, "LEU", "B", 50, 1, 60) +
        line(7, "ASN", "B", 60, 1, 70);
    return readMolecule("a.pdb", text);
}

/// Numbers of the residues that are selected.
std::string numbers(std::string_view text) {
    const Molecule molecule = peptide();
    const std::vector<bool> set = selectAtoms(molecule, parseSelection(text));
    std::string list;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set[i]) list += std::to_string(i + 1);
    return list;
}

TEST(SelectionWords, Numbers) {
    EXPECT_EQ(numbers("b > 50"), "67");
    EXPECT_EQ(numbers("b>=50"), "567");
    EXPECT_EQ(numbers("b-factor < 20"), "1");
    EXPECT_EQ(numbers("B <= 20 and chain A"), "12");
    EXPECT_EQ(numbers("b = 30"), "3");
    EXPECT_EQ(numbers("b != 30"), "124567");
    EXPECT_EQ(numbers("occupancy < 1"), "345");
    EXPECT_EQ(numbers("q = 0.3"), "5");
    EXPECT_EQ(numbers("not q == 1"), "345");
}

/// Atoms of residues that are no polymer, one behind the other.
Molecule ligands(std::initializer_list<std::pair<const char*, int>> residues) {
    std::string text;
    int number = 0, atom = 0;
    for (const auto& [name, atoms] : residues) {
        ++number;
        for (int i = 0; i < atoms; ++i, ++atom) {
            text += formatted("HETATM%5d  C%-2d %s A%4d    %8.3f%8.3f%8.3f  1.00  0.00           C\n", atom + 1, i,
                              name, number, 1.5 * atom, 0.0, 0.0);
        }
    }
    return readMolecule("a.pdb", text);
}

std::string listMainLigand(const Molecule& molecule) {
    const std::vector<bool> set = selectAtoms(molecule, parseSelection("mainligand"));
    std::string list;
    for (const Residue& residue : molecule.residues) {
        const auto count =
            std::count(set.begin() + residue.firstAtom, set.begin() + residue.firstAtom + residue.atomCount, true);
        if (count == 0) continue;
        EXPECT_EQ(count, residue.atomCount);
        list += std::to_string(residue.number);
    }
    return list;
}

TEST(SelectionWords, TheMainLigandIsTheLargestThatIsNoGlycan) {
    EXPECT_EQ(listMainLigand(ligands({{"NAG", 14}, {"QQ1", 6}, {"QQ2", 10}, {"QQ2", 10}, {"SO4", 5}})), "3");
    EXPECT_EQ(listMainLigand(ligands({{"GOL", 6}, {"NAG", 14}})), "2") << "for want of another one";
    EXPECT_EQ(listMainLigand(ligands({{"HOH", 1}, {"HOH", 1}})), "");
    EXPECT_EQ(listMainLigand(peptide()), "");
}

TEST(SelectionWords, Folds) {
    EXPECT_EQ(numbers("ss helix"), "12");
    EXPECT_EQ(numbers("helix"), "12");
    EXPECT_EQ(numbers("ss S"), "4");
    EXPECT_EQ(numbers("ss h+s"), "124");
    EXPECT_EQ(numbers("ss loop"), "3567");
    EXPECT_EQ(numbers("ss ''"), "3567");
}

TEST(SelectionWords, Sequences) {
    EXPECT_EQ(numbers("sequence LN"), "2367");
    EXPECT_EQ(numbers("seq g?n"), "123");
    EXPECT_EQ(numbers("sequence KA"), "");  // of two chains
    EXPECT_EQ(numbers("pepseq GL+AL"), "1256");
    const Molecule dna = sampleMolecule("dna");
    const std::vector<bool> all = selectAtoms(dna, parseSelection("sequence ?"));
    EXPECT_EQ(std::count(all.begin(), all.end(), false), 0);
    const std::vector<bool> some = selectAtoms(dna, parseSelection("sequence CG"));
    EXPECT_GT(std::count(some.begin(), some.end(), true), 0);
}

TEST(SelectionWords, AroundLeavesOutWhatItIsMeasuredFrom) {
    EXPECT_EQ(numbers("around 10 of resi 3"), "24");
    EXPECT_EQ(numbers("within 10 of resi 3"), "234");
    EXPECT_EQ(numbers("chain B and around 25 of (chain A)"), "56");
    EXPECT_EQ(numbers("chain B around 10 of (chain A)"), "5");
}

TEST(SelectionWords, WordsOfChimeraX) {
    EXPECT_EQ(numbers("/A:2-3"), "23");
    EXPECT_EQ(numbers("/A"), "1234");
    EXPECT_EQ(numbers("/A,B:leu"), "26");
    EXPECT_EQ(numbers(":2-3,7"), "237");
    EXPECT_EQ(numbers("@ca & /B"), "567");
    EXPECT_EQ(numbers("#1/B:5@CA"), "5");
    EXPECT_EQ(numbers("#2"), "");
    EXPECT_EQ(numbers("not /A:2 and (:LEU or :1)"), "16");
}

TEST(SelectionWords, MisspeltOnesAreSuggested) {
    const auto fault = [](std::string_view text) {
        try {
            parseSelection(text);
        } catch (const Error& error) {
            test::expectCleanMessage(error.what());
            return std::string(error.what());
        }
        return std::string("it reads");
    };
    EXPECT_NE(fault("chian A").find("found 'chian' (did you mean 'chain'?)"), std::string::npos) << fault("chian A");
    EXPECT_NE(fault("protien").find("'protein'"), std::string::npos);
    EXPECT_NE(fault("not sidechian").find("'sidechain'"), std::string::npos);
    EXPECT_EQ(fault("xyzzy").find("did you mean"), std::string::npos);
    EXPECT_NE(fault("b 50").find("one of < <= = >= > !="), std::string::npos);
    EXPECT_NE(fault("b > high").find("expected a number"), std::string::npos);
    EXPECT_NE(fault("ss knot").find("helix, strand or loop"), std::string::npos);
    EXPECT_NE(fault("sequence A-B").find("one-letter codes"), std::string::npos);
    EXPECT_NE(fault("/A/B//CA").find("column"), std::string::npos);  // PyMOL's, where places have meanings
    EXPECT_NE(fault("within 3 of chain A around 4 of chain B").find("parentheses"), std::string::npos);
}

}  // namespace
}  // namespace nacre
