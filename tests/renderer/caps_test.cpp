// Caps of meshes that the near plane cuts, on every path: depth, normal and atom are those of the plane. A ray caster
// judges where they are: a point of the plane is inside a closed mesh if the ray from it away from the viewer leaves
// the mesh once more than it enters.

#include <glm/geometric.hpp>
#include <optional>

#include "tests/renderer/meshes.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

/// The inside of a closed mesh on a plane across the view.
class MeshInside {
public:
    MeshInside(const Representation& r, const View& view, double height)
        : r_(r), vertices_(turnedVertices(r, view)), view_(view), height_(height) {}

    /// A point of the plane, as a pixel sees it.
    glm::dvec3 planePoint(std::uint32_t x, std::uint32_t y) const {
        const glm::dvec2 q((x + 0.5 - view_.width / 2.0) / view_.pixelsPerAngstrom,
                           (view_.height / 2.0 - y - 0.5) / view_.pixelsPerAngstrom);
        if (view_.projection == Projection::orthographic) return {q, height_};
        return {q * ((view_.eyeDistance - height_) / view_.eyeDistance), height_};
    }
    /// Empty near the outline.
    std::optional<bool> has(const glm::dvec3& place) const {
        const glm::dvec3 ray = view_.projection == Projection::orthographic
                                   ? glm::dvec3(0, 0, -1)
                                   : glm::normalize(place - glm::dvec3(0, 0, view_.eyeDistance));
        int winding = 0;
        for (const Triangle& t : r_.triangles) {
            const glm::dvec3 &a = vertices_[t.a], ab = vertices_[t.b] - a, ac = vertices_[t.c] - a;
            const glm::dvec3 n = glm::cross(ab, ac);
            const double facing = glm::dot(ray, n);
            if (std::abs(facing) < 1e-12) continue;
            const double along = glm::dot(a - place, n) / facing;
            if (along < -0.2) continue;
            const glm::dvec3 p = place + ray * along - a;
            const double beta = glm::dot(glm::cross(p, ac), n) / glm::dot(n, n),
                         gamma = glm::dot(glm::cross(ab, p), n) / glm::dot(n, n);
            const double least = std::min({1 - beta - gamma, beta, gamma});
            if (least < -1e-3) continue;
            if (std::abs(along) <= 0.2 || least < 1e-3) return std::nullopt;
            winding += facing > 0 ? 1 : -1;
        }
        return winding > 0;
    }

private:
    const Representation& r_;
    std::vector<glm::dvec3> vertices_;
    View view_;
    double height_;
};

std::uint32_t nearestAtom(const Representation& r, const glm::dvec3& place, double& margin) {
    double least = 1e9, next = 1e9;
    std::uint32_t nearest = 0;
    for (const SurfaceAtom& atom : r.surfaceAtoms) {
        const double height = glm::distance(place, glm::dvec3(atom.center)) - static_cast<double>(atom.radius);
        if (height < least)
            next = least, least = height, nearest = atom.look.atom;
        else
            next = std::min(next, height);
    }
    margin = next - least;
    return nearest;
}

struct CapCase {
    const char* name;
    Style style;
    Projection projection;
};
void PrintTo(const CapCase& c, std::ostream* out) { *out << c.name; }

class Caps : public SharedRenderers<CapCase> {};

TEST_P(Caps, AreOnThePlaneOnEveryPath) {
    const Representation r = scene("sample:dna", GetParam().style);
    for (const Visibility path : devicePaths()) sharedRenderer(path)->setScene(r);
    // The scene stays; views and planes change, as in a window.
    for (const auto& [rotation, near] :
         {std::pair(glm::dvec3(20, 30, 10), 0.0), {glm::dvec3(50, -70, 0), 0.0}, {glm::dvec3(50, -70, 0), 3.5}}) {
        RenderSettings s = settings(r, 100, GetParam().projection, rotation);
        s.effects.clip.near = near;
        FirstPicture picture;
        for (const Visibility path : devicePaths()) picture.expectSame(sharedRenderer(path), s, visibilityName(path));
        const LayerPicture& first = picture.layers;
        const MeshInside inside(r, s.view, -near);
        const bool perspective = GetParam().projection == Projection::perspective;
        const double plane = (perspective ? s.view.eyeDistance : s.view.radius) + near;
        std::size_t caps = 0, compared = 0, wrong = 0, offPlane = 0, turned = 0, named = 0, misnamed = 0;
        for (std::uint32_t y = 0; y < 100; y += 3)
            for (std::uint32_t x = 0; x < 100; x += 3) {
                const std::size_t i = y * std::size_t{100} + x;
                const glm::dvec3 place = inside.planePoint(x, y);
                const std::optional<bool> capped = inside.has(place);
                if (!capped) continue;
                ++compared;
                const bool drawn = first.id[i] != 0 && std::abs(static_cast<double>(first.z[i]) - plane) < 0.004;
                wrong += drawn != *capped;
                if (!*capped) continue;
                ++caps;
                offPlane += !drawn;
                turned += first.normal[3 * i] != 0 || first.normal[3 * i + 1] != 0 || first.normal[3 * i + 2] != 1;
                if (GetParam().style != Style::surface) continue;
                double margin = 0;
                const std::uint32_t nearest = nearestAtom(r, glm::transpose(s.view.rotation) * place, margin);
                if (margin < 0.2) continue;  // Å
                ++named;
                misnamed += first.id[i] != nearest;
            }
        EXPECT_GE(caps, GetParam().style == Style::surface ? 40u : 2u);
        EXPECT_GT(compared, 500u);
        EXPECT_EQ(wrong, 0u);
        EXPECT_EQ(offPlane, 0u);
        EXPECT_EQ(turned, 0u);
        EXPECT_LE(misnamed, named / 30);
    }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Caps,
                         testing::Values(CapCase{"Surface", Style::surface, Projection::orthographic},
                                         CapCase{"SurfaceInPerspective", Style::surface, Projection::perspective},
                                         CapCase{"Cartoon", Style::cartoon, Projection::orthographic}),
                         [](const auto& tested) { return std::string(tested.param.name); });

// Pixels on the plane have --cap-color's hue, of atoms, sticks and meshes, on every path; others keep theirs.
TEST(CapsOfScenes, HaveTheGivenColour) {
    for (const Style style : {Style::spacefill, Style::licorice, Style::surface}) {
        Representation r = scene("sample:dna", style);
        for (SphereLook& look : r.sphereLooks) look.color = 0xff40ff40u;
        for (CylinderLook& look : r.cylinderLooks) look.colorA = look.colorB = 0xff40ff40u;
        for (SphereLook& look : r.meshLooks) look.color = 0xff40ff40u;
        for (SurfaceAtom& atom : r.surfaceAtoms) atom.look.color = 0xff40ff40u;
        RenderSettings s = settings(r, 100, Projection::orthographic);
        s.supersample = 1;
        s.effects.clip.near = 0;
        s.effects.clip.capColor = {1, 0, 0.5f};
        for (const Visibility path : devicePaths()) {
            ValidatedRenderer renderer(path, r);
            const LayerPicture layers = renderer->layers(s);
            const Picture picture = renderer->render(s);
            std::size_t caps = 0, others = 0, wrong = 0;
            for (std::size_t i = 0; i < layers.id.size(); ++i) {
                if (layers.id[i] == 0) continue;
                const bool cap = std::abs(static_cast<double>(layers.z[i]) - s.view.radius) < 0.004;
                const float *pixel = &picture.rgba[4 * i], red = pixel[0], green = pixel[1];
                ++(cap ? caps : others);
                wrong += cap ? !(red > 2 * green) : !(green > red);
            }
            EXPECT_GT(caps, style == Style::licorice ? 20u : 300u) << visibilityName(path);
            EXPECT_GT(others, 100u) << visibilityName(path);
            // What is not cut may meet the plane.
            EXPECT_LE(wrong, 1 + caps / 50) << visibilityName(path) << " " << static_cast<int>(style);
        }
    }
}

TEST(CapsOfScenes, FollowTheSceneAndNeedNoNewBake) {
    const Representation r = scene("sample:dna", Style::surface);
    ValidatedRenderer renderer(Visibility::tiles), fresh(Visibility::tiles);
    RenderSettings s = settings(r, 100, Projection::orthographic);
    s.occlusion.directions = 8;
    renderer->setScene(r);
    const Picture whole = renderer->render(s);
    const double baked = renderer->stats().bakeMilliseconds;
    RenderSettings cut = s;
    cut.effects.clip.near = 0;
    const Picture clipped = renderer->render(cut);
    EXPECT_EQ(renderer->stats().bakeMilliseconds, baked);
    EXPECT_NE(clipped.rgba, whole.rgba);
    EXPECT_EQ(renderer->render(s).rgba, whole.rgba);
    // As if nothing had been drawn before.
    fresh->setScene(r);
    EXPECT_EQ(fresh->render(cut).rgba, clipped.rgba);
    // Recoloured caps have the new colours.
    Representation red = r;
    for (SphereLook& look : red.meshLooks) look.color = 0xff0000ffu;
    for (SurfaceAtom& atom : red.surfaceAtoms) atom.look.color = 0xff0000ffu;
    renderer->setScene(red);
    fresh->setScene({});
    fresh->setScene(red);
    EXPECT_EQ(renderer->render(cut).rgba, fresh->render(cut).rgba);
}

}  // namespace
}  // namespace nacre::test
