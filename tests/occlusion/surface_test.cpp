// What must not show in baked occlusion: the seams of its maps, light inside contacts.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tests/occlusion/scenes.h"
#include "tests/occlusion/traced_points.h"

namespace nacre::test {
namespace {

Representation spheres(std::vector<Sphere> list) {
    Representation r;
    r.spheres = std::move(list);
    for (std::uint32_t i = 0; i < r.spheres.size(); ++i) {
        r.sphereLooks.push_back({0xffffffff, i + 1});
        r.radius = std::max(r.radius, static_cast<double>(glm::length(r.spheres[i].center) + r.spheres[i].radius));
    }
    r.drawnAtoms = r.spheres.size();
    return r;
}

/// Largest step of occlusion between neighbouring pixels of sphere 1, over views all around it: anywhere, and where the
/// octahedral map is folded or cut (an axis of its normal changes sign between the pixels).
struct Steps {
    float anywhere = 0, seam = 0;
};
Steps largestSteps(const Representation& r) {
    ValidatedRenderer renderer(Visibility::automatic, r);
    Steps steps;
    for (const glm::dvec3& turn : {glm::dvec3(0, 0, 0),
                                   {90, 0, 0},
                                   {-90, 0, 0},
                                   {0, 90, 0},
                                   {0, -90, 0},
                                   {180, 0, 0},
                                   {35, 45, 0},
                                   {-35, 135, 20}}) {
        RenderSettings s = settings(r, 256, Projection::orthographic, turn);
        s.occlusion.directions = 256;
        const LayerPicture p = renderer->layers(s);
        const glm::dmat3 back = glm::transpose(s.view.rotation);
        const auto normal = [&](std::size_t i) {
            return back * glm::dvec3(p.normal[3 * i], p.normal[3 * i + 1], p.normal[3 * i + 2]);
        };
        for (std::size_t i = 0; i + 256 < p.id.size(); ++i)
            for (const std::size_t j : {i + 1, i + 256}) {
                if (p.id[i] != 1 || p.id[j] != 1) continue;
                const glm::dvec3 a = normal(i), b = normal(j);
                if (glm::dot(a, b) < std::cos(0.06)) continue;  // at the silhouette a pixel is a long way
                const float step = std::abs(p.occlusion[i] - p.occlusion[j]);
                steps.anywhere = std::max(steps.anywhere, step);
                if (a.x * b.x < 0 || a.y * b.y < 0 || a.z * b.z < 0) steps.seam = std::max(steps.seam, step);
            }
    }
    return steps;
}

TEST(OcclusionSeams, ALoneSphereHasNone) {
    EXPECT_LE(largestSteps(spheres({{{0, 0, 0}, 1.7f}})).anywhere, 1.01f / 255);
}

TEST(OcclusionSeams, AHalfCoveredSphereStepsNoMoreThereThanElsewhere) {
    // A large neighbour covers one side; its shadow crosses the folds of the map.
    for (const glm::vec3& way : {glm::vec3(0, 0, 1), {1, 0, 0}, {0.577f, 0.577f, 0.577f}}) {
        const Steps steps = largestSteps(spheres({{{0, 0, 0}, 1.7f}, {way * 3.0f, 3.0f}}));
        EXPECT_GT(steps.anywhere, 0.004f);
        EXPECT_LE(steps.seam, 0.06f);
        EXPECT_LE(steps.seam, steps.anywhere);
    }
}

TEST(OcclusionContacts, LetNoLightIn) {
    // Around the contact of two spheres, and in the hollow between four: what rays say is dark is dark.
    const float s = 1.5f;
    for (const Representation& r :
         {spheres({{{0, 0, 0}, 1.7f}, {{0, 0, 3.4f}, 1.7f}}), spheres({{{0, 0, 0}, 1.7f}, {{0, 0, 2.2f}, 1.5f}}),
          spheres({{{s, s, s}, 2}, {{s, -s, -s}, 2}, {{-s, s, -s}, 2}, {{-s, -s, s}, 2}, {{0, 0, 0}, 1}})}) {
        ValidatedRenderer renderer(Visibility::automatic, r);
        const auto points = tracePoints(*renderer.operator->(), r, 4000, 400);
        RenderSettings settings;
        settings.supersample = 1;
        settings.occlusion.directions = 256;
        std::vector<TracedPoint> dark;
        std::copy_if(points.begin(), points.end(), std::back_inserter(dark),
                     [](const TracedPoint& p) { return p.open < 0.3; });
        const Difference all = bakedDifference(*renderer.operator->(), r, settings, points);
        EXPECT_LE(all.rootMeanSquare, 0.03);
        if (dark.size() < 20) continue;
        const Difference d = bakedDifference(*renderer.operator->(), r, settings, dark);
        EXPECT_LE(d.mean, 0.03) << dark.size() << " points";
        EXPECT_LE(d.worst, 0.25);
    }
}

TEST(OcclusionSeen, AnAtomInACageIsNotAndItsWallsAre) {
    std::vector<Sphere> cage{{{0, 0, 0}, 0.5f}};
    for (int i = 0; i < 60; ++i) {
        const double z = 1 - (2 * i + 1) / 60.0, angle = 2 * std::numbers::pi * std::fmod(i / std::numbers::phi, 1.0);
        const double flat = std::sqrt(1 - z * z);
        cage.push_back({glm::vec3(4 * flat * std::cos(angle), 4 * flat * std::sin(angle), 4 * z), 1.6f});
    }
    ValidatedRenderer renderer(Visibility::automatic, spheres(cage));
    RenderSettings s = settings(spheres(cage), 64, Projection::orthographic);
    s.occlusion.directions = 64;
    EXPECT_TRUE(renderer->seenSpheres().empty());
    renderer->layers(s);
    const std::vector<bool> seen = renderer->seenSpheres();
    ASSERT_EQ(seen.size(), cage.size());
    EXPECT_FALSE(seen[0]);
    EXPECT_EQ(std::count(seen.begin(), seen.end(), true), 60);
    EXPECT_EQ(renderer->stats().occlusion.neverSeen, 1u);
}

}  // namespace
}  // namespace nacre::test
