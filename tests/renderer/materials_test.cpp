// Materials: the formula of each on every path, of whole pictures and of parts.

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/scene/color/colors.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

constexpr Material kEach[] = {Material::matte, Material::plastic, Material::metal, Material::glow};

double linear(std::uint32_t byte) {
    const double c = (byte & 0xff) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Without occlusion or shadow.
glm::dvec3 lit(Material material, std::uint32_t color, const glm::dvec3& normal) {
    const glm::dvec3 base(linear(color), linear(color >> 8), linear(color >> 16));
    const glm::dvec3 light = glm::normalize(glm::dvec3(-0.35, 0.55, 0.76));
    const double facing = std::max(glm::dot(normal, glm::normalize(light + glm::dvec3(0, 0, 1))), 0.0);
    const glm::dvec3 around =
        glm::mix(glm::dvec3(0.54, 0.52, 0.52), glm::dvec3(0.70, 0.73, 0.77), 0.5 + 0.5 * normal.y);
    const glm::dvec3 arriving = around + 0.74 * std::max(glm::dot(normal, light), 0.0);
    switch (material) {
        case Material::matte:
            return base * arriving;
        case Material::plastic:
            return base * arriving + 0.16 * std::pow(facing, 42);
        case Material::metal:
            return base * (0.45 * arriving + 1.1 * std::pow(facing, 8));
        case Material::glow:
            return base * (0.95 + 0.75 * std::max(normal.z, 0.0));
    }
    return {};
}

/// A ball of each kind of a material's own, and one of the picture's.
Representation balls() {
    Representation r;
    r.ownMaterials = true;
    const auto add = [&](std::uint32_t color) {
        const auto number = static_cast<std::uint32_t>(r.spheres.size());
        r.spheres.push_back({{2.5f * static_cast<float>(number) - 5, 0, 0}, 1.2f});
        r.sphereLooks.push_back({color, number + 1});
    };
    add(0xff40a0e0u);
    for (const Material material : kEach) add(withMaterial(0xffd06020u, material));
    r.radius = 6.5;
    r.drawnAtoms = 5;
    r.atomGroups.resize(5);
    return r;
}

TEST(Materials, AreShadedByTheirFormulaOnEveryPath) {
    const Representation r = balls();
    RenderSettings s = settings(r, 200, Projection::orthographic, {0, 0, 0});
    for (const Material ofPicture : kEach) {
        s.effects.light.material = ofPicture;
        for (const Visibility path : devicePaths()) {
            ValidatedRenderer renderer(path, r);
            const LayerPicture p = renderer->layers(s);
            std::array<int, 5> judged{};
            double worst = 0;
            for (std::size_t i = 0; i < p.id.size(); ++i) {
                if (p.id[i] == 0) continue;
                const std::size_t ball = p.id[i] - 1;
                const glm::dvec3 normal(p.normal[3 * i], p.normal[3 * i + 1], p.normal[3 * i + 2]);
                const glm::dvec3 wanted =
                    lit(ball == 0 ? ofPicture : kEach[ball - 1], r.sphereLooks[ball].color, normal);
                for (int k = 0; k < 3; ++k)
                    worst = std::max(
                        worst, std::abs(wanted[k] - static_cast<double>(p.rgba[4 * i + static_cast<std::size_t>(k)])));
                ++judged[ball];
            }
            for (const int count : judged) EXPECT_GT(count, 500);
            EXPECT_LT(worst, 1e-3) << visibilityName(path) << ", material " << static_cast<int>(ofPicture);
        }
    }
}

TEST(Materials, MatteIsPlasticWithoutHighlight) {
    Representation r = scene("sample:dna", Style::ballAndStick);
    RenderSettings s = settings(r, 128, Projection::perspective);
    s.effects.shadow.strength = 0.5;
    s.occlusion.directions = 32;
    ValidatedRenderer renderer(Visibility::fragdepth, r);
    const std::vector<float> plastic = renderer->render(s).rgba;
    s.effects.light.material = Material::matte;
    const std::vector<float> matte = renderer->render(s).rgba;
    EXPECT_NE(matte, plastic);
    s.effects.light.material = Material::plastic;
    s.effects.light.highlight = 0;
    EXPECT_EQ(renderer->render(s).rgba, matte);
}

Rule show(const char* selection, Style style, std::optional<Material> material, std::optional<double> opacity = {}) {
    Rule rule;
    rule.selection = parseSelection(selection);
    rule.style = style;
    rule.material = material;
    rule.opacity = opacity;
    return rule;
}

TEST(Materials, OfPartsAreTheSameOnEveryPath) {
    const Molecule m = molecule("sample:dna");
    RepresentationOptions look{Style::ballAndStick, ColorScheme::element};
    look.rules = {show("chain A", Style::cartoon, Material::metal), show("resi 3-5", Style::licorice, Material::glow),
                  show("chain B and resi 15-18", Style::surface, Material::matte),
                  show("chain B and resi 19-24", Style::surface, {}, 0.5)};
    const Representation r = represent(m, drawnAtoms(m), look);
    ASSERT_TRUE(r.ownMaterials);
    RenderSettings s = settings(r, 160, Projection::perspective);
    s.effects.shadow.strength = 0.5;
    s.occlusion.directions = 16;
    PathRenderers renderers;
    const std::vector<float> parts = sameOnEveryPath(renderers, r, s).rgba;
    for (Rule& rule : look.rules) rule.material.reset();
    ValidatedRenderer& renderer = renderers[Visibility::tiles];
    const Representation plain = represent(m, drawnAtoms(m), look);
    EXPECT_FALSE(plain.ownMaterials);
    renderer->setScene(plain);
    std::size_t changed = 0;
    const std::vector<float> without = renderer->render(s).rgba;
    for (std::size_t i = 0; i < parts.size(); i += 4) changed += parts[i] != without[i];
    EXPECT_GT(changed, 1000u);
    EXPECT_LT(changed, parts.size() / 8) << "what has no material of its own keeps its bits";
}

// A copy's colour multiplies a tint, which may have a material, too.
TEST(Materials, OfCopiesInTheirColours) {
    Molecule m = molecule("sample:glucose");
    addCopies(m, {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}});
    RepresentationOptions look{.style = Style::spacefill, .color = ColorScheme::copy, .assembly = "1"};
    RenderSettings s = settings(represent(m, drawnAtoms(m), look), 128, Projection::orthographic);
    s.effects.light.material = Material::metal;
    PathRenderers renderers;
    const std::vector<float> whole = sameOnEveryPath(renderers, represent(m, drawnAtoms(m), look), s).rgba;
    s.effects.light.material = Material::plastic;
    look.rules = {show("all", Style::spacefill, Material::metal)};
    const std::vector<float> parts = sameOnEveryPath(renderers, represent(m, drawnAtoms(m), look), s).rgba;
    ASSERT_EQ(parts.size(), whole.size());
    double worst = 0;
    for (std::size_t i = 0; i < parts.size(); ++i)
        worst = std::max(worst, std::abs(static_cast<double>(parts[i]) - static_cast<double>(whole[i])));
    EXPECT_LT(worst, 0.01) << "a step of 8 bits: the material takes bits of the red";
}

}  // namespace
}  // namespace nacre::test
