// Traits of files that people reported to other viewers, and what is right. `reports/README.md` of the data folder has
// their sources.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "engine/molecule/chemistry/drawn_orders.h"
#include "engine/molecule/crystal.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/element.h"
#include "engine/molecule/kabsch_sander.h"
#include "engine/molecule/residue_kind.h"
#include "engine/molecule/selection/selection.h"
#include "engine/molecule/text.h"
#include "tests/molecule/expect_error.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

Molecule report(const char* file, int model = 1) {
    return readMoleculeFile(test::dataFile(std::string("reports/") + file), {.model = model});
}

/// Symbols of all atoms: "Na K ?".
std::string symbols(const Molecule& molecule) {
    std::string text;
    for (const Atom& atom : molecule.atoms)
        text += (text.empty() ? "" : " ") + std::string(atom.element == 0 ? "?" : elementSymbol(atom.element));
    return text;
}

/// Bonds as numbers of atoms from 1: "1-2 2-3".
std::string listBonds(const Molecule& molecule) {
    std::string text;
    for (const Bond& bond : molecule.bonds)
        text += (text.empty() ? "" : " ") + std::to_string(bond.a + 1) + "-" + std::to_string(bond.b + 1);
    return text;
}

std::int64_t countNotes(const Molecule& molecule, ReadAction action, std::string_view what) {
    std::int64_t count = 0;
    for (const ReadNote& note : listReadNotes(molecule, drawnOrders(molecule)))
        count += note.action == action && note.what == what ? note.count : 0;
    return count;
}

bool warns(const Molecule& molecule, std::string_view part) {
    return std::any_of(molecule.warnings.begin(), molecule.warnings.end(),
                       [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
}

std::size_t selected(const Molecule& molecule, const char* selection) {
    const std::vector<bool> atoms = selectAtoms(molecule, parseSelection(selection));
    return static_cast<std::size_t>(std::count(atoms.begin(), atoms.end(), true));
}

class Reports : public testing::Test {
protected:
    void SetUp() override { NACRE_NEEDS_DATA(); }
};

TEST_F(Reports, BondsOfOneModelAreNotAppliedToOtherAtoms) {
    EXPECT_EQ(listBonds(report("r03_models_conect.pdb", 1)), "1-2 2-3");
    EXPECT_EQ(listBonds(report("r03_models_conect.pdb", 2)), "1-4 2-3");  // by distance: 1.4 and 1.2 Å
    const Molecule joined = readMoleculeFile(test::dataFile("reports/r03_models_conect.pdb"), {.model = kAllModels});
    for (const Bond& bond : joined.bonds)
        EXPECT_LT(glm::distance(joined.atoms[bond.a].position, joined.atoms[bond.b].position), 2);
}

TEST_F(Reports, ExhaustiveConectRules) {
    const Molecule genome = report("r04_genome.pdb");
    EXPECT_EQ(genome.bonds.size(), 39u);
    EXPECT_EQ(countNotes(genome, ReadAction::guessed, "bonds"), 0);
}

TEST_F(Reports, NamesInSmallLettersTellElements) {
    EXPECT_EQ(symbols(report("r09b_mixed_case.pdb")), "C Cl Br Na Si Fe Zn Se Ca C");
}

TEST_F(Reports, IonsOfSimulationPrograms) {
    const Molecule ions = report("r12b_ions.pdb");
    EXPECT_EQ(symbols(ions), "Na Na K Cs Cl Ca Li Rb Ba Cd Zn Na Na Cl Cl K K Na Cl O Mg Fe Na");
    EXPECT_EQ(selected(ions, "ion"), 22u);
}

TEST_F(Reports, CoordinatesWiderThanTheirColumns) {
    const Molecule wild = report("r10_wild.pdb");
    ASSERT_EQ(wild.atoms.size(), 3u);
    EXPECT_NEAR(wild.atoms[0].position.x, 31256.965, 2e-3);
    EXPECT_NEAR(wild.atoms[0].position.y, 32685.064, 2e-3);
    EXPECT_NEAR(wild.atoms[0].position.z, 60403.930, 4e-3);
    EXPECT_FLOAT_EQ(wild.atoms[0].occupancy, 1);
    EXPECT_FLOAT_EQ(wild.atoms[0].temperatureFactor, 999.99f);
    EXPECT_EQ(wild.residues[0].number, 11);
}

TEST_F(Reports, ShiftedColumns) {
    const Molecule shifted = report("r24_gmx_shift.pdb");
    ASSERT_EQ(shifted.atoms.size(), 6u);
    EXPECT_EQ(shifted.atoms[3].position, glm::vec3(14.195f, 58.650f, 112.800f));
    EXPECT_EQ(shifted.residues.back().number, 10000);
    EXPECT_EQ(listBonds(shifted), "1-2 1-3 4-5 4-6");
    EXPECT_FLOAT_EQ(shifted.atoms[3].occupancy, 1);
    EXPECT_EQ(symbols(shifted), "O H H O H H");
}

TEST_F(Reports, SeveralDataBlocksAreModels) {
    const Molecule first = report("r14_pymol_multi.cif");
    EXPECT_EQ(first.atoms.size(), 12u);
    EXPECT_EQ(first.file.models, 2);
    EXPECT_EQ(first.file.totalAtomsAllModels, 24);
    EXPECT_TRUE(warns(first, "2 data blocks")) << "said";
    const Molecule second = report("r14_pymol_multi.cif", 2);
    EXPECT_EQ(second.atoms.size(), 12u);
    EXPECT_NE(second.atoms[0].position, first.atoms[0].position);
    EXPECT_EQ(report("r14_pymol_multi.cif", kAllModels).atoms.size(), 24u);
    EXPECT_THROW(report("r14_pymol_multi.cif", 3), Error);
}

TEST_F(Reports, ElementsThatShareASite) {
    const Molecule mixed = report("r34_substitution.cif");
    EXPECT_EQ(mixed.atoms.size(), 7u);
    EXPECT_TRUE(warns(mixed, "sites that several elements share: 3"));
    std::string drawn;
    for (const std::uint32_t atom : drawnAtoms(mixed)) drawn += std::string(mixed.atoms[atom].name.view()) + " ";
    EXPECT_EQ(drawn, "Sr Fe O1 O2 ");
    for (const Bond& bond : mixed.bonds) {
        const char a = mixed.atoms[bond.a].alternate, b = mixed.atoms[bond.b].alternate;
        EXPECT_TRUE(a == '\0' || b == '\0' || a == b);
    }
    // Four sites each of Sr with La and of O1 with F1, on mirrors; four of Fe, on centres; eight of O2 with F2.
    ASSERT_EQ(mixed.assemblies.size(), 1u);
    std::size_t atoms = 0;
    for (const AssemblyPart& part : mixed.assemblies[0].parts)
        for (const std::uint32_t subchain : part.subchains)
            for (const Residue& residue : mixed.residues)
                if (residue.subchain == subchain) atoms += residue.atomCount * part.transforms.size();
    EXPECT_EQ(atoms, 36u);
}

TEST_F(Reports, DisorderMarkedByQuestionMarks) {
    const Molecule disorder = report("r35_question_marks.cif");
    EXPECT_EQ(disorder.atoms[2].name.view(), "O1");
    EXPECT_EQ(listBonds(disorder).find("3-4"), std::string::npos);
    EXPECT_EQ(disorder.atoms[2].alternate, 'A');
    EXPECT_EQ(disorder.atoms[3].alternate, 'B');
}

TEST_F(Reports, OneOddItemIsLeftOut) {
    const Molecule charged = report("r41_chg.sdf");
    EXPECT_EQ(charged.atoms[0].charge, 1);
    EXPECT_EQ(countNotes(charged, ReadAction::leftOut, "charges"), 1);
    EXPECT_TRUE(warns(charged, "left out 1 charge, line 8"));

    const Molecule unplaced = report("r44_no_coordinates.cif");
    EXPECT_EQ(unplaced.atoms.size(), 2u);
    EXPECT_EQ(countNotes(unplaced, ReadAction::leftOut, "atoms"), 1);
    EXPECT_TRUE(warns(unplaced, "left out 1 atom, line 16"));
}

TEST_F(Reports, MeekosTypes) {
    for (int model = 1; model <= 2; ++model) {
        const Molecule docked = report("r42_glue.pdbqt", model);
        EXPECT_EQ(symbols(docked), "C C O H N As Cl Br S B Si");
        EXPECT_EQ(countNotes(docked, ReadAction::leftOut, "atoms"), 1);
    }
}

TEST_F(Reports, SpheresOfIntegrativeModels) {
    const Molecule spheres = report("r46_ihm.cif");
    ASSERT_EQ(spheres.atoms.size(), 3u);
    EXPECT_EQ(spheres.atoms[0].position, glm::vec3(384.6f, -36.3f, 194.5f));
    EXPECT_FLOAT_EQ(vanDerWaalsRadius(spheres.atoms[0]), 5.75f);
    EXPECT_FLOAT_EQ(vanDerWaalsRadius(spheres.atoms[1]), 6.25f);
    EXPECT_FLOAT_EQ(vanDerWaalsRadius(spheres.atoms[2]), 15.25f);
    EXPECT_EQ(selected(spheres, "chain A"), 2u);
    EXPECT_TRUE(spheres.bonds.empty());
}

TEST_F(Reports, MartiniGrains) {
    const Molecule grains = report("r49_martini.pdb");
    EXPECT_EQ(symbols(grains).find_first_not_of("? Na"), std::string::npos) << symbols(grains);
    std::size_t backbone = 0, side = 0;
    for (const Bond& bond : grains.bonds) {
        const std::string_view a = grains.atoms[bond.a].name.view(), b = grains.atoms[bond.b].name.view();
        backbone += a == "BB" && b == "BB";
        side += a == "BB" && b == "SC1";
    }
    EXPECT_EQ(backbone, 11u);
    EXPECT_EQ(side, 12u);
    EXPECT_EQ(grains.bonds.size(), 23u);
    EXPECT_EQ(selected(grains, "water"), 1u);
    EXPECT_EQ(selected(grains, "ion"), 1u);
    EXPECT_EQ(selected(grains, "protein"), 24u);
    EXPECT_GT(vanDerWaalsRadius(grains.atoms[0]), 2);
    EXPECT_EQ(drawnAtoms(grains).size(), 25u) << "all but the water";
}

TEST_F(Reports, LabelsOfMinerals) { EXPECT_EQ(symbols(report("s02_amcsd_water.cif")), "Ca C O O O O O O H Ca Si"); }

TEST_F(Reports, ReversedChains) {
    const Molecule dna = report("s10_reversed_dna.pdb");
    std::size_t links = 0, residues = 0;
    for (const Bond& bond : dna.bonds) {
        const std::string_view a = dna.atoms[bond.a].name.view(), b = dna.atoms[bond.b].name.view();
        links += (a == "P" && b == "O3'") || (a == "O3'" && b == "P");
    }
    for (const ResidueKind kind : residueKinds(dna)) residues += kind == ResidueKind::nucleic;
    EXPECT_EQ(links, residues - dna.chains.size());
}

TEST_F(Reports, ChainsThatTheFileSaysNothingOfAreAssigned) {
    const Molecule one = report("s11_helix_one_chain.pdb");
    const std::vector<SecondaryStructure> folds = secondaryStructure(one);
    std::vector<std::size_t> helical(one.chains.size());
    for (std::size_t i = 0; i < folds.size(); ++i)
        helical[one.residues[i].chain] += folds[i] == SecondaryStructure::helix;
    std::size_t chains = 0;
    for (std::size_t i = 0; i < helical.size(); ++i) chains += helical[i] > 20;
    EXPECT_GE(chains, 4u) << "four chains of haemoglobin";
    for (std::size_t i = 0; i < folds.size(); ++i)
        if (one.chains[one.residues[i].chain].name == "A") {
            EXPECT_EQ(folds[i], one.residues[i].secondary);
        }
}

TEST_F(Reports, SegmentsAreChainsWhereThereIsNone) {
    const Molecule segments = report("s17_segid_only.pdb");
    ASSERT_EQ(segments.chains.size(), 2u);
    EXPECT_EQ(segments.chains[0].name, "PROA");
    EXPECT_EQ(segments.chains[1].name, "PROB");
    EXPECT_EQ(selected(segments, "segi PROA") + selected(segments, "segid PROB"), segments.atoms.size());
    EXPECT_EQ(selected(segments, "segi PROA"), selected(segments, "chain PROA"));
    EXPECT_EQ(countNotes(segments, ReadAction::read, "segments"), 2);
}

TEST_F(Reports, ConnectionsByLabelsAlone) {
    const Molecule disulfide = report("t09_conn_label_only.cif");
    EXPECT_EQ(listBonds(disulfide), "2-3");
    EXPECT_EQ(disulfide.bonds[0].source, BondSource::file);
}

TEST_F(Reports, LatticesOfExtendedXyz) {
    const Molecule salt = report("u1_lattice_salt.xyz");
    ASSERT_TRUE(salt.file.box.has_value());
    EXPECT_EQ((*salt.file.box)[1], glm::vec3(0, 5.64f, 0));
    EXPECT_EQ(symbols(salt), "Na Na Na Na Cl Cl Cl Cl");
    ASSERT_EQ(salt.assemblies.size(), 1u);
    EXPECT_EQ(salt.assemblies[0].parts[0].transforms.size(), 27u);
    EXPECT_EQ(crystalCopies(salt, {0, 0, 0}, {1, 0, 0}).size(), 2u);
    EXPECT_NEAR((*cellEdges(salt.file))[2].z, 5.64, 1e-5);
}

TEST_F(Reports, CellsOfPoscar) {
    const Molecule salt = report("r47_POSCAR");
    EXPECT_EQ(symbols(salt), "Na Na Na Na Cl Cl Cl Cl");
    EXPECT_NEAR(salt.atoms[1].position.y, 2.82, 1e-5);
    EXPECT_TRUE(salt.file.box.has_value());
}

TEST_F(Reports, BondsOfTinker) {
    const Molecule tinker = report("r31_tinker.xyz");
    EXPECT_EQ(symbols(tinker), "C C H H O");
    EXPECT_EQ(listBonds(tinker), "1-2 1-3 1-4 2-5");
}

// The same traits in other places.

TEST(OddFiles, LigandByLabelWithoutNumber) {
    const Molecule covalent = readMolecule("a.cif", R"(data_a
loop_
_atom_site.id
_atom_site.type_symbol
_atom_site.label_atom_id
_atom_site.label_comp_id
_atom_site.label_asym_id
_atom_site.label_seq_id
_atom_site.auth_seq_id
_atom_site.Cartn_x
_atom_site.Cartn_y
_atom_site.Cartn_z
_atom_site.auth_asym_id
1 S SG CYS A 7 107 0 0 0 X
2 C C1 LIG B . 301 1.8 0 0 X
loop_
_struct_conn.id
_struct_conn.conn_type_id
_struct_conn.ptnr1_label_asym_id
_struct_conn.ptnr1_label_comp_id
_struct_conn.ptnr1_label_seq_id
_struct_conn.ptnr1_label_atom_id
_struct_conn.ptnr2_label_asym_id
_struct_conn.ptnr2_label_comp_id
_struct_conn.ptnr2_label_seq_id
_struct_conn.ptnr2_label_atom_id
c1 covale A CYS 7 SG B LIG . C1
)");
    EXPECT_EQ(listBonds(covalent), "1-2");
    EXPECT_EQ(covalent.bonds[0].source, BondSource::file);
}

TEST(OddFiles, FirstLettersAsElements) {
    // As MDTraj writes ions: the first letter of the name is the element.
    const auto element = [](const char* name, const char* residue, const char* symbol) {
        return readMolecule("a.pdb", std::string("HETATM    1 ") + name + " " + residue +
                                         " A   1       1.000   2.000   3.000  1.00  0.00          " + symbol + "\n")
            .atoms[0]
            .element;
    };
    EXPECT_EQ(element(" SOD", "SOD", " S"), 11);
    EXPECT_EQ(element(" POT", "POT", " P"), 19);
    EXPECT_EQ(element(" CLA", "CLA", " C"), 17);
    EXPECT_EQ(element(" CAL", "CAL", " C"), 20);
    EXPECT_EQ(element("NA  ", "NA ", " N"), 11);
    EXPECT_EQ(element(" Na+", "Na+", "  "), 11);
    EXPECT_EQ(element(" NA ", "ION", "  "), 11);
    EXPECT_EQ(element(" CA ", "ALA", " C"), 6) << "an alpha carbon alone";
    EXPECT_EQ(element(" CD2", "LEU", "  "), 6);
    EXPECT_EQ(element(" O  ", "HOH", " O"), 8);
}

TEST(OddFiles, UnusableCoordinatesAreLeftOutUnlessMostAre) {
    const std::string good = "ATOM      1  C   LIG A   1       1.000   0.000   0.000  1.00  0.00           C\n",
                      bad = "ATOM      2  C   LIG A   1    ********   0.000   0.000  1.00  0.00           C\n";
    const Molecule one = readMolecule("a.pdb", good + bad);
    EXPECT_EQ(one.atoms.size(), 1u);
    EXPECT_TRUE(warns(one, "left out 1 atom, line 2: no usable coordinates"));
    test::expectError("a.pdb", good + bad + bad, {"(line 2)", "invalid x coordinate '********'"});
    EXPECT_EQ(readMolecule("a.xyz", "2\n\nC 0 0 0\nC x 0 0\n").atoms.size(), 1u);
    EXPECT_EQ(
        readMolecule("a.pqr", "ATOM 1 C LIG 1 0.0 0.0 0.0 0.1 1.7\nATOM 2 C LIG 1 nan 0.0 0.0 0.1 1.7\n").atoms.size(),
        1u);
}

TEST(OddFiles, ResidueNamesOfFourLettersInPqr) {
    const Molecule named =
        readMolecule("a.pqr", "ATOM      1  N   NALAA   1      11.104   6.134  -6.504 -0.4000 1.8240\n");
    EXPECT_EQ(named.residues[0].name.view(), "NALA");
    EXPECT_EQ(named.chains[0].name, "A");
    EXPECT_FLOAT_EQ(named.atoms[0].position.x, 11.104f);
}

// The schema's other form of a cell.
TEST(OddFiles, CellParametersOfCml) {
    const Molecule salt = readMolecule("a.cml", R"(<molecule><crystal>
<cellParameter parameterType="length" units="units:angstrom">4 5 6</cellParameter>
<cellParameter parameterType="angle">90 90 90</cellParameter></crystal>
<atomArray><atom id="a" elementType="Na" xFract="0.5" yFract="0.5" zFract="0.5"/></atomArray></molecule>)");
    EXPECT_LT(glm::distance(salt.atoms[0].position, glm::vec3(2, 2.5f, 3)), 1e-5f);
    EXPECT_NEAR((*salt.file.box)[1].y, 5, 1e-5);
}

TEST(OddFiles, EachCrystalOfCmlHasItsOwnCell) {
    const auto crystal = [](const char* edge, const char* id) {
        std::string text = "<molecule><crystal>";
        for (const char* name : {"a", "b", "c"})
            text += std::string("<scalar title=\"") + name + "\">" + edge + "</scalar>";
        for (const char* name : {"alpha", "beta", "gamma"})
            text += std::string("<scalar title=\"") + name + "\">90</scalar>";
        return text + "</crystal><atomArray><atom id=\"" + id +
               "\" elementType=\"C\" xFract=\"0.5\" yFract=\"0\" zFract=\"0\"/></atomArray></molecule>";
    };
    const Molecule two = readMolecule("a.cml", "<cml>" + crystal("4", "a") + crystal("8", "b") + "</cml>");
    ASSERT_EQ(two.atoms.size(), 2u);
    EXPECT_NEAR(two.atoms[0].position.x, 2, 1e-5);
    EXPECT_NEAR(two.atoms[1].position.x, 4, 1e-5);
}

TEST(OddFiles, AtomsTooNearAreNotBonded) {
    EXPECT_TRUE(readMolecule("a.xyz", "2\n\nC 0 0 0\nO 0.9 0 0\n").bonds.empty());
    EXPECT_EQ(readMolecule("a.xyz", "2\n\nN 0 0 0\nN 1.1 0 0\n").bonds.size(), 1u);
    EXPECT_EQ(readMolecule("a.xyz", "2\n\nO 0 0 0\nH 0.8 0 0\n").bonds.size(), 1u);
}

// As the HPS model names its beads.
TEST(OddFiles, GrainsNamedByTheLettersOfAminoAcids) {
    const std::pair<const char*, const char*> names[] = {{"P", "PRO"}, {"N", "ASN"}, {"C", "CYS"},
                                                         {"S", "SER"}, {"K", "LYS"}, {"V", "VAL"}};
    std::string text;
    int i = 0;
    for (const auto& [letter, residue] : names) {
        text += formatted("ATOM  %5d  %s   %s A%4d    %8.3f   0.000   0.000  1.00  0.00\n", i + 1, letter, residue,
                          i + 1, 3.8 * i);
        ++i;
    }
    const Molecule grains = readMolecule("a.pdb", text);
    EXPECT_EQ(symbols(grains), "? ? ? ? ? ?") << "no phosphorus, no potassium";
    EXPECT_EQ(grains.bonds.size(), 5u);
    EXPECT_EQ(countNotes(grains, ReadAction::guessed, "coarse grains"), 6);
    EXPECT_EQ(countNotes(grains, ReadAction::guessed, "elements"), 0);
}

TEST(OddFiles, OneGrainPerResidue) {
    std::string text;
    const char* names[] = {"GLY", "ALA", "TRP", "LYS", "SER", "VAL"};
    for (int i = 0; i < 6; ++i) {
        text +=
            formatted("ATOM  %5d  B   %s A%4d    %8.3f   0.000   0.000  1.00  0.00\n", i + 1, names[i], i + 1, 3.8 * i);
    }
    const Molecule grains = readMolecule("a.pdb", text);
    EXPECT_EQ(symbols(grains), "? ? ? ? ? ?") << "no boron";
    EXPECT_EQ(grains.bonds.size(), 5u);
    EXPECT_GT(vanDerWaalsRadius(grains.atoms[2]), 2.5f);
}

TEST(OddFiles, TungstenStaysTungsten) {
    const Molecule one =
        readMolecule("a.pdb", "HETATM    1  W     W A   1       1.000   2.000   3.000  1.00  0.00           W\n");
    EXPECT_EQ(symbols(one), "W");
}

/// An alpha carbon, or another atom of one residue.
std::string atomLine(const char* record, const char* residue, char chain, int number, int x) {
    return formatted("%-6s    1  CA  %3s %c%4d    %8.3f   0.000   0.000  1.00  0.00\n", record, residue, chain, number,
                     static_cast<double>(x));
}

TEST(OddFiles, LettersThatBeginAgainAreOtherChains) {
    // MDTraj calls its 27th chain A.
    const auto chains = [](const std::string& text) {
        std::string names;
        for (const Chain& chain : readMolecule("a.pdb", text).chains) names += chain.name;
        return names;
    };
    const std::string both =
        atomLine("ATOM", "ALA", 'A', 1, 0) + atomLine("ATOM", "ALA", 'A', 2, 4) + atomLine("ATOM", "ALA", 'B', 1, 8);
    EXPECT_EQ(chains(both + atomLine("ATOM", "GLY", 'A', 1, 12) + atomLine("ATOM", "GLY", 'A', 2, 16)), "ABA");
    EXPECT_EQ(chains(both + atomLine("HETATM", "HEM", 'A', 1, 12) + atomLine("ATOM", "HOH", 'A', 2, 16)), "AB")
        << "ligands and water stand behind all chains";
    EXPECT_EQ(chains(both + atomLine("ATOM", "GLY", 'A', 3, 12)), "AB") << "the chain goes on";
    EXPECT_EQ(chains(both + atomLine("ATOM", "GLY", 'B', 1, 12)), "AB") << "no other chain came between";
}

}  // namespace
}  // namespace nacre
