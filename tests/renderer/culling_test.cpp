// What is left out of a frame because it does not show never changes a bit of it.

#include <random>

#include "engine/threads.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

struct CulledCase {
    const char* name;
    Style style;
    Projection projection;
    bool copies;
};
void PrintTo(const CulledCase& c, std::ostream* out) { *out << c.name; }

/// The DNA, and, with copies, six of it side by side.
Representation culledScene(const CulledCase& c) {
    if (!c.copies) return scene(c.name, c.style);
    Molecule m = molecule(c.name);
    addCopies(m, {{0, 0, 0}, {24, 0, 5}, {48, 0, 10}, {0, 30, 15}, {24, 30, 20}, {48, 30, 25}});
    RepresentationOptions options{.style = c.style, .color = ColorScheme::element, .assembly = "1"};
    return represent(m, drawnAtoms(m), options);
}

class Culling : public SharedRenderers<CulledCase> {};

TEST_P(Culling, NeverChangesABit) {
    const CulledCase& c = GetParam();
    const Representation r = culledScene(c);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::uint64_t most = 0, least = UINT64_MAX;
    bool found = false;  // by the host
    for (const Visibility path : devicePaths()) {
        ValidatedRenderer& renderer = sharedRenderer(path, r);
        for (const double zoom : {0.1, 1.0, 3.0, 9.0, 30.0}) {
            if (zoom < 1 && c.style != Style::spacefill) continue;  // atoms under a pixel
            RenderSettings s = settings(r, 120, c.projection, {unit(random) * 180, unit(random) * 180, 0}, zoom);
            s.view.pan = glm::dvec2(unit(random), unit(random)) * (0.5 * r.radius);
            s.view.quarterTurns = static_cast<int>(zoom) % 4;
            s.effects.contours.width = zoom > 5 ? 12 : 0;
            s.tuning.cull = false;
            const Picture whole = renderer->render(s);
            const auto count = [&] { return renderer->stats().spheres + renderer->stats().triangles / 20; };
            const std::uint64_t submitted = count();
            s.tuning.cull = true;
            s.tuning.hideFrom = 0;
            EXPECT_EQ(renderer->render(s).rgba, whole.rgba) << "zoom " << zoom;
            EXPECT_LE(count(), submitted);
            if (path == Visibility::tiles && zoom == 1) found = renderer->stats().lists.entries == 0;
            most = std::max(most, count());
            least = std::min(least, count());
        }
    }
    // Zoomed in, most atoms are off screen; but those of a lone helix fill few chunks.
    EXPECT_LT(least, most);
    if (c.style == Style::spacefill) {
        EXPECT_EQ(found, isSoftwareDevice());
    }
    if (c.copies) {
        EXPECT_LT(4 * least, most);
    }
}

// Where shaders write depth, software devices test it behind them: there the host drops what is hidden. GPUs test it
// before, against plates.
TEST(LateDepthTests, AreSparedHiddenSpheres) {
    const Representation r = scene("sample:dna", Style::spacefill);
    for (const Visibility path : devicePaths()) {
        ValidatedRenderer renderer(path, r);
        for (const double halos : {0.0, 3.0}) {
            RenderSettings s = settings(r, 120, Projection::perspective, {20, 70, 0});
            s.effects.halos.width = halos;
            s.tuning.cull = false;
            const Picture whole = renderer->render(s);
            s.tuning.cull = true;
            EXPECT_EQ(renderer->render(s).rgba, whole.rgba) << visibilityName(path);
            if (halos > 0) continue;  // reaches from behind what hides the spheres
            const bool late = isSoftwareDevice() && (path == Visibility::fragdepth || path == Visibility::deferred);
            EXPECT_EQ(renderer->stats().spheres + 40 < r.spheres.size(), late) << visibilityName(path);
        }
    }
}

// Enough chunks for several threads, which share the picture's rows.
TEST(CopiesBehindCopies, NeverChangeABit) {
    Molecule m = molecule("sample:dna");
    std::vector<glm::vec3> shifts;
    for (int i = 0; i < 1200; ++i) shifts.emplace_back(i % 12 * 26, i / 12 % 10 * 40, i / 120 * 26);
    addCopies(m, shifts);
    RepresentationOptions options{.style = Style::spacefill, .color = ColorScheme::element, .assembly = "1"};
    const Representation r = represent(m, drawnAtoms(m), options);
    ValidatedRenderer renderer(Visibility::tiles, r);
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        RenderSettings s = settings(r, 160, projection, {12, 20, 5}, 1.5);
        s.tuning.cull = false;
        const Picture whole = renderer->render(s);
        const std::uint64_t submitted = renderer->stats().spheres;
        s.tuning.cull = true;
        // Small ones along parallel rays are hidden from fewer on, by two threads at least.
        setThreadsPerTask(2);
        EXPECT_EQ(renderer->render(s).rgba, whole.rgba);
        EXPECT_EQ(renderer->stats().lists.entries == 0, projection == Projection::orthographic);
        s.tuning.hideFrom = 0;
        EXPECT_EQ(renderer->render(s).rgba, whole.rgba);
        EXPECT_EQ(renderer->stats().spheres * 8 < submitted, projection == Projection::perspective);
        // Smaller than pixels.
        s = settings(r, 160, projection, {12, 20, 5}, 0.6);
        const Picture by2 = renderer->render(s);
        setThreadsPerTask(1);
        EXPECT_EQ(renderer->render(s).rgba, by2.rgba);
        setThreadsPerTask(0);
        // Many pixels, since few depend on rounding.
        s = settings(r, 640, projection, {33, 21, 7}, 2);
        s.tuning.cull = false;
        const Picture many = renderer->render(s);
        s.tuning.cull = true;
        EXPECT_EQ(renderer->render(s).rgba, many.rgba);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Culling,
                         testing::Values(CulledCase{"sample:dna", Style::spacefill, Projection::orthographic, false},
                                         CulledCase{"sample:dna", Style::cartoon, Projection::perspective, true},
                                         CulledCase{"sample:dna", Style::licorice, Projection::perspective, false},
                                         CulledCase{"sample:dna", Style::ballAndStick, Projection::orthographic, true}),
                         [](const auto& test) { return "case" + std::to_string(test.index); });

}  // namespace
}  // namespace nacre::test
