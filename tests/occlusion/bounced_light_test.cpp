// Light in clefts, against paths that bounce from surface to surface.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iostream>
#include <numbers>
#include <random>

#include "engine/mesh/cartoon.h"
#include "engine/molecule/kabsch_sander.h"
#include "shaders/common/layout.h"
#include "tests/reference/path_tracer.h"
#include "tests/renderer/meshes.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

struct Lit {
    Representation scene;
    RenderSettings settings;
};

/// A ball in a shell of others, seen through a hole: hardly any direction reaches it.
Lit well() {
    Lit lit;
    Representation& r = lit.scene;
    const auto add = [&](const glm::dvec3& at, float radius, std::uint32_t color) {
        const auto atom = static_cast<std::uint32_t>(r.spheres.size()) + 1;
        r.spheres.push_back({glm::vec3(at), radius});
        r.sphereLooks.push_back({color, atom});
    };
    add(glm::dvec3(0), 2.0f, 0xff40a0ffu);
    constexpr int kShell = 500;
    for (int i = 0; i < kShell; ++i) {
        const double z = 1 - (2 * i + 1.0) / kShell, angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
        const glm::dvec3 at =
            10.0 * glm::dvec3(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z);
        if (z > 0 && std::hypot(at.x, at.y) < 3.0) continue;
        add(at, 1.7f, i % 3 == 0 ? 0xff6060f0u : 0xffd0d0d0u);
    }
    r.radius = 12;
    lit.settings = settings(r, 192, Projection::orthographic, {0, 0, 0}, 2.5);
    return lit;
}

Lit dna() {
    Lit lit{scene("sample:dna", Style::spacefill), {}};
    lit.settings = settings(lit.scene, 192, Projection::orthographic, {20, 30, 10}, 1.5);
    return lit;
}

Lit dnaCartoon() {
    const Molecule m = molecule("sample:dna");
    const std::vector<std::uint32_t> drawn = drawnAtoms(m);
    const Representation spheres = represent(m, drawn, {Style::spacefill, ColorScheme::chain});
    Lit lit;
    Representation& r = lit.scene;
    r.center = spheres.center;
    r.radius = spheres.radius;
    appendMesh(
        cartoon(m, drawn, secondaryStructure(m), {}, r.center), glm::dvec3(0),
        [](std::uint32_t atom) {
            return SphereLook{0xffc09060u, atom + 1};
        },
        r);
    lit.settings = settings(r, 192, Projection::orthographic, {20, 30, 10}, 1.5);
    return lit;
}

/// About the drug of 1HPV, in the depth of the protease.
Lit pocket() {
    const Molecule m = molecule("1hpv.pdb");
    Lit lit{represent(m, drawnAtoms(m), {Style::spacefill, ColorScheme::element}), {}};
    lit.settings = settings(lit.scene, 256, Projection::orthographic, {0, 0, 0}, 4);
    return lit;
}

/// One sample a pixel, linear, with all light but the highlight's from the sky.
struct Pictures {
    LayerPicture layers;
    std::vector<float> drawn, open, base;  // as drawn, without occlusion, without light
};
Pictures picturesOf(const Lit& lit, const Light& light) {
    RenderSettings s = lit.settings;
    s.fine = true;
    s.occlusion.directions = 128;
    s.effects.light = light;
    ValidatedRenderer renderer(Visibility::automatic);
    renderer->setScene(lit.scene);
    Pictures p{renderer->layers(s), renderer->render(s).rgba, {}, {}};
    s.effects.light.occlusion = 0;
    p.open = renderer->render(s).rgba;
    s.lighting = false;
    p.base = renderer->render(s).rgba;
    return p;
}

glm::dvec3 pixelOf(const std::vector<float>& rgba, std::size_t i) {
    return {rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]};
}

class SquaredErrors {
public:
    void add(double difference) {
        sum_ += difference * difference;
        ++count_;
    }
    double rms() const { return std::sqrt(sum_ / static_cast<double>(count_)); }

private:
    double sum_ = 0;
    std::size_t count_ = 0;
};

Light ambientAlone() {
    Light light;
    light.direct = light.highlight = 0;
    return light;
}
/// The sky of shaders/common/shading.glsl.
reference::Sky sky() {
    const glm::dvec3 down(0.54, 0.52, 0.52), up(0.70, 0.73, 0.77);
    return {0.5 * (down + up), 0.5 * (up - down)};
}

class BouncedLight : public testing::TestWithParam<const char*> {
protected:
    static Lit lit() {
        const std::string name = GetParam();
        if (name == "Well") return well();
        if (name == "DnaSpheres") return dna();
        return name == "DnaCartoon" ? dnaCartoon() : pocket();
    }
};

/// Root mean square of what is drawn less what paths find, and of what was drawn before light bounced.
struct Errors {
    SquaredErrors drawn, before;
};
Errors errorsOf(const Lit& scene, const Light& light, const reference::Sky& sky) {
    const Pictures p = picturesOf(scene, light);
    std::vector<std::uint32_t> pixels;
    for (std::uint32_t i = 0; i < p.layers.id.size(); ++i)
        if (p.layers.id[i]) pixels.push_back(i);
    std::shuffle(pixels.begin(), pixels.end(), std::mt19937(3));
    pixels.resize(std::min<std::size_t>(pixels.size(), 1000));
    const auto truth = reference::tracePaths(scene.scene, scene.settings.view, pixels, sky, 256);
    Errors errors;
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        if (std::isnan(truth[k].x)) continue;  // an outline
        const double open = p.layers.occlusion[pixels[k]];
        for (int c = 0; c < 3; ++c) {
            const std::size_t at = 4 * std::size_t{pixels[k]} + c;
            errors.drawn.add(p.drawn[at] - truth[k][c]);
            errors.before.add(p.open[at] * open * (0.45 * open + 0.55) - truth[k][c]);
        }
    }
    std::cout << "RMS " << errors.drawn.rms() << ", before " << errors.before.rms() << "\n";
    return errors;
}

TEST_P(BouncedLight, IsNearPaths) {
    if (GetParam() == std::string("Pocket")) NACRE_NEEDS_DATA();
    const Lit scene = lit();
    const Errors errors = errorsOf(scene, ambientAlone(), sky());
    EXPECT_LT(errors.drawn.rms(), 0.025);
    EXPECT_LT(errors.drawn.rms(), 0.6 * errors.before.rms());
}

/// Pictures have no shadows unless asked: so far they cannot be right.
TEST_P(BouncedLight, IsNearerToPathsWithDirectLight) {
    if (GetParam() == std::string("Pocket")) NACRE_NEEDS_DATA();
    Light matt;
    matt.highlight = 0;
    reference::Sky withSun = sky();
    withSun.sun = glm::dvec3(0.74);
    withSun.toSun = glm::normalize(glm::dvec3(layout::kLightX, layout::kLightY, layout::kLightZ));
    const Errors errors = errorsOf(lit(), matt, withSun);
    EXPECT_LT(errors.drawn.rms(), 0.95 * errors.before.rms());
}

TEST_P(BouncedLight, LeavesNoPlaceBlack) {
    if (GetParam() == std::string("Pocket")) NACRE_NEEDS_DATA();
    const Pictures p = picturesOf(lit(), Light());
    for (std::size_t i = 0; i < p.layers.id.size(); ++i)
        for (std::size_t c = 4 * i; p.layers.id[i] && c < 4 * i + 3; ++c)
            ASSERT_GE(p.drawn[c], 0.04f * p.base[c]) << i % p.layers.width << ", " << i / p.layers.width;
}

INSTANTIATE_TEST_SUITE_P(Scenes, BouncedLight, testing::Values("Well", "DnaSpheres", "DnaCartoon", "Pocket"),
                         [](const auto& test) { return std::string(test.param); });

TEST(BouncedLightInTheDark, RunsIntoTheLeastWithoutABorder) {
    const Pictures p = picturesOf(well(), ambientAlone());
    std::size_t closed = 0, nearlyClosed = 0;
    for (std::size_t i = 0; i < p.layers.id.size(); ++i) {
        const float open = p.layers.occlusion[i];
        if (!p.layers.id[i] || open > 0.03f) continue;
        ++(open == 0 ? closed : nearlyClosed);
        const glm::dvec3 base = pixelOf(p.base, i), drawn = pixelOf(p.drawn, i);
        const double albedo = (base.x + base.y + base.z) / 3;
        // As Jimenez et al. (2016) have it.
        const double least = 0.08, a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417,
                     c = 2.7552 * albedo + 0.6903, there = std::max(least, ((least * a + b) * least + c) * least);
        const glm::dvec3 share = drawn / pixelOf(p.open, i);
        for (int channel = 0; channel < 3; ++channel)
            ASSERT_NEAR(share[channel], there, open == 0 ? 1e-5 : 0.012) << open;
    }
    EXPECT_GT(closed, 50u);
    EXPECT_GT(nearlyClosed, 50u);
}

}  // namespace
}  // namespace nacre::test
