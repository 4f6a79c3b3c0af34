#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "engine/molecule/element.h"
#include "engine/molecule/read.h"
#include "tests/molecule/geometry.h"

namespace nacre {
namespace {

using test::position;

struct Length {
    const char* a;
    const char* b;
    double value;
};

// Means over crystal structures, Å. Sugar and phosphate: A. Gelbin et al., J. Am. Chem. Soc. 118 (1996) 519-529.
const std::vector<Length> kBackbone = {
    {"P", "OP1", 1.485},   {"P", "OP2", 1.485},   {"P", "O5'", 1.593},   {"O5'", "C5'", 1.440},
    {"C5'", "C4'", 1.512}, {"C4'", "C3'", 1.528}, {"C3'", "C2'", 1.518}, {"C2'", "C1'", 1.521},
    {"O4'", "C1'", 1.420}, {"O4'", "C4'", 1.449}, {"O3'", "C3'", 1.431},
};
// Bases: L. Clowney et al., J. Am. Chem. Soc. 118 (1996) 509-518.
const std::map<std::string, std::vector<Length>> kBases = {
    {"DA",
     {{"N9", "C1'", 1.462},
      {"N1", "C2", 1.339},
      {"C2", "N3", 1.331},
      {"N3", "C4", 1.344},
      {"C4", "C5", 1.383},
      {"C5", "C6", 1.406},
      {"C6", "N1", 1.351},
      {"C5", "N7", 1.388},
      {"N7", "C8", 1.311},
      {"C8", "N9", 1.373},
      {"N9", "C4", 1.374},
      {"C6", "N6", 1.335}}},
    {"DG",
     {{"N9", "C1'", 1.459},
      {"N1", "C2", 1.373},
      {"C2", "N3", 1.323},
      {"N3", "C4", 1.350},
      {"C4", "C5", 1.379},
      {"C5", "C6", 1.419},
      {"C6", "N1", 1.391},
      {"C5", "N7", 1.388},
      {"N7", "C8", 1.305},
      {"C8", "N9", 1.374},
      {"N9", "C4", 1.375},
      {"C2", "N2", 1.341},
      {"C6", "O6", 1.237}}},
    {"DC",
     {{"N1", "C1'", 1.470},
      {"N1", "C2", 1.397},
      {"C2", "N3", 1.353},
      {"N3", "C4", 1.335},
      {"C4", "C5", 1.425},
      {"C5", "C6", 1.339},
      {"N1", "C6", 1.367},
      {"C2", "O2", 1.240},
      {"C4", "N4", 1.335}}},
    {"DT",
     {{"N1", "C1'", 1.473},
      {"N1", "C2", 1.376},
      {"C2", "N3", 1.373},
      {"N3", "C4", 1.382},
      {"C4", "C5", 1.445},
      {"C5", "C6", 1.339},
      {"C6", "N1", 1.378},
      {"C2", "O2", 1.220},
      {"C4", "O4", 1.228},
      {"C5", "C7", 1.496}}},
};

struct Angle {
    const char* a;
    const char* b;
    const char* c;
    double value;
};
// Angles to the atoms that hang off the bases (Clowney et al.) and the backbone (Gelbin et al.), degrees.
const std::map<std::string, std::vector<Angle>> kHangingAngles = {
    {"DA", {{"N1", "C6", "N6", 118.6}, {"C4", "N9", "C1'", 126.3}}},
    {"DG", {{"N1", "C6", "O6", 119.9}, {"N1", "C2", "N2", 116.2}, {"C4", "N9", "C1'", 126.5}}},
    {"DC", {{"N1", "C2", "O2", 118.9}, {"N3", "C4", "N4", 118.0}, {"C2", "N1", "C1'", 118.8}}},
    {"DT",
     {{"N1", "C2", "O2", 123.1}, {"N3", "C4", "O4", 119.9}, {"C4", "C5", "C7", 119.0}, {"C2", "N1", "C1'", 118.2}}},
};

class SampleDna : public ::testing::Test {
protected:
    const Molecule molecule = sampleMolecule("dna");
    std::string residueName(std::uint32_t r) const { return std::string(molecule.residues[r].name.view()); }
};

TEST_F(SampleDna, HasTheAtomsOfTheDodecamerAs1bnaHasThem) {
    EXPECT_EQ(molecule.atoms.size(), 486u);
    ASSERT_EQ(molecule.residues.size(), 24u);
    ASSERT_EQ(molecule.chains.size(), 2u);
    std::string sequence;
    for (std::uint32_t r = 0; r < 24; ++r) {
        sequence += residueName(r);
        EXPECT_EQ(molecule.residues[r].number, static_cast<int>(r + 1));
        EXPECT_EQ(molecule.chains[molecule.residues[r].chain].name, r < 12 ? "A" : "B");
    }
    const std::string strand = "DCDGDCDGDADADTDTDCDGDCDG";
    EXPECT_EQ(sequence, strand + strand);
    EXPECT_EQ(molecule.atoms[0].name.view(), "O5'");
    EXPECT_EQ(std::count_if(molecule.atoms.begin(), molecule.atoms.end(),
                            [](const Atom& atom) { return elementSymbol(atom.element) == "P"; }),
              22);
    for (const Atom& atom : molecule.atoms) EXPECT_FALSE(atom.hetero);
}

TEST_F(SampleDna, EveryBondHasItsPublishedLength) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> tested;
    const auto expectLength = [&](std::uint32_t r1, const char* n1, std::uint32_t r2, const char* n2, double value) {
        const auto a = test::atomIndex(molecule, r1, n1);
        const auto b = test::atomIndex(molecule, r2, n2);
        tested.insert(std::minmax(a, b));
        EXPECT_NEAR(glm::distance(position(molecule, r1, n1), position(molecule, r2, n2)), value, 0.03)
            << residueName(r1) << r1 << ' ' << n1 << '-' << n2;
    };
    for (std::uint32_t r = 0; r < 24; ++r) {
        for (const auto& [a, b, value] : kBackbone)
            if (r % 12 != 0 || (std::string(a) != "P")) expectLength(r, a, r, b, value);
        for (const auto& [a, b, value] : kBases.at(residueName(r))) expectLength(r, a, r, b, value);
        if (r % 12 != 11) expectLength(r, "O3'", r + 1, "P", 1.607);
    }
    // No other pair is near enough to be bonded, so the list is complete and nothing collides.
    for (std::uint32_t i = 0; i < molecule.atoms.size(); ++i) {
        for (std::uint32_t j = i + 1; j < molecule.atoms.size(); ++j) {
            if (tested.count({i, j})) continue;
            EXPECT_GT(glm::distance(molecule.atoms[i].position, molecule.atoms[j].position), 2.0f) << i << ' ' << j;
        }
    }
}

TEST_F(SampleDna, CarriesExactlyThoseBonds) {
    // 20 sugar-phosphate bonds less what the two 5' ends lack is 22 * 11 + 2 * 8; bases as listed; 22 links.
    std::size_t expected = 22 * 11 + 2 * 8 + 22;
    for (std::uint32_t r = 0; r < 24; ++r) expected += kBases.at(residueName(r)).size();
    EXPECT_EQ(molecule.bonds.size(), expected);
    for (const Bond& bond : molecule.bonds)
        EXPECT_LT(glm::distance(molecule.atoms[bond.a].position, molecule.atoms[bond.b].position), 1.7f);
    // Kekulé structures: A has 4 double bonds, G 4, C 3, T 3; each phosphate has one.
    const auto doubles = std::ranges::count_if(molecule.bonds, [](const Bond& bond) { return bond.order == 2; });
    EXPECT_EQ(doubles, 4 * 4 + 8 * 4 + 8 * 3 + 4 * 3 + 22);
}

TEST_F(SampleDna, BackboneTorsionsAreThoseOfTheFibreModel) {
    // W. Saenger, Principles of Nucleic Acid Structure (1984): B-DNA of Arnott and Hukins (1972).
    for (const std::uint32_t r : {1u, 5u, 10u, 13u, 18u, 22u}) {
        const auto at = [&](std::uint32_t residue, const char* name) { return position(molecule, residue, name); };
        const bool purine = residueName(r) == "DA" || residueName(r) == "DG";
        const double alpha = test::torsion(at(r - 1, "O3'"), at(r, "P"), at(r, "O5'"), at(r, "C5'"));
        const double beta = test::torsion(at(r, "P"), at(r, "O5'"), at(r, "C5'"), at(r, "C4'"));
        const double gamma = test::torsion(at(r, "O5'"), at(r, "C5'"), at(r, "C4'"), at(r, "C3'"));
        const double delta = test::torsion(at(r, "C5'"), at(r, "C4'"), at(r, "C3'"), at(r, "O3'"));
        const double epsilon = test::torsion(at(r, "C4'"), at(r, "C3'"), at(r, "O3'"), at(r + 1, "P"));
        const double zeta = test::torsion(at(r, "C3'"), at(r, "O3'"), at(r + 1, "P"), at(r + 1, "O5'"));
        const double chi =
            test::torsion(at(r, "O4'"), at(r, "C1'"), at(r, purine ? "N9" : "N1"), at(r, purine ? "C4" : "C2"));
        EXPECT_NEAR(alpha, -46.8, 0.7);
        EXPECT_NEAR(beta, -146.0, 0.7);
        EXPECT_NEAR(gamma, 36.4, 0.7);
        EXPECT_NEAR(delta, 156.4, 0.7);
        EXPECT_NEAR(epsilon, 155.0, 0.7);
        EXPECT_NEAR(zeta, -95.2, 0.7);
        EXPECT_NEAR(chi, -97.8, 1.5);
    }
}

TEST_F(SampleDna, HangingAtomsStandAtPublishedAngles) {
    for (std::uint32_t r = 0; r < 24; ++r) {
        const auto at = [&](const char* name) { return position(molecule, r, name); };
        for (const auto& [a, b, c, value] : kHangingAngles.at(residueName(r)))
            EXPECT_NEAR(test::angle(at(a), at(b), at(c)), value, 3.5) << residueName(r) << ' ' << a << b << c;
        if (r % 12 == 0) continue;
        EXPECT_NEAR(test::angle(at("OP1"), at("P"), at("OP2")), 119.6, 4.0);
        EXPECT_NEAR(test::angle(at("OP1"), at("P"), at("O5'")), 109.0, 1.3);
        EXPECT_NEAR(test::angle(at("OP2"), at("P"), at("O5'")), 109.0, 1.3);
        // Which of the two is OP1 is a matter of hand; the sign is that of the 1BNA entry.
        const glm::dvec3 o3 = position(molecule, r - 1, "O3'");
        EXPECT_LT(glm::dot(glm::cross(at("OP1") - at("P"), at("OP2") - at("P")), at("O5'") - at("P")), 0);
        EXPECT_GT(glm::dot(glm::cross(at("OP1") - at("P"), at("OP2") - at("P")), o3 - at("P")), 0);
    }
}

TEST_F(SampleDna, SugarsHaveTheHandOfDeoxyribose) {
    // 2'-deoxy-beta-D-ribofuranose in DNA: C1' R, C3' S, C4' R.
    for (std::uint32_t r = 0; r < 24; ++r) {
        const auto at = [&](const char* name) { return position(molecule, r, name); };
        const bool purine = residueName(r) == "DA" || residueName(r) == "DG";
        EXPECT_EQ(test::chirality(at("C1'"), at("O4'"), at(purine ? "N9" : "N1"), at("C2'")), 'R');
        EXPECT_EQ(test::chirality(at("C3'"), at("O3'"), at("C4'"), at("C2'")), 'S');
        EXPECT_EQ(test::chirality(at("C4'"), at("O4'"), at("C3'"), at("C5'")), 'R');
    }
}

TEST_F(SampleDna, BasesAreFlat) {
    for (std::uint32_t r = 0; r < 24; ++r) {
        const bool purine = residueName(r) == "DA" || residueName(r) == "DG";
        const glm::dvec3 origin = position(molecule, r, "C2");
        const glm::dvec3 normal =
            glm::normalize(glm::cross(position(molecule, r, "C4") - origin, position(molecule, r, "C6") - origin));
        const Residue& residue = molecule.residues[r];
        for (std::uint32_t i = residue.firstAtom; i < residue.firstAtom + residue.atomCount; ++i) {
            const std::string name(molecule.atoms[i].name.view());
            if (name.find_first_of("'P") != std::string::npos) continue;
            EXPECT_LT(std::abs(glm::dot(glm::dvec3(molecule.atoms[i].position) - origin, normal)), 0.05) << name;
        }
        EXPECT_LT(std::abs(glm::dot(position(molecule, r, "C1'") - origin, normal)), purine ? 0.2 : 0.1);
    }
}

TEST_F(SampleDna, PairsByWatsonAndCrick) {
    // Published ranges for Watson-Crick pairs, donor to acceptor: 2.7 to 3.1 Å, three for G-C and two for A-T.
    using Pair = std::tuple<const char*, const char*>;
    for (std::uint32_t i = 0; i < 12; ++i) {
        std::uint32_t a = i;
        std::uint32_t b = 23 - i;
        if (residueName(a) == "DC" || residueName(a) == "DT") std::swap(a, b);
        std::vector<Pair> contacts;
        if (residueName(a) == "DG") {
            ASSERT_EQ(residueName(b), "DC");
            contacts = {{"O6", "N4"}, {"N1", "N3"}, {"N2", "O2"}};
        } else {
            ASSERT_EQ(residueName(a), "DA");
            ASSERT_EQ(residueName(b), "DT");
            contacts = {{"N6", "O4"}, {"N1", "N3"}};
        }
        for (const auto& [donor, acceptor] : contacts) {
            const double distance = glm::distance(position(molecule, a, donor), position(molecule, b, acceptor));
            EXPECT_GE(distance, 2.69) << donor << acceptor;
            EXPECT_LE(distance, 3.1) << donor << acceptor;
        }
        // C1'-C1' of a Watson-Crick pair: 10.4 to 10.9 Å.
        EXPECT_NEAR(glm::distance(position(molecule, a, "C1'"), position(molecule, b, "C1'")), 10.7, 0.3);
    }
}

TEST_F(SampleDna, TurnsRightHandedWithRiseAndTwistOfBDna) {
    for (std::uint32_t r = 1; r < 24; ++r) {
        if (r == 12) continue;
        const glm::dvec3 before = position(molecule, r - 1, "C1'");
        const glm::dvec3 after = position(molecule, r, "C1'");
        // The axis is y. Strand A descends and strand B climbs, 5' to 3': antiparallel.
        const double rise = after.y - before.y;
        EXPECT_NEAR(rise, r < 12 ? -3.38 : 3.38, 1e-4);
        const double turn =
            std::atan2(before.z * after.x - before.x * after.z, before.z * after.z + before.x * after.x);
        // Right-handed: the turn about +y has the sign of the rise along it.
        EXPECT_NEAR(turn * 180 / std::numbers::pi, r < 12 ? -36.0 : 36.0, 1e-3);
        EXPECT_NEAR(std::hypot(after.x, after.z), 5.86, 1e-4);
    }
    for (std::uint32_t r = 2; r < 12; ++r) {
        const glm::dvec3 phosphorus = position(molecule, r, "P");
        EXPECT_NEAR(std::hypot(phosphorus.x, phosphorus.z), 8.91, 1e-4);
        // Along a strand of B-DNA with C2'-endo sugars phosphates stand 6.4 to 7.0 Å apart.
        EXPECT_NEAR(glm::distance(position(molecule, r - 1, "P"), phosphorus), 6.46, 0.02);
    }
}

TEST_F(SampleDna, MinorGrooveIsTheNarrowOne) {
    // Phosphates facing each other across the minor groove: about 11.7 Å between P, 5.9 Å wide (Arnott's B-DNA).
    double narrowest = 1e9;
    for (std::uint32_t a = 1; a < 12; ++a)
        for (std::uint32_t b = 13; b < 24; ++b)
            narrowest = std::min(narrowest, glm::distance(position(molecule, a, "P"), position(molecule, b, "P")));
    EXPECT_NEAR(narrowest, 11.7, 0.5);
}

}  // namespace
}  // namespace nacre
