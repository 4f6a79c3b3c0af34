// Lines, backbones and carbohydrates.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <set>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/scene/build/carbohydrates.h"
#include "engine/scene/build/representation.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

Representation drawn(const Molecule& m, Style style, Carbohydrates sugars = Carbohydrates::off) {
    return represent(m, drawnAtoms(m), RepresentationOptions{.style = style, .carbohydrates = sugars});
}

TEST(LineStyle, DrawsEachBondOnceInPixels) {
    const Molecule m = sampleMolecule("glucose");
    const Representation r = drawn(m, Style::line);
    EXPECT_TRUE(r.spheres.empty() && r.cylinders.empty() && r.triangles.empty());
    ASSERT_EQ(r.wires.size(), m.bonds.size());
    for (std::size_t i = 0; i < r.wires.size(); ++i) {
        EXPECT_EQ(r.wires[i].radius, -0.75f);
        const glm::dvec3 a = glm::dvec3(m.atoms[r.wireLooks[i].atomA - 1].position) - r.center;
        EXPECT_LT(glm::distance(a, glm::dvec3(r.wires[i].a)), 1e-5);
    }
    EXPECT_EQ(r.drawnAtoms, m.atoms.size());
}

TEST(LineStyle, HalvesBondsToOtherStylesAndCrossesLoneAtoms) {
    const Molecule m = sampleMolecule("glucose");
    RepresentationOptions look{.style = Style::ballAndStick};
    Rule rule;
    rule.selection = parseSelection("id 1");
    rule.style = Style::line;
    look.rules = {rule};
    const Representation r = represent(m, drawnAtoms(m), look);
    EXPECT_EQ(r.spheres.size(), m.atoms.size() - 1);
    std::size_t bonds = 0;
    for (const Bond& bond : m.bonds) bonds += bond.a == 0 || bond.b == 0;
    EXPECT_EQ(r.wires.size(), bonds);
    look.rules[0].selection = parseSelection("all");
    Molecule alone;
    alone.atoms = {m.atoms[0]};
    alone.residues = {m.residues[0]};
    alone.residues[0].atomCount = 1;
    alone.chains = m.chains;
    alone.subchains = m.subchains;
    EXPECT_EQ(represent(alone, drawnAtoms(alone), look).wires.size(), 6u);
}

TEST(LineStyle, CopiesOfAnAssemblyHaveLinesOfTheirOwn) {
    Molecule m = sampleMolecule("glucose");
    if (m.subchains.empty()) m.subchains = {"A"};
    m.assemblies = {{"1", "", {{}}}};
    m.assemblies[0].parts[0].subchains = {0};
    for (const float x : {0.0f, 20.0f}) {
        glm::mat4x3 transform(1.0f);
        transform[3].x = x;
        m.assemblies[0].parts[0].transforms.push_back(transform);
    }
    const Representation r = represent(m, drawnAtoms(m), RepresentationOptions{.style = Style::line, .assembly = "1"});
    EXPECT_EQ(r.wires.size(), 2 * m.bonds.size());
    EXPECT_GT(r.radius, 10);
}

TEST(BackboneStyle, GoesThroughAlphaCarbons) {
    NACRE_NEEDS_DATA();
    const Molecule m = readMoleculeFile(test::dataFile("1crn.pdb"));
    const Representation r = drawn(m, Style::backbone);
    ASSERT_EQ(r.spheres.size(), 46u);
    EXPECT_EQ(r.cylinders.size(), 45u);
    for (const SphereLook& look : r.sphereLooks) EXPECT_EQ(m.atoms[look.atom - 1].name.view(), "CA");
    for (const Cylinder& c : r.cylinders) EXPECT_NEAR(glm::distance(c.a, c.b), 3.8, 0.15);
}

TEST(BackboneStyle, LeavesLigandsLicoriceAndBreaksWhereTheChainDoes) {
    NACRE_NEEDS_DATA();
    const Molecule m = readMoleculeFile(test::dataFile("1hpv.pdb"));
    const Representation r = drawn(m, Style::backbone);
    std::set<std::uint32_t> guides, others;  // double bonds have round ends
    for (const SphereLook& look : r.sphereLooks) {
        const Atom& atom = m.atoms[look.atom - 1];
        const bool ligand = m.residues[atom.residue].name.view() == "478";
        (ligand ? others : guides).insert(look.atom);
        EXPECT_TRUE(ligand || atom.name.view() == "CA") << atom.name.view();
    }
    EXPECT_EQ(guides.size(), 198u);
    EXPECT_EQ(others.size(), 35u);
}

TEST(Sugars, HaveTheSymbolsOfTheStandard) {
    EXPECT_EQ(sugarSymbol(Name("NAG"))->name, "GlcNAc");
    EXPECT_EQ(sugarSymbol(Name("NAG"))->shape, SugarShape::cube);
    EXPECT_EQ(sugarSymbol(Name("BMA"))->shape, SugarShape::sphere);
    EXPECT_EQ(sugarSymbol(Name("BMA"))->color, sugarSymbol(Name("MAN"))->color);
    EXPECT_EQ(sugarSymbol(Name("FUC"))->shape, SugarShape::cone);
    EXPECT_EQ(sugarSymbol(Name("SIA"))->shape, SugarShape::diamond);
    EXPECT_EQ(sugarSymbol(Name("XYP"))->shape, SugarShape::star);
    EXPECT_EQ(sugarSymbol(Name("ALA")), nullptr);
}

/// Rows of the standard's table, www.ncbi.nlm.nih.gov/glycans/snfg.html, with a residue each.
TEST(Sugars, AgreeWithTheStandardsTable) {
    const struct {
        const char *residue, *sugar;
        SugarShape shape;
        std::uint32_t rgb;
    } kRows[] = {
        {"BGC", "Glc", SugarShape::sphere, 0x0090bc},         {"Z8H", "Gul", SugarShape::sphere, 0xf47920},
        {"LXB", "GulNAc", SugarShape::cube, 0xf47920},        {"YYQ", "GalNAc", SugarShape::cube, 0xffd400},
        {"95Z", "ManN", SugarShape::crossedCube, 0x00a651},   {"X1X", "TalA", SugarShape::dividedDiamond, 0x8fcce9},
        {"66O", "6dGul", SugarShape::cone, 0xf47920},         {"GYE", "Fuc", SugarShape::cone, 0xed1c24},
        {"Z9W", "QuiNAc", SugarShape::dividedCone, 0x0090bc}, {"PZU", "Par", SugarShape::flatRectangle, 0xf69ea1},
        {"Z3U", "Dig", SugarShape::flatRectangle, 0xa54399},  {"64K", "Ara", SugarShape::star, 0x00a651},
        {"NGC", "Neu5Gc", SugarShape::diamond, 0x8fcce9},     {"289", "DDmanHep", SugarShape::flatHexagon, 0xf69ea1},
        {"1S4", "Mur", SugarShape::flatHexagon, 0xa17a4d},    {"XXM", "Api", SugarShape::pentagon, 0x0090bc},
        {"LFR", "Fru", SugarShape::pentagon, 0x00a651},       {"TTV", "Psi", SugarShape::pentagon, 0xf69ea1},
    };
    for (const auto& row : kRows) {
        const SugarSymbol* symbol = sugarSymbol(Name(row.residue));
        ASSERT_NE(symbol, nullptr) << row.residue;
        EXPECT_EQ(symbol->name, row.sugar) << row.residue;
        EXPECT_EQ(symbol->shape, row.shape) << row.residue;
        EXPECT_EQ(symbol->color, packedColor(row.rgb)) << row.residue;
    }
}

TEST(Sugars, BesideACartoonAreSymbolsIfAskedFor) {
    NACRE_NEEDS_DATA();
    const Molecule m = readMoleculeFile(test::dataFile("1igy.pdb.gz"));
    const auto findSugars = [&](const Representation& r, bool meshes) {
        std::set<std::uint32_t> residues;
        const auto note = [&](std::uint32_t atom) {
            const std::uint32_t residue = m.atoms[atom - 1].residue;
            if (sugarSymbol(m.residues[residue].name)) residues.insert(residue);
        };
        if (meshes)
            for (const SphereLook& look : r.meshLooks) note(look.atom);
        else
            for (const SphereLook& look : r.sphereLooks) note(look.atom);
        return residues.size();
    };
    const Representation off = drawn(m, Style::cartoon), on = drawn(m, Style::cartoon, Carbohydrates::on),
                         icon = drawn(m, Style::cartoon, Carbohydrates::icon);
    EXPECT_GT(findSugars(off, false), 10u);
    EXPECT_EQ(findSugars(off, true), 0u);
    EXPECT_EQ(findSugars(on, false), 0u);
    EXPECT_EQ(findSugars(on, true), findSugars(off, false));
    EXPECT_EQ(findSugars(icon, false), findSugars(off, false));
    EXPECT_EQ(findSugars(icon, true), findSugars(off, false));
    bool blue = false;
    for (const SphereLook& look : on.meshLooks) blue = blue || look.color == sugarSymbol(Name("NAG"))->color;
    EXPECT_TRUE(blue);
}

/// What triangles enclose: positive if they face outwards.
double measureVolume(const Mesh& mesh) {
    double volume = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        volume += glm::dot(a, glm::cross(b, c)) / 6;
    }
    return volume;
}

TEST(Sugars, EverySymbolIsAClosedSolidThatFacesOutwards) {
    const Molecule glucose = sampleMolecule("glucose");
    std::vector<std::uint32_t> atoms;
    for (std::uint32_t i = 0; i < glucose.atoms.size(); ++i) atoms.push_back(i);
    for (const char* name : {"GLC", "NAG", "GCS", "BDP", "FUC", "49T", "DDA", "XYP", "SIA", "KDO", "FRU"}) {
        Molecule m = glucose;
        for (Residue& residue : m.residues) residue.name = Name(name);
        ASSERT_TRUE(isSugar(m, 0)) << name;
        const Mesh mesh = sugarSymbols(m, atoms, {}, glm::dvec3(m.atoms[0].position));
        EXPECT_GT(measureVolume(mesh), 2.0) << name;
        EXPECT_LT(measureVolume(mesh), 30.0) << name;
    }
}

TEST(Sugars, AreScaledAndMayHaveTheColorsOfTheirAtoms) {
    const Molecule glucose = sampleMolecule("glucose");
    std::vector<std::uint32_t> atoms;
    for (std::uint32_t i = 0; i < glucose.atoms.size(); ++i) atoms.push_back(i);
    const double plain = measureVolume(sugarSymbols(glucose, atoms, {}, {}));
    EXPECT_NEAR(measureVolume(sugarSymbols(glucose, atoms, {.scale = 2}, {})), 8 * plain, 0.01 * plain);
    const auto findColor = [&](bool symbols) {
        RepresentationOptions look;
        look.style = Style::carbohydrate;
        look.color = Coloring::uniform(packedColor(0xff0000));
        look.sugarColors = symbols;
        return represent(glucose, drawnAtoms(glucose), look).meshLooks.at(0).color;
    };
    EXPECT_EQ(findColor(true), sugarSymbol(glucose.residues[0].name)->color);
    EXPECT_EQ(findColor(false), packedColor(0xff0000));
}

}  // namespace
}  // namespace nacre
