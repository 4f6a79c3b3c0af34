// What files say of themselves: title, organism, method, and what they call chains and ligands.

#include <gtest/gtest.h>

#include "engine/molecule/formats/plain_names.h"
#include "engine/molecule/read.h"
#include "engine/molecule/text.h"
#include "tests/molecule/text_file.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

using Names = std::map<std::string, std::string>;

TEST(PlainNames, CapitalsBecomeSmall) {
    EXPECT_EQ(plainCase("X-RAY DIFFRACTION", true), "X-ray diffraction");
    EXPECT_EQ(plainCase("SOLUTION NMR", true), "Solution NMR");
    EXPECT_EQ(plainCase("HIV-1 PROTEASE", true), "HIV-1 protease");
    EXPECT_EQ(plainCase("HUMAN IMMUNODEFICIENCY VIRUS 1", true), "Human immunodeficiency virus 1");
    EXPECT_EQ(plainCase("Homo sapiens", true), "Homo sapiens");
    EXPECT_EQ(plainComponentName("N-ACETYL-D-GLUCOSAMINE", ""), "N-acetyl-D-glucosamine");
    EXPECT_EQ(plainComponentName("PROTOPORPHYRIN IX CONTAINING FE", "HEME"), "heme");
    EXPECT_EQ(plainComponentName("{3-[(4-AMINO-BENZENESULFONYL)-ISOBUTYL-AMINO]}", "VX-478; AMPRENAVIR"), "amprenavir");
    EXPECT_EQ(plainComponentName("GLYCEROL", "GLYCERIN; PROPANE-1,2,3-TRIOL"), "glycerol");
    EXPECT_EQ(plainComponentName("SULFATE ION", "?"), "sulfate ion");
}

TEST(Names, OfPdbHeaders) {
    const std::string text =
        "HEADER    HYDROLASE/HYDROLASE INHIBITOR           18-NOV-94   1HPV\n"
        "TITLE     CRYSTAL STRUCTURE\n"
        "COMPND    MOL_ID: 1;\n"
        "COMPND   2 MOLECULE: HIV-1 PROTEASE;\n"
        "COMPND   3 CHAIN: A, B;\n"
        "COMPND   4 MOL_ID: 2; MOLECULE: DNA (5'-D(*CP*G)-3'); CHAIN: C\n"
        "SOURCE    MOL_ID: 1;\n"
        "SOURCE   2 ORGANISM_SCIENTIFIC: HUMAN IMMUNODEFICIENCY\n"
        "SOURCE   3 VIRUS 1;\n"
        "EXPDTA    X-RAY DIFFRACTION\n"
        "HETNAM     478 {3-[(4-AMINO-BENZENESULFONYL)-ISOBUTYL-AMINO]-1-\n"
        "HETNAM   2 478  BENZYL}-CARBAMIC ACID\n"
        "HETSYN     478 VX-478; AMPRENAVIR\n"
        "ATOM      1  CA  PRO A   1       0.000   0.000   0.000  1.00  0.00           C\n";
    const FileSummary file = readMolecule("1hpv.pdb", text).file;
    EXPECT_EQ(file.organism, "Human immunodeficiency virus 1");
    EXPECT_EQ(file.method, "X-ray diffraction");
    EXPECT_EQ(file.componentNames, (Names{{"478", "amprenavir"}}));
    EXPECT_EQ(file.chainNames.at("A"), "HIV-1 protease");
    EXPECT_EQ(file.chainNames.at("B"), "HIV-1 protease");
    EXPECT_EQ(file.chainNames.at("C").substr(0, 3), "DNA");
}

TEST(Names, OldPdbFilesHaveOneTextForTheirTitle) {
    const FileSummary file = readMolecule("1hpv.pdb", test::readText(test::dataFile("1hpv.pdb"))).file;
    EXPECT_EQ(file.title.substr(0, 60), "HIV-1 PROTEASE (E.C.3.4.23.-) COMPLEXED WITH VX-478 (3(S)-N-");
    EXPECT_TRUE(file.chainNames.empty());
}

TEST(Names, OfMmcif) {
    const std::string text =
        "data_x\n_exptl.method 'ELECTRON MICROSCOPY'\n"
        "_entity_src_gen.entity_id 1\n_entity_src_gen.pdbx_gene_src_scientific_name 'Homo sapiens'\n"
        "loop_\n_entity.id\n_entity.type\n_entity.pdbx_description\n1 polymer Hemoglobin\n2 non-polymer x\n"
        "loop_\n_entity_poly.entity_id\n_entity_poly.type\n1 'polypeptide(L)'\n"
        "loop_\n_chem_comp.id\n_chem_comp.mon_nstd_flag\n_chem_comp.name\n_chem_comp.pdbx_synonyms\n"
        "GLY y GLYCINE ?\nHEM . 'PROTOPORPHYRIN IX CONTAINING FE' HEME\n"
        "loop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
        "_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.label_entity_id\n_atom_site.label_seq_id\n"
        "_atom_site.auth_asym_id\n_atom_site.auth_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
        "_atom_site.Cartn_z\n"
        "ATOM 1 C CA GLY A 1 1 X 1 0 0 0\nHETATM 2 FE FE HEM B 2 . X 2 5 0 0\n";
    const FileSummary file = readMolecule("a.cif", text).file;
    EXPECT_EQ(file.method, "Electron microscopy");
    EXPECT_EQ(file.organism, "Homo sapiens");
    EXPECT_EQ(file.chainNames, (Names{{"X", "Hemoglobin"}}));
    EXPECT_EQ(file.componentNames, (Names{{"HEM", "heme"}}));
}

TEST(Names, AreBounded) {
    std::string text;
    for (int i = 0; i < 5000; ++i) {
        text += formatted("HETNAM     %03X A NAME\n", i % 4096);
    }
    text += "ATOM      1  CA  PRO A   1       0.000   0.000   0.000  1.00  0.00           C\n";
    EXPECT_EQ(readMolecule("a.pdb", text).file.componentNames.size(), kMostNames);
}

}  // namespace
}  // namespace nacre
