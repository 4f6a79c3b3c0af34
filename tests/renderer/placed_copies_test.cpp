// What is left out of a view because it lies beside the picture.

#include "engine/passes/placed_copies.h"

#include <cmath>
#include <random>
#include <set>

#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

/// Molecules scattered over a box of 80 Å.
Representation scattered(int copies) {
    Molecule m = sampleMolecule("glucose");
    m.subchains = {"A"};
    m.assemblies = {{"1", "", {{{}, {0}}}}};
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-40, 40);
    for (int i = 0; i < copies; ++i) {
        glm::mat4x3 transform(1.0f);
        transform[3] = {place(random), place(random), place(random)};
        m.assemblies[0].parts[0].transforms.push_back(transform);
    }
    return represent(m, drawnAtoms(m), RepresentationOptions{.style = Style::ballAndStick, .assembly = "1"});
}

/// Whether some sphere of a copy reaches into the picture.
bool shows(const Representation& r, const View& view, const glm::dmat4x3& transform) {
    for (const Sphere& sphere : r.spheres) {
        const glm::dvec3 p = view.rotation * (transform * glm::dvec4(glm::dvec3(sphere.center), 1.0));
        const double magnify = view.eyeDistance > 0 ? view.eyeDistance / (view.eyeDistance - p.z) : 1.0;
        const double x = (std::abs(p.x) - sphere.radius) * magnify * view.pixelsPerAngstrom;
        const double y = (std::abs(p.y) - sphere.radius) * magnify * view.pixelsPerAngstrom;
        if (x < view.width / 2.0 && y < view.height / 2.0) return true;
    }
    return false;
}

TEST(PlacedCopies, LeaveOutNothingThatShowsAndMostOfTheRest) {
    const Representation r = scattered(200);
    for (const Projection projection : {Projection::orthographic, Projection::perspective})
        for (const double zoom : {1.0, 4.0, 10.0}) {
            const View view = settings(r, 200, projection, {20, 50, 70}, zoom).view;
            const passes::PlacedCopies placed = passes::placeCopies(r, view);
            std::set<std::uint32_t> drawn;
            for (const auto& call : placed.spheres) drawn.insert(call.copy);
            std::size_t showing = 0;
            for (std::uint32_t i = 0; i < 200; ++i) {
                const bool seen = shows(r, view, r.copies.transforms[i]);
                showing += seen;
                EXPECT_TRUE(!seen || drawn.contains(i)) << "zoom " << zoom << ", copy " << i;
            }
            EXPECT_EQ(placed.sphereCount(), drawn.size() * r.spheres.size());
            // A few stand at the edge, where a sphere about the molecule reaches in and no atom does.
            EXPECT_LE(drawn.size(), showing + 40) << "zoom " << zoom;
            if (zoom == 1) {
                EXPECT_EQ(drawn.size(), 200u);
            }
        }
}

TEST(PlacedCopies, OfAPlainMoleculeAreTheViewsRotation) {
    const Representation r = scene("sample:dna", Style::spacefill);
    const View view = settings(r, 100, Projection::orthographic).view;
    const passes::PlacedCopies placed = passes::placeCopies(r, view);
    ASSERT_EQ(placed.rows.size(), 3u);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(placed.rows[static_cast<std::size_t>(i)],
                  glm::vec4(view.rotation[0][i], view.rotation[1][i], view.rotation[2][i], 0));
    EXPECT_EQ(placed.sphereCount(), r.spheres.size());
}

}  // namespace
}  // namespace nacre::test
