#include "engine/scene/color/color_schemes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/color/colors.h"
#include "engine/scene/color/palettes.h"
#include "tests/molecule/build_molecule.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

ColoredAtoms colored(const Molecule& molecule, Coloring coloring) {
    std::vector<std::uint32_t> atoms(molecule.atoms.size());
    std::iota(atoms.begin(), atoms.end(), 0u);
    ColoredAtoms result = colorAtoms(molecule, atoms, coloring);
    EXPECT_EQ(result.colors.size(), atoms.size());
    return result;
}

std::string labels(const ColoredAtoms& result) {
    std::string text;
    for (const LegendEntry& entry : result.legend) text += (text.empty() ? "" : "|") + entry.label;
    return text;
}

Molecule bValues(std::initializer_list<float> values) {
    test::MoleculeText text;
    text.residue("ALA");
    for (const float value : values) {
        text.atom("C", "C", {0, 0, 0});
        text.molecule.atoms.back().temperatureFactor = value;
    }
    return text.molecule;
}

TEST(ColorSchemes, NamesGoBothWays) {
    for (int i = 0; i < static_cast<int>(ColorScheme::uniform); ++i) {
        const auto scheme = static_cast<ColorScheme>(i);
        EXPECT_EQ(colorSchemeFromName(colorSchemeName(scheme)), scheme) << i;
    }
    EXPECT_EQ(colorSchemeFromName("BFactor"), ColorScheme::bFactor);
    EXPECT_FALSE(colorSchemeFromName(""));
    EXPECT_FALSE(colorSchemeFromName("red"));
}

TEST(ColorSchemes, CarbonsAloneTakeAColourAndTheLegendSaysSo) {
    constexpr std::uint32_t kOrange = packedColor(0xffa500);
    test::MoleculeText text;
    text.residue("LIG").atom("C1", "C", {0, 0, 0}).atom("O1", "O", {2, 0, 0}).atom("FE", "Fe", {4, 0, 0});
    const Coloring coloring = Coloring::elementWithCarbons(kOrange);
    const ColoredAtoms result = colored(text.molecule, coloring);
    EXPECT_EQ(result.colors, (std::vector<std::uint32_t>{kOrange, elementColor(8), elementColor(26)}));
    ASSERT_EQ(labels(result), "C|O|Fe");
    EXPECT_EQ(result.legend[0].color, kOrange);
    EXPECT_EQ(coloringText(coloring), "element:#ffa500");
    EXPECT_EQ(coloringText(ColorScheme::element), "element");
    EXPECT_EQ(coloringText(Coloring::uniform(kOrange)), "#ffa500");
    EXPECT_EQ(colored(text.molecule, ColorScheme::element).colors[0], elementColor(6));
}

TEST(ColorSchemes, PlddtHasFourBandsInThePublishedColours) {
    const auto predicted = [](Molecule molecule) {
        molecule.file.confidence = true;
        return molecule;
    };
    const Molecule crystal = bValues({98, 90.01f, 90, 70, 69.9f, 50, 49.9f, 0});
    const ColoredAtoms result = colored(predicted(crystal), ColorScheme::plddt);
    const std::array<std::uint32_t, 4> bands = {packedColor(0x0053d6), packedColor(0x65cbf3), packedColor(0xffdb13),
                                                packedColor(0xff7d45)};
    const std::vector<std::uint32_t> expected = {bands[0], bands[0], bands[1], bands[1],
                                                 bands[2], bands[2], bands[3], bands[3]};
    EXPECT_EQ(result.colors, expected);
    EXPECT_EQ(result.legend.size(), 4u);
    EXPECT_EQ(result.warning, "");
    EXPECT_NE(colored(predicted(bValues({30, 140})), ColorScheme::plddt).warning, "");
    EXPECT_NE(colored(predicted(bValues({0.3f, 0.9f})), ColorScheme::plddt).warning, "");
    EXPECT_NE(colored(crystal, ColorScheme::plddt).warning.find("does not say that it is a prediction"),
              std::string::npos);
}

TEST(ColorSchemes, BFactorSpreadsFromLowToHighAndOneOutlierDoesNotSpoilIt) {
    Molecule molecule = bValues({});
    for (int i = 0; i <= 100; ++i) {
        molecule.atoms.push_back({});
        molecule.atoms.back().temperatureFactor = static_cast<float>(i == 100 ? 9999 : i);
    }
    const ColoredAtoms result = colored(molecule, ColorScheme::bFactor);
    EXPECT_EQ(result.colors.front(), paletteColor(Palette::sunset, 0));
    EXPECT_EQ(result.colors[50], paletteColor(Palette::sunset, 0.5));
    EXPECT_EQ(result.colors.back(), paletteColor(Palette::sunset, 1));
    EXPECT_EQ(labels(result), "2 or less|26|50|74|98 or more");
    const ColoredAtoms flat = colored(bValues({5, 5, 5}), ColorScheme::bFactor);
    EXPECT_EQ(labels(flat), "5");
    EXPECT_NE(flat.warning, "");
}

TEST(ColorSchemes, OccupancyGoesFromZeroToOne) {
    Molecule molecule = bValues({0, 0, 0});
    molecule.atoms[0].occupancy = 0;
    molecule.atoms[1].occupancy = 0.25f;
    const ColoredAtoms result = colored(molecule, ColorScheme::occupancy);
    EXPECT_EQ(colorText(result.colors[0]), "#440154");
    EXPECT_EQ(colorText(result.colors[1]), "#3b528b");
    EXPECT_EQ(colorText(result.colors[2]), "#fde725");
    EXPECT_EQ(labels(result), "0.00|0.25|0.50|0.75|1.00");
}

TEST(ColorSchemes, DistanceIsFromTheCentreOfTheAtoms) {
    test::MoleculeText text;
    text.residue("LIG").atom("C1", "C", {-3, 0, 0}).atom("C2", "C", {0, 0, 0}).atom("C3", "C", {3, 0, 0});
    const ColoredAtoms result = colored(text.molecule, ColorScheme::distance);
    EXPECT_EQ(result.colors[0], paletteColor(Palette::viridis, 1));
    EXPECT_EQ(result.colors[1], paletteColor(Palette::viridis, 0));
    EXPECT_EQ(result.colors[2], result.colors[0]);
}

TEST(ColorSchemes, PartialChargesHaveZeroInTheMiddle) {
    test::MoleculeText text;
    text.residue("LIG").atom("C1", "C", {-3, 0, 0}).atom("O2", "O", {0, 0, 0}).atom("C3", "C", {3, 0, 0});
    EXPECT_EQ(colored(text.molecule, ColorScheme::charge).stops, 0u);  // by residue, and formal charges
    text.molecule.partialCharges = {0, -0.8f, 0.4f};
    const ColoredAtoms result = colored(text.molecule, ColorScheme::charge);
    EXPECT_EQ(result.warning, "");
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(result.colors[i], paletteColor(Palette::redWhiteBlue, std::array{0.5, 0.0, 0.75}[i])) << i;
    EXPECT_EQ(labels(result), "-0.8|-0.4|0.0|0.4|0.8");
    Coloring narrow = ColorScheme::charge;
    narrow.range = ColorRange{-0.5, 0.5};
    EXPECT_EQ(labels(colored(text.molecule, narrow)), "-0.50 or less|-0.25|0.00|0.25|0.50");
}

TEST(ColorSchemes, RainbowRunsAlongEachChain) {
    test::MoleculeText text;
    for (const int number : {1, 2, 3}) text.residue("ALA", number).atom("CA", "C", {0, 0, 0});
    text.residue("HEM", 4).atom("FE", "FE", {0, 0, 0});
    text.residue("ALA", 1).atom("CA", "C", {0, 0, 0});
    text.molecule.chains.push_back({"B"});
    text.molecule.residues[4].chain = 1;
    const ColoredAtoms result = colored(text.molecule, ColorScheme::rainbow);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(result.colors[static_cast<std::size_t>(i)], paletteColor(Palette::rainbow, i / 2.0));
    EXPECT_EQ(result.colors[4], result.colors[0]);
    EXPECT_EQ(result.legend.back().label, "not in a chain");
    EXPECT_EQ(result.legend.back().color, result.colors[3]);
    EXPECT_NE(colored(sampleMolecule("buckyball"), ColorScheme::rainbow).warning, "");
}

TEST(ColorSchemes, ChargeAndHydrophobicityOfResidues) {
    test::MoleculeText text;
    for (const char* name : {"ASP", "LYS", "ALA", "HIP", "ASH", "DA", "ILE", "ARG", "MSE"})
        text.residue(name).atom("C", "C", {0, 0, 0});
    text.residue("ZN").atom("ZN", "ZN", {0, 0, 0});
    text.residue("CL").atom("CL", "CL", {0, 0, 0});
    text.residue("LIG").atom("N1", "N", {0, 0, 0});
    text.molecule.atoms.back().charge = 1;
    const ColoredAtoms charge = colored(text.molecule, ColorScheme::charge);
    const std::uint32_t minus = charge.colors[0], plus = charge.colors[1], none = charge.colors[2];
    EXPECT_EQ(charge.colors,
              (std::vector<std::uint32_t>{minus, plus, none, plus, none, minus, none, plus, none, plus, minus, plus}));
    EXPECT_EQ(labels(charge), "negative|neutral|positive");
    const ColoredAtoms hydro = colored(text.molecule, ColorScheme::hydrophobicity);
    EXPECT_EQ(hydro.colors[6], paletteColor(Palette::lipophilicity, 1));
    EXPECT_EQ(hydro.colors[7], paletteColor(Palette::lipophilicity, 0));
    EXPECT_EQ(labels(hydro), "-4.50|-2.25|0.00|2.25|4.50|not an amino acid");
}

TEST(ColorSchemes, SecondaryStructureOfCrambin) {
    EXPECT_NE(colored(sampleMolecule("dna"), ColorScheme::secondaryStructure).warning, "");
    NACRE_NEEDS_DATA();
    const ColoredAtoms result = colored(readMoleculeFile(test::dataFile("1crn.pdb")), ColorScheme::secondaryStructure);
    EXPECT_EQ(labels(result), "helix|strand|other protein");
    EXPECT_EQ(result.warning, "");
    EXPECT_EQ(result.colors.front(), result.legend[1].color);  // THR 1 is in a strand
}

TEST(ColorSchemes, EntitiesOfHaemoglobin) {
    NACRE_NEEDS_DATA();
    const ColoredAtoms bySequence = colored(readMoleculeFile(test::dataFile("4hhb.pdb")), ColorScheme::entity);
    EXPECT_EQ(labels(bySequence), "chains A, C|chains B, D|HEM|PO4|water");
    const ColoredAtoms stated = colored(readMoleculeFile(test::dataFile("4hhb.cif.gz")), ColorScheme::entity);
    EXPECT_EQ(stated.legend.size(), 5u);
    EXPECT_EQ(stated.legend[0].label, "1");
}

TEST(ColorSchemes, ChainsResiduesAndOneColour) {
    const Molecule dna = sampleMolecule("dna");
    EXPECT_EQ(labels(colored(dna, ColorScheme::chain)), "A|B");
    EXPECT_EQ(colored(dna, ColorScheme::residue).colors[0], residueColor(dna.residues[0].name.view()));
    const ColoredAtoms one = colored(dna, Coloring::uniform(packedColor(0x123456)));
    EXPECT_EQ(labels(one), "#123456");
    EXPECT_EQ(one.colors.back(), packedColor(0x123456));
}

/// Two molecules of one residue each, chain A.
Molecule twoInputs() {
    test::MoleculeText text;
    text.residue("ALA").atom("CA", "C", {0, 0, 0}).atom("N", "N", {2, 0, 0}).residue("ALA").atom("CA", "C", {9, 0, 0});
    text.molecule.chains.push_back({"A", 2});
    text.molecule.residues[1].chain = 1;
    text.molecule.modelsAreInputs = true;
    text.molecule.inputs = {"apo", "holo"};
    return text.molecule;
}

TEST(ColorSchemes, InputsAreToldApart) {
    const ColoredAtoms inputs = colored(twoInputs(), ColorScheme::input);
    EXPECT_EQ(labels(inputs), "apo|holo");
    EXPECT_EQ(inputs.colors[0], inputs.colors[1]);
    EXPECT_NE(inputs.colors[0], inputs.colors[2]);
    // So are their chains, which models of one file share.
    for (const ColorScheme scheme : {ColorScheme::chain, ColorScheme::chainCarbons}) {
        const ColoredAtoms chains = colored(twoInputs(), scheme);
        EXPECT_NE(chains.colors[0], chains.colors[2]);
    }
    EXPECT_EQ(labels(colored(twoInputs(), ColorScheme::chain)), "A of apo|A of holo");
    Molecule models = twoInputs();
    models.modelsAreInputs = false;
    models.inputs.clear();
    EXPECT_EQ(labels(colored(models, ColorScheme::chain)), "A");
    EXPECT_NE(colored(models, ColorScheme::input).warning, "");
}

TEST(ColorSchemes, AChainWithoutANameIsNamedByItsResidues) {
    const auto legendLabel = [](std::initializer_list<const char*> residues) {
        test::MoleculeText text;
        for (const char* name : residues) text.residue(name).atom("C", "C", {0, 0, 0});
        text.molecule.chains[0].name.clear();
        return labels(colored(text.molecule, ColorScheme::chainCarbons));
    };
    EXPECT_EQ(legendLabel({"478"}), "C of 478");
    EXPECT_EQ(legendLabel({"HOH", "478", "HOH"}), "C of 478");
    EXPECT_EQ(legendLabel({"478", "CLX"}), "C of ligand");
    EXPECT_EQ(legendLabel({""}), "C of ligand");
    EXPECT_EQ(legendLabel({"ALA", "GLY"}), "C of protein");
}

TEST(ColorSchemes, ALegendListsWhatIsDrawn) {
    const Molecule dna = sampleMolecule("dna");
    const auto listLabels = [&](Style style) {
        std::string text;
        for (const Legend& legend : represent(dna, drawnAtoms(dna), {style, ColorScheme::chainCarbons}).legends)
            for (const LegendEntry& entry : legend.entries) text += entry.label + "|";
        return text;
    };
    EXPECT_EQ(listLabels(Style::spacefill), "C of chain A|C of chain B|N|O|P|");
    EXPECT_EQ(listLabels(Style::cartoon), "C of chain A|C of chain B|");
}

TEST(ColorSchemes, ASurfaceOverACartoonHasItsColours) {
    const Molecule dna = sampleMolecule("dna");
    Rule surface;
    surface.style = Style::surface;
    surface.selection = parseSelection("all");
    const auto schemeColors = [&](std::optional<ColorScheme> told) {
        RepresentationOptions options{Style::cartoon, ColorScheme::chainCarbons, {surface}};
        if (told) {
            Rule color;
            color.action = Rule::Action::color;
            color.selection = parseSelection("all");
            color.coloring = *told;
            options.rules.push_back(color);
        }
        const std::vector<std::uint32_t> drawn = drawnAtoms(dna);
        const MeshAtoms seen = makeAppearance(dna, drawn, options).surface;
        return std::set<std::uint32_t>(seen.colors.begin(), seen.colors.end());
    };
    EXPECT_EQ(schemeColors(std::nullopt),
              (std::set<std::uint32_t>{kindColor(0, kChainPalette), kindColor(1, kChainPalette)}));
    EXPECT_EQ(schemeColors(ColorScheme::element).size(), 4u);
}

TEST(ColorSchemes, CarbonsByChainAndTheRestByElement) {
    const Molecule dna = sampleMolecule("dna");
    const ColoredAtoms result = colored(dna, ColorScheme::chainCarbons);
    const ColoredAtoms chains = colored(dna, ColorScheme::chain), elements = colored(dna, ColorScheme::element);
    for (std::size_t i = 0; i < dna.atoms.size(); ++i)
        ASSERT_EQ(result.colors[i], dna.atoms[i].element == 6 ? chains.colors[i] : elements.colors[i]) << i;
    EXPECT_EQ(labels(result), "C of chain A|C of chain B|N|O|P");
}

TEST(ColorSchemes, CarbonsOfALigandAreToldFromThoseOfItsChain) {
    test::MoleculeText text;
    text.residue("ALA").atom("CA", "C", {0, 0, 0}).atom("N", "N", {1.5, 0, 0});
    text.residue("MK1").atom("C1", "C", {9, 0, 0});
    const ColoredAtoms result = colored(text.molecule, ColorScheme::chainCarbons);
    EXPECT_EQ(result.colors[0], kindColor(0, kChainPalette));
    EXPECT_EQ(result.colors[2], elementColor(6));
    EXPECT_EQ(labels(result), "C of chain A|C of ligands|N");
    // Without a polymer there is no chain to be told from.
    test::MoleculeText alone;
    alone.residue("MK1").atom("C1", "C", {9, 0, 0});
    EXPECT_EQ(colored(alone.molecule, ColorScheme::chainCarbons).colors[0], kindColor(0, kChainPalette));
}

TEST(ColorSchemes, RangesAndPalettesAreThoseAskedFor) {
    const Molecule molecule = bValues({0, 10, 35, 60, 99});
    Coloring coloring(ColorScheme::bFactor);
    coloring.range = ColorRange{10, 60};
    coloring.palette = Palette::viridis;
    EXPECT_EQ(coloringText(coloring), "b-factor:10..60:viridis");
    const ColoredAtoms result = colored(molecule, coloring);
    const double places[] = {0, 0, 0.5, 1, 1};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(result.colors[i], paletteColor(Palette::viridis, places[i]));
    EXPECT_EQ(labels(result), "10.0 or less|22.5|35.0|47.5|60.0 or more");
    EXPECT_EQ(result.stops, 5u);
    coloring.range = ColorRange{60, 10};  // the other way round
    EXPECT_EQ(colored(molecule, coloring).colors[4], paletteColor(Palette::viridis, 0));
    EXPECT_EQ(labels(colored(molecule, coloring)), "60.0 or more|47.5|35.0|22.5|10.0 or less");
    coloring.range = ColorRange{-5, 99};  // nothing lies beyond
    EXPECT_EQ(labels(colored(molecule, coloring)).find("or"), std::string::npos);
    Coloring chain(ColorScheme::chain);
    chain.palette = Palette::muted;
    EXPECT_EQ(colored(sampleMolecule("dna"), chain).colors[0], kindColor(0, Palette::muted));
}

TEST(ColorSchemes, CopiesOfAnAssemblyTakeTheirColoursInTurn) {
    Molecule m = sampleMolecule("glucose");
    m.subchains = {"A"};
    AssemblyPart part{{}, {0}};
    for (int i = 0; i < 20; ++i) {
        glm::mat4x3 place(1.0f);
        place[3] = {20.0f * static_cast<float>(i), 0, 0};
        part.transforms.push_back(place);
    }
    m.assemblies = {{"1", "", {part}}};
    std::vector<std::uint32_t> atoms(m.atoms.size());
    std::iota(atoms.begin(), atoms.end(), 0u);
    RepresentationOptions options{.color = ColorScheme::copy};
    const Representation alone = represent(m, atoms, options);
    EXPECT_EQ(alone.sphereLooks[0].color, kindColor(0, kChainPalette));
    EXPECT_NE(alone.warnings.at(0).find("--assembly"), std::string::npos);
    options.assembly = "1";
    options.palette = Palette::bright;
    const Representation r = represent(m, atoms, options);
    ASSERT_EQ(r.copies.colors.size(), 14u);
    EXPECT_EQ(r.copies.colors[3], kindColor(3, Palette::bright));
    for (const SphereLook& look : r.sphereLooks) EXPECT_TRUE(isCopyTint(look.color));
    EXPECT_EQ(r.legends.at(0).scheme, "copy:bright");
    EXPECT_EQ(r.legends[0].entries.at(0).label, "20 copies in 14 colours");
    for (const SphereLook& look : r.sphereLooks) EXPECT_EQ(tintedColor(0xff336699u, look.color), 0xff336699u);
    // Nobody is lost, and neighbours differ.
    std::set<int> places;
    for (std::size_t i = 0; i < 20; ++i) {
        places.insert(static_cast<int>(std::lround(r.copies.transforms[i][3].x / 20)));
        for (std::size_t j = 0; j < i; ++j)
            if (i % 14 == j % 14) {
                EXPECT_GT(std::abs(r.copies.transforms[i][3].x - r.copies.transforms[j][3].x), 30);
            }
    }
    EXPECT_EQ(places.size(), 20u);
}

TEST(ColorSchemes, ChainsOfACopyAreTintsOfItsColour) {
    Molecule m = sampleMolecule("dna");
    m.subchains = {"A", "B"};
    for (Residue& residue : m.residues) residue.subchain = residue.chain;
    AssemblyPart part{{glm::mat4x3(1.0f), glm::mat4x3(1.0f)}, {0, 1}};
    part.transforms[1][3] = {60, 0, 0};
    m.assemblies = {{"1", "", {part}}};
    std::vector<std::uint32_t> atoms(m.atoms.size());
    std::iota(atoms.begin(), atoms.end(), 0u);
    RepresentationOptions options{.color = ColorScheme::copyChain, .assembly = "1"};
    const Representation r = represent(m, atoms, options);
    EXPECT_EQ(r.copies.colors.size(), 2u);
    for (const SphereLook& look : r.sphereLooks)
        EXPECT_EQ(look.color, copyTint(m.residues[m.atoms[look.atom - 1].residue].chain, 2));
    ASSERT_EQ(r.legends.at(0).entries.size(), 4u);  // two copies, two chains
    EXPECT_EQ(r.legends[0].entries[3].label, "chain B");
    EXPECT_EQ(r.legends[0].entries[3].color, tintedColor(kindColor(0, kChainPalette), copyTint(1, 2)));
    // Alone, a molecule shows the tints of its one copy.
    options.assembly.clear();
    const Representation alone = represent(m, atoms, options);
    EXPECT_EQ(alone.sphereLooks.front().color, kindColor(0, kChainPalette));
    EXPECT_EQ(alone.sphereLooks.back().color, tintedColor(kindColor(0, kChainPalette), copyTint(1, 2)));
    // Both strands are one kind of molecule.
    options.color = ColorScheme::copyEntity;
    EXPECT_LE(represent(m, atoms, options).legends.at(0).entries.size(), 3u);
    EXPECT_EQ(tintedColor(0xffffffffu, 0xfe808080u), 0xff808080u);
}

}  // namespace
}  // namespace nacre
