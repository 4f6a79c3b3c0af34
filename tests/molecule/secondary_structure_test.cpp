#include "engine/molecule/secondary_structure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "engine/molecule/read.h"
#include "tests/molecule/build_molecule.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

/// 'H', 'E' or '-' of each residue.
std::string fold(const Molecule& molecule) {
    std::string text;
    for (const Residue& residue : molecule.residues) text += "-HE"[static_cast<int>(residue.secondary)];
    return text;
}

TEST(SecondaryStructure, OfPdbLines) {
    const auto helix =
        secondaryOfPdbLine("HELIX    1  H1 ILE A   -7  PRO A   19B 1                                  13");
    ASSERT_TRUE(helix);
    EXPECT_EQ(helix->kind, SecondaryStructure::helix);
    EXPECT_EQ(helix->chain, "A");
    EXPECT_EQ(helix->first, -7);
    EXPECT_EQ(helix->last, 19);
    EXPECT_EQ(helix->firstCode, '\0');
    EXPECT_EQ(helix->lastCode, 'B');
    const auto strand = secondaryOfPdbLine("SHEET    2  S1 2 CYS B  32C ILE B  35 -1");
    ASSERT_TRUE(strand);
    EXPECT_EQ(strand->kind, SecondaryStructure::strand);
    EXPECT_EQ(strand->chain, "B");
    EXPECT_EQ(strand->first, 32);
    EXPECT_EQ(strand->firstCode, 'C');
    EXPECT_EQ(strand->last, 35);
    for (const char* line : {"HELIX", "HELIX    1  H1 ILE A    x  PRO A   19", "SHEET ", "TURN     1", ""})
        EXPECT_FALSE(secondaryOfPdbLine(line)) << line;
}

TEST(SecondaryStructure, RangesMarkResiduesInOrderOfTheFile) {
    test::MoleculeText text;
    for (const int number : {1, 2, 3, 5, 4, 6}) text.residue("ALA", number).atom("CA", "C", {0, 0, 0});
    applySecondaryStructure(text.molecule, {{SecondaryStructure::strand, "A", 1, 3, '\0', '\0'},
                                            {SecondaryStructure::helix, "A", 3, 4, '\0', '\0'},
                                            {SecondaryStructure::helix, "B", 1, 2, '\0', '\0'},
                                            {SecondaryStructure::helix, "A", 6, 99, '\0', '\0'}});
    EXPECT_EQ(fold(text.molecule), "EEHHH-");
    EXPECT_TRUE(text.molecule.statesSecondaryStructure);
    ASSERT_EQ(text.molecule.notes.size(), 1u);
    EXPECT_EQ(describeNote(text.molecule.notes[0]),
              "left out 2 helix or strand records: of residues that are not there");
}

TEST(SecondaryStructure, ManyOverlappingRangesTakeLinearTime) {
    test::MoleculeText text;
    std::vector<SecondaryRange> ranges;
    for (int i = 0; i < 20000; ++i) {
        text.residue("ALA", i).atom("CA", "C", {0, 0, 0});
        ranges.push_back({SecondaryStructure::helix, "A", 0, 19999, '\0', '\0'});
    }
    applySecondaryStructure(text.molecule, ranges);
    EXPECT_EQ(fold(text.molecule), std::string(20000, 'H'));
}

TEST(SecondaryStructure, PdbAndMmcifSayTheSame) {
    NACRE_NEEDS_DATA();
    const Molecule pdb = readMoleculeFile(test::dataFile("1crn.pdb"));
    EXPECT_EQ(fold(pdb), "EEEE--HHHHHHHHHHHHH---HHHHHHHH-EEEE-----------");
    EXPECT_EQ(fold(readMoleculeFile(test::dataFile("1crn.cif"))), fold(pdb).substr(0, 46));
    for (const char* name : {"4hhb", "1igy"}) {
        const bool plain = std::string(name) == "4hhb";
        const Molecule a = readMoleculeFile(test::dataFile(std::string(name) + (plain ? ".pdb" : ".pdb.gz")));
        const Molecule b = readMoleculeFile(test::dataFile(std::string(name) + ".cif.gz"));
        const auto marks = [](const Molecule& molecule) {
            const std::string text = fold(molecule);
            return std::array{std::count(text.begin(), text.end(), 'H'), std::count(text.begin(), text.end(), 'E')};
        };
        EXPECT_GT(marks(a)[0], 20) << name;
        EXPECT_EQ(marks(a), marks(b)) << name;
        EXPECT_TRUE(a.statesSecondaryStructure && b.statesSecondaryStructure);
    }
    EXPECT_FALSE(readMoleculeFile(test::dataFile("1bna.pdb")).statesSecondaryStructure);
}

TEST(SecondaryStructure, StrandsOfPredictedModelsStandInStructConf) {
    const std::string text =
        "data_x\nloop_\n_struct_conf.conf_type_id\n_struct_conf.beg_auth_asym_id\n_struct_conf.beg_auth_seq_id\n"
        "_struct_conf.end_auth_asym_id\n_struct_conf.end_auth_seq_id\nSTRN A 1 A 1\nHELX_RH_AL_P A 2 A 2\nBEND A 3 A "
        "3\n"
        "loop_\n_atom_site.type_symbol\n_atom_site.auth_asym_id\n_atom_site.auth_seq_id\n_atom_site.auth_comp_id\n"
        "_atom_site.label_entity_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
        "C A 1 ALA 7 0 0 0\nC A 2 ALA 7 3 0 0\nC A 3 ALA q 6 0 0\nC A 4 ALA . 9 0 0\n";
    const Molecule molecule = readMolecule("x.cif", text);
    EXPECT_EQ(fold(molecule), "EH--");
    EXPECT_EQ(molecule.entities, (std::vector<std::string>{"7", "q"}));
    EXPECT_EQ(molecule.residues[0].entity, 1u);
    EXPECT_EQ(molecule.residues[2].entity, 2u);
    EXPECT_EQ(molecule.residues[3].entity, 0u);
}

}  // namespace
}  // namespace nacre
