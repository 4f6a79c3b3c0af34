#include "tests/occlusion/traced_light.h"

#include <algorithm>
#include <numbers>
#include <random>

#include "engine/mesh/cartoon.h"
#include "engine/molecule/kabsch_sander.h"
#include "tests/renderer/meshes.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {

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

Lit pocket(ColorScheme colors) {
    const Molecule m = molecule("1hpv.pdb");
    Lit lit{represent(m, drawnAtoms(m), {Style::spacefill, colors}), {}};
    lit.settings = settings(lit.scene, 256, Projection::orthographic, {0, 0, 0}, 4);
    return lit;
}

Lit hemoglobin(ColorScheme colors) {
    const Molecule m = molecule("4hhb.pdb");
    Lit lit{represent(m, drawnAtoms(m), {Style::spacefill, colors}), {}};
    lit.settings = settings(lit.scene, 256, Projection::orthographic, {20, 30, 10}, 1.5);
    return lit;
}

Light ambientAlone() {
    Light light;
    light.direct = light.highlight = 0;
    return light;
}

reference::Sky sky() {
    const glm::dvec3 down(0.54, 0.52, 0.52), up(0.70, 0.73, 0.77);
    return {0.5 * (down + up), 0.5 * (up - down)};
}

TracedLight traceLight(const Lit& lit, const LayerPicture& layers, const reference::Sky& sky, std::size_t pixels,
                       std::size_t paths) {
    std::vector<std::uint32_t> covered;
    for (std::uint32_t i = 0; i < layers.id.size(); ++i)
        if (layers.id[i]) covered.push_back(i);
    std::shuffle(covered.begin(), covered.end(), std::mt19937(3));
    covered.resize(std::min(covered.size(), pixels));
    const auto light = reference::tracePaths(lit.scene, lit.settings.view, covered, sky, paths);
    TracedLight traced;
    for (std::size_t i = 0; i < covered.size(); ++i) {
        if (std::isnan(light[i].x)) continue;  // an outline
        traced.pixels.push_back(covered[i]);
        traced.light.push_back(light[i]);
    }
    return traced;
}

double lightError(const std::vector<float>& rgba, const TracedLight& truth) {
    SquaredErrors errors;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            errors.add(rgba[4 * std::size_t{truth.pixels[i]} + static_cast<std::size_t>(c)] - truth.light[i][c]);
    return errors.rms();
}

}  // namespace nacre::test
