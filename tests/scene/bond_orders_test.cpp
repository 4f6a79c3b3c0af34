// Double, aromatic and delocalised bonds.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/scene/build/representation.h"

namespace nacre {
namespace {

constexpr Element kCarbon = 6, kOxygen = 8;

struct AtomText {
    Element element;
    glm::vec3 place;
};

Molecule makeMolecule(const std::vector<AtomText>& atoms, const std::vector<std::array<std::uint32_t, 3>>& bonds) {
    Molecule molecule;
    molecule.chains.resize(1);
    molecule.residues.resize(1);
    molecule.residues[0].atomCount = static_cast<std::uint32_t>(atoms.size());
    for (const AtomText& text : atoms) {
        Atom atom;
        atom.element = text.element;
        atom.position = text.place;
        molecule.atoms.push_back(atom);
    }
    for (const auto& [a, b, order] : bonds)
        molecule.bonds.push_back({a, b, static_cast<std::uint8_t>(order), BondSource::file});
    return molecule;
}

/// A flat ring in the plane z = 0 about the origin. @param orders  of its bonds, from the first to the last atom
Molecule makeRing(const std::vector<std::uint32_t>& orders, double reach) {
    std::vector<AtomText> atoms;
    std::vector<std::array<std::uint32_t, 3>> bonds;
    const auto count = static_cast<std::uint32_t>(orders.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        const double angle = 6.283185307 * i / count;
        atoms.push_back({kCarbon, glm::vec3(reach * std::cos(angle), reach * std::sin(angle), 0)});
        if (i + 1 < count) bonds.push_back({i, i + 1, orders[i]});
    }
    bonds.push_back({0, count - 1, orders.back()});
    return makeMolecule(atoms, bonds);
}

Representation drawnWith(const Molecule& molecule, Style style, BondOrders orders = BondOrders::ligands,
                         AromaticForm form = AromaticForm::dashes) {
    RepresentationOptions options{style, ColorScheme::element};
    options.bondOrders = orders;
    options.aromatic = form;
    return represent(molecule, drawnAtoms(molecule), options);
}

/// Sticks that are thinner than the thickest.
std::vector<Cylinder> thinOnes(const Representation& scene) {
    float thickest = 0;
    for (const Cylinder& c : scene.cylinders) thickest = std::max(thickest, c.radius);
    std::vector<Cylinder> thin;
    for (const Cylinder& c : scene.cylinders)
        if (c.radius < thickest) thin.push_back(c);
    return thin;
}

double fromMiddle(const Representation& scene, const glm::vec3& point) {
    return glm::length(glm::dvec3(point) + scene.center);
}

TEST(BondOrdersDrawn, AromaticRingsHaveThreeDashesInsideEachBond) {
    const Molecule benzene = makeRing({4, 4, 4, 4, 4, 4}, 1.39);
    for (const Style style : {Style::ballAndStick, Style::licorice}) {
        const Representation scene = drawnWith(benzene, style);
        const std::vector<Cylinder> dashes = thinOnes(scene);
        EXPECT_EQ(scene.drawnBonds, 6u);
        EXPECT_EQ(dashes.size(), 18u);
        for (const Cylinder& dash : dashes) {
            EXPECT_NEAR(dash.a.z, 0, 1e-5);
            EXPECT_LT(fromMiddle(scene, (dash.a + dash.b) / 2.0f), 1.39 * 0.866 - 0.2);
        }
    }
    // From any Kekulé structure, and without hydrogens.
    EXPECT_EQ(thinOnes(drawnWith(makeRing({1, 2, 1, 2, 1, 2}, 1.39), Style::licorice)).size(), 18u);
}

TEST(BondOrdersDrawn, AromaticRingsMayHaveACircle) {
    const Representation scene =
        drawnWith(makeRing({4, 4, 4, 4, 4, 4}, 1.39), Style::licorice, BondOrders::ligands, AromaticForm::ring);
    const std::vector<Cylinder> pieces = thinOnes(scene);
    ASSERT_EQ(pieces.size(), 24u);
    std::map<std::uint32_t, int> ofAtoms;
    for (const Cylinder& piece : pieces) {
        EXPECT_NEAR(fromMiddle(scene, piece.a), 0.57 * 1.39, 1e-4);
        EXPECT_NEAR(piece.a.z, 0, 1e-5);
    }
    for (const CylinderLook& look : scene.cylinderLooks)
        if (look.atomA == look.atomB) ++ofAtoms[look.atomA];
    EXPECT_EQ(ofAtoms.size(), 6u);
    for (const auto& [atom, count] : ofAtoms) EXPECT_EQ(count, 4) << atom;
}

TEST(BondOrdersDrawn, ADoubleBondOfARingHasItsSecondLineInside) {
    Molecule ring = makeRing({2, 1, 1, 1, 1, 1}, 1.45);
    for (std::size_t i = 2; i < 6; ++i) ring.atoms[i].position.z = i % 2 ? 0.25f : -0.25f;  // no aromatic ring
    const Representation scene = drawnWith(ring, Style::licorice);
    const std::vector<Cylinder> thin = thinOnes(scene);
    ASSERT_EQ(thin.size(), 1u);
    EXPECT_LT(fromMiddle(scene, (thin[0].a + thin[0].b) / 2.0f), 1.45 * 0.866 - 0.3);
    EXPECT_EQ(thinOnes(drawnWith(ring, Style::licorice, BondOrders::off)).size(), 0u);
}

TEST(BondOrdersDrawn, CarboxylatesAreDelocalisedBetweenTheirOxygens) {
    const Molecule acetate = makeMolecule(
        {{kCarbon, {-1.5f, 0, 0}}, {kCarbon, {0, 0, 0}}, {kOxygen, {0.63f, 1.09f, 0}}, {kOxygen, {0.63f, -1.09f, 0}}},
        {{0, 1, 1}, {1, 2, 2}, {1, 3, 1}});
    const Representation scene = drawnWith(acetate, Style::licorice);
    const std::vector<Cylinder> dashes = thinOnes(scene);
    ASSERT_EQ(dashes.size(), 6u);
    const glm::vec3 carbon = glm::vec3(-scene.center);
    for (const Cylinder& dash : dashes) {
        EXPECT_NEAR(dash.a.z, 0, 1e-5);
        EXPECT_LT(std::abs(dash.a.y - carbon.y) / (dash.a.x - carbon.x), std::sqrt(3.0f));  // between the bonds
    }
}

TEST(BondOrdersDrawn, PolymersHaveTheirsInLicoriceIfAskedFor) {
    const Molecule dna = sampleMolecule("dna");
    const Representation plain = drawnWith(dna, Style::licorice);
    EXPECT_EQ(plain.cylinders.size(), plain.drawnBonds);
    const Representation all = drawnWith(dna, Style::licorice, BondOrders::on);
    EXPECT_GT(all.cylinders.size(), all.drawnBonds + 200);
    const Representation balls = drawnWith(dna, Style::ballAndStick);
    EXPECT_EQ(balls.cylinders.size(), balls.drawnBonds + 106);  // as their templates have them
}

TEST(BondOrdersDrawn, AreAsManyWhereAtomsMove) {
    Molecule benzene = makeRing({4, 4, 4, 4, 4, 4}, 1.39);
    MovingScene moving(benzene, drawnAtoms(benzene), {Style::licorice, ColorScheme::element});
    const std::size_t spheres = moving.scene().spheres.size(), sticks = moving.scene().cylinders.size();
    for (Atom& atom : benzene.atoms) atom.position *= 1.03f;
    moving.move(benzene);
    EXPECT_EQ(moving.scene().spheres.size(), spheres);
    EXPECT_EQ(moving.scene().cylinders.size(), sticks);
}

}  // namespace
}  // namespace nacre
