// Primitives beside a molecule: the same on every path, with depth, numbers and occlusion.

#include "engine/scene/build/primitives.h"

#include "engine/scene/build/map_scene.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

/// One of each, opaque and translucent, about glucose.
Primitives oneOfEach() {
    const PrimitiveLook red{packedColor(0xd03030), 1, 1}, glass{packedColor(0x3060d0), 0.4, 2};
    Primitives p;
    p.notes = {"red", "glass"};
    p.lines.push_back({{-6, -4, 0}, {6, -4, 0}, 0.3, 0, {}, red});
    p.lines.push_back({{-6, -5, 0}, {6, -5, 0}, 0, 2, {0.4, 0.3}, red});
    p.lines.push_back({{-6, 5, 0}, {6, 5, 0}, 0.3, 0, {0.8, 0.4}, glass});
    p.arrows.push_back({{-5, 3, 2}, {5, 3, -2}, 0.2, 0.5, 1.2, true, true, {}, red});
    p.balls.push_back({{5, 0, 0}, 1.2, red});
    p.balls.push_back({{-5, 0, 0}, 1.2, glass});
    p.ellipsoids.push_back({{0, 0, 0}, {{{4, 0, 0}, {0, 2, 1}, {0, -0.5, 1}}}, glass});
    p.ellipses.push_back({{0, -6, 0}, {2, 0, 1}, {0, 1.5, 0}, 0, 4, red});
    p.boxes.push_back({{0, 6, 0}, {{{1, 0, 0.3}, {0, 1, 0}, {-0.3, 0, 1}}}, glass, red, 0.08});
    return p;
}

Representation withPrimitives() {
    Representation r = scene("sample:glucose", Style::ballAndStick), beside;
    beside.center = r.center;
    Primitives p = oneOfEach();
    const auto shift = [&](glm::dvec3& place) { place += r.center; };
    for (auto& line : p.lines) shift(line.a), shift(line.b);
    for (auto& arrow : p.arrows) shift(arrow.from), shift(arrow.to);
    for (auto& ball : p.balls) shift(ball.center);
    for (auto& ellipsoid : p.ellipsoids) shift(ellipsoid.center);
    for (auto& ellipse : p.ellipses) shift(ellipse.center);
    for (auto& box : p.boxes) shift(box.center);
    addPrimitives(p, beside);
    joinScenes(r, beside);
    return r;
}

TEST(PrimitivePictures, AreTheSameOnEveryPath) {
    PathRenderers renderers;
    const Representation r = withPrimitives();
    // Whole and cut, in either projection once: each of the four has pipelines of its own on five paths.
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        RenderSettings s = settings(r, 120, projection, {20, 30, 5});
        s.occlusion.directions = 8;
        s.effects.contours.width = 1;
        if (projection == Projection::perspective) s.effects.clip.near = -1;
        sameOnEveryPath(renderers, r, s);
    }
}

TEST(PrimitivePictures, HaveNumbersDepthAndOcclusion) {
    ValidatedRenderer renderer(Visibility::automatic);
    const Representation r = withPrimitives();
    RenderSettings s = settings(r, 200, Projection::orthographic);
    s.occlusion.directions = 32;
    renderer->setScene(r);
    const LayerPicture picture = renderer->layers(s);
    std::map<std::uint32_t, std::size_t> seen;
    float darkest = 1;
    for (std::size_t i = 0; i < picture.id.size(); ++i) {
        ++seen[picture.id[i]];
        if (r.noteNumber(picture.id[i]) == 0) continue;
        EXPECT_TRUE(std::isfinite(picture.z[i]));
        darkest = std::min(darkest, picture.occlusion[i]);
    }
    const auto first = static_cast<std::uint32_t>(r.atomGroups.size() + 1);
    EXPECT_GT(seen[first], 1000u);
    EXPECT_EQ(seen[first + 1], 0u) << "layers show what hides more than half";
    EXPECT_LT(darkest, 0.8f);
    const std::uint32_t at = renderer->atomAt(s, 100 + 5 * s.view.pixelsPerAngstrom, 100, 1);
    EXPECT_EQ(r.noteNumber(at), 1u) << "the red ball";
}

}  // namespace
}  // namespace nacre::test
