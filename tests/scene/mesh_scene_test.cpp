// Cartoons and surfaces among the styles of a representation.

#include "engine/scene/build/mesh_scene.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "engine/molecule/drawn_atoms.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/color/colors.h"
#include "tests/molecule/build_peptide.h"

namespace nacre {
namespace {

/// A helix of twelve residues, a ligand of two bonded atoms, and an ion.
Molecule complex() {
    Molecule molecule = test::buildChain(12, -57, -47);
    test::MoleculeText text;
    text.molecule = molecule;
    text.residue("LIG", 20).atom("C1", "C", {12, 0, 0}).atom("O1", "O", {13.2f, 0, 0});
    text.residue("ZN", 21).atom("ZN", "Zn", {0, 14, 0});
    molecule = text.molecule;
    molecule.bonds.push_back({48, 49});
    return molecule;
}

Rule showAs(const char* selection, Style style) { return {Rule::Action::show, parseSelection(selection), style, {}}; }
Rule hidden(const char* selection) { return {Rule::Action::hide, parseSelection(selection), {}, {}}; }

Appearance makeLooks(std::optional<Style> style, std::vector<Rule> rules = {}) {
    const Molecule molecule = complex();
    return makeAppearance(molecule, drawnAtoms(molecule), {style, ColorScheme::element, std::move(rules)});
}

TEST(MeshScene, ACartoonLeavesLigandsAsSticksAndIonsAsBalls) {
    const Appearance a = makeLooks(Style::cartoon);
    EXPECT_EQ(a.atoms, (std::vector<std::uint32_t>{48, 49, 50}));
    EXPECT_EQ(a.styles, (std::vector<Style>{Style::licorice, Style::licorice, Style::ballAndStick}));
    EXPECT_EQ(a.cartoon.atoms.size(), 48u);
    EXPECT_TRUE(a.surface.atoms.empty());
    EXPECT_EQ(a.seen, 51u);
}

TEST(MeshScene, RulesOfAtomsLeaveTheCartoon) {
    const Appearance a = makeLooks(Style::cartoon, {showAs("resi 5", Style::licorice)});
    EXPECT_EQ(a.atoms.size(), 4u + 3u);
    EXPECT_EQ(a.cartoon.atoms.size(), 48u);
    // A cartoon takes the place of atoms, a surface that of space-filling ones alone.
    const Appearance b =
        makeLooks(Style::licorice, {showAs("resi 5", Style::cartoon), showAs("resi 7", Style::surface)});
    EXPECT_EQ(b.atoms.size(), 51u - 4u);
    EXPECT_EQ(b.cartoon.atoms.size(), 4u);
    EXPECT_EQ(b.surface.atoms.size(), 4u);
    const Appearance c = makeLooks(Style::spacefill, {showAs("resi 7", Style::surface)});
    EXPECT_EQ(c.atoms.size(), 51u - 4u);
    const Appearance d =
        makeLooks(Style::spacefill, {showAs("resi 7", Style::surface), showAs("resi 7", Style::licorice)});
    EXPECT_EQ(d.atoms.size(), 51u);
    EXPECT_EQ(d.surface.atoms.size(), 4u);
}

TEST(MeshScene, WhatIsHiddenLosesAllAndComesBackAsItIsShown) {
    const Appearance a = makeLooks(Style::cartoon, {hidden("resi 5")});
    EXPECT_EQ(a.cartoon.atoms.size(), 44u);
    EXPECT_EQ(a.seen, 47u);
    const Appearance b = makeLooks(Style::cartoon, {hidden("resi 5"), showAs("resi 5", Style::licorice)});
    EXPECT_EQ(b.cartoon.atoms.size(), 44u);
    EXPECT_EQ(b.atoms.size(), 4u + 3u);
    const Appearance c = makeLooks(Style::spacefill, {hidden("resi 5"), showAs("resi 5", Style::surface)});
    EXPECT_EQ(c.atoms.size(), 47u);
    EXPECT_EQ(c.surface.atoms.size(), 4u);
}

Representation sceneOfComplex(Style style, Coloring coloring = ColorScheme::element) {
    const Molecule molecule = complex();
    return represent(molecule, drawnAtoms(molecule), {style, coloring, {}});
}

TEST(MeshScene, MeshesStandWithTheAtomsAndHaveTheirColours) {
    for (const Style style : {Style::cartoon, Style::surface}) {
        const Representation scene = sceneOfComplex(style, Coloring::uniform(packedColor(0x336699)));
        ASSERT_FALSE(scene.triangles.empty());
        EXPECT_EQ(scene.drawnAtoms, 51u);
        const Molecule molecule = complex();
        for (const Triangle& t : scene.triangles)
            for (const std::uint32_t v : {t.a, t.b, t.c}) {
                const MeshVertex& vertex = scene.meshVertices[v];
                const SphereLook& look = scene.meshLooks[vertex.look];
                EXPECT_EQ(look.color, packedColor(0x336699));
                const glm::dvec3 atom = glm::dvec3(molecule.atoms[look.atom - 1].position) - scene.center;
                ASSERT_LT(glm::length(glm::dvec3(decodePosition(vertex, t.step())) - atom), 4.0);
            }
        // The view holds all of it, and not much more.
        EXPECT_GE(scene.radius, meshReach(scene));
    }
    EXPECT_EQ(sceneOfComplex(Style::cartoon).spheres.size(), 3u);
    EXPECT_GE(sceneOfComplex(Style::cartoon).cylinders.size(), 1u);
    // The ligand stays beside a surface, as beside a cartoon.
    EXPECT_EQ(sceneOfComplex(Style::surface).spheres.size(), 3u);
}

TEST(MeshScene, WhatMovesKeepsItsFold) {
    Molecule molecule = complex();
    const std::vector<std::uint32_t> drawn = drawnAtoms(molecule);
    MovingScene moving(molecule, drawn, {Style::cartoon, ColorScheme::chain, {}});
    const std::size_t triangles = moving.scene().triangles.size();
    const double radius = moving.scene().radius;
    moving.move(molecule);
    EXPECT_EQ(moving.scene().triangles.size(), triangles);
    EXPECT_NEAR(moving.scene().radius, radius, 1e-3);
    // Turned peptide planes would be no helix any more; it stays one, with as many triangles.
    for (Atom& atom : molecule.atoms)
        if (atom.name == Name("O")) atom.position += glm::vec3(0, 0, 1);
    moving.move(molecule);
    EXPECT_EQ(moving.scene().triangles.size(), triangles);
}

TEST(MeshScene, CopiesOfAnAssemblyShareTheirTriangles) {
    Molecule molecule = complex();
    molecule.subchains = {"A", "B"};
    for (Residue& residue : molecule.residues) residue.subchain = residue.number >= 20 ? 1 : 0;
    AssemblyPart both{{glm::mat4x3(1.0f), glm::mat4x3(1.0f)}, {0}};
    both.transforms[1][3] = {40, 0, 0};
    AssemblyPart once{{glm::mat4x3(1.0f)}, {1}};
    molecule.assemblies.push_back({"1", "", {both, once}});
    RepresentationOptions options{Style::spacefill, ColorScheme::chain, {}};
    Rule all;
    all.selection = parseSelection("all");
    all.style = Style::surface;
    options.rules.push_back(all);
    options.assembly = "1";
    const Representation scene = represent(molecule, drawnAtoms(molecule), options);
    ASSERT_EQ(scene.copies.triangles.size(), 2u);
    std::size_t count = 0;
    for (const PrimitiveRun& run : scene.copies.triangles) {
        EXPECT_EQ(run.first, count);
        count += run.count;
        EXPECT_GT(run.radius, 1.5);
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            const Triangle& t = scene.triangles[i];
            const bool ligand = scene.meshLooks[scene.meshVertices[t.a].look].atom > 48;
            EXPECT_EQ(scene.copies.lists[run.list].size(), ligand ? 1u : 2u);
        }
    }
    EXPECT_EQ(count, scene.triangles.size());
    EXPECT_EQ(scene.drawnAtoms, 2u * 48u + 3u);
}

TEST(MeshScene, ModelsHaveTheirOwnTriangles) {
    Molecule molecule = complex();
    molecule.chains.push_back({"A", 2});
    for (std::size_t r = 6; r < 12; ++r) molecule.residues[r].chain = 1;
    const Representation scene = represent(molecule, drawnAtoms(molecule), {Style::cartoon, ColorScheme::chain, {}});
    ASSERT_EQ(scene.triangleModels.size(), 2u);
    EXPECT_EQ(scene.triangleModels[0].count + scene.triangleModels[1].count, scene.triangles.size());
    EXPECT_NE(scene.triangleModels[0].model, scene.triangleModels[1].model);
}

}  // namespace
}  // namespace nacre
