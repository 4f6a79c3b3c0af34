#include "engine/molecule/residue_kind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "engine/molecule/chain_summary.h"
#include "engine/molecule/read.h"
#include "engine/molecule/residue_facts.h"
#include "engine/molecule/selection/selection.h"
#include "engine/molecule/text.h"
#include "tests/molecule/build_molecule.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

ResidueKind residueKind(const char* name, const char* atom = "X", const char* symbol = "C") {
    test::MoleculeText text;
    text.residue(name).atom(atom, symbol, {0, 0, 0});
    return residueKinds(text.molecule).at(0);
}

TEST(ResidueKind, ByName) {
    for (const char* name : {"ALA", "MSE", "HID", "HSP", "CYX", "SEP", "UNK", "ACE", "PYL"})
        EXPECT_EQ(residueKind(name), ResidueKind::protein) << name;
    for (const char* name : {"A", "DA", "U", "T", "DT", "PSU", "H2U"})
        EXPECT_EQ(residueKind(name), ResidueKind::nucleic) << name;
    for (const char* name : {"HOH", "WAT", "DOD", "TIP3", "SOL"})
        EXPECT_EQ(residueKind(name), ResidueKind::water) << name;
    for (const char* name : {"SO4", "PO4", "NO3"}) EXPECT_EQ(residueKind(name), ResidueKind::ion) << name;
    for (const char* name : {"HEM", "ATP", "NAG", "GOL", "", "QQQ"})
        EXPECT_EQ(residueKind(name), ResidueKind::ligand) << name;
}

TEST(ResidueKind, SingleMetalsAndHalogensAreIonsButNobleGasesAreNot) {
    EXPECT_EQ(residueKind("ZN", "ZN", "ZN"), ResidueKind::ion);
    EXPECT_EQ(residueKind("CL", "CL", "CL"), ResidueKind::ion);
    EXPECT_EQ(residueKind("XE", "XE", "XE"), ResidueKind::ligand);
    EXPECT_EQ(residueKind("", "Au", "AU"), ResidueKind::ligand);  // an atom of a cluster in a format without residues
    test::MoleculeText text;
    text.residue("CA").atom("CA", "CA", {0, 0, 0}, 'A').atom("CA", "CA", {1, 0, 0}, 'B');
    EXPECT_EQ(residueKinds(text.molecule).at(0), ResidueKind::ion);
}

TEST(ResidueKind, UnknownNamesCountAsPolymerIfTheyAreBondedIntoOne) {
    test::MoleculeText text;
    text.residue("QQQ", 1).atom("N", "N", {0, 0, 0}).atom("CA", "C", {1.5f, 0, 0}).atom("C", "C", {3, 0, 0});
    text.residue("ALA", 2).atom("N", "N", {4.3f, 0, 0});
    EXPECT_EQ(residueKinds(text.molecule).at(0), ResidueKind::ligand);
    text.molecule.bonds.push_back({2, 3, 1, BondSource::distance});
    EXPECT_EQ(residueKinds(text.molecule).at(0), ResidueKind::protein);
    test::MoleculeText other;
    other.residue("QQ2", 1).atom("C1*", "C", {0, 0, 0}).atom("C3*", "C", {1, 0, 0}).atom("O3*", "O", {2, 0, 0});
    other.residue("DA", 2).atom("P", "P", {3.6f, 0, 0});
    other.molecule.bonds.push_back({2, 3, 1, BondSource::distance});
    EXPECT_EQ(residueKinds(other.molecule).at(0), ResidueKind::nucleic);
}

TEST(ResidueKind, UnknownNamesWithinAChainNeedNoUsualAtoms) {
    test::MoleculeText text;
    text.residue("ALA", 1).atom("C", "C", {0, 0, 0});
    text.residue("QQQ", 2).atom("N1", "N", {1.3f, 0, 0}).atom("CA1", "C", {2.8f, 0, 0}).atom("C1", "C", {4.3f, 0, 0});
    text.residue("ALA", 3).atom("N", "N", {5.6f, 0, 0});
    text.molecule.bonds = {{0, 1, 1, BondSource::distance}};
    EXPECT_EQ(residueKinds(text.molecule).at(1), ResidueKind::ligand);  // bonded to one neighbour
    text.molecule.bonds.push_back({3, 4, 1, BondSource::distance});
    EXPECT_EQ(residueKinds(text.molecule).at(1), ResidueKind::protein);
}

TEST(ResidueKind, EntitiesComeFirst) {
    constexpr const char* kHead =
        "data_x\nloop_\n_entity.id\n_entity.type\n1 polymer\n2 non-polymer\n3 water\n4 polymer\n"
        "loop_\n_entity_poly.entity_id\n_entity_poly.type\n1 'polypeptide(L)'\n4 polydeoxyribonucleotide\n"
        "loop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n"
        "_atom_site.label_asym_id\n_atom_site.label_entity_id\n_atom_site.auth_seq_id\n_atom_site.Cartn_x\n"
        "_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
    const auto row = [](const char* atom, const char* residue, int entity, int number) {
        return std::string("HETATM C ") + atom + " " + residue + " A " + std::to_string(entity) + " " +
               std::to_string(number) + " " + std::to_string(9 * number) + " 0 0\n";
    };
    const std::string text = kHead + row("CA", "QQQ", 1, 1) + row("CA", "ALA", 2, 2) + row("CA", "DAR", 2, 3) +
                             row("O", "OXY", 3, 4) + row("P", "QQ2", 4, 5) + row("S", "SO4", 2, 6);
    const Molecule molecule = readMolecule("x.cif", text);
    using enum ResidueKind;
    EXPECT_EQ(residueKinds(molecule), (std::vector<ResidueKind>{protein, ligand, ligand, water, nucleic, ion}));
    std::string silent = text;
    silent.replace(silent.find("_entity.type"), 12, "_entity.kind");
    silent.replace(silent.find("_entity_poly.type"), 17, "_entity_poly.kind");
    EXPECT_EQ(residueKinds(readMolecule("x.cif", silent)),
              (std::vector<ResidueKind>{ligand, protein, protein, ligand, ligand, ion}));
}

TEST(ResidueKind, PeptideLikeInhibitorsAreOneLigand) {
    const auto line = [](const char* record, const char* atom, const char* residue, int number, double x) {
        return formatted("%-6s%5d  %-3s %3s A%4d    %8.3f%8.3f%8.3f  1.00  0.00           %c\n", record, number, atom,
                         residue, number, x, 0.0, 0.0, atom[0]);
    };
    const auto backbone = [&](const char* record, const char* residue, int number, double x) {
        return line(record, "N", residue, number, x) + line(record, "CA", residue, number, x + 1.45) +
               line(record, "C", residue, number, x + 2.95);
    };
    // A chain with a modified residue in it; an inhibitor beside it, of D-arginine and what no table of amino acids
    // has; and a free glycine.
    const std::string text = backbone("ATOM", "ALA", 1, 0) + backbone("HETATM", "MSE", 2, 4.3) +
                             backbone("ATOM", "ALA", 3, 8.6) + backbone("HETATM", "DAR", 4, 20) +
                             line("HETATM", "C1", "2EP", 5, 24.4) + line("HETATM", "C2", "2EP", 5, 25.9) +
                             backbone("HETATM", "GLY", 6, 40);
    const Molecule molecule = readMolecule("x.pdb", text);
    using enum ResidueKind;
    EXPECT_EQ(residueKinds(molecule), (std::vector<ResidueKind>{protein, protein, protein, ligand, ligand, ligand}));
    // Alpha carbons alone have no bonds that could tell.
    const std::string carbons = line("ATOM", "CA", "ALA", 1, 0) + line("HETATM", "CA", "MSE", 2, 3.8);
    EXPECT_EQ(residueKinds(readMolecule("x.pdb", carbons)), (std::vector<ResidueKind>{protein, protein}));
}

TEST(ResidueKind, OfThrombinsInhibitor) {
    NACRE_NEEDS_DATA();
    const Molecule molecule = readMoleculeFile(test::dataFile("1a4w-thrombin.cif.gz"));
    const std::vector<bool> ligand = selectAtoms(molecule, parseSelection("ligand"));
    EXPECT_EQ(std::count(ligand.begin(), ligand.end(), true), 42);
    std::map<std::string, std::size_t> ligands;
    for (const ChainSummary& chain : summariseChains(molecule))
        for (const auto& [name, count] : chain.ligands) ligands[name] += count;
    EXPECT_EQ(ligands, (std::map<std::string, std::size_t>{{"2EP", 1}, {"ANS", 1}, {"DAR", 1}, {"KTH", 1}}));
}

TEST(ResidueFacts, AreComputedOnceAndHandedOn) {
    test::MoleculeText text;
    text.residue("SER", 1).atom("CA", "C", {0, 0, 0});
    text.residue("THR", 1).atom("CA", "C", {1, 0, 0});
    text.residue("GLY", 2).atom("CA", "C", {5, 0, 0});
    const ResidueFacts facts(text.molecule), copy = facts;
    EXPECT_EQ(&copy.kinds(), &facts.kinds());
    EXPECT_EQ(&copy.folds(), &facts.folds());
    EXPECT_EQ(&copy.conformer(), &facts.conformer());
    EXPECT_EQ(facts.positions(), (std::vector<std::uint32_t>{0, 0, 2}));
    const Molecule other = text.molecule;
    EXPECT_EQ(&facts.moved(other).molecule(), &other);
    EXPECT_EQ(&facts.moved(other).folds(), &facts.folds());
    EXPECT_NE(&ResidueFacts(other).kinds(), &facts.kinds());
}

TEST(ResidueKind, LettersOfAminoAcids) {
    EXPECT_EQ(aminoAcidLetter(Name("TRP")), 'W');
    EXPECT_EQ(aminoAcidLetter(Name("MSE")), 'M');
    EXPECT_EQ(aminoAcidLetter(Name("HIE")), 'H');
    for (const char* name : {"UNK", "DA", "HEM", "", "HOH"}) EXPECT_EQ(aminoAcidLetter(Name(name)), '\0') << name;
}

TEST(ResidueKind, BackboneByName) {
    EXPECT_TRUE(isBackbone(ResidueKind::protein, Name("OXT")));
    EXPECT_FALSE(isBackbone(ResidueKind::protein, Name("CB")));
    EXPECT_TRUE(isBackbone(ResidueKind::nucleic, Name("O1P")));
    EXPECT_TRUE(isBackbone(ResidueKind::nucleic, Name("C2'")));
    EXPECT_FALSE(isBackbone(ResidueKind::nucleic, Name("N9")));
    EXPECT_FALSE(isBackbone(ResidueKind::ligand, Name("CA")));
}

}  // namespace
}  // namespace nacre
