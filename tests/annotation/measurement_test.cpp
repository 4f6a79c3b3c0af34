#include "app/annotation/measurement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/molecule/read.h"

namespace nacre::app {
namespace {

TEST(Measurement, DistancesAnglesTorsions) {
    EXPECT_DOUBLE_EQ(measureDistance({1, 2, 3}, {4, 6, 3}), 5);
    EXPECT_NEAR(measureAngle({1, 0, 0}, {0, 0, 0}, {0, 2, 0}), 90, 1e-12);
    EXPECT_NEAR(measureAngle({1, 1, 1}, {0, 0, 0}, {-1, -1, 1}), std::acos(-1.0 / 3) * 180 / M_PI,
                1e-9);  // tetrahedral
    EXPECT_NEAR(measureTorsion({1, 0, 0}, {0, 0, 0}, {0, 0, 1}, {1, 0, 1}), 0, 1e-12);
    EXPECT_NEAR(std::abs(measureTorsion({1, 0, 0}, {0, 0, 0}, {0, 0, 1}, {-1, 0, 1})), 180, 1e-12);
    // Looking from b to c along +z with x to the right, y is to the left hand: a at x, d at y. Seen against the
    // direction of sight counter-clockwise is positive in a right-handed frame, so along it +90 is clockwise.
    EXPECT_NEAR(measureTorsion({1, 0, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}), 90, 1e-12);
}

TEST(Measurement, TheGlucoseChairHasStaggeredTorsions) {
    // Chair of glucopyranose: ring torsions of about 55 to 65 degrees, alternating in sign (Cremer and Pople, 1975).
    const Molecule m = sampleMolecule("glucose");
    const auto at = [&](const char* name) {
        for (const Atom& a : m.atoms)
            if (a.name.view() == name) return glm::dvec3(a.position);
        ADD_FAILURE() << name;
        return glm::dvec3();
    };
    const double first = measureTorsion(at("C1"), at("C2"), at("C3"), at("C4"));
    const double second = measureTorsion(at("C2"), at("C3"), at("C4"), at("C5"));
    EXPECT_NEAR(std::abs(first), 57, 8);
    EXPECT_NEAR(std::abs(second), 57, 8);
    EXPECT_LT(first * second, 0);
}

TEST(Measurement, Words) {
    const std::vector<glm::dvec3> p = {{0, 0, 0}, {0, 0, 1.5}, {0, 1, 1.5}, {1, 1, 1.5}};
    EXPECT_EQ(measurementText(std::span(p).first(1)), "");
    EXPECT_EQ(measurementText(std::span(p).first(2)), "distance 1.50 Å");
    EXPECT_EQ(measurementText(std::span(p).first(3)), "angle 90.0°");
    EXPECT_EQ(measurementText(p).substr(0, 8), "torsion ");
    EXPECT_EQ(atomText(sampleMolecule("dna"), 0).substr(0, 7), "Oxygen ");
    EXPECT_NE(atomText(sampleMolecule("dna"), 0).find("chain A, atom 1"), std::string::npos);
    EXPECT_EQ(elementName(79), "Gold");
    EXPECT_EQ(elementName(118), "Oganesson");
    EXPECT_EQ(elementName(255), "Atom");
}

TEST(Measurement, ContactsAreSaidByTheirEnds) {
    const Molecule dna = sampleMolecule("dna");
    Interaction bond;
    bond.distance = 2.914;
    bond.a.atoms = {0};
    bond.b.atoms = {1};
    const std::string first = shortAtomText(dna, 0), second = shortAtomText(dna, 1);
    EXPECT_EQ(contactText(dna, bond), "Hydrogen bond 2.91 Å, " + first + " to " + second);
    bond.kind = InteractionKind::waterBridge;
    bond.waters = {2};
    EXPECT_EQ(contactText(dna, bond),
              "Water bridge 2.91 Å, " + first + " to " + second + " by " + shortAtomText(dna, 2));
    bond = {};
    bond.kind = InteractionKind::saltBridge;
    bond.a.atoms = {0, 1, 2};  // a group is its residue
    bond.b.atoms = {3};
    EXPECT_EQ(contactText(dna, bond), "Salt bridge 0.00 Å, DC 1 to " + shortAtomText(dna, 3));
}

}  // namespace
}  // namespace nacre::app
