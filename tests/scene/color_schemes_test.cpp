#include "engine/scene/color_schemes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "engine/molecule/read.h"
#include "engine/scene/colors.h"
#include "engine/scene/palettes.h"
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
    EXPECT_EQ(labels(result), "0|0.25|0.5|0.75|1");
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
    EXPECT_EQ(labels(hydro), "ASP -3.5|LYS -3.9|ALA 1.8|HIP -3.2|ASH -3.5|not an amino acid|ILE 4.5|ARG -4.5|MSE 1.9");
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

double linear(std::uint32_t color, int channel) {
    const double coded = (color >> (8 * channel) & 0xff) / 255.0;
    return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}

/// What remains for people without the long-wave (red) cones or the middle-wave (green) ones: F. Viénot, H. Brettel,
/// J. D. Mollon, Color Res. Appl. 24 (1999) 243, in the linear-RGB form of that paper.
std::array<double, 3> seenWithout(bool red, std::uint32_t color) {
    const double r = linear(color, 0), g = linear(color, 1), b = linear(color, 2);
    const double l = 17.8824 * r + 43.5161 * g + 4.11935 * b, m = 3.45565 * r + 27.1554 * g + 3.86714 * b;
    const double s = 0.0299566 * r + 0.184309 * g + 1.46709 * b;
    return red ? std::array{2.02344 * m - 2.52581 * s, m, s} : std::array{l, 0.494207 * l + 1.24827 * s, s};
}

TEST(ColorSchemes, KindsStayApartForColourBlindPeople) {
    for (const bool red : {true, false})
        for (std::size_t i = 0; i < 7; ++i)
            for (std::size_t j = i + 1; j < 7; ++j) {
                const auto a = seenWithout(red, kindColor(i)), b = seenWithout(red, kindColor(j));
                double apart = 0;
                for (std::size_t k = 0; k < 3; ++k) apart = std::max(apart, std::abs(std::log(a[k] / b[k])));
                EXPECT_GT(apart, 0.2) << i << " and " << j;
            }
    std::set<std::uint32_t> different;
    for (std::size_t i = 0; i < 14; ++i) different.insert(kindColor(i));
    EXPECT_EQ(different.size(), 14u);
    EXPECT_EQ(kindColor(14), kindColor(0));
}

TEST(ColorSchemes, PalettesEndWhereTheyShould) {
    for (const Palette palette : {Palette::sunset, Palette::viridis, Palette::rainbow, Palette::lipophilicity}) {
        EXPECT_EQ(paletteColor(palette, -1), paletteColor(palette, 0));
        EXPECT_EQ(paletteColor(palette, 2), paletteColor(palette, 1));
        EXPECT_EQ(paletteColor(palette, std::nan("")), paletteColor(palette, 0));
        EXPECT_NE(paletteColor(palette, 0), paletteColor(palette, 1));
    }
    EXPECT_EQ(colorText(paletteColor(Palette::lipophilicity, 0.5)), "#ffffff");
    EXPECT_EQ(colorText(paletteColor(Palette::lipophilicity, 0.75)), "#dcc385");
}

}  // namespace
}  // namespace nacre
