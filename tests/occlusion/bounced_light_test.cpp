// Light in clefts, against paths that bounce from surface to surface.

#include <glm/geometric.hpp>
#include <iostream>

#include "shaders/common/layout.h"
#include "tests/occlusion/traced_light.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

/// One sample a pixel, linear, with all light but the highlight's from the sky.
struct Pictures {
    LayerPicture layers;
    std::vector<float> drawn, open, base;  // as drawn, without occlusion, without light
};
Pictures renderPictures(const Lit& lit, const Light& light) {
    RenderSettings s = lit.settings;
    s.fine = true;
    s.occlusion.directions = 128;
    s.effects.light = light;
    ValidatedRenderer renderer(Visibility::automatic, lit.scene);
    Pictures p{renderer->layers(s), renderer->render(s).rgba, {}, {}};
    s.effects.light.occlusion = 0;
    p.open = renderer->render(s).rgba;
    s.lighting = false;
    p.base = renderer->render(s).rgba;
    return p;
}

glm::dvec3 readPixel(const std::vector<float>& rgba, std::size_t i) {
    return {rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]};
}

class BouncedLight : public testing::TestWithParam<const char*> {
protected:
    static Lit lit() {
        const std::string name = GetParam();
        if (name == "Well") return well();
        if (name == "DnaSpheres") return dna();
        return name == "DnaCartoon" ? dnaCartoon() : pocket(ColorScheme::element);
    }
};

/// Root mean square of what is drawn less what paths find, and of what was drawn before light bounced.
struct Errors {
    SquaredErrors drawn, before;
};
Errors measureErrors(const Lit& scene, const Light& light, const reference::Sky& sky) {
    const Pictures p = renderPictures(scene, light);
    const TracedLight truth = traceLight(scene, p.layers, sky);
    Errors errors;
    for (std::size_t k = 0; k < truth.pixels.size(); ++k) {
        const double open = p.layers.occlusion[truth.pixels[k]];
        for (int c = 0; c < 3; ++c) {
            const std::size_t at = 4 * std::size_t{truth.pixels[k]} + c;
            errors.drawn.add(p.drawn[at] - truth.light[k][c]);
            errors.before.add(p.open[at] * open * (0.45 * open + 0.55) - truth.light[k][c]);
        }
    }
    std::cout << "RMS " << errors.drawn.rms() << ", before " << errors.before.rms() << "\n";
    return errors;
}

TEST_P(BouncedLight, IsNearPaths) {
    if (GetParam() == std::string("Pocket")) NACRE_NEEDS_DATA("1hpv.pdb");
    const Lit scene = lit();
    const Errors errors = measureErrors(scene, ambientAlone(), sky());
    EXPECT_LT(errors.drawn.rms(), 0.025);
    EXPECT_LT(errors.drawn.rms(), 0.6 * errors.before.rms());
}

/// Pictures have no shadows unless asked: so far they cannot be right.
TEST_P(BouncedLight, IsNearerToPathsWithDirectLight) {
    if (GetParam() == std::string("Pocket")) NACRE_NEEDS_DATA("1hpv.pdb");
    reference::Sky withSun = sky();
    withSun.sun = glm::dvec3(0.74);
    withSun.toSun = glm::normalize(glm::dvec3(layout::kLightX, layout::kLightY, layout::kLightZ));
    const Errors errors = measureErrors(lit(), Light{.highlight = 0}, withSun);
    EXPECT_LT(errors.drawn.rms(), 0.95 * errors.before.rms());
}

TEST_P(BouncedLight, LeavesNoPlaceBlack) {
    if (GetParam() == std::string("Pocket")) NACRE_NEEDS_DATA("1hpv.pdb");
    const Pictures p = renderPictures(lit(), Light());
    for (std::size_t i = 0; i < p.layers.id.size(); ++i)
        for (std::size_t c = 4 * i; p.layers.id[i] && c < 4 * i + 3; ++c)
            ASSERT_GE(p.drawn[c], 0.04f * p.base[c]) << i % p.layers.width << ", " << i / p.layers.width;
}

INSTANTIATE_TEST_SUITE_P(Scenes, BouncedLight, testing::Values("Well", "DnaSpheres", "DnaCartoon", "Pocket"),
                         [](const auto& test) { return std::string(test.param); });

TEST(BouncedLightInTheDark, RunsIntoTheLeastWithoutABorder) {
    const Pictures p = renderPictures(well(), ambientAlone());
    std::size_t closed = 0, nearlyClosed = 0;
    for (std::size_t i = 0; i < p.layers.id.size(); ++i) {
        const float open = p.layers.occlusion[i];
        if (!p.layers.id[i] || open > 0.03f) continue;
        ++(open == 0 ? closed : nearlyClosed);
        const glm::dvec3 base = readPixel(p.base, i), drawn = readPixel(p.drawn, i);
        const double albedo = (base.x + base.y + base.z) / 3;
        // As Jimenez et al. (2016) have it.
        const double least = 0.08, a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417,
                     c = 2.7552 * albedo + 0.6903, there = std::max(least, ((least * a + b) * least + c) * least);
        const glm::dvec3 share = drawn / readPixel(p.open, i);
        for (int channel = 0; channel < 3; ++channel)
            ASSERT_NEAR(share[channel], there, open == 0 ? 1e-5 : 0.012) << open;
    }
    EXPECT_GT(closed, 50u);
    EXPECT_GT(nearlyClosed, 50u);
}

struct Colorful {
    const char* name;
    Lit (*lit)();
    const char* file;
    double most;  ///< share of the error that is left
};
void PrintTo(const Colorful& c, std::ostream* out) { *out << c.name; }
class LightOfNeighbours : public testing::TestWithParam<Colorful> {};

TEST_P(LightOfNeighbours, IsNearerToPaths) {
    NACRE_NEEDS_DATA(GetParam().file);
    const Lit lit = GetParam().lit();
    RenderSettings s = lit.settings;
    s.fine = true;
    s.occlusion.directions = 128;
    s.effects.light = ambientAlone();
    ValidatedRenderer renderer(Visibility::automatic, lit.scene);
    const TracedLight truth = traceLight(lit, renderer->layers(s), sky(), 600, 2048);
    const double before = lightError(renderer->render(s).rgba, truth);
    s.occlusion.bounce = true;
    const double after = lightError(renderer->render(s).rgba, truth);
    std::cout << "RMS " << before << ", with light of neighbours " << after << "\n";
    EXPECT_LT(after, GetParam().most * before);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, LightOfNeighbours,
    testing::Values(Colorful{"Well", well, "sample:", 0.7}, Colorful{"Dna", dna, "sample:dna", 0.5},
                    Colorful{"Chains", [] { return hemoglobin(ColorScheme::chain); }, "4hhb.pdb", 0.5},
                    Colorful{"Elements", [] { return hemoglobin(ColorScheme::element); }, "4hhb.pdb", 0.5},
                    Colorful{"Pocket", [] { return pocket(ColorScheme::chain); }, "1hpv.pdb", 0.5},
                    Colorful{"PocketElements", [] { return pocket(ColorScheme::element); }, "1hpv.pdb", 0.5},
                    Colorful{"DnaCartoon", dnaCartoon, "sample:dna", 0.84}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace nacre::test
