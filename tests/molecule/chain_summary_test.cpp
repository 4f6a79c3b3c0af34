#include "engine/molecule/chain_summary.h"

#include <gtest/gtest.h>

#include "engine/molecule/read.h"
#include "engine/molecule/text.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

/// One atom line for each "chain residue number atom".
std::string line(char chain, const char* residue, int number, const char* atom, bool hetero = false,
                 char alternate = ' ', double along = 0) {
    return formatted("%-6s%5d %-4s%c%3s %c%4d    %8.3f%8.3f%8.3f  1.00  0.00\n", hetero ? "HETATM" : "ATOM", 1, atom,
                     alternate, residue, chain, number, number * 3.0 + along, 0.0, 0.0);
}

TEST(ChainSummary, SequenceLigandsIonsAndWater) {
    const std::string text =
        line('A', "ALA", 1, " CA ") + line('A', "MSE", 2, " CA ", true) + line('A', "HIE", 3, " CA ") +
        line('A', "SER", 4, " CA ", false, 'A') + line('A', "THR", 4, " CA ", false, 'B') +
        line('A', "UNX", 5, " N  ") + line('A', "UNX", 5, " CA ", false, ' ', 1) +
        line('A', "UNX", 5, " C  ", false, ' ', 1.8) + line('A', "GLY", 6, " N  ") + line('A', " ZN", 9, "ZN  ", true) +
        line('A', "XYL", 10, " C1 ", true) + line('A', "XYL", 10, " C2 ", true) + line('B', " DA", 1, " P  ") +
        line('B', "  U", 2, " P  ") + line('B', "HOH", 3, " O  ", true) + line('B', "HOH", 4, " O  ", true);
    const auto chains = summariseChains(readMolecule("a.pdb", text));
    ASSERT_EQ(chains.size(), 2u);
    EXPECT_EQ(chains[0].sequence, "AMHSXG");  // a modified residue as its parent, an alternating one once
    EXPECT_EQ(chains[0].aminoAcids, 6u);
    EXPECT_EQ(chains[0].ions, (std::map<std::string, std::size_t>{{"ZN", 1}}));
    EXPECT_EQ(chains[0].ligands, (std::map<std::string, std::size_t>{{"XYL", 1}}));
    EXPECT_EQ(chains[1].sequence, "AU");
    EXPECT_EQ(chains[1].nucleotides, 2u);
    EXPECT_EQ(chains[1].waters, 2u);
}

TEST(Resolution, AsEachFormatStatesIt) {
    const std::string atom = line('A', "ALA", 1, " CA ");
    const auto ofPdb = [&](const char* text) {
        return readMolecule("a.pdb", "REMARK   2\nREMARK   2 RESOLUTION. " + std::string(text) + "\n" + atom)
            .file.resolution;
    };
    EXPECT_EQ(ofPdb("   1.90 ANGSTROMS."), 1.9);
    EXPECT_EQ(ofPdb("1.90 ANGSTROMS."), 1.9);  // before 2007
    EXPECT_EQ(ofPdb("NOT APPLICABLE."), std::nullopt);
    const auto ofCif = [](const std::string& items) {
        return readMolecule("a.cif",
                            "data_x\n" + items + "_atom_site.Cartn_x 1\n_atom_site.Cartn_y 2\n_atom_site.Cartn_z 3\n")
            .file.resolution;
    };
    EXPECT_EQ(ofCif("_refine.ls_d_res_high 2.05\n"), 2.05);
    EXPECT_EQ(ofCif("_refine.ls_d_res_high .\n_em_3d_reconstruction.resolution 3.4\n"), 3.4);
    EXPECT_EQ(ofCif("_refine.ls_d_res_high ?\n"), std::nullopt);
    EXPECT_EQ(ofCif(""), std::nullopt);
}

TEST(Resolution, OfTheArchivesFiles) {
    NACRE_NEEDS_DATA();
    EXPECT_EQ(readMoleculeFile(test::dataFile("1bna-old-remediation.pdb")).file.resolution, 1.9);
    EXPECT_EQ(readMoleculeFile(test::dataFile("1crn.cif")).file.resolution, 1.5);
    EXPECT_EQ(readMoleculeFile(test::dataFile("gfp-1ema.cif")).file.resolution, 1.9);
    EXPECT_EQ(readMoleculeFile(test::dataFile("1l2y.pdb")).file.resolution, std::nullopt);  // by NMR
}

}  // namespace
}  // namespace nacre
