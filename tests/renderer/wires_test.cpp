// Lines of constant width: the same on every path, as wide at any zoom, and nothing to light and atoms.

#include "engine/scene/build/translucency.h"
#include "engine/scene/color/colors.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

/// A grid of lines in front of glucose, each a few pixels from the next.
Representation withWires(float width) {
    Representation r = scene("sample:glucose", Style::ballAndStick);
    for (int i = -4; i <= 4; ++i) {
        const auto at = static_cast<float>(i);
        r.wires.push_back({{at, -4, 3}, -width / 2, {at, 4, 3}, 0});
        r.wires.push_back({{-4, at, 1}, -width / 2, {4, at, -3}, 0});
        for (int k = 0; k < 2; ++k) r.wireLooks.push_back({0xff00ff, 0xff00ff, 0, 0});
    }
    r.radius = std::max(r.radius, 7.0);
    return r;
}

void expectWiresOnEveryPath(Projection projection) {
    PathRenderers renderers;
    const Representation r = withWires(1.5f);
    RenderSettings s = settings(r, 200, projection, {20, 30, 5});
    s.occlusion.directions = 8;
    s.effects.contours.width = 1;
    sameOnEveryPath(renderers, r, s);
    const LayerPicture picture = renderers[Visibility::tiles]->layers(s);
    std::size_t nameless = 0;
    for (std::size_t i = 0; i < picture.id.size(); ++i) nameless += picture.id[i] == 0 && std::isfinite(picture.z[i]);
    EXPECT_GT(nameless, 1000u) << "lines have depth, and name no atom";
}

TEST(Wires, AreTheSameOnEveryPath) { expectWiresOnEveryPath(Projection::orthographic); }

TEST(Wires, AreTheSameOnEveryPathInPerspective) { expectWiresOnEveryPath(Projection::perspective); }

/// Pixels of a row that show lines.
std::size_t pinkAcross(const Picture& p, std::uint32_t row) {
    std::size_t pink = 0;
    for (std::uint32_t x = 0; x < p.width; ++x) {
        const float* c = p.rgba.data() + 4 * (std::size_t{row} * p.width + x);
        pink += c[0] > 2 * c[1] && c[2] > 2 * c[1];
    }
    return pink;
}

TEST(Wires, AreAsWideAtAnyZoomAndDepth) {
    ValidatedRenderer renderer(Visibility::automatic);
    for (const Projection projection : {Projection::orthographic, Projection::perspective})
        for (const double zoom : {0.6, 3.0}) {
            Representation r = scene("sample:glucose", Style::ballAndStick);
            r.spheres.clear(), r.sphereLooks.clear(), r.cylinders.clear(), r.cylinderLooks.clear();
            r.radius = 7;
            for (const float z : {-3.0f, 3.0f}) {  // two lines at different depths
                r.wires.push_back({{z / 6, -9, z}, -4, {z / 6, 9, z}, 0});
                r.wireLooks.push_back({0xff00ff, 0xff00ff, 0, 0});
            }
            renderer->setScene(r);
            RenderSettings s = settings(r, 200, projection);
            s.view.pixelsPerAngstrom *= zoom;
            s.lighting = false;
            for (const std::uint32_t samples : {1u, 2u}) {
                s.supersample = samples;
                EXPECT_NEAR(static_cast<double>(pinkAcross(renderer->render(s), 100)), 16, 2) << zoom << " " << samples;
            }
        }
}

/// Frames of a window that is sharper at rest than in motion differ in scale: their lines take no pipelines of their
/// own.
TEST(Wires, NeedNoPipelineForAnotherScale) {
    const auto added = [](const Representation& r, Visibility path) {
        ValidatedRenderer renderer(path, r);
        RenderSettings s = settings(r, 96, Projection::orthographic);
        s.occlusion.directions = 0;
        s.supersample = 2;
        renderer->render(s);
        const std::uint64_t before = renderer->stats().pipelines;
        s.supersample = 3;
        renderer->render(s);
        return renderer->stats().pipelines - before;
    };
    const Representation with = withWires(2);
    Representation without = with;
    without.wires.clear();
    without.wireLooks.clear();
    for (const Visibility path : {Visibility::fragdepth, Visibility::deferred, Visibility::tiles})
        EXPECT_EQ(added(with, path), added(without, path)) << static_cast<int>(path);
}

/// Colours that go over from corner to corner are the same on every path, and others than those of the nearest corners.
void expectBlendedColorsOnEveryPath(double opacity) {
    PathRenderers renderers;
    Representation r = scene("sample:glucose", Style::surface);
    for (std::size_t i = 0; i < r.meshLooks.size(); ++i)
        r.meshLooks[i].color = withOpacity(i % 2 ? 0xff2040e0u : 0xff40e020u, opacity);
    if (opacity < 1) orderByTranslucency(r, r.triangles.begin(), r.triangles.end());
    RenderSettings s = settings(r, 160, Projection::perspective, {20, 30, 5});
    s.occlusion.directions = 8;
    r.blendsColors = true;
    sameOnEveryPath(renderers, r, s);
    renderers[Visibility::tiles]->setScene(r);
    const Picture blended = renderers[Visibility::tiles]->render(s);
    r.blendsColors = false;
    renderers[Visibility::tiles]->setScene(r);
    EXPECT_NE(renderers[Visibility::tiles]->render(s).rgba, blended.rgba);
}

TEST(BlendedColors, AreTheSameOnEveryPath) { expectBlendedColorsOnEveryPath(1); }

TEST(BlendedColors, AreTheSameOnEveryPathWhereLightGoesThroughThem) { expectBlendedColorsOnEveryPath(0.5); }

TEST(Wires, ChangeNothingOfOcclusion) {
    ValidatedRenderer renderer(Visibility::automatic);
    const Representation with = withWires(1);
    Representation without = with;
    without.wires.clear();
    without.wireLooks.clear();
    RenderSettings s = settings(with, 128, Projection::orthographic);
    s.occlusion.directions = 16;
    renderer->setScene(without);
    const LayerPicture a = renderer->layers(s);
    renderer->setScene(with);
    const LayerPicture b = renderer->layers(s);
    for (std::size_t i = 0; i < a.id.size(); ++i) {
        if (b.id[i] == 0 && !std::isfinite(b.z[i])) continue;
        EXPECT_EQ(b.occlusion[i], b.id[i] == 0 ? 1.0f : a.occlusion[i]) << "a line is in the open";
    }
}

}  // namespace
}  // namespace nacre::test
