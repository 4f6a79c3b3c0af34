#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "engine/molecule/element.h"
#include "engine/molecule/read.h"
#include "tests/molecule/geometry.h"
#include "tests/support/error_text.h"

namespace nacre {
namespace {

glm::dvec3 at(const Molecule& molecule, const char* name) { return test::position(molecule, 0, name); }

TEST(Samples, UnknownNameIsAnErrorThatNamesWhatThereIs) {
    EXPECT_EQ(test::errorText([&] { sampleMolecule("rna"); }),
              "unknown sample: rna: there are dna, glucose and buckyball (did you mean 'dna'?)");
}

TEST(SampleGlucose, HasEveryAtomAndBondOfGlucose) {
    const Molecule molecule = sampleMolecule("glucose");
    std::map<std::string, int> formula;
    for (const Atom& atom : molecule.atoms) ++formula[std::string(elementSymbol(atom.element))];
    EXPECT_EQ(formula, (std::map<std::string, int>{{"C", 6}, {"H", 12}, {"O", 6}}));
    ASSERT_EQ(molecule.bonds.size(), 24u);
    // Typical lengths: F. H. Allen et al., J. Chem. Soc. Perkin Trans. 2 (1987) S1.
    const std::map<std::string, std::pair<double, double>> lengths = {
        {"CC", {1.51, 1.54}}, {"CO", {1.39, 1.45}}, {"CH", {1.06, 1.11}}, {"HO", {0.95, 0.99}}};
    std::vector<int> valence(molecule.atoms.size());
    for (const Bond& bond : molecule.bonds) {
        EXPECT_EQ(bond.order, 1);
        ++valence[bond.a];
        ++valence[bond.b];
        std::string pair = std::string(elementSymbol(molecule.atoms[bond.a].element)) +
                           std::string(elementSymbol(molecule.atoms[bond.b].element));
        if (pair == "OH" || pair == "HC" || pair == "OC") std::swap(pair[0], pair[1]);
        ASSERT_TRUE(lengths.count(pair)) << pair;
        const double length = glm::distance(molecule.atoms[bond.a].position, molecule.atoms[bond.b].position);
        EXPECT_GE(length, lengths.at(pair).first) << pair;
        EXPECT_LE(length, lengths.at(pair).second) << pair;
    }
    for (std::size_t i = 0; i < valence.size(); ++i) {
        const auto symbol = elementSymbol(molecule.atoms[i].element);
        EXPECT_EQ(valence[i], symbol == "C" ? 4 : symbol == "O" ? 2 : 1) << molecule.atoms[i].name.view();
    }
}

TEST(SampleGlucose, AnglesAreTetrahedralThroughout) {
    const Molecule molecule = sampleMolecule("glucose");
    std::vector<std::vector<std::uint32_t>> neighbours(molecule.atoms.size());
    for (const Bond& bond : molecule.bonds) {
        neighbours[bond.a].push_back(bond.b);
        neighbours[bond.b].push_back(bond.a);
    }
    for (std::uint32_t b = 0; b < neighbours.size(); ++b) {
        for (const auto a : neighbours[b]) {
            for (const auto c : neighbours[b]) {
                if (a >= c) continue;
                const double angle =
                    test::angle(molecule.atoms[a].position, molecule.atoms[b].position, molecule.atoms[c].position);
                EXPECT_GT(angle, 104.0) << molecule.atoms[b].name.view();
                EXPECT_LT(angle, 115.0) << molecule.atoms[b].name.view();
            }
        }
    }
    EXPECT_NEAR(test::angle(at(molecule, "C5"), at(molecule, "O5"), at(molecule, "C1")), 113.5, 0.1);
    EXPECT_NEAR(test::angle(at(molecule, "C2"), at(molecule, "C3"), at(molecule, "C4")), 110.0, 0.1);
}

TEST(SampleGlucose, IsAlphaAndD) {
    // IUPAC: (2S,3R,4S,5S,6R)-6-(hydroxymethyl)oxane-2,3,4,5-tetrol; C1 is locant 2.
    const Molecule m = sampleMolecule("glucose");
    EXPECT_EQ(test::chirality(at(m, "C1"), at(m, "O5"), at(m, "O1"), at(m, "C2")), 'S');
    EXPECT_EQ(test::chirality(at(m, "C2"), at(m, "O2"), at(m, "C1"), at(m, "C3")), 'R');
    EXPECT_EQ(test::chirality(at(m, "C3"), at(m, "O3"), at(m, "C2"), at(m, "C4")), 'S');
    EXPECT_EQ(test::chirality(at(m, "C4"), at(m, "O4"), at(m, "C5"), at(m, "C3")), 'S');
    EXPECT_EQ(test::chirality(at(m, "C5"), at(m, "O5"), at(m, "C4"), at(m, "C6")), 'R');
}

TEST(SampleGlucose, IsThe4C1Chair) {
    const Molecule m = sampleMolecule("glucose");
    const std::vector<const char*> ring = {"C1", "C2", "C3", "C4", "C5", "O5"};
    for (std::size_t i = 0; i < 6; ++i) {
        const double torsion =
            test::torsion(at(m, ring[i]), at(m, ring[(i + 1) % 6]), at(m, ring[(i + 2) % 6]), at(m, ring[(i + 3) % 6]));
        EXPECT_NEAR(torsion, i % 2 == 0 ? -56 : 56, 6) << ring[i];  // C1-C2-C3-C4 is about -54 in 4C1
    }
    // Groups by the ring torsion from two atoms back: equatorial is trans, axial gauche.
    EXPECT_GT(std::abs(test::torsion(at(m, "O5"), at(m, "C1"), at(m, "C2"), at(m, "O2"))), 165);
    EXPECT_GT(std::abs(test::torsion(at(m, "C1"), at(m, "C2"), at(m, "C3"), at(m, "O3"))), 165);
    EXPECT_GT(std::abs(test::torsion(at(m, "C2"), at(m, "C3"), at(m, "C4"), at(m, "O4"))), 165);
    EXPECT_GT(std::abs(test::torsion(at(m, "C3"), at(m, "C4"), at(m, "C5"), at(m, "C6"))), 165);
    EXPECT_LT(std::abs(test::torsion(at(m, "C3"), at(m, "C2"), at(m, "C1"), at(m, "O1"))), 75);
    EXPECT_NEAR(test::torsion(at(m, "O5"), at(m, "C5"), at(m, "C6"), at(m, "O6")), 60, 1);
}

TEST(SampleGlucose, NothingCollides) {
    const Molecule m = sampleMolecule("glucose");
    std::set<std::pair<std::uint32_t, std::uint32_t>> bonded;
    for (const Bond& bond : m.bonds) bonded.insert({bond.a, bond.b});
    for (std::uint32_t i = 0; i < m.atoms.size(); ++i) {
        for (std::uint32_t j = i + 1; j < m.atoms.size(); ++j) {
            if (bonded.count({i, j})) continue;
            EXPECT_GT(glm::distance(m.atoms[i].position, m.atoms[j].position), 1.75f)
                << m.atoms[i].name.view() << ' ' << m.atoms[j].name.view();
        }
    }
}

TEST(SampleBuckyball, IsATruncatedIcosahedron) {
    const Molecule molecule = sampleMolecule("buckyball");
    ASSERT_EQ(molecule.atoms.size(), 60u);
    ASSERT_EQ(molecule.bonds.size(), 90u);
    std::vector<std::multiset<int>> orders(60);
    for (const Bond& bond : molecule.bonds) {
        orders[bond.a].insert(bond.order);
        orders[bond.b].insert(bond.order);
        const double length = glm::distance(molecule.atoms[bond.a].position, molecule.atoms[bond.b].position);
        EXPECT_NEAR(length, bond.order == 2 ? 1.401 : 1.458, 1e-4);
    }
    for (const auto& atom : orders) EXPECT_EQ(atom, (std::multiset<int>{1, 1, 2}));
    // The mean radius of C60 by electron diffraction is 3.557 Å (Hedberg et al. 1991).
    for (const Atom& atom : molecule.atoms) EXPECT_NEAR(glm::length(glm::dvec3(atom.position)), 3.557, 0.01);
}

TEST(SampleBuckyball, SingleBondsMakeTwelveSeparatePentagons) {
    const Molecule molecule = sampleMolecule("buckyball");
    std::vector<std::uint32_t> group(60);
    for (std::uint32_t i = 0; i < 60; ++i) group[i] = i;
    for (int round = 0; round < 5; ++round) {
        for (const Bond& bond : molecule.bonds)
            if (bond.order == 1) group[bond.a] = group[bond.b] = std::min(group[bond.a], group[bond.b]);
    }
    std::map<std::uint32_t, int> sizes;
    for (const auto g : group) ++sizes[g];
    EXPECT_EQ(sizes.size(), 12u);
    for (const auto& [g, size] : sizes) EXPECT_EQ(size, 5) << g;
}

TEST(ElementTable, TakesSymbolsInAnyCase) {
    EXPECT_EQ(elementFromSymbol("FE"), 26);
    EXPECT_EQ(elementFromSymbol("fe"), 26);
    EXPECT_EQ(elementFromSymbol("h"), 1);
    EXPECT_EQ(elementFromSymbol("D"), 119);
    EXPECT_EQ(elementFromSymbol("Og"), 118);
    for (const char* unknown : {"X", "", "C1", "Xx", " C", "Cla", "\xff\xfe"}) EXPECT_EQ(elementFromSymbol(unknown), 0);
    for (int number = 1; number <= 119; ++number) {
        const auto element = static_cast<Element>(number);
        EXPECT_EQ(elementFromSymbol(elementSymbol(element)), element);
    }
}

TEST(ElementTable, HoldsThePublishedRadii) {
    EXPECT_FLOAT_EQ(vanDerWaalsRadius(6), 1.70f);  // Bondi
    EXPECT_FLOAT_EQ(vanDerWaalsRadius(8), 1.52f);
    EXPECT_FLOAT_EQ(covalentRadius(1), 0.31f);  // Cordero et al. 2008
    EXPECT_FLOAT_EQ(covalentRadius(26), 1.32f);
    EXPECT_GT(vanDerWaalsRadius(200), 0.0f);  // outside the table counts as unknown
    EXPECT_TRUE(isHydrogen(119));
    EXPECT_TRUE(isMetal(26));
    EXPECT_FALSE(isMetal(6));
}

}  // namespace
}  // namespace nacre
