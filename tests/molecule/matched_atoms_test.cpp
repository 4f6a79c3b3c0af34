// Atoms that a fit pairs. The judge is Biopython 1.80's PairwiseAligner: global mode, BLOSUM62, open_gap_score -11,
// extend_gap_score -1, gaps at the ends 0; its blocks are written out below, of alignments that are the only best ones.

#include "engine/molecule/matched_atoms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "engine/molecule/join_models.h"
#include "engine/molecule/read.h"
#include "engine/molecule/residue_distances.h"
#include "engine/molecule/selection/selection.h"
#include "engine/molecule/superpose.h"
#include "tests/molecule/build_molecule.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

std::string_view residueCode(char letter) {
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
            for (const char letter : sequence) text.residue(residueCode(letter), ++number).atom("CA", "C", {0, 0, 0});
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

/// A fit of one selection on another, of molecules whose positions in the list are their models.
PrunedSuperposition fitPairs(const Molecule& molecule, const AtomPairs& pairs) {
    std::vector<glm::dvec3> from, to;
    for (const std::uint32_t atom : pairs.first) from.emplace_back(molecule.atoms[atom].position);
    for (const std::uint32_t atom : pairs.second) to.emplace_back(molecule.atoms[atom].position);
    return superposePruned(to, from);
}

AtomPairs matched(const Molecule& molecule, const char* first, const char* second) {
    return matchAtoms(molecule, selectAtoms(molecule, parseSelection(first)),
                      selectAtoms(molecule, parseSelection(second)));
}

Molecule together(std::vector<Molecule> molecules) {
    for (std::size_t i = 0; i < molecules.size(); ++i)
        for (Chain& chain : molecules[i].chains) chain.model = static_cast<int>(i + 1);
    Molecule whole = joinModels("a b", std::move(molecules), 1'000'000);
    whole.modelsAreInputs = true;
    whole.inputs = {"a", "b"};
    return whole;
}

struct FitCase {
    const char *fixed, *moving, *first, *second;
    std::size_t pairs, kept;
    double rmsd, keptRmsd;
};

// The judge is PyMOL 2.5's `align` with cycles=5 and cutoff=2, and with cycles=0.
TEST(MatchedAtoms, FitAsPyMolFits) {
    NACRE_NEEDS_DATA();
    const FitCase cases[] = {
        {"1u19-rhodopsin.cif.gz", "3pqr.pdb", "#2 and chain A and name CA", "#1 and chain A and name CA", 326, 288,
         2.8351, 1.5646},
        // Palmitates have CA atoms, too; the nearer of two equal chains is taken.
        {"1u19-rhodopsin.cif.gz", "3pqr.pdb", "#2 and name CA", "#1 and name CA", 326, 284, 2.8161, 1.5366},
        // The inhibitor of 1A4W has CA atoms in chain H.
        {"1a4w-thrombin.cif.gz", "1bcu-icode.pdb", "#2 and chain H and name CA", "#1 and chain H and name CA", 248, 227,
         0.2025, 0.1563},
        {"4hhb.pdb", "4hhb.pdb", "#2 and chain A", "#1 and chain C", 1069, 904, 0.6180, 0.2402},
        {"4hhb.pdb", "4hhb.pdb", "#2 and name CA and chain A+B", "#1 and name CA and chain C+D", 287, 254, 0.3796,
         0.2855}};
    for (const FitCase& row : cases) {
        const Molecule molecule =
            together({readMoleculeFile(test::dataFile(row.fixed)), readMoleculeFile(test::dataFile(row.moving))});
        const AtomPairs pairs = matched(molecule, row.first, row.second);
        const PrunedSuperposition fit = fitPairs(molecule, pairs);
        EXPECT_EQ(pairs.first.size(), row.pairs) << row.first;
        EXPECT_EQ(fit.count, row.kept) << row.first;
        EXPECT_EQ(std::count(fit.kept.begin(), fit.kept.end(), 1), static_cast<std::ptrdiff_t>(row.kept));
        EXPECT_NEAR(fit.rmsdOfAll, row.rmsd, 2e-4) << row.first;
        EXPECT_NEAR(fit.motion.rmsd, row.keptRmsd, 2e-4) << row.first;
    }
}

TEST(MatchedAtoms, ChainsAreThoseThatComeTogether) {
    NACRE_NEEDS_DATA();
    // The same tetramer with the names of its like chains exchanged: in the order of the file, nothing would fit.
    const Molecule fixed = readMoleculeFile(test::dataFile("4hhb.pdb"));
    Molecule moving = fixed;
    for (Atom& atom : moving.atoms) atom.position = {atom.position.z + 50, atom.position.x, atom.position.y};
    const std::size_t chains = moving.chains.size();
    ASSERT_GE(chains, 4u);
    std::swap(moving.chains[0].name, moving.chains[2].name);
    std::swap(moving.chains[1].name, moving.chains[3].name);
    const Molecule molecule = together({fixed, moving});
    const AtomPairs pairs = matched(molecule, "#2", "#1");
    EXPECT_NEAR(fitPairs(molecule, pairs).rmsdOfAll, 0, 1e-4);
    using Pair = std::pair<std::uint32_t, std::uint32_t>;
    const auto first = static_cast<std::uint32_t>(chains);
    EXPECT_EQ(pairs.chains, (std::vector<Pair>{{first, 0}, {first + 1, 1}, {first + 2, 2}, {first + 3, 3}}));
}

TEST(MatchedAtoms, LigandsArePairedWhereNothingElseIsSelected) {
    NACRE_NEEDS_DATA();
    const Molecule thrombin = readMoleculeFile(test::dataFile("4hhb.pdb"));
    const AtomPairs pairs = matched(thrombin, "chain A and resn HEM", "chain C and resn HEM");
    EXPECT_EQ(pairs.first.size(), 43u);  // of a haem
    EXPECT_TRUE(pairs.chains.empty());
}

TEST(MatchedAtoms, ResiduesKnowHowFarTheirCounterpartsAre) {
    NACRE_NEEDS_DATA();
    const Molecule fixed = readMoleculeFile(test::dataFile("1crn.pdb"));
    Molecule moved = fixed;
    for (Atom& atom : moved.atoms)
        if (moved.residues[atom.residue].number > 40) atom.position.z += 2;
    const Molecule molecule = together({fixed, moved});
    const std::vector<double> distances = residueDistances(molecule);
    ASSERT_EQ(distances.size(), 92u);
    for (std::size_t i = 0; i < distances.size(); ++i) EXPECT_NEAR(distances[i], i % 46 >= 40 ? 2 : 0, 1e-4) << i;
    EXPECT_TRUE(std::isnan(residueDistances(fixed)[0]));
}

// 3PQR's chain B is the C-terminal peptide of transducin, 11 residues (SEQRES); 1U19 has rhodopsins alone. The end of
// any long chain agrees with so short a one in 3 residues of 11.
TEST(MatchedAtoms, APeptideIsNoCounterpartOfAProtein) {
    NACRE_NEEDS_DATA();
    const Molecule joined = together(
        {readMoleculeFile(test::dataFile("1u19-rhodopsin.cif.gz")), readMoleculeFile(test::dataFile("3pqr.pdb"))});
    const std::vector<double> distances = residueDistances(joined);
    std::size_t paired = 0, peptide = 0;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const Chain& chain = joined.chains[joined.residues[i].chain];
        if (chain.model != 2 || joined.residues[i].name == Name("HOH")) continue;
        if (chain.name == "A") paired += !std::isnan(distances[i]);
        if (chain.name != "B") continue;
        EXPECT_TRUE(std::isnan(distances[i])) << joined.residues[i].number;
        ++peptide;
    }
    EXPECT_GE(paired, 320u);
    EXPECT_EQ(peptide, 11u);
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
