// Planes that cut, lines about what stands in front, fog: the same on every path, and what they say they are.

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/reference/ray_caster.h"
#include "tests/reference/solids.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

struct EffectCase {
    const char* name;
    const char* molecule;
    Style style;
    Projection projection;
};

void PrintTo(const EffectCase& c, std::ostream* out) { *out << c.name; }

class Effect : public SharedRenderers<EffectCase> {
protected:
    /// Everything that can be on.
    RenderSettings all(const Representation& r) const {
        RenderSettings s = settings(r, 160, GetParam().projection, {40, -70, 15});
        s.effects.clip = {-0.1 * r.radius, 0.5 * r.radius, Clip::Cap::hatched};
        s.effects.contours = {2.5, 0.8, 1, {0.1f, 0, 0.3f}};
        s.effects.fog.range = Fog::Range::automatic;
        s.effects.shadow.strength = 0.8;
        return s;
    }
};

TEST_P(Effect, IsTheSamePictureOnEveryPath) {
    const Representation r = scene(GetParam().molecule, GetParam().style);
    RenderSettings s = all(r);
    RenderSettings rims = s;
    rims.effects.contours.weights = 3;
    rims.effects.halos = {5, 6, 0.8, {0.2f, 0, 0}};
    LayerPicture layers;
    std::vector<float> picture, rimmed;
    for (const Visibility path : devicePaths()) {
        ValidatedRenderer& renderer = sharedRenderer(path, r);
        const std::vector<float> withRims = renderer->render(rims).rgba;
        if (rimmed.empty()) rimmed = withRims;
        EXPECT_EQ(withRims, rimmed) << visibilityName(path);
        // Every shape of either; SamePicture draws more pairs of them. Each pair has pipelines of its own.
        for (const auto& [plates, impostor] : {std::pair{PlateShape::none, ImpostorShape::square},
                                               {PlateShape::square, ImpostorShape::pyramid},
                                               {PlateShape::dome3, ImpostorShape::square}}) {
            if (path == Visibility::tiles && plates != PlateShape::none) continue;  // it has neither
            s.tuning.plates = plates;
            s.tuning.impostor = impostor;
            const LayerPicture l = renderer->layers(s);
            const std::vector<float> p = renderer->render(s).rgba;
            if (picture.empty()) layers = l, picture = p;
            const std::string what = std::string(visibilityName(path)) + ", plates " +
                                     std::to_string(static_cast<int>(plates)) + ", impostor " +
                                     std::to_string(static_cast<int>(impostor));
            EXPECT_EQ(l.id, layers.id) << what;
            EXPECT_EQ(l.z, layers.z) << what;
            EXPECT_EQ(l.rgba, layers.rgba) << what;
            EXPECT_EQ(p, picture) << what;
        }
    }
}

/// The part of a pixel's ray that lies in a solid, as distances Z, and how deep its point of a plane is in the solid.
struct Inside {
    double enter, leave, deep;
    std::uint32_t atom;
};

std::vector<Inside> findSolids(const Representation& r, const View& view, const reference::Line& line, double near) {
    std::vector<Inside> found;
    const glm::dvec3 point = line.origin + line.direction * (near / -line.direction.z);
    for (std::size_t i = 0; i < r.spheres.size(); ++i) {
        const glm::dvec3 center = view.rotation * glm::dvec3(r.spheres[i].center);
        const double radius = r.spheres[i].radius;
        if (const auto c = reference::cross(line, reference::Ball{center, radius}))
            found.push_back({-c->enter * line.direction.z, -c->leave * line.direction.z,
                             1 - glm::dot(point - center, point - center) / (radius * radius), r.sphereLooks[i].atom});
    }
    for (std::size_t i = 0; i < r.cylinders.size(); ++i) {
        const Cylinder& rod = r.cylinders[i];
        const glm::dvec3 a = view.rotation * glm::dvec3(rod.a), b = view.rotation * glm::dvec3(rod.b);
        if (const auto c = reference::cross(line, reference::Rod{a, b, rod.radius})) {
            const glm::dvec3 axis = glm::normalize(b - a);
            const double along = glm::dot(point - a, axis);
            const glm::dvec3 side = point - a - axis * along;
            const bool first = along < glm::length(b - a) / 2;
            found.push_back({-c->enter * line.direction.z, -c->leave * line.direction.z,
                             1 - glm::dot(side, side) / (rod.radius * rod.radius),
                             first ? r.cylinderLooks[i].atomA : r.cylinderLooks[i].atomB});
        }
    }
    return found;
}

TEST_P(Effect, PlanesCutAsExactRaysSay) {
    const Representation r = scene(GetParam().molecule, GetParam().style);
    RenderSettings s = all(r);
    ValidatedRenderer& renderer = sharedRenderer(Visibility::tiles, r);
    const LayerPicture layers = renderer->layers(s);
    const double center = s.view.projection == Projection::perspective ? s.view.eyeDistance : s.view.radius;
    const double near = center + s.effects.clip.near, far = center + s.effects.clip.far;
    int caps = 0, skins = 0, skinsOnPlane = 0, wrong = 0, wrongOwners = 0;
    for (std::uint32_t y = 0; y < layers.height; ++y)
        for (std::uint32_t x = 0; x < layers.width; ++x) {
            const auto solids = findSolids(r, s.view, reference::pixelLine(s.view, x, y), near);
            double nearest = std::numeric_limits<double>::infinity(), deepest = 0;
            for (const Inside& i : solids)
                if (i.leave > near && std::max(i.enter, near) <= far)
                    nearest = std::min(nearest, std::max(i.enter, near));
            const std::size_t at = std::size_t{y} * layers.width + x;
            if (std::isinf(nearest) ? layers.id[at] != 0 : !(std::abs(layers.z[at] - nearest) < 0.025)) {
                ++wrong;
                continue;
            }
            if (nearest != near) {
                skins += layers.id[at] != 0;
                continue;
            }
            ++caps;
            if (layers.normal[3 * at + 2] != 1.0f) {  // the skin of another, hardly behind the plane
                ++skinsOnPlane;
                continue;
            }
            const auto owns = [&](const Inside& i) { return i.enter < near && i.leave > near; };
            for (const Inside& i : solids)
                if (owns(i)) deepest = std::max(deepest, i.deep);
            wrongOwners += std::ranges::none_of(
                solids, [&](const Inside& i) { return owns(i) && i.atom == layers.id[at] && i.deep > deepest - 0.01; });
        }
    EXPECT_GT(caps, 150);
    EXPECT_GT(skins, 300);
    EXPECT_EQ(skinsOnPlane, 0) << "of " << caps;
    // Pixels at an edge may fall to either side.
    EXPECT_LE(wrong, 4) << "of " << caps << " and " << skins;
    EXPECT_LE(wrongOwners, 4);
}

TEST_P(Effect, LinesStandWhereDepthJumpsAndNowhereElse) {
    const Representation r = scene(GetParam().molecule, GetParam().style);
    RenderSettings s = settings(r, 160, GetParam().projection, {40, -70, 15});
    s.lighting = false;
    ValidatedRenderer& renderer = sharedRenderer(Visibility::tiles, r);
    const LayerPicture layers = renderer->layers(s);
    const std::vector<float> plain = renderer->render(s).rgba;
    s.effects.contours = {2, 2.0, 1, {0, 0, 1}};
    const std::vector<float> lined = renderer->render(s).rgba;
    EXPECT_EQ(renderer->layers(s).id, layers.id) << "layers have no lines";
    const auto width = static_cast<int>(layers.width), height = static_cast<int>(layers.height);
    /// The least Z within a distance of a pixel.
    const auto nearestAbout = [&](int x, int y, double reach) {
        float least = std::numeric_limits<float>::infinity();
        const int n = static_cast<int>(std::ceil(reach));
        for (int j = std::max(y - n, 0); j <= std::min(y + n, height - 1); ++j)
            for (int i = std::max(x - n, 0); i <= std::min(x + n, width - 1); ++i)
                if (std::hypot(i - x, j - y) <= reach)
                    least = std::min(least, layers.z[static_cast<std::size_t>(j * width + i)]);
        return least;
    };
    int lines = 0, unfounded = 0, missing = 0, judged = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto at = static_cast<std::size_t>(y * width + x);
            const bool line = lined[4 * at] == 0 && lined[4 * at + 1] == 0 && lined[4 * at + 2] == 1;
            lines += line;
            // A line's own atom is within its width; a pixel more, since pixels are met at their centres alone.
            unfounded += line && !(nearestAbout(x, y, 3.5) < layers.z[at] - 2.0f);
            if (!line) {
                EXPECT_EQ(lined[4 * at], plain[4 * at]);
                // Beside what stands in front of it by far there must be one. Silhouettes bend back: that takes some Å.
                const bool jump = nearestAbout(x, y, 1) < layers.z[at] - 5.5f;
                missing += jump;
                judged += jump;
            }
            judged += line;
        }
    EXPECT_GT(lines, 400);
    EXPECT_EQ(unfounded, 0);
    EXPECT_EQ(missing, 0) << "of " << judged;
}

/// What rims of a scene of balls are to be at a pixel, by every ball.
struct Rims {
    bool line = false;
    double halo = 0;
};

TEST_P(Effect, WidthOfLinesAndDensityOfHalosFollowWhatStandsBehind) {
    if (GetParam().style != Style::spacefill || GetParam().projection != Projection::orthographic) return;
    const Molecule m = molecule(GetParam().molecule);
    const Representation r = scene(GetParam().molecule, GetParam().style);
    RenderSettings s = settings(r, 160, GetParam().projection, {40, -70, 15});
    s.lighting = false;
    s.effects.contours = {4, 1.5, 3, {0, 0, 1}};
    s.effects.halos = {9, 8, 0.5, {1, 0, 0}};
    ValidatedRenderer& renderer = sharedRenderer(Visibility::tiles, r);
    const LayerPicture layers = renderer->layers(s);
    const std::vector<float> drawn = renderer->render(s).rgba;
    const double perPixel = 1 / s.view.pixelsPerAngstrom;
    const auto findResidue = [&](std::uint32_t atom) { return m.atoms[atom - 1].residue; };
    const auto expected = [&](const glm::dvec2& q, std::uint32_t seen, double Z) {
        Rims rims;
        for (std::size_t i = 0; i < r.spheres.size(); ++i) {
            const glm::dvec3 center = s.view.rotation * glm::dvec3(r.spheres[i].center);
            const double outside = glm::length(q - glm::dvec2(center)) - double{r.spheres[i].radius};
            if (outside <= 0 || outside > 9 * perPixel) continue;
            const double behind = Z - (s.view.radius - center.z), t = 1 - outside / (9 * perPixel);
            rims.halo = std::max(rims.halo, t * t * (3 - 2 * t) * std::clamp(behind / 8, 0.0, 1.0));
            double share = 1;
            if (seen) {
                const std::uint32_t a = findResidue(seen), b = findResidue(r.sphereLooks[i].atom);
                const bool far = std::abs(static_cast<int>(a) - static_cast<int>(b)) > 6;
                const bool chain = m.residues[a].chain != m.residues[b].chain;
                share = behind < -0.5 ? 0 : chain ? 1 : far ? 0.67 : behind > 1.5 ? 0.34 : 0;
            }
            rims.line = rims.line || outside <= share * 4 * perPixel;
        }
        return rims;
    };
    int lines = 0, halos = 0, wrong = 0;
    for (std::uint32_t y = 0; y < layers.height; ++y)
        for (std::uint32_t x = 0; x < layers.width; ++x) {
            const std::size_t at = std::size_t{y} * layers.width + x;
            const glm::dvec2 q((x + 0.5 - layers.width / 2.0) * perPixel, (layers.height / 2.0 - y - 0.5) * perPixel);
            const Rims rims = expected(q, layers.id[at], layers.z[at]);
            const bool line = drawn[4 * at] == 0 && drawn[4 * at + 2] == 1;
            const double under = layers.id[at] ? layers.rgba[4 * at + 1] : 1;
            lines += rims.line;
            wrong += line != rims.line;
            if (line || rims.line || rims.halo < 0.02) continue;
            ++halos;
            wrong += std::abs(drawn[4 * at + 1] - under * (1 - 0.5 * rims.halo)) > 0.01;
        }
    EXPECT_GT(lines, 1000);
    EXPECT_GT(halos, 1000);
    EXPECT_LE(wrong, 8) << "of " << lines << " and " << halos;  // ends of rims fall to either side
}

TEST_P(Effect, FogTakesColourToTheBackgroundInProportionToDepth) {
    const Representation r = scene(GetParam().molecule, GetParam().style);
    RenderSettings s = settings(r, 96, GetParam().projection);
    s.background = {0, 1, 0, 1};
    ValidatedRenderer& renderer = sharedRenderer(Visibility::tiles, r);
    const LayerPicture clear = renderer->layers(s);
    s.effects.fog = {Fog::Range::given, -2, 6, 0.5};
    const LayerPicture fog = renderer->layers(s);
    const double center = s.view.projection == Projection::perspective ? s.view.eyeDistance : s.view.radius;
    for (std::size_t i = 0; i < clear.id.size(); ++i) {
        if (clear.id[i] == 0) continue;
        const double share = 0.5 * std::clamp((clear.z[i] - center + 2) / 8, 0.0, 1.0);
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_NEAR(fog.rgba[4 * i + c], std::lerp(clear.rgba[4 * i + c], c == 1 ? 1.0 : 0.0, share), 1e-4);
    }
}

TEST_P(Effect, ShadowsFallWhereARayToTheLightIsBlocked) {
    if (GetParam().style != Style::spacefill) return;  // thinner than a shadow's soft edge
    const Representation r = scene(GetParam().molecule, GetParam().style);
    RenderSettings s = settings(r, 128, GetParam().projection, {40, -70, 15});
    s.effects.light.ambient = s.effects.light.highlight = 0;
    ValidatedRenderer& renderer = sharedRenderer(Visibility::tiles, r);
    const LayerPicture bare = renderer->layers(s);
    s.effects.shadow.strength = 1;
    const LayerPicture shadowed = renderer->layers(s);
    const glm::dvec3 light = glm::normalize(glm::dvec3(-0.35, 0.55, 0.76));
    /// Whether a ball stands between a place and the light if all were larger by `more` Å.
    const auto blocked = [&](const glm::dvec3& place, std::uint32_t own, double more) {
        for (std::size_t i = 0; i < r.spheres.size(); ++i) {
            if (r.sphereLooks[i].atom == own) continue;
            const glm::dvec3 to = s.view.rotation * glm::dvec3(r.spheres[i].center) - place;
            const double along = glm::dot(to, light), reach = r.spheres[i].radius + more;
            if (reach > 0 && along > 0 && glm::dot(to, to) - along * along < reach * reach) return true;
        }
        return false;
    };
    // Edges are soft: what is nearer to one is not judged.
    constexpr double kSoft = 0.7;
    int dark = 0, bright = 0, wrong = 0;
    for (std::uint32_t y = 0; y < bare.height; ++y)
        for (std::uint32_t x = 0; x < bare.width; ++x) {
            const std::size_t at = std::size_t{y} * bare.width + x;
            const glm::dvec3 normal(bare.normal[3 * at], bare.normal[3 * at + 1], bare.normal[3 * at + 2]);
            if (bare.id[at] == 0 || glm::dot(normal, light) < 0.5) continue;
            const reference::Line line = reference::pixelLine(s.view, x, y);
            const glm::dvec3 place = line.origin + line.direction * (bare.z[at] / -line.direction.z);
            double share = 0;
            for (std::size_t c = 0; c < 3; ++c)
                share = std::max(share, double{shadowed.rgba[4 * at + c] / bare.rgba[4 * at + c]});
            if (blocked(place, bare.id[at], -kSoft)) {
                ++dark;
                wrong += share > 0.01;
            } else if (!blocked(place, bare.id[at], kSoft)) {
                ++bright;
                wrong += share < 0.99;
            }
        }
    EXPECT_GT(dark, 200);
    EXPECT_GT(bright, 300);
    EXPECT_LE(wrong, (dark + bright) / 30) << dark << " and " << bright;
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Effect,
    testing::Values(EffectCase{"spheres", "sample:dna", Style::spacefill, Projection::orthographic},
                    EffectCase{"spheres_in_perspective", "sample:dna", Style::spacefill, Projection::perspective},
                    EffectCase{"sticks", "sample:glucose", Style::licorice, Projection::orthographic},
                    EffectCase{"balls_and_sticks_in_perspective", "sample:buckyball", Style::ballAndStick,
                               Projection::perspective}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace nacre::test
