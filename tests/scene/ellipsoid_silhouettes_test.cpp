// The outlines of ellipsoids in a picture, beside those of the quadrics: the figures of docs/pictures.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <span>
#include <string>

#include "engine/molecule/displacement.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/instances/mesh_levels.h"
#include "engine/scene/view/camera.h"
#include "engine/settings.h"

namespace nacre {
namespace {

/// Atoms as close as in crystals of small molecules (18 Å^3 each), in a ball, with displacements of all shapes.
Molecule ballOfAtoms(std::size_t count) {
    constexpr double kApart = 2.62;
    std::vector<glm::dvec3> places;
    for (int x = -8; x <= 8; ++x)
        for (int y = -8; y <= 8; ++y)
            for (int z = -8; z <= 8; ++z) places.push_back(kApart * glm::dvec3(x, y, z));
    std::ranges::stable_sort(places, {}, [](const glm::dvec3& p) { return glm::length(p); });
    std::string text = std::to_string(count) + "\n\n";
    for (const glm::dvec3& p : std::span(places).first(count))
        text += "C " + std::to_string(p.x) + ' ' + std::to_string(p.y) + ' ' + std::to_string(p.z) + '\n';
    Molecule m = readMolecule("ball.xyz", text);
    for (std::size_t i = 0; i < count; ++i) {
        const double s = static_cast<double>(i);
        const glm::dvec3 u = glm::normalize(glm::dvec3(std::sin(s), std::cos(2 * s), std::sin(3 * s) + 0.1));
        // 0.015 to 0.06 Å^2: B factors of 1.2 to 4.7 Å^2.
        const double across = 0.015 + 0.015 * std::abs(std::sin(5 * s)),
                     along = across + 0.03 * std::abs(std::cos(7 * s));
        glm::dmat3 tensor = glm::dmat3(across) + (along - across) * glm::outerProduct(u, u);
        m.displacements.push_back(toDisplacement(tensor));
    }
    return m;
}

/// The largest distance of the outlines of drawn ellipsoids from those of the quadrics, pixels.
double largestDistance(std::size_t count, double meshError) {
    const Molecule m = ballOfAtoms(count);
    const Representation r = represent(m, drawnAtoms(m), {.style = Style::ellipsoids});
    constexpr std::uint32_t kPixels = 2000;
    const View view = makeView({.rotationDegrees = {20, 30, 10}}, r.radius, kPixels, kPixels);
    constexpr int kRays = 360;
    std::vector<std::array<double, kRays>> reaches(m.atoms.size());
    for (auto& reach : reaches) reach.fill(0);
    for (const PrimitiveRun& run : drawnRuns(r, errorInSpace(view, meshError)))
        for (std::size_t i = run.first; i < std::size_t{run.first} + run.count; ++i) {
            const Triangle& t = drawnTriangle(r, i);
            const std::uint32_t atom = r.meshLooks[r.meshVertices[t.a].look].atom - 1;
            const auto at = [&](std::uint32_t v) {
                return glm::dvec2(view.rotation * (glm::dvec3(decodePosition(r.meshVertices[v], t.step())) + r.center -
                                                   glm::dvec3(m.atoms[atom].position)));
            };
            const glm::dvec2 corners[] = {at(t.a), at(t.b), at(t.c)};
            for (int side = 0; side < 3; ++side) {
                const glm::dvec2 a = corners[side], way = corners[(side + 1) % 3] - a;
                // Rays from the atom's centre that meet the side.
                const auto number = [](const glm::dvec2& p) {
                    return std::atan2(p.y, p.x) / (2 * std::numbers::pi) * kRays;
                };
                double from = number(a), to = number(a + way);
                if (from > to) std::swap(from, to);
                if (to - from > kRays / 2) std::swap(from, to), to += kRays;
                for (int ray = static_cast<int>(std::ceil(from)); ray <= static_cast<int>(std::floor(to)); ++ray) {
                    const double angle = 2 * std::numbers::pi * ray / kRays;
                    const glm::dvec2 d(std::cos(angle), std::sin(angle));
                    const double slope = d.x * way.y - d.y * way.x;
                    if (std::abs(slope) < 1e-12) continue;
                    double& reach = reaches[atom][static_cast<std::size_t>((ray + 2 * kRays) % kRays)];
                    reach = std::max(reach, (a.x * way.y - a.y * way.x) / slope);
                }
            }
        }
    double largest = 0;
    for (std::size_t i = 0; i < m.atoms.size(); ++i) {
        // The quadric's outline is that of its projected tensor.
        const double scale = probabilityScale(50);
        const glm::dmat3 turned = view.rotation * tensorMatrix(m.displacements[i]) * glm::transpose(view.rotation);
        const glm::dmat2 inverse = glm::inverse(glm::dmat2(turned) * scale * scale);
        for (int ray = 0; ray < kRays; ++ray) {
            const double angle = 2 * std::numbers::pi * ray / kRays;
            const glm::dvec2 p =
                glm::dvec2(std::cos(angle), std::sin(angle)) * reaches[i][static_cast<std::size_t>(ray)];
            const double square = glm::dot(p, inverse * p);
            EXPECT_LT(square, 1 + 1e-3) << "inside";
            const double slope = glm::length(inverse * p) / std::sqrt(square);
            largest = std::max(largest, std::abs(1 - std::sqrt(square)) / slope);
        }
    }
    return largest * view.pixelsPerAngstrom;
}

TEST(EllipsoidSilhouettes, AreWithinAFractionOfAPixel) {
    const double usual = RenderSettings{}.meshError;
    const struct {
        std::size_t count;
        double meshError, most;
    } rows[] = {{50, usual, 0.15}, {50, 0, 0.04}, {1000, usual, 0.25}};
    for (const auto& [count, meshError, most] : rows) {
        const double found = largestDistance(count, meshError);
        std::printf("%zu %g %.4f\n", count, meshError, found);
        EXPECT_LT(found, most) << count;
        EXPECT_GT(found, most / 2) << count << ": the page says more";
    }
}

}  // namespace
}  // namespace nacre
