#include "engine/scene/build/appearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/color/colors.h"
#include "engine/scene/color/palettes.h"
#include "tests/molecule/build_molecule.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

constexpr std::uint32_t kRed = packedColor(0xff0000), kBlue = packedColor(0x0000ff);

/// N-C-C in a row, 1.5 Å apart, and an oxygen far off.
Molecule row() {
    test::MoleculeText text;
    text.residue("GLY", 1).atom("N", "N", {0, 0, 0}).atom("CA", "C", {1.5f, 0, 0}).atom("C", "C", {3, 0, 0});
    text.residue("HOH", 2).atom("O", "O", {9, 0, 0});
    text.molecule.bonds = {{0, 1, 1, BondSource::file}, {1, 2, 2, BondSource::file}};
    return text.molecule;
}

std::vector<std::uint32_t> all(const Molecule& molecule) {
    std::vector<std::uint32_t> drawn(molecule.atoms.size());
    std::iota(drawn.begin(), drawn.end(), 0u);
    return drawn;
}

Rule show(const char* selection, Style style) { return {Rule::Action::show, parseSelection(selection), style, {}}; }
Rule hide(const char* selection) { return {Rule::Action::hide, parseSelection(selection), {}, {}}; }
Rule color(const char* selection, Coloring coloring) {
    return {Rule::Action::color, parseSelection(selection), {}, coloring};
}

Appearance appear(std::vector<Rule> rules, std::optional<Style> style = Style::spacefill) {
    const Molecule molecule = row();
    return makeAppearance(molecule, all(molecule), {style, ColorScheme::element, std::move(rules)});
}

TEST(Appearance, LaterRulesPrevail) {
    const Appearance a = appear({hide("elem C"), show("name CA", Style::licorice), show("elem N", Style::licorice),
                                 show("elem N", Style::ballAndStick), hide("water"),
                                 color("all", Coloring::uniform(kRed)), color("elem N", Coloring::uniform(kBlue))});
    EXPECT_EQ(a.atoms, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(a.styles, (std::vector<Style>{Style::ballAndStick, Style::licorice}));
    EXPECT_EQ(a.colors, (std::vector<std::uint32_t>{kBlue, kRed}));
    EXPECT_TRUE(a.warnings.empty());
    // The other way round.
    const Appearance b = appear({show("name CA", Style::licorice), hide("elem C"),
                                 color("elem N", Coloring::uniform(kBlue)), color("all", Coloring::uniform(kRed))});
    EXPECT_EQ(b.atoms, (std::vector<std::uint32_t>{0, 3}));
    EXPECT_EQ(b.colors, (std::vector<std::uint32_t>{kRed, kRed}));
}

TEST(Appearance, RulesChooseAmongTheDrawnAtoms) {
    const Molecule molecule = row();
    const std::vector<std::uint32_t> drawn = {0, 1, 2};
    const Appearance a =
        makeAppearance(molecule, drawn, {Style::spacefill, {}, {show("water", Style::licorice), hide("resn QQQ")}});
    EXPECT_EQ(a.atoms, drawn);
    ASSERT_EQ(a.warnings.size(), 2u);
    EXPECT_NE(a.warnings[0].find("'water' matches no atoms to show: those that it matches are not drawn"),
              std::string::npos);
    EXPECT_NE(a.warnings[1].find("'resn QQQ' matches no atoms to hide"), std::string::npos);
}

TEST(Appearance, WarningsCountWatersByTheirKind) {
    Molecule molecule = row();
    molecule.residues[1].name = Name("W");  // a Martini bead, or an entity of mmCIF
    molecule.residues[1].entityKind = EntityKind::water;
    const Appearance a =
        makeAppearance(molecule, drawnAtoms(molecule), {Style::spacefill, {}, {show("resn W", Style::licorice)}});
    ASSERT_EQ(a.warnings.size(), 1u);
    EXPECT_NE(a.warnings[0].find("1 in hidden waters"), std::string::npos) << a.warnings[0];
}

TEST(Appearance, LegendsNameWhatIsSeen) {
    const Appearance a = appear({color("name CA", Coloring::uniform(kRed)), hide("water"),
                                 color("elem N", Coloring::uniform(kRed)), color("elem N", ColorScheme::chain)});
    ASSERT_EQ(a.legends.size(), 3u);  // nothing is left of the third rule
    EXPECT_EQ(a.legends[0].selection, "all");
    EXPECT_EQ(a.legends[0].scheme, "element");
    ASSERT_EQ(a.legends[0].entries.size(), 1u);  // the oxygen is hidden, the nitrogen has another scheme
    EXPECT_EQ(a.legends[0].entries[0].label, "C");
    EXPECT_EQ(a.legends[0].entries[0].color, elementColor(6));
    EXPECT_EQ(a.legends[1].selection, "name CA");
    EXPECT_EQ(a.legends[1].scheme, "#ff0000");
    EXPECT_EQ(a.legends[2].scheme, "chain");
    EXPECT_EQ(a.legends[2].entries[0].label, "A");
}

TEST(Appearance, TheStyleForAllDependsOnWhatIsLeft) {
    EXPECT_EQ(appear({}, std::nullopt).styles[0], Style::ballAndStick);
    EXPECT_EQ(appear({hide("elem C")}, std::nullopt).styles[0], Style::spacefill);  // no bond is left
}

TEST(Appearance, HidingEverythingIsAnError) {
    const Molecule molecule = row();
    EXPECT_THROW(represent(molecule, all(molecule), {Style::spacefill, {}, {hide("all")}}), Error);
}

TEST(Appearance, ABondTakesTheStouterStyleOfItsAtoms) {
    const Molecule molecule = row();
    const auto cylinders = [&](std::vector<Rule> rules) {
        return represent(molecule, all(molecule), {Style::spacefill, ColorScheme::element, std::move(rules)}).cylinders;
    };
    EXPECT_EQ(cylinders({}).size(), 0u);
    const auto stick = cylinders({show("name N", Style::licorice)});
    ASSERT_EQ(stick.size(), 1u);  // from the stick's atom into the ball of the other
    EXPECT_FLOAT_EQ(stick[0].radius, 0.25f);
    const auto mixed = cylinders({show("name N", Style::licorice), show("elem C", Style::ballAndStick)});
    ASSERT_EQ(mixed.size(), 3u);  // one licorice, then the double bond's two strands
    EXPECT_FLOAT_EQ(mixed[0].radius, 0.25f);
    EXPECT_FLOAT_EQ(mixed[1].radius, 0.08f);
    const auto hidden = cylinders({show("all", Style::licorice), hide("name CA")});
    EXPECT_EQ(hidden.size(), 0u);
}

TEST(Appearance, HalvesOfABondHaveTheColoursOfTheirAtoms) {
    const Molecule molecule = row();
    const Representation scene =
        represent(molecule, all(molecule),
                  {Style::licorice, Coloring::uniform(kRed), {color("name CA", Coloring::uniform(kBlue))}});
    ASSERT_EQ(scene.cylinderLooks.size(), 2u);
    EXPECT_EQ(scene.cylinderLooks[0].colorA, kRed);
    EXPECT_EQ(scene.cylinderLooks[0].colorB, kBlue);
    EXPECT_EQ(scene.legends.size(), 2u);
}

TEST(Appearance, AChromophoreKeepsItsSticksBesideTheRibbon) {
    NACRE_NEEDS_DATA();
    const Molecule gfp = readMoleculeFile(test::dataFile("gfp-1ema.cif"));
    const Appearance a = makeAppearance(gfp, drawnAtoms(gfp), {Style::cartoon, ColorScheme::element, {}});
    std::size_t sticks = 0;
    for (std::size_t i = 0; i < a.atoms.size(); ++i) {
        EXPECT_EQ(gfp.residues[gfp.atoms[a.atoms[i]].residue].name, Name("CRO"));
        sticks += a.styles[i] == Style::licorice;
    }
    EXPECT_EQ(sticks, 22u);
    const auto inCartoon = std::ranges::count_if(
        a.cartoon.atoms, [&](std::uint32_t atom) { return gfp.residues[gfp.atoms[atom].residue].name == Name("CRO"); });
    EXPECT_EQ(inCartoon, 22);
    const Appearance hidden =
        makeAppearance(gfp, drawnAtoms(gfp), {Style::cartoon, ColorScheme::element, {hide("resn CRO")}});
    EXPECT_TRUE(hidden.atoms.empty());
    EXPECT_EQ(hidden.cartoon.atoms.size(), a.cartoon.atoms.size() - 22);
}

}  // namespace
}  // namespace nacre
