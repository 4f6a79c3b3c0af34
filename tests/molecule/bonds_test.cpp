#include "engine/molecule/bonds/bonds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "engine/molecule/formats/format_table.h"
#include "tests/molecule/build_molecule.h"
#include "tests/molecule/text_file.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

using test::MoleculeText;

/// "0-1 2=3": every bond, in order.
std::string listBonds(Molecule molecule) {
    perceiveBonds(molecule);
    std::string text;
    for (const Bond& bond : molecule.bonds) {
        if (!text.empty()) text += ' ';
        text += std::to_string(bond.a) + "-=#:"[bond.order - 1] + std::to_string(bond.b);
    }
    return text;
}

std::string pairAt(std::string_view first, std::string_view second, float distance) {
    MoleculeText text;
    text.residue("LIG").atom("A", first, {0, 0, 0}).atom("B", second, {distance, 0, 0});
    return listBonds(text.molecule);
}

TEST(DistanceBonds, LieBetweenTheTwoLimits) {
    EXPECT_EQ(pairAt("C", "C", 1.90f), "0-1");  // 2 * 0.73 + 0.45 = 1.91
    EXPECT_EQ(pairAt("C", "C", 1.92f), "");
    EXPECT_EQ(pairAt("C", "C", 1.04f), "0-1");  // 0.7 * 2 * 0.73 = 1.02
    EXPECT_EQ(pairAt("C", "C", 1.00f), "");
    EXPECT_EQ(pairAt("O", "H", 0.60f), "0-1");  // 0.6 * (0.66 + 0.31) = 0.58
    EXPECT_EQ(pairAt("O", "H", 0.56f), "");
    EXPECT_EQ(pairAt("S", "S", 2.54f), "0-1");  // 2 * 1.05 + 0.45 = 2.55
    EXPECT_EQ(pairAt("S", "S", 2.56f), "");
}

TEST(DistanceBonds, NeverJoinHydrogensOrNobleGases) {
    EXPECT_EQ(pairAt("H", "H", 0.74f), "");
    EXPECT_EQ(pairAt("D", "H", 0.74f), "");
    EXPECT_EQ(pairAt("Ne", "C", 1.4f), "");
    EXPECT_EQ(pairAt("H", "C", 1.09f), "0-1");
}

TEST(DistanceBonds, HydrogenKeepsItsNearestNeighbour) {
    MoleculeText text;
    text.residue("LIG").atom("O1", "O", {0, 0, 0}).atom("H", "H", {1.0f, 0, 0}).atom("O2", "O", {2.3f, 0, 0});
    EXPECT_EQ(listBonds(text.molecule), "0-1");
}

TEST(DistanceBonds, HydrogenSharedByTwoConformersBondsInBoth) {
    MoleculeText text;
    text.residue("LIG").atom("O", "O", {0, 0, 0}, 'A').atom("O", "O", {0.1f, 0, 0}, 'B').atom("H", "H", {1, 0, 0});
    EXPECT_EQ(listBonds(text.molecule), "0-2 1-2");
}

TEST(DistanceBonds, AlternateLocationsExcludeEachOther) {
    MoleculeText text;
    text.residue("LIG").atom("C1", "C", {0, 0, 0});
    text.atom("C2", "C", {1.5f, 0, 0}, 'A').atom("C2", "C", {1.2f, 0.9f, 0}, 'B');
    EXPECT_EQ(listBonds(text.molecule), "0-1 0-2");
}

TEST(DistanceBonds, WatersBondOnlyInside) {
    MoleculeText text;
    text.residue("HOH", 1).atom("O", "O", {0, 0, 0}).atom("H1", "H", {0.96f, 0, 0});
    text.residue("HOH", 2).atom("O", "O", {0, 1.3f, 0}).atom("H1", "H", {0.96f, 1.3f, 0});
    text.residue("LIG", 3).atom("C", "C", {0, -1.4f, 0});
    EXPECT_EQ(listBonds(text.molecule), "0-1 2-3");
}

TEST(DistanceBonds, MetalsBondOnlyInsideTheirResidue) {
    MoleculeText haem;
    haem.residue("HEM", 1).atom("FE", "Fe", {0, 0, 0}).atom("NA", "N", {2.0f, 0, 0});
    haem.residue("HIS", 2).atom("NE2", "N", {0, 0, 2.1f});
    EXPECT_EQ(listBonds(haem.molecule), "0-1");
    MoleculeText ions;
    ions.residue("ZN", 1).atom("ZN", "Zn", {0, 0, 0});
    ions.residue("CYS", 2).atom("SG", "S", {2.3f, 0, 0});
    ions.residue("CL", 3).atom("CL", "Cl", {2.3f, 2.0f, 0});
    EXPECT_EQ(listBonds(ions.molecule), "");
}

TEST(StatedBonds, AreKeptWhateverTheirLength) {
    MoleculeText text;
    text.residue("ZN", 1).atom("ZN", "Zn", {0, 0, 0});
    text.residue("CYS", 2).atom("SG", "S", {2.3f, 0, 0});
    text.molecule.bonds = {{1, 0, 1, BondSource::file},
                           {0, 1, 1, BondSource::file},
                           {0, 0, 1, BondSource::file},
                           {0, 9, 1, BondSource::file}};
    EXPECT_EQ(listBonds(text.molecule), "0-1");  // sorted, once, without itself and without what is not there
}

TEST(StatedBonds, OfAWholeResidueLeaveNothingToDistance) {
    MoleculeText text;
    text.residue("LIG").atom("C1", "C", {0, 0, 0}).atom("C2", "C", {1.5f, 0, 0}).atom("C3", "C", {0.75f, 1.3f, 0});
    text.residue("LIG", 2).atom("C", "C", {0, -1.5f, 0}).atom("C2", "C", {0, -3.0f, 0});
    text.molecule.bonds = {{0, 1, 1, BondSource::file}, {1, 2, 2, BondSource::file}};
    EXPECT_EQ(listBonds(text.molecule), "0-1 1=2 3-4");
    text.molecule.bonds.pop_back();  // one of three atoms unstated: the file did not mean to state all
    EXPECT_EQ(listBonds(text.molecule), "0-1 0-2 0-3 1-2 3-4");
}

TEST(StatedBonds, LinksLeaveTheRestToTheRules) {
    MoleculeText text;
    text.residue("CYS", 1).atom("CB", "C", {0, 0, 0}).atom("SG", "S", {1.8f, 0, 0});
    text.residue("CYS", 9).atom("SG", "S", {1.8f, 2.05f, 0}).atom("CB", "C", {0, 2.05f, 0});
    EXPECT_EQ(listBonds(text.molecule), "0-1 1-2 2-3");  // the disulphide by distance
    text.molecule.bonds = {{1, 2, 1, BondSource::file}};
    EXPECT_EQ(listBonds(text.molecule), "0-1 1-2 2-3");
}

TEST(StatedBonds, OfABondTableAreTheWholeTruth) {
    MoleculeText text;
    text.residue("").atom("C", "C", {0, 0, 0}).atom("C", "C", {1, 0, 0}).atom("C", "C", {2, 0, 0});
    text.molecule.bonds = {{0, 1, 1, BondSource::file}};
    text.molecule.file.bonds = 1;
    EXPECT_EQ(listBonds(text.molecule), "0-1");
}

TEST(TemplateBonds, KnowOrdersAndIgnoreContacts) {
    MoleculeText text;  // N CA C O of glycine, with O pressed against N
    text.residue("GLY").atom("N", "N", {0, 1.4f, 0}).atom("CA", "C", {0, 0, 0}).atom("C", "C", {1.5f, 0, 0});
    text.atom("O", "O", {1.2f, 1.2f, 0}).atom("HA2", "H", {-0.6f, -0.9f, 0});
    EXPECT_EQ(listBonds(text.molecule), "0-1 1-2 1-4 2=3");
    text.molecule.residues[0].name = Name("XXX");  // without a template the contacts count
    EXPECT_EQ(listBonds(text.molecule), "0-1 0-3 1-2 1-3 1-4 2-3");
}

TEST(TemplateBonds, OrderComesToStatedBonds) {
    MoleculeText text;
    text.residue("GLY").atom("C", "C", {0, 0, 0}).atom("O", "O", {1.23f, 0, 0});
    text.molecule.bonds = {{0, 1, 1, BondSource::file}};
    EXPECT_EQ(listBonds(text.molecule), "0=1");
}

TEST(TemplateBonds, LinkNeighboursThatAreNear) {
    const auto dipeptide = [](float gap) {
        MoleculeText text;
        text.residue("GLY", 1).atom("C", "C", {0, 0, 0}).residue("ALA", 2).atom("N", "N", {gap, 0, 0});
        return text.molecule;
    };
    Molecule linked = dipeptide(1.33f);
    perceiveBonds(linked);
    ASSERT_EQ(linked.bonds.size(), 1u);
    EXPECT_EQ(linked.bonds[0].source, BondSource::residueTemplate);
    EXPECT_EQ(listBonds(dipeptide(3.8f)), "");
}

TEST(TemplateBonds, LinkWithPoorGeometryMakesNoRingOfThree) {
    MoleculeText text;
    text.residue("GLY", 1).atom("C", "C", {0, 0, 0});
    text.residue("ALA", 2).atom("N", "N", {1.0f, 0, 0}).atom("CA", "C", {1.2f, 1.3f, 0});
    EXPECT_EQ(listBonds(text.molecule), "0-1 1-2");
}

TEST(TemplateBonds, RepeatedNamesAreLeftToDistance) {
    MoleculeText text;
    text.residue("ALA").atom("CA", "C", {0, 0, 0}).atom("CB", "C", {1.5f, 0, 0}).atom("CA", "C", {3.0f, 0, 0});
    EXPECT_EQ(listBonds(text.molecule), "0-1 1-2");
}

// ---- hostile geometry -------------------------------------------------------------------------------------------

Molecule manyAtoms(std::size_t count, float spacing) {
    MoleculeText text;
    text.residue("LIG");
    for (std::size_t i = 0; i < count; ++i) {
        const auto [x, y, z] = std::tuple{i % 50, i / 50 % 50, i / 2500};
        text.atom("C", "C", glm::vec3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)) * spacing);
    }
    return text.molecule;
}

TEST(HostileGeometry, EndsWithoutBondsAndWithAWarning) {
    for (const float spacing : {0.0f, 0.05f, 0.2f}) {
        Molecule molecule = manyAtoms(200000, spacing);
        perceiveBonds(molecule);
        EXPECT_LE(molecule.bonds.size(), 16u * molecule.atoms.size() / 2) << spacing;
        EXPECT_FALSE(molecule.warnings.empty()) << spacing;
        EXPECT_LE(molecule.warnings.size(), 2u);
    }
    Molecule lattice = manyAtoms(2500, 1.5f);
    perceiveBonds(lattice);
    EXPECT_EQ(lattice.bonds.size(), 2u * 50 * 49);  // a simple square lattice: 49 bonds a row
    EXPECT_TRUE(lattice.warnings.empty());
}

TEST(HostileGeometry, FarApartCostsNothing) {
    for (const float far : {1e5f, 1e20f, 3e38f}) {
        MoleculeText text;
        text.residue("LIG").atom("C", "C", {-far, far, 0}).atom("C", "C", {0, 0, 0}).atom("C", "C", {1.5f, 0, 0});
        text.atom("C", "C", {far, far, far});
        EXPECT_EQ(listBonds(text.molecule), "1-2") << far;
    }
}

// ---- real files -------------------------------------------------------------------------------------------------

Molecule bondedFile(const std::string& file) {
    Molecule molecule = formatRow(Format::pdb).read(file, test::readText(test::dataFile(file)), {});
    perceiveBonds(molecule);
    return molecule;
}

TEST(BondsOfFiles, HaveTheNumbersThatCountingGives) {
    NACRE_NEEDS_DATA();
    // Crambin by its sequence (TTCCPSIVARSNFNVCRLPGTPEAICATYTGCIIIPGATCPGDYAN): a tree has one bond fewer than
    // atoms, 327 - 1; each ring adds one: 5 proline, 1 phenylalanine, 2 tyrosine, and 3 disulphides close three more.
    EXPECT_EQ(bondedFile("1crn.pdb").bonds.size(), 326u + 5 + 1 + 2 + 3);
    // 1BNA: two strands, 486 - 2; a ring per sugar (24), one per pyrimidine (12), two per purine (12).
    EXPECT_EQ(bondedFile("1bna.pdb").bonds.size(), 484u + 24 + 12 + 24);
    // Caffeine: 24 atoms and two rings; every one stated, none added.
    const Molecule caffeine = bondedFile("small/caffeine.pdb");
    EXPECT_EQ(caffeine.bonds.size(), 25u);
    EXPECT_TRUE(std::all_of(caffeine.bonds.begin(), caffeine.bonds.end(),
                            [](const Bond& bond) { return bond.source == BondSource::file; }));
    EXPECT_EQ(bondedFile("neon-pump.pdb").bonds.size(), 8870u);
    EXPECT_EQ(bondedFile("small/theoretical-bearing.pdb").bonds.size(), 278u);
}

TEST(BondsOfFiles, AgreeForOldAndNewNames) {
    NACRE_NEEDS_DATA();
    EXPECT_EQ(bondedFile("1bna-old-remediation.pdb").bonds.size(), bondedFile("1bna.pdb").bonds.size());
}

TEST(BondsOfFiles, GiveHydrogensOneBondAndCarbonsFour) {
    NACRE_NEEDS_DATA();
    for (const char* file : {"1l2y.pdb", "3j6r-hpv16.pdb.gz", "1igy.pdb.gz", "4hhb.pdb", "1aon-groel.pdb.gz"}) {
        const Molecule molecule = bondedFile(file);
        std::vector<int> valence(molecule.atoms.size());
        std::vector<int> neighbours(molecule.atoms.size());
        for (const Bond& bond : molecule.bonds) {
            valence[bond.a] += bond.order;
            valence[bond.b] += bond.order;
            ++neighbours[bond.a];
            ++neighbours[bond.b];
        }
        for (std::size_t i = 0; i < valence.size(); ++i) {
            const Atom& atom = molecule.atoms[i];
            if (isHydrogen(atom.element)) {
                EXPECT_EQ(neighbours[i], 1) << file << " " << i;
            }
            if (atom.element == 6 && atom.alternate == 0) {
                EXPECT_LE(valence[i], 4) << file << " " << i;
            }
        }
    }
}

}  // namespace
}  // namespace nacre
