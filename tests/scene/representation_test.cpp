#include "engine/scene/build/representation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <set>

#include "engine/error.h"
#include "engine/molecule/element.h"
#include "engine/scene/build/bond_cylinders.h"
#include "engine/scene/color/colors.h"

namespace nacre {
namespace {

Molecule makeMolecule(std::initializer_list<std::pair<int, glm::vec3>> atoms,
                      std::initializer_list<std::array<int, 3>> bonds = {}) {
    Molecule molecule;
    molecule.chains.resize(1);
    molecule.residues.resize(1);
    for (const auto& [element, position] : atoms) {
        Atom atom;
        atom.element = static_cast<Element>(element);
        atom.position = position;
        molecule.atoms.push_back(atom);
    }
    for (const auto& [a, b, order] : bonds)
        molecule.bonds.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                                  static_cast<std::uint8_t>(order), BondSource::file});
    return molecule;
}

std::vector<std::uint32_t> everyAtom(const Molecule& molecule) {
    std::vector<std::uint32_t> drawn(molecule.atoms.size());
    std::iota(drawn.begin(), drawn.end(), 0u);
    return drawn;
}

// Formaldehyde in the plane z = 5, C=O along x.
Molecule formaldehyde() {
    return makeMolecule({{6, {10, 0, 5}}, {8, {11.2f, 0, 5}}, {1, {9.4f, 0.94f, 5}}, {1, {9.4f, -0.94f, 5}}},
                        {{0, 1, 2}, {0, 2, 1}, {0, 3, 1}});
}

TEST(Representation, SpacefillTakesVanDerWaalsRadiiAboutTheBoxMiddle) {
    const Molecule molecule = makeMolecule({{6, {100, 0, 0}}, {8, {104, 2, 0}}});
    const Representation scene = represent(molecule, everyAtom(molecule), {});
    EXPECT_EQ(scene.center, glm::dvec3(102, 1, 0));
    ASSERT_EQ(scene.spheres.size(), 2u);
    EXPECT_EQ(scene.spheres[0].center, glm::vec3(-2, -1, 0));
    EXPECT_FLOAT_EQ(scene.spheres[0].radius, 1.7f);
    EXPECT_FLOAT_EQ(scene.spheres[1].radius, 1.52f);
    EXPECT_NEAR(scene.radius, std::sqrt(5.0) + 1.7, 1e-6);
    EXPECT_TRUE(scene.cylinders.empty());
    EXPECT_EQ(scene.drawnBonds, 0u);
}

TEST(Representation, AtomIdIsThePositionInTheFile) {
    const Molecule molecule = formaldehyde();
    const std::vector<std::uint32_t> drawn = {1, 3};
    const Representation scene = represent(molecule, drawn, {Style::ballAndStick, ColorScheme::element});
    ASSERT_EQ(scene.sphereLooks.size(), 2u);
    EXPECT_EQ(scene.sphereLooks[0].atom, 2u);
    EXPECT_EQ(scene.sphereLooks[1].atom, 4u);
    EXPECT_TRUE(scene.cylinders.empty());  // no bond has both ends drawn
}

TEST(Representation, BallAndStickDrawsADoubleBondInTheMoleculesPlane) {
    const Molecule molecule = formaldehyde();
    const Representation scene = represent(molecule, everyAtom(molecule), {Style::ballAndStick, ColorScheme::element});
    EXPECT_FLOAT_EQ(scene.spheres[0].radius, 0.25f * 1.7f);
    ASSERT_EQ(scene.cylinders.size(), 4u);
    EXPECT_EQ(scene.drawnBonds, 3u);
    const Cylinder &one = scene.cylinders[0], &two = scene.cylinders[1];
    EXPECT_NEAR(one.a.z, 0.0f, 1e-5f);
    EXPECT_NEAR(two.a.z, 0.0f, 1e-5f);
    EXPECT_NEAR(one.a.y + two.a.y, 0.0f, 1e-5f);
    EXPECT_GT(glm::distance(one.a, two.a), one.radius + two.radius);  // a gap between the strands
    EXPECT_NEAR(glm::distance(one.a, one.b), 1.2f, 1e-5f);
    EXPECT_FLOAT_EQ(scene.cylinders[2].radius, 0.15f);
    EXPECT_EQ(scene.cylinderLooks[0].colorA, elementColor(6));
    EXPECT_EQ(scene.cylinderLooks[0].colorB, elementColor(8));
    EXPECT_EQ(scene.cylinderLooks[0].atomA, 1u);
    EXPECT_EQ(scene.cylinderLooks[0].atomB, 2u);
}

TEST(Representation, EveryStrandEndsInsideTheSmallestBall) {
    float smallest = 10;
    for (int element = 0; element <= 119; ++element)
        smallest = std::min(smallest, 0.25f * vanDerWaalsRadius(static_cast<Element>(element)));
    for (std::uint8_t order = 1; order <= 5; ++order) {
        const BondStrands strands = bondStrands(order);
        for (std::size_t i = 0; i < static_cast<std::size_t>(strands.count); ++i)
            EXPECT_LT(std::abs(strands.strands[i].offset) + strands.strands[i].radius, smallest);
        const BondStrands thick = licoriceStrands(order);
        for (std::size_t i = 0; i < static_cast<std::size_t>(thick.count); ++i)
            EXPECT_LE(std::abs(thick.strands[i].offset) + thick.strands[i].radius, static_cast<float>(Sizes{}.stick));
    }
}

TEST(Representation, LicoriceIsAQuarterAngstromThroughout) {
    const Molecule molecule = formaldehyde();
    RepresentationOptions options{Style::licorice, ColorScheme::element};
    options.bondOrders = BondOrders::off;
    const Representation scene = represent(molecule, everyAtom(molecule), options);
    ASSERT_EQ(scene.cylinders.size(), 3u);
    for (const Sphere& sphere : scene.spheres) EXPECT_FLOAT_EQ(sphere.radius, 0.25f);
    for (const Cylinder& cylinder : scene.cylinders) EXPECT_FLOAT_EQ(cylinder.radius, 0.25f);
}

TEST(Representation, CoordinationOfAMetalIsDashedInEveryStyleWithBonds) {
    const Molecule molecule = makeMolecule({{26, {0, 0, 0}}, {7, {2, 0, 0}}}, {{0, 1, 2}});
    for (const Style style : {Style::ballAndStick, Style::licorice}) {
        const Representation scene = represent(molecule, everyAtom(molecule), RepresentationOptions{.style = style});
        EXPECT_EQ(scene.drawnBonds, 1u);
        ASSERT_GE(scene.cylinders.size(), 3u);
        float from = scene.spheres[0].center.x + scene.spheres[0].radius;
        const float to = scene.spheres[1].center.x - scene.spheres[1].radius;
        const float gap = (to - from) / static_cast<float>(2 * scene.cylinders.size() + 1);
        for (const Cylinder& dash : scene.cylinders) {
            EXPECT_FLOAT_EQ(dash.radius, kDashRadius);
            EXPECT_NEAR(dash.a.x, from + gap, 1e-5f);
            EXPECT_NEAR(dash.b.x, from + 2 * gap, 1e-5f);
            from = dash.b.x;
        }
        EXPECT_EQ(scene.cylinderLooks.front().atomA, 1u);
        EXPECT_EQ(scene.cylinderLooks.front().atomB, 1u);
        EXPECT_EQ(scene.cylinderLooks.back().atomA, 2u);
        EXPECT_EQ(scene.cylinderLooks.back().atomB, 2u);
    }
}

TEST(Representation, BondsAmongMetalsAreSolidAndTouchingBallsNeedNoDash) {
    RepresentationOptions options{.style = Style::licorice};
    const Molecule gold = makeMolecule({{79, {0, 0, 0}}, {79, {2.9f, 0, 0}}}, {{0, 1, 1}});
    EXPECT_EQ(represent(gold, everyAtom(gold), options).cylinders.size(), 1u);
    const Molecule near = makeMolecule({{26, {0, 0, 0}}, {7, {0.4f, 0, 0}}}, {{0, 1, 1}});
    EXPECT_TRUE(represent(near, everyAtom(near), options).cylinders.empty());
    const Molecule far = makeMolecule({{26, {0, 0, 0}}, {7, {4000, 0, 0}}}, {{0, 1, 1}});
    EXPECT_EQ(represent(far, everyAtom(far), options).cylinders.size(), 16u);
}

TEST(Representation, BondsWithoutLengthAreLeftOut) {
    const Molecule molecule = makeMolecule({{6, {1, 1, 1}}, {6, {1, 1, 1}}}, {{0, 1, 2}});
    const Representation scene = represent(molecule, everyAtom(molecule), {Style::ballAndStick, ColorScheme::element});
    EXPECT_TRUE(scene.cylinders.empty());
    EXPECT_EQ(scene.drawnBonds, 0u);
}

TEST(Representation, ALonelyDoubleBondStillGetsASide) {
    for (const glm::vec3 way : {glm::vec3(1.2f, 0, 0), glm::vec3(0, 1.2f, 0), glm::vec3(0, 0, 1.2f)}) {
        const Molecule molecule = makeMolecule({{8, {0, 0, 0}}, {8, way}}, {{0, 1, 2}});
        const Representation scene =
            represent(molecule, everyAtom(molecule), {Style::ballAndStick, ColorScheme::element});
        ASSERT_EQ(scene.cylinders.size(), 2u);
        EXPECT_NEAR(glm::distance(scene.cylinders[0].a, scene.cylinders[1].a), 0.26f, 1e-5f);
        EXPECT_NEAR(glm::dot(scene.cylinders[1].a - scene.cylinders[0].a, way), 0.0f, 1e-5f);
    }
}

TEST(Representation, NothingDrawnIsAnError) { EXPECT_THROW(represent(formaldehyde(), {}, {}), Error); }

TEST(Representation, DefaultStyleNeedsBondsAndFewAtoms) {
    EXPECT_EQ(defaultStyle(formaldehyde(), everyAtom(formaldehyde())), Style::ballAndStick);
    const Molecule argon = makeMolecule({{18, {0, 0, 0}}});
    EXPECT_EQ(defaultStyle(argon, everyAtom(argon)), Style::spacefill);
    Molecule chain = formaldehyde();
    chain.atoms.resize(99);
    EXPECT_EQ(defaultStyle(chain, everyAtom(chain)), Style::ballAndStick);
    chain.atoms.resize(100);
    EXPECT_EQ(defaultStyle(chain, everyAtom(chain)), Style::spacefill);
    EXPECT_EQ(defaultStyle(chain, everyAtom(chain), Style::licorice), Style::licorice);
}

int channel(std::uint32_t color, int index) { return static_cast<int>(color >> (8 * index) & 0xff); }

TEST(Colors, ElementsKeepTheHuesThatChemistsKnow) {
    const std::uint32_t oxygen = elementColor(8), nitrogen = elementColor(7), sulphur = elementColor(16);
    EXPECT_GT(channel(oxygen, 0), channel(oxygen, 2) + 60);
    EXPECT_GT(channel(nitrogen, 2), channel(nitrogen, 0) + 60);
    EXPECT_GT(std::min(channel(sulphur, 0), channel(sulphur, 1)), channel(sulphur, 2) + 60);
    for (int i = 0; i < 3; ++i) EXPECT_GT(channel(elementColor(1), i), 220);
    EXPECT_LT(channel(elementColor(6), 0) - channel(elementColor(6), 2), 25);
}

TEST(Colors, EveryElementIsOpaqueAndNoneIsBlack) {
    std::set<std::uint32_t> different;
    for (int element = 0; element <= 119; ++element) {
        const std::uint32_t color = elementColor(static_cast<Element>(element));
        EXPECT_EQ(color >> 24, 255u);
        EXPECT_GT(channel(color, 0) + channel(color, 1) + channel(color, 2), 200) << element;
        different.insert(color);
    }
    EXPECT_GT(different.size(), 110u);
    EXPECT_EQ(elementColor(200), elementColor(0));
}

TEST(Colors, ChainsDifferAndRepeatAfterSixteen) {
    std::set<std::uint32_t> different;
    for (std::size_t i = 0; i < 16; ++i) different.insert(kindColor(i, kChainPalette));
    EXPECT_EQ(different.size(), 16u);
    EXPECT_EQ(kindColor(16, kChainPalette), kindColor(0, kChainPalette));
}

TEST(Colors, ResiduesByKind) {
    EXPECT_EQ(residueColor("DA"), residueColor("A"));
    EXPECT_EQ(residueColor("MSE"), residueColor("MET"));
    EXPECT_NE(residueColor("ASP"), residueColor("LYS"));
    EXPECT_EQ(residueColor(""), residueColor("XYZ"));
}

TEST(Colors, SchemesReachTheStreams) {
    Molecule molecule = makeMolecule({{6, {0, 0, 0}}, {6, {3, 0, 0}}});
    molecule.chains.resize(2);
    molecule.residues = {{Name("ASP"), 1, 0, '\0', {}, 0, 0}, {Name("LYS"), 2, 0, '\0', {}, 1, 0}};
    molecule.atoms[1].residue = 1;
    const auto byChain = represent(molecule, everyAtom(molecule), {Style::spacefill, ColorScheme::chain});
    EXPECT_EQ(byChain.sphereLooks[0].color, kindColor(0, kChainPalette));
    EXPECT_EQ(byChain.sphereLooks[1].color, kindColor(1, kChainPalette));
    const auto byResidue = represent(molecule, everyAtom(molecule), {Style::spacefill, ColorScheme::residue});
    EXPECT_EQ(byResidue.sphereLooks[0].color, residueColor("ASP"));
    EXPECT_EQ(byResidue.sphereLooks[1].color, residueColor("LYS"));
}

}  // namespace
}  // namespace nacre
