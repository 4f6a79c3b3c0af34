#include "engine/molecule/selection/selection.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/molecule/read.h"
#include "tests/molecule/build_molecule.h"
#include "tests/molecule/expect_error.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

std::size_t count(const Molecule& molecule, std::string_view text) {
    const std::vector<bool> set = selectAtoms(molecule, parseSelection(text));
    EXPECT_EQ(set.size(), molecule.atoms.size());
    return static_cast<std::size_t>(std::count(set.begin(), set.end(), true));
}

/// Names of the selected atoms, each with its residue's number.
std::string names(const Molecule& molecule, std::string_view text) {
    const std::vector<bool> set = selectAtoms(molecule, parseSelection(text));
    std::string list;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set[i])
            list += std::string(molecule.atoms[i].name.view()) +
                    std::to_string(molecule.residues[molecule.atoms[i].residue].number) + " ";
    return list;
}

/// Two residues of chain A, one of chain a with insertion codes, haem iron, a sodium ion and a water.
Molecule mixed() {
    test::MoleculeText text;
    text.residue("ALA", -2).atom("N", "N", {0, 0, 0}).atom("CA", "C", {1.5f, 0, 0}).atom("CB", "C", {1.5f, 1.5f, 0});
    text.residue("GLY", 3)
        .atom("N", "N", {3, 0, 0})
        .atom("CA", "C", {4.5f, 0, 0}, 'A')
        .atom("HA2", "H", {5, 1, 0}, 'B');
    text.residue("SER", 82, 'A').atom("N", "N", {9, 0, 0}).atom("OG", "O", {10, 0, 0});
    text.residue("HEM", 101).atom("FE", "FE", {20, 0, 0}).atom("NA", "N", {22, 0, 0}).atom("C1A", "C", {23, 0, 0});
    text.residue("NA", 102).atom("NA", "NA", {30, 0, 0});
    text.residue("HOH", 103).atom("O", "O", {40, 0, 0});
    text.molecule.chains.push_back({"a"});
    text.molecule.residues[2].chain = 1;
    for (std::size_t i = 8; i < text.molecule.atoms.size(); ++i) text.molecule.atoms[i].hetero = true;
    return text.molecule;
}

struct Chosen {
    const char* selection;
    const char* names;
};
void PrintTo(const Chosen& c, std::ostream* out) { *out << c.selection; }
class Selects : public testing::TestWithParam<Chosen> {};

TEST_P(Selects, TheseAtoms) { EXPECT_EQ(names(mixed(), GetParam().selection), GetParam().names); }

INSTANTIATE_TEST_SUITE_P(
    Selection, Selects,
    testing::Values(Chosen{"chain a", "N82 OG82 "}, Chosen{"CHAIN a", "N82 OG82 "},
                    Chosen{"chain a+Q and name n", "N82 "}, Chosen{"resn ala", "N-2 CA-2 CB-2 "},
                    Chosen{"resname HEM,hoh", "FE101 NA101 C1A101 O103 "}, Chosen{"resn HEM, HOH and elem o", "O103 "},
                    Chosen{"resi -2", "N-2 CA-2 CB-2 "}, Chosen{"resi \\-2", "N-2 CA-2 CB-2 "},
                    Chosen{"resi -5--1", "N-2 CA-2 CB-2 "}, Chosen{"resi -5-3 and name N", "N-2 N3 "},
                    Chosen{"resi -5:3 and name N", "N-2 N3 "}, Chosen{"resi 82", ""}, Chosen{"resi 82A", "N82 OG82 "},
                    Chosen{"resi 82a", "N82 OG82 "}, Chosen{"resi 81-82", "N82 OG82 "}, Chosen{"resi 82B-90", ""},
                    Chosen{"resi 80-82A", "N82 OG82 "}, Chosen{"resi 82-82B", "N82 OG82 "},
                    Chosen{"resi 3+102", "N3 CA3 HA23 NA102 "}, Chosen{"name NA", "NA101 NA102 "},
                    Chosen{"name C* and hetatm", "C1A101 "}, Chosen{"name 'NA' and not ion", "NA101 "},
                    Chosen{"elem FE", "FE101 "}, Chosen{"symbol fe+na", "FE101 NA102 "}, Chosen{"e. h", "HA23 "},
                    Chosen{"protein", "N-2 CA-2 CB-2 N3 CA3 HA23 N82 OG82 "},
                    Chosen{"polymer and chain a", "N82 OG82 "}, Chosen{"nucleic", ""},
                    Chosen{"ligand", "FE101 NA101 C1A101 "}, Chosen{"water", "O103 "}, Chosen{"solvent", "O103 "},
                    Chosen{"ion", "NA102 "}, Chosen{"backbone", "N-2 CA-2 N3 CA3 HA23 N82 "},
                    Chosen{"sidechain", "CB-2 OG82 "}, Chosen{"hydrogen", "HA23 "}, Chosen{"hydrogens", "HA23 "},
                    Chosen{"h.", "HA23 "}, Chosen{"altloc A", "CA3 "}, Chosen{"alt b", "HA23 "},
                    Chosen{"altloc '' and resi 3", "N3 "}, Chosen{"none", ""},
                    Chosen{"* & hetatm", "FE101 NA101 C1A101 NA102 O103 "}, Chosen{"model 1 and ion", "NA102 "},
                    Chosen{"id 1+3-4", "N-2 CB-2 N3 "}, Chosen{"model 2", ""}, Chosen{"model 1-3 and ion", "NA102 "},
                    Chosen{"not (protein or hetatm)", ""}, Chosen{"!protein&!ligand", "NA102 O103 "},
                    Chosen{"not not ion", "NA102 "}, Chosen{"ion or water and none", "NA102 "},
                    Chosen{"(ion or water) and none", ""}, Chosen{"ion|water", "NA102 O103 "},
                    Chosen{"within 3 of (elem FE)", "FE101 NA101 C1A101 "},
                    Chosen{"within 2.5 of elem FE", "FE101 NA101 "}, Chosen{"within 0 of ion", "NA102 "},
                    Chosen{"within 10000 of none", ""}, Chosen{"ligand within 2 of (name FE)", "FE101 NA101 "},
                    Chosen{"elem C or ion within 3 of ligand", "C1A101 "}, Chosen{"byres (name OG)", "N82 OG82 "},
                    // As PyMOL has them: behind what they are about.
                    Chosen{"name FE around 2.5", "NA101 "}, Chosen{"name FE expand 2.5", "FE101 NA101 "},
                    Chosen{"byres name FE around 2.5", "FE101 NA101 C1A101 "},
                    Chosen{"(resi 3 and name N) around 1.6", "CA-2 CA3 "},
                    Chosen{"ion or (name FE around 2.5)", "NA101 NA102 "}, Chosen{"bychain name OG", "N82 OG82 "},
                    Chosen{"bc. name OG", "N82 OG82 "}, Chosen{"~(protein or ligand)", "NA102 O103 "},
                    // As ChimeraX has them.
                    Chosen{"name FE :<2.5", "FE101 NA101 C1A101 "}, Chosen{"name FE @<2.5", "FE101 NA101 "},
                    Chosen{"/a :<0", "N82 OG82 "}, Chosen{"@FE:<2.5", "FE101 NA101 C1A101 "},
                    Chosen{"protein @>0", "FE101 NA101 C1A101 NA102 O103 "},
                    Chosen{"not byres within 9.9 of (chain a)", "FE101 NA101 C1A101 NA102 O103 "}));

TEST(Selection, BondsAndSegments) {
    test::MoleculeText text;
    text.residue("LIG", 1).atom("C1", "C", {0, 0, 0}).atom("C2", "C", {1.5f, 0, 0}).atom("C3", "C", {3, 0, 0});
    text.residue("HOH", 2).atom("O", "O", {9, 0, 0});
    Molecule molecule = text.molecule;
    molecule.bonds = {{0, 1}, {1, 2}};
    molecule.subchains = {"A", "B"};
    molecule.residues[1].subchain = 1;
    EXPECT_EQ(names(molecule, "neighbor name C2"), "C11 C31 ");
    EXPECT_EQ(names(molecule, "name C1 extend 1"), "C11 C21 ");
    EXPECT_EQ(names(molecule, "name C1 extend 2"), "C11 C21 C31 ");
    EXPECT_EQ(names(molecule, "bymolecule name C3"), "C11 C21 C31 ");
    EXPECT_EQ(names(molecule, "segi B"), "O2 ");
    EXPECT_THROW(parseSelection("chain A and name C1 around 5"), Error);  // PyMOL and ChimeraX differ
    EXPECT_THROW(parseSelection("not name C1 expand 5"), Error);
    EXPECT_THROW(parseSelection("name C1 around"), Error);
}

TEST(Selection, ByResidueTakesAllOfWhatItTouches) {
    EXPECT_EQ(names(mixed(), "byres (within 3 of (name CA and resi -2))"), "N-2 CA-2 CB-2 N3 CA3 HA23 ");
    EXPECT_EQ(names(mixed(), "byres name OG"), "N82 OG82 ");
}

TEST(Selection, ByResidueJoinsResiduesThatTheFileInterleaves) {
    test::MoleculeText text;
    text.residue("SER", 1).atom("N", "N", {0, 0, 0}, 'A');
    text.residue("THR", 1).atom("N", "N", {0, 0, 0}, 'B');
    text.residue("SER", 1).atom("CA", "C", {1, 0, 0}, 'A');
    EXPECT_EQ(count(text.molecule, "byres (name CA)"), 2u);
}

struct Fault {
    const char* text;
    const char* says;
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.text; }
class Refused : public testing::TestWithParam<Fault> {};

TEST_P(Refused, WithTheColumn) {
    try {
        parseSelection(GetParam().text);
        ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
        test::expectCleanMessage(error.what());
        EXPECT_NE(std::string(error.what()).find(GetParam().says), std::string::npos) << error.what();
    }
}

INSTANTIATE_TEST_SUITE_P(
    Selection, Refused,
    testing::Values(
        Fault{"", "column 1: expected a selection"}, Fault{"   ", "column 4: expected a selection"},
        Fault{"foo", "column 1: expected a selection such as 'chain A', 'resn HEM' or 'protein', found 'foo'"},
        Fault{"x.", "column 1: expected a selection such as 'chain A', 'resn HEM' or 'protein', found 'x.'"},
        Fault{"expand", "column 1: expected a selection such as 'chain A', 'resn HEM' or 'protein', found 'expand'"},
        Fault{"chain A and resi x", "column 18: expected a residue number, found 'x'"},
        Fault{"chain", "column 6: expected a chain name, found the end"},
        Fault{"chain and protein", "column 7: expected a chain name, found 'and'"},
        Fault{"resn HEM+", "column 10: expected a residue name, found the end"},
        Fault{"name (CA)", "column 6: expected an atom name, found '('"},
        Fault{"elem Qq", "column 6: expected an element symbol, found 'Qq'"},
        Fault{"elem C1", "column 6: expected an element"}, Fault{"resi 1-", "column 8: expected a residue number"},
        Fault{"resi 5-3", "column 8: the range ends before it begins"},
        Fault{"resi 5AB", "column 8: expected '+', ',' or the end of the number"},
        Fault{"resi 99999999999", "column 6: expected a residue number"}, Fault{"resi 1.5", "column 7"},
        Fault{"model one", "column 7: expected a model number"}, Fault{"protein)", "column 8: expected 'and', 'or'"},
        Fault{"(protein", "column 9: expected 'and', 'or' or ')', found the end"},
        Fault{"protein ligand", "column 9: expected 'and', 'or' or the end, found 'ligand'"},
        Fault{"protein and", "column 12: expected a selection"}, Fault{"or protein", "column 1: expected a selection"},
        Fault{"not", "column 4: expected a selection"}, Fault{"within x of all", "column 8: expected a distance"},
        Fault{"within -1 of all", "column 8: expected a distance"}, Fault{"within nan of all", "column 8: expected"},
        Fault{"within inf of all", "column 8: expected"}, Fault{"within 5 protein", "column 10: expected 'of'"},
        Fault{"within 5 off all", "(did you mean 'of'?)"}, Fault{"chain A adn chain B", "(did you mean 'and'?)"},
        Fault{"within 5 of", "column 12: expected a selection"},
        Fault{"byres ligand and chain A", "column 14: put parentheses around what 'byres' applies to"},
        Fault{"within 5 of ligand or ion", "column 20: put parentheses"},
        Fault{"protein within 5 of (ligand) and ion", "column 30: put parentheses"},
        Fault{"chain 'A", "column 7: this quote is not closed"}, Fault{"chain Å and foo", "column 13: expected"},
        Fault{"\x1b[31m", "column 1"}));

TEST(Selection, NestingAndLengthAreBounded) {
    const auto nested = [](int depth) { return std::string(depth, '(') + "all" + std::string(depth, ')'); };
    EXPECT_EQ(count(mixed(), nested(60)), mixed().atoms.size());
    EXPECT_THROW(parseSelection(nested(100000)), Error);
    EXPECT_THROW(parseSelection(nested(70)), Error);
    std::string nots;
    for (int i = 0; i < 1000; ++i) nots += "not ";
    EXPECT_THROW(parseSelection(nots + "all"), Error);
    std::string chain = "all";
    for (int i = 0; i < 1000; ++i) chain += " and all";
    EXPECT_EQ(count(mixed(), chain), mixed().atoms.size());
}

TEST(Selection, IsAPlainValueThatKeepsItsText) {
    const Selection selection = parseSelection(" chain A and  resi 3 ");
    EXPECT_EQ(selection.text, "chain A and  resi 3");
    EXPECT_EQ(selection, parseSelection("chain A and  resi 3"));
    EXPECT_NE(selection, parseSelection("chain A and resi 4"));
}

TEST(Selection, KindsOfRealFiles) {
    NACRE_NEEDS_DATA();
    const Molecule haemoglobin = readMoleculeFile(test::dataFile("4hhb.pdb"));
    EXPECT_EQ(count(haemoglobin, "protein") + count(haemoglobin, "ligand") + count(haemoglobin, "ion") +
                  count(haemoglobin, "water"),
              4779u);
    EXPECT_EQ(count(haemoglobin, "ligand"), 4u * 43u);  // HEM
    EXPECT_EQ(count(haemoglobin, "byres (elem FE)"), 4u * 43u);
    EXPECT_EQ(count(haemoglobin, "resn PO4"), count(haemoglobin, "ion"));
    EXPECT_EQ(count(haemoglobin, "sidechain or backbone"), count(haemoglobin, "protein"));
    EXPECT_EQ(count(haemoglobin, "backbone and name CA"), 141u * 2 + 146u * 2);
    const Molecule dna = readMoleculeFile(test::dataFile("1bna.pdb"));
    EXPECT_EQ(count(dna, "nucleic"), 486u);
    EXPECT_EQ(count(dna, "water"), 80u);
    EXPECT_EQ(count(dna, "backbone and elem P"), 22u);
    const Molecule old = readMoleculeFile(test::dataFile("1bna-old-remediation.pdb"));
    EXPECT_EQ(count(old, "backbone"), count(dna, "backbone"));  // C5* is C5'
    // The chromophore is a modified part of the chain.
    const Molecule gfp = readMoleculeFile(test::dataFile("gfp-1ema.cif"));
    EXPECT_EQ(count(gfp, "protein and resn CRO"), count(gfp, "resn CRO"));
    EXPECT_GT(count(gfp, "resn CRO"), 10u);
}

TEST(Selection, TheModelIsTheOneThatWasRead) {
    NACRE_NEEDS_DATA();
    const Molecule third = readMoleculeFile(test::dataFile("1l2y.pdb"), {.format = {}, .model = 3});
    EXPECT_EQ(count(third, "model 3"), 304u);
    EXPECT_EQ(count(third, "model 1"), 0u);
}

/// It is written into saved views, and compared where a view changes.
TEST(Selection, ItsTextIsAllOfItAndReadsAgain) {
    std::string many = "id 1";
    for (int i = 2; i < 400; ++i) many += "+" + std::to_string(2 * i);
    for (const std::string& text : {std::string("chain A\t+B and\n all"), many}) {
        const Selection selection = parseSelection(text);
        EXPECT_EQ(selection.text.size(), text.size());
        EXPECT_EQ(parseSelection(selection.text), selection);
        EXPECT_EQ(selection.text.find('\n'), std::string::npos);
    }
    EXPECT_NE(parseSelection(many + "+5"), parseSelection(many + "+7"));
}

}  // namespace
}  // namespace nacre
