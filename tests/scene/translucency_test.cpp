// What of a scene one looks through.

#include "engine/scene/build/translucency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/scene/build/chunks.h"
#include "engine/scene/color/colors.h"
#include "tests/renderer/meshes.h"

namespace nacre::test {
namespace {

TEST(Opacity, GoesInStepsOfAHundredAndTwentyEighth) {
    for (const std::uint32_t color : {0xff123456u, copyTint(0, 1)}) {
        EXPECT_EQ(withOpacity(color, 1), color);
        EXPECT_TRUE(isOpaque(color));
        for (const double opacity : {0.0, 1.0 / 128, 0.25, 0.5, 0.75, 0.999}) {
            const std::uint32_t mixed = withOpacity(color, opacity);
            EXPECT_EQ(opacitySteps(mixed), std::max(5.0, std::round(opacity * 128)));
            EXPECT_EQ(isCopyTint(mixed), isCopyTint(color));
            EXPECT_EQ(mixed & 0xffffffu, color & 0xffffffu);
        }
        EXPECT_FALSE(isOpaque(withOpacity(color, 127.0 / 128)));
    }
}

Rule shown(const std::string& selection, Style style, std::optional<double> opacity) {
    Rule rule;
    rule.selection = parseSelection(selection);
    rule.style = style;
    rule.opacity = opacity;
    return rule;
}

TEST(Translucency, LayersPerLengthAreAreaByVolume) {
    Representation r;
    r.spheres = {{{0, 0, 0}, 2.0f}, {{0, 0, 0}, 1.0f}};
    r.sphereLooks = {{withOpacity(0xff123456u, 0.5), 1}, {0xff123456u, 2}};
    // The mean way through a ball is 4/3 of its radius.
    EXPECT_NEAR(layersPerLength(r, translucentParts(r)), 1 / (4.0 / 3 * 2), 1e-6);
    r.sphereLooks[1].color = r.sphereLooks[0].color;
    EXPECT_NEAR(layersPerLength(r, translucentParts(r)), (1 + 0.25) / (4.0 / 3 * 2), 1e-6);
    // A mesh about the ball is met twice where a ball shows its front alone.
    Representation mesh;
    appendMesh(
        icosphere({0, 0, 0}, 2, 5, 0), glm::dvec3(0),
        [](std::uint32_t) {
            return SphereLook{withOpacity(0xff123456u, 0.5), 1};
        },
        mesh);
    EXPECT_NEAR(layersPerLength(mesh, translucentParts(mesh)), 2 / (4.0 / 3 * 2), 2e-3);
    // Of a stick with flat ends, a quarter of its surface.
    Representation stick;
    stick.cylinders = {{{0, 0, -3}, 1, {0, 0, 3}, 0}};
    stick.cylinderLooks = {{withOpacity(0xff123456u, 0.5), withOpacity(0xff123456u, 0.5), 1, 2}};
    constexpr double kArea = 3.5 * std::numbers::pi, kVolume = std::numbers::pi / 6 * 2 * 2 * 8;
    EXPECT_NEAR(layersPerLength(stick, translucentParts(stick)), kArea / kVolume, 1e-6);
    EXPECT_EQ(layersPerLength({}, {}), 0);
}

TEST(Translucency, ComesFromARuleOrFromWhatIsForAll) {
    const Molecule dna = sampleMolecule("dna");
    RepresentationOptions look{.style = Style::cartoon};
    look.surface.resolution = 1;
    look.surfaceOpacity = 0.75;
    look.rules = {shown("chain A", Style::surface, 0.25), shown("chain B", Style::surface, {})};
    const Representation r = represent(dna, drawnAtoms(dna), look);
    const TranslucentRuns runs = translucentParts(r).triangles;
    ASSERT_EQ(runs.size(), 2u);
    // Of the one mesh, what is opaque first, then what hides more than a half; the cartoon stands before it, whole.
    EXPECT_EQ(runs[0].kind, Translucency::dense);
    EXPECT_EQ(runs[1].kind, Translucency::faint);
    EXPECT_GT(runs[0].first, 0u);
    EXPECT_EQ(runs[1].first, runs[0].first + runs[0].count);
    EXPECT_EQ(runs[1].first + runs[1].count, r.triangles.size());
    for (std::uint32_t i = 0; i < r.triangles.size(); ++i) {
        const Triangle& t = r.triangles[i];
        const bool opaque = i < runs[0].first, dense = i < runs[1].first;
        std::uint32_t most = 0;
        for (const std::uint32_t v : {t.a, t.b, t.c}) {
            const SphereLook& of = r.meshLooks[r.meshVertices[v].look];
            const bool a = dna.chains[dna.residues[dna.atoms[of.atom - 1].residue].chain].name == "A";
            ASSERT_EQ(opacitySteps(of.color), opaque ? 128u : a ? 32u : 96u);
            most = std::max(most, opacitySteps(of.color));
        }
        ASSERT_EQ(most > 64, dense);
    }
}

TEST(Translucency, OfAtomsIsOneRunBehindTheOpaqueOnes) {
    const Molecule dna = sampleMolecule("dna");
    RepresentationOptions look;
    look.style = Style::ballAndStick;
    look.atomOpacity = 0.25;
    look.rules = {shown("chain A", Style::licorice, 1.0)};
    Representation r = represent(dna, drawnAtoms(dna), look);
    const auto chainName = [&](std::uint32_t number) {
        return dna.chains[dna.residues[dna.atoms[number - 1].residue].chain].name;
    };
    orderInSpace(r);
    const TranslucentParts parts = translucentParts(r);
    ASSERT_EQ(parts.spheres.size(), 1u);
    ASSERT_EQ(parts.cylinders.size(), 1u);
    EXPECT_TRUE(parts.triangles.empty());
    EXPECT_EQ(parts.spheres[0].kind, Translucency::faint);
    EXPECT_EQ(parts.spheres[0].first + parts.spheres[0].count, r.spheres.size());
    for (std::uint32_t i = 0; i < r.spheres.size(); ++i) {
        const bool opaque = chainName(r.sphereLooks[i].atom) == "A";
        ASSERT_EQ(opacitySteps(r.sphereLooks[i].color), opaque ? 128u : 32u);
        ASSERT_EQ(i < parts.spheres[0].first, opaque);
    }
    // A stick has the opacity of the atom at each end.
    for (const CylinderLook& stick : r.cylinderLooks) {
        ASSERT_EQ(opacitySteps(stick.colorA), chainName(stick.atomA) == "A" ? 128u : 32u);
        ASSERT_EQ(opacitySteps(stick.colorB), chainName(stick.atomB) == "A" ? 128u : 32u);
    }
}

TEST(Translucency, IsNoneWhereAllIsOpaque) {
    const Molecule dna = sampleMolecule("dna");
    RepresentationOptions look{.style = Style::surface};
    look.surface.resolution = 1.2;
    EXPECT_TRUE(translucentParts(represent(dna, drawnAtoms(dna), look)).empty());
}

}  // namespace
}  // namespace nacre::test
