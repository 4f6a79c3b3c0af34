// Atoms that a fit pairs. The judge is Biopython 1.80's PairwiseAligner: global mode, BLOSUM62, open_gap_score -11,
// extend_gap_score -1, gaps at the ends 0; its blocks are written out below, of alignments that are the only best ones.

#include "engine/molecule/matched_atoms.h"

#include <gtest/gtest.h>

#include <array>

#include "engine/molecule/read.h"
#include "engine/molecule/selection/selection.h"
#include "engine/molecule/superpose.h"
#include "tests/molecule/build_molecule.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

std::string_view residueOf(char letter) {
    constexpr std::string_view kLetters = "ARNDCQEGHILKMFPSTWYV";
    constexpr std::array<std::string_view, 20> kNames = {"ALA", "ARG", "ASN", "ASP", "CYS", "GLN", "GLU",
                                                         "GLY", "HIS", "ILE", "LEU", "LYS", "MET", "PHE",
                                                         "PRO", "SER", "THR", "TRP", "TYR", "VAL"};
    return kNames.at(kLetters.find(letter));
}

struct Block {
    std::uint32_t first, second, length;
};
struct MatchCase {
    std::string first, second;
    std::vector<Block> blocks;
};

TEST(MatchedAtoms, PairsTheResiduesThatBiopythonPairs) {
    const MatchCase cases[] = {
        {"CMRNWDKYRTERNFFNGNWFRYDGYRYYMRGRWC", "LPYCMRNWDKCRTEWDFFNGNWYRSYGYRIYMRGRWC", {{0, 3, 34}}},
        {"KIGQGNYITSLPIVNDTFQLCSFRNWYLLKVSYPNNHS",
         "PMWGNYITSKPIVNDTFCGPLCSMRWYLLAVSYPNNIS",
         {{1, 0, 17}, {18, 19, 6}, {25, 25, 13}}},
        {"CFWHFKMGCNQCGGASYQHIACFWKVYLCTVR", "WHFKDMGCNQCRNASYQHCFWKSYLCTVR", {{2, 0, 4}, {6, 5, 13}, {21, 18, 11}}},
        {"VANEVMCHKVKSDDSPSSINCDLHSQTAETKCWAT", "VANEVICHKVKSDDKPSSINCTLHSAETKCWHW", {{0, 0, 25}, {27, 25, 8}}},
        {"MGETSKAAHSHEVKPKKNGDGSELESVVASK", "CACLTSKAAHSHEVQPEKSELEMNVADK", {{0, 1, 17}, {21, 18, 10}}}};
    for (const MatchCase& sequences : cases) {
        test::MoleculeText text;
        int number = 0;
        for (const std::string& sequence : {sequences.first, sequences.second})
            for (const char letter : sequence) text.residue(residueOf(letter), ++number).atom("CA", "C", {0, 0, 0});
        const auto second = static_cast<std::uint32_t>(sequences.first.size());
        std::vector<bool> first(text.molecule.atoms.size()), other(first.size());
        for (std::uint32_t i = 0; i < first.size(); ++i) (i < second ? first : other)[i] = true;
        std::vector<std::uint32_t> expectedFirst, expectedSecond;
        for (const Block& block : sequences.blocks)
            for (std::uint32_t i = 0; i < block.length; ++i) {
                expectedFirst.push_back(block.first + i);
                expectedSecond.push_back(second + block.second + i);
            }
        const AtomPairs pairs = matchAtoms(text.molecule, first, other);
        EXPECT_EQ(pairs.first, expectedFirst) << sequences.first;
        EXPECT_EQ(pairs.second, expectedSecond) << sequences.first;
    }
}

TEST(MatchedAtoms, AreThoseOfTheConformerThatIsDrawn) {
    test::MoleculeText text;
    text.residue("SER", 1).atom("CA", "C", {0, 0, 0}, 'A', 0.3f).atom("CA", "C", {1, 0, 0}, 'B', 0.7f);
    text.residue("SER", 2).atom("CA", "C", {5, 0, 0});
    const AtomPairs pairs = matchAtoms(text.molecule, {true, true, false}, {false, false, true});
    EXPECT_EQ(pairs.first, (std::vector<std::uint32_t>{1}));
    // A selection of the other conformer means that one.
    EXPECT_EQ(matchAtoms(text.molecule, {true, false, false}, {false, false, true}).first,
              (std::vector<std::uint32_t>{0}));
}

TEST(MatchedAtoms, OfResiduesThatAreNoAminoAcidsGoByTheirNames) {
    test::MoleculeText text;
    for (const char* name : {"DA", "DC", "DG", "DC", "DG"}) text.residue(name, 1).atom("P", "P", {0, 0, 0});
    const AtomPairs pairs =
        matchAtoms(text.molecule, {true, true, true, false, false}, {false, false, false, true, true});
    EXPECT_EQ(pairs.first, (std::vector<std::uint32_t>{1, 2}));
    EXPECT_EQ(pairs.residues, 2u);
    EXPECT_EQ(pairs.sameResidues, 2u);
    EXPECT_TRUE(matchAtoms(text.molecule, std::vector<bool>(5), std::vector<bool>(5, true)).first.empty());
}

// Biopython's Superimposer after its PairwiseAligner: 139 pairs, 1.5697 Å.
TEST(MatchedAtoms, OfHemoglobinsChains) {
    NACRE_NEEDS_DATA();
    const Molecule molecule = readMoleculeFile(test::dataFile("4hhb.pdb"));
    const AtomPairs pairs =
        matchAtoms(molecule, selectAtoms(molecule, parseSelection("chain A and protein and name CA")),
                   selectAtoms(molecule, parseSelection("chain B and protein and name CA")));
    ASSERT_EQ(pairs.first.size(), 139u);
    std::vector<glm::dvec3> from, to;
    for (const std::uint32_t atom : pairs.first) from.emplace_back(molecule.atoms[atom].position);
    for (const std::uint32_t atom : pairs.second) to.emplace_back(molecule.atoms[atom].position);
    EXPECT_NEAR(superpose(to, from).rmsd, 1.570, 0.001);
}

}  // namespace
}  // namespace nacre
