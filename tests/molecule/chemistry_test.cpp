#include "engine/molecule/chemistry/chemistry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <string>

#include "engine/molecule/bonds/bonds.h"
#include "engine/molecule/chemistry/steps.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "tests/molecule/build_molecule.h"
#include "tests/molecule/build_peptide.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

using test::MoleculeText;

Chemistry makeChemistry(Molecule& molecule) {
    perceiveBonds(molecule);
    return perceiveChemistry(molecule, drawnAtoms(molecule, {.water = true, .hydrogens = true}));
}

/// "C1-C2 C2=O1": bonds by the names of atoms; aromatic ones with a colon.
std::string describeOrders(Molecule molecule) {
    const Chemistry chemistry = makeChemistry(molecule);
    std::string text;
    for (std::size_t i = 0; i < molecule.bonds.size(); ++i) {
        const Bond& bond = molecule.bonds[i];
        text += text.empty() ? "" : " ";
        text += molecule.atoms[bond.a].name.view();
        text += chemistry.aromatic[i] ? ':' : "-=#"[chemistry.order[i] - 1];
        text += molecule.atoms[bond.b].name.view();
    }
    return text;
}

/// A regular polygon of carbons whose sides are as long as given, Å.
void addPolygon(MoleculeText& text, int sides, float length, std::string_view symbols) {
    const float turn = 6.2831853f / static_cast<float>(sides), radius = length / (2 * std::sin(turn / 2));
    for (int i = 0; i < sides; ++i) {
        const float angle = turn * static_cast<float>(i);
        const std::string symbol(1, symbols[static_cast<std::size_t>(i)]);
        text.atom(symbol + std::to_string(i + 1), symbol, {radius * std::cos(angle), radius * std::sin(angle), 0});
    }
}

std::string polygon(int sides, float length, std::string_view symbols) {
    MoleculeText text;
    text.residue("LIG");
    addPolygon(text, sides, length, symbols);
    return describeOrders(text.molecule);
}

TEST(BondOrders, FlatRingsAreAromaticByHueckelsRule) {
    EXPECT_EQ(polygon(6, 1.39f, "CCCCCC"), "C1:C2 C1:C6 C2:C3 C3:C4 C4:C5 C5:C6");
    EXPECT_EQ(polygon(6, 1.35f, "NCCCCC"), "N1:C2 N1:C6 C2:C3 C3:C4 C4:C5 C5:C6");
    EXPECT_EQ(polygon(5, 1.38f, "NCNCC"), "N1:C2 N1:C5 C2:N3 N3:C4 C4:C5");
    EXPECT_EQ(polygon(5, 1.40f, "OCCCC"), "O1:C2 O1:C5 C2:C3 C3:C4 C4:C5");
}

TEST(BondOrders, AChairIsSaturated) {
    MoleculeText text;
    text.residue("LIG");
    for (int i = 0; i < 6; ++i) {
        const float angle = 1.0471976f * static_cast<float>(i);
        text.atom("C" + std::to_string(i + 1), "C",
                  {1.45f * std::cos(angle), 1.45f * std::sin(angle), i % 2 ? 0.25f : -0.25f});
    }
    EXPECT_EQ(describeOrders(text.molecule), "C1-C2 C1-C6 C2-C3 C3-C4 C4-C5 C5-C6");
}

/// Two further atoms about C1 at (0, 0, 0), whose first neighbour lies on the negative x axis: 120 degrees apart.
glm::vec3 forked(float length, bool up) { return {length * 0.5f, length * (up ? 0.8660254f : -0.8660254f), 0}; }

TEST(BondOrders, GroupsAreDrawnAsChemistsDrawThem) {
    const auto group = [](std::string_view centre, std::string_view first, float l1, std::string_view second,
                          float l2) {
        MoleculeText text;
        text.residue("LIG").atom("C2", "C", {-1.5f, 0, 0}).atom("X", centre, {0, 0, 0});
        text.atom("A", first, forked(l1, true)).atom("B", second, forked(l2, false));
        return describeOrders(text.molecule);
    };
    EXPECT_EQ(group("C", "O", 1.25f, "O", 1.26f), "C2-X X=A X-B");  // lengths that do not differ leave the file's order
    EXPECT_EQ(group("C", "O", 1.32f, "O", 1.21f), "C2-X X-A X=B");
    EXPECT_EQ(group("C", "N", 1.33f, "O", 1.23f), "C2-X X-A X=B");
    EXPECT_EQ(group("C", "C", 1.34f, "C", 1.50f), "C2-X X=A X-B");
    EXPECT_EQ(group("N", "O", 1.22f, "O", 1.22f), "C2-X X=A X-B");
}

TEST(BondOrders, LinearAtomsHaveTripleBonds) {
    MoleculeText text;
    text.residue("LIG").atom("C1", "C", {-1.46f, 0, 0}).atom("C2", "C", {0, 0, 0}).atom("N", "N", {1.15f, 0, 0});
    EXPECT_EQ(describeOrders(text.molecule), "C1-C2 C2#N");
}

TEST(BondOrders, HydrogensThatAreThereDecide) {
    // Formaldehyde and methanol with the same length of the bond: what counts is who has the hydrogens.
    MoleculeText flat;
    flat.residue("LIG").atom("C", "C", {0, 0, 0}).atom("O", "O", {1.30f, 0, 0});
    flat.atom("H1", "H", {-0.55f, 0.95f, 0}).atom("H2", "H", {-0.55f, -0.95f, 0});
    EXPECT_EQ(describeOrders(flat.molecule), "C=O C-H1 C-H2");
    MoleculeText full;
    full.residue("LIG").atom("C", "C", {0, 0, 0}).atom("O", "O", {1.30f, 0, 0}).atom("HO", "H", {1.6f, 0.9f, 0});
    full.atom("H1", "H", {-0.4f, 1, 0}).atom("H2", "H", {-0.4f, -0.5f, 0.87f}).atom("H3", "H", {-0.4f, -0.5f, -0.87f});
    EXPECT_EQ(describeOrders(full.molecule), "C-O C-H1 C-H2 C-H3 O-HO");
}

TEST(BondOrders, StatedOnesStay) {
    const std::string atoms =
        "a\n\n\n  2  1  0     0  0            999 V2000\n    0.0       0.0       0.0    C   0  0\n"
        "    1.20      0.0       0.0    O   0  0\n";
    EXPECT_EQ(describeOrders(readMolecule("a.sdf", atoms + "  1  2  1  0\nM  END\n")), "C-O");
    EXPECT_EQ(describeOrders(readMolecule("a.sdf", atoms + "  1  2  2  0\nM  END\n")), "C=O");
}

TEST(BondOrders, ComponentsOfAnMmcifFileStateThem) {
    const std::string atoms =
        "data_a\nloop_\n_atom_site.label_comp_id\n_atom_site.label_atom_id\n_atom_site.type_symbol\n_atom_site.Cartn_"
        "x\n"
        "_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.label_alt_id\nLIG C1 C 0 0 0 .\nLIG C2 C 1.5 0 0 A\n"
        "LIG C2 C 1.5 0.2 0 B\n";
    const std::string bonds =
        "loop_\n_chem_comp_bond.comp_id\n_chem_comp_bond.atom_id_1\n_chem_comp_bond.atom_id_2\n"
        "_chem_comp_bond.value_order\nLIG C1 C2 TRIP\nLIG C2 C3 SING\nOTH C1 C2 DOUB\n";
    const Molecule molecule = readMolecule("a.cif", atoms + bonds);
    ASSERT_EQ(molecule.bonds.size(), 2u);  // to both places of C2, none to C3, which is not there
    EXPECT_EQ(molecule.bonds[0].source, BondSource::file);
    EXPECT_EQ(describeOrders(molecule), "C1#C2 C1#C2");
    EXPECT_EQ(describeOrders(readMolecule("a.cif", atoms)), "C1-C2 C1-C2");
}

TEST(Rings, EveryFaceOfACage) {
    Molecule cage = sampleMolecule("buckyball");
    const Chemistry chemistry = makeChemistry(cage);
    std::map<std::size_t, int> sizes;
    for (const Ring& ring : chemistry.rings) ++sizes[ring.atoms.size()];
    EXPECT_EQ(sizes, (std::map<std::size_t, int>{{5, 12}, {6, 20}}));  // Euler: 32 faces
    std::vector<int> twofold(cage.atoms.size());
    for (std::size_t i = 0; i < cage.bonds.size(); ++i)
        if (chemistry.order[i] == 2) {
            ++twofold[cage.bonds[i].a];
            ++twofold[cage.bonds[i].b];
        }
    EXPECT_EQ(std::count(twofold.begin(), twofold.end(), 1), 60);
}

TEST(Rings, NoneInAChain) {
    Molecule chain = test::buildChain(20, -60, -45);
    EXPECT_TRUE(makeChemistry(chain).rings.empty());
}

TEST(Rings, OfACubicLatticeAreItsFaces) {
    constexpr int n = 12;
    MoleculeText lattice;
    lattice.residue("LIG");
    for (int x = 0; x < n; ++x)
        for (int y = 0; y < n; ++y)
            for (int z = 0; z < n; ++z) lattice.atom("SI", "Si", 2.3f * glm::vec3(x, y, z));
    const Chemistry chemistry = makeChemistry(lattice.molecule);
    EXPECT_EQ(chemistry.rings.size(), 3u * n * (n - 1) * (n - 1));
    EXPECT_TRUE(std::all_of(chemistry.rings.begin(), chemistry.rings.end(),
                            [](const Ring& ring) { return ring.atoms.size() == 4; }));
}

/// The best sum by trying all.
float bestByTrial(const PiSystem& system, std::size_t bond, std::vector<std::uint8_t>& used, float sum) {
    if (bond == system.bonds.size()) {
        for (std::size_t i = 0; i < used.size(); ++i) {
            if (used[i] > system.atoms[i].most) return -1e9f;
            sum -= system.atoms[i].cost[used[i]];
        }
        return sum;
    }
    float best = -1e9f;
    for (std::uint8_t pi = 0; pi <= 2; ++pi) {
        used[system.bonds[bond].a] += pi;
        used[system.bonds[bond].b] += pi;
        if (used[system.bonds[bond].a] <= 2 && used[system.bonds[bond].b] <= 2)
            best = std::max(best, bestByTrial(system, bond + 1, used, sum + system.bonds[bond].gain[pi]));
        used[system.bonds[bond].a] -= pi;
        used[system.bonds[bond].b] -= pi;
    }
    return best;
}

TEST(PiBonds, AreTheBestOfAllDistributions) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> value(-1, 1);
    for (int trial = 0; trial < 60; ++trial) {
        PiSystem system;
        system.atoms.resize(8);
        for (PiSystem::Atom& atom : system.atoms)
            atom = {{value(random), value(random), value(random)}, static_cast<std::uint8_t>(random() % 3)};
        for (int i = 0; i < 9; ++i) {
            const auto a = static_cast<std::uint32_t>(random() % 8), b = static_cast<std::uint32_t>(random() % 8);
            if (a != b) system.bonds.push_back({a, b, {0, value(random), value(random)}});
        }
        std::vector<std::uint8_t> used(8);
        std::vector<std::uint8_t> touched(8);
        for (const PiSystem::Bond& bond : system.bonds) touched[bond.a] = touched[bond.b] = 1;
        for (std::size_t i = 0; i < 8; ++i)  // an atom without bonds costs the same in any case
            if (!touched[i]) system.atoms[i].cost[0] = 0;
        const std::vector<std::uint8_t> found = bestPiBonds(system);
        ASSERT_EQ(found.size(), system.bonds.size());
        float sum = 0;
        std::vector<std::uint8_t> counts(8);
        for (std::size_t i = 0; i < found.size(); ++i) {
            sum += system.bonds[i].gain[found[i]];
            counts[system.bonds[i].a] = static_cast<std::uint8_t>(counts[system.bonds[i].a] + found[i]);
            counts[system.bonds[i].b] = static_cast<std::uint8_t>(counts[system.bonds[i].b] + found[i]);
        }
        for (std::size_t i = 0; i < 8; ++i) {
            ASSERT_LE(counts[i], system.atoms[i].most);
            sum -= system.atoms[i].cost[counts[i]];
        }
        EXPECT_NEAR(sum, bestByTrial(system, 0, used, 0), 1e-4) << trial;
    }
}

TEST(States, AcidsBasesAndWhatIsDelocalised) {
    MoleculeText text;  // an acetate and a methylamine, apart
    text.residue("ACT").atom("CH3", "C", {-1.5f, 0, 0}).atom("C", "C", {0, 0, 0});
    text.atom("O", "O", forked(1.25f, true)).atom("OXT", "O", forked(1.25f, false));
    text.residue("NME", 2).atom("C", "C", {20, 0, 0}).atom("N", "N", {21.47f, 0, 0});
    const Chemistry chemistry = makeChemistry(text.molecule);
    EXPECT_EQ(chemistry.charge, (std::vector<std::int8_t>{0, 0, 0, -1, 0, 1}));
    EXPECT_EQ(chemistry.hydrogens, (std::vector<std::uint8_t>{3, 0, 0, 0, 3, 3}));
    EXPECT_EQ(chemistry.delocalised, (std::vector<std::uint8_t>{0, 1, 1, 0}));
    EXPECT_EQ(chemistry.hybrid, (std::vector<std::uint8_t>{3, 2, 2, 2, 3, 3}));
}

/// A molecule of stated orders and charges; the hydrogens that RDKit 2022.09 adds to each atom.
struct StatedCase {
    const char* name;
    std::vector<std::pair<const char*, int>> atoms;  ///< element, charge
    std::vector<std::array<int, 3>> bonds;           ///< from 0; order
    std::vector<std::uint8_t> hydrogens;
};

TEST(States, HydrogensOfUnusualValencesAreRdkits) {
    const StatedCase cases[] = {
        {"sulfonium", {{"C", 0}, {"S", 1}, {"C", 0}, {"C", 0}}, {{0, 1, 1}, {1, 2, 1}, {1, 3, 1}}, {3, 0, 3, 3}},
        {"sulfonium, uncharged",
         {{"C", 0}, {"S", 0}, {"C", 0}, {"C", 0}},
         {{0, 1, 1}, {1, 2, 1}, {1, 3, 1}},
         {3, 0, 3, 3}},
        {"phosphonium",
         {{"C", 0}, {"P", 1}, {"C", 0}, {"C", 0}, {"C", 0}},
         {{0, 1, 1}, {1, 2, 1}, {1, 3, 1}, {1, 4, 1}},
         {3, 0, 3, 3, 3}},
        {"perchlorate",
         {{"O", -1}, {"Cl", 0}, {"O", 0}, {"O", 0}, {"O", 0}},
         {{0, 1, 1}, {1, 2, 2}, {1, 3, 2}, {1, 4, 2}},
         {0, 0, 0, 0, 0}},
        {"perchlorate, charges apart",
         {{"O", -1}, {"Cl", 3}, {"O", -1}, {"O", -1}, {"O", -1}},
         {{0, 1, 1}, {1, 2, 1}, {1, 3, 1}, {1, 4, 1}},
         {0, 0, 0, 0, 0}},
        {"vanadate",
         {{"O", -1}, {"V", 0}, {"O", 0}, {"O", -1}, {"O", -1}},
         {{0, 1, 1}, {1, 2, 2}, {1, 3, 1}, {1, 4, 1}},
         {0, 0, 0, 0, 0}},
        {"ammonium", {{"N", 1}}, {}, {4}},
        {"azide", {{"C", 0}, {"N", 0}, {"N", 1}, {"N", -1}}, {{0, 1, 1}, {1, 2, 2}, {2, 3, 2}}, {3, 0, 0, 0}},
        {"azide, uncharged", {{"C", 0}, {"N", 0}, {"N", 0}, {"N", 0}}, {{0, 1, 1}, {1, 2, 2}, {2, 3, 2}}, {3, 0, 0, 0}},
        {"diazo, uncharged", {{"C", 0}, {"C", 0}, {"N", 0}, {"N", 0}}, {{0, 1, 1}, {1, 2, 2}, {2, 3, 2}}, {3, 1, 0, 0}},
        {"isocyanide", {{"C", 0}, {"N", 1}, {"C", -1}}, {{0, 1, 1}, {1, 2, 3}}, {3, 0, 0}},
        {"carbon monoxide, uncharged", {{"C", 0}, {"O", 0}}, {{0, 1, 3}}, {0, 0}},
        {"oxonium", {{"C", 0}, {"O", 1}, {"C", 0}, {"C", 0}}, {{0, 1, 1}, {1, 2, 1}, {1, 3, 1}}, {3, 0, 3, 3}},
        {"diphenyliodonium's centre", {{"C", 0}, {"I", 1}, {"C", 0}}, {{0, 1, 1}, {1, 2, 1}}, {3, 0, 3}},
        {"sulfone, charges apart",
         {{"C", 0}, {"S", 2}, {"O", -1}, {"O", -1}, {"C", 0}},
         {{0, 1, 1}, {1, 2, 1}, {1, 3, 1}, {1, 4, 1}},
         {3, 0, 0, 0, 3}}};
    for (const StatedCase& row : cases) {
        MoleculeText text;
        text.residue("LIG");
        for (std::size_t i = 0; i < row.atoms.size(); ++i) {
            text.atom(row.atoms[i].first, row.atoms[i].first,
                      {1.5f * static_cast<float>(i), 0.1f * static_cast<float>(i * i), 0});
            text.molecule.atoms.back().charge = static_cast<std::int8_t>(row.atoms[i].second);
        }
        text.molecule.file.format = "sdf-v2000";
        for (const auto& [a, b, order] : row.bonds)
            text.molecule.bonds.push_back({static_cast<std::uint32_t>(std::min(a, b)),
                                           static_cast<std::uint32_t>(std::max(a, b)), static_cast<std::uint8_t>(order),
                                           BondSource::file});
        const Chemistry chemistry =
            perceiveChemistry(text.molecule, drawnAtoms(text.molecule, {.water = true, .hydrogens = true}));
        EXPECT_EQ(chemistry.hydrogens, row.hydrogens) << row.name;
    }
}

TEST(BondOrders, AzidesAndDiazoGroupsByTheirShape) {
    MoleculeText azide;  // methyl azide, by microwave spectroscopy: 1.24 and 1.13 Å
    azide.residue("LIG").atom("C", "C", {-0.6f, 1.33f, 0}).atom("N1", "N", {0, 0, 0}).atom("N2", "N", {1.23f, 0, 0});
    azide.atom("N3", "N", {2.36f, 0.1f, 0});
    EXPECT_EQ(describeOrders(azide.molecule), "C-N1 N1=N2 N2=N3");
    MoleculeText diazo;
    diazo.residue("LIG").atom("C1", "C", {-0.75f, 1.3f, 0}).atom("C", "C", {0, 0, 0}).atom("N2", "N", {1.31f, 0, 0});
    diazo.atom("N3", "N", {2.44f, 0.05f, 0});
    EXPECT_EQ(describeOrders(diazo.molecule), "C1-C C=N2 N2=N3");
}

std::size_t drawnRings(const Chemistry& chemistry) {
    return static_cast<std::size_t>(std::count_if(chemistry.rings.begin(), chemistry.rings.end(),
                                                  [](const Ring& ring) { return ring.drawnAromatic; }));
}

TEST(Rings, AreDrawnAsTextbooksDrawThem) {
    Molecule cage = sampleMolecule("buckyball");
    EXPECT_EQ(drawnRings(makeChemistry(cage)), 0u);  // a Kekulé structure
    MoleculeText fused;                              // naphthalene
    fused.residue("LIG");
    const float side = 1.40f, half = side / 2, high = side * 0.8660254f;
    for (const glm::vec3 at :
         {glm::vec3(0, half, 0), glm::vec3(0, -half, 0), glm::vec3(high, -side, 0), glm::vec3(2 * high, -half, 0),
          glm::vec3(2 * high, half, 0), glm::vec3(high, side, 0), glm::vec3(-high, side, 0),
          glm::vec3(-2 * high, half, 0), glm::vec3(-2 * high, -half, 0), glm::vec3(-high, -side, 0)})
        fused.atom("C", "C", at);
    EXPECT_EQ(drawnRings(makeChemistry(fused.molecule)), 2u);
}

TEST(Rings, OfFilesAreDrawnAsTextbooksDrawThem) {
    NACRE_NEEDS_DATA();
    const auto drawnIn = [](const char* file) {
        Molecule molecule = readMoleculeFile(test::dataFile(file));
        const Chemistry chemistry =
            perceiveChemistry(molecule, drawnAtoms(molecule, {.water = false, .hydrogens = true}));
        return std::pair(drawnRings(chemistry), chemistry.rings.size());
    };
    EXPECT_EQ(drawnIn("small/c60-buckminsterfullerene.sdf"), (std::pair<std::size_t, std::size_t>(0, 32)));
    EXPECT_EQ(drawnIn("small/caffeine.pdb"), (std::pair<std::size_t, std::size_t>(0, 2)));
    EXPECT_EQ(drawnIn("small/ferrocene.cml"), (std::pair<std::size_t, std::size_t>(2, 2)));
    EXPECT_EQ(drawnIn("small/benzene.xyz"), (std::pair<std::size_t, std::size_t>(1, 1)));
    EXPECT_EQ(drawnIn("small/hem-ccd.cif").first, 0u);
    EXPECT_EQ(drawnIn("small/adrenalin.sdf").first, 1u);
    const Molecule blood = readMoleculeFile(test::dataFile("4hhb.pdb"));
    const Chemistry chemistry = perceiveChemistry(blood, drawnAtoms(blood));
    for (const Ring& ring : chemistry.rings) {
        const bool haem = blood.residues[blood.atoms[ring.atoms[0]].residue].name == Name("HEM");
        EXPECT_FALSE(haem && ring.drawnAromatic);
    }
}

TEST(Chemistry, AHeapOfAtomsAndALatticeEnd) {
    MoleculeText heap;
    heap.residue("LIG");
    for (int i = 0; i < 3000; ++i) heap.atom("C", "C", {0.01f * static_cast<float>(i % 50), 0, 0});
    makeChemistry(heap.molecule);
    MoleculeText lattice;  // diamond, whose rings share every bond
    lattice.residue("LIG");
    for (int x = 0; x < 8; ++x)
        for (int y = 0; y < 8; ++y)
            for (int z = 0; z < 8; ++z)
                for (int i = 0; i < 8; ++i) {
                    const int half = i % 4;
                    const glm::vec3 base(half == 1 || half == 2, half == 1 || half == 3, half == 2 || half == 3);
                    const glm::vec3 shift = i < 4 ? glm::vec3(0) : glm::vec3(0.5f);
                    lattice.atom("C", "C", 1.7835f * (base + shift) + 3.567f * glm::vec3(x, y, z));
                }
    const Chemistry chemistry = makeChemistry(lattice.molecule);
    EXPECT_GT(chemistry.rings.size(), 4000u);
    EXPECT_EQ(std::count(chemistry.order.begin(), chemistry.order.end(), 2), 0);
}

}  // namespace
}  // namespace nacre
