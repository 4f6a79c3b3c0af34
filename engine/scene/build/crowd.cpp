#include "engine/scene/build/crowd.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>

#include "engine/error.h"
#include "engine/scene/build/representation.h"

namespace nacre {

void refuseCrowd(const Representation& r) {
    constexpr double kMostCovered = 10'000;
    const auto countCopies = [&](const PrimitiveRun& run) {
        return static_cast<double>(r.copies.lists[run.list].size());
    };
    const auto area = [](const auto& primitives, std::size_t first, std::size_t count, const auto& measureArea) {
        double sum = 0;
        for (std::size_t i = first; i < first + count; ++i) sum += measureArea(primitives[i]);
        return sum;
    };
    const auto disc = [](const Sphere& s) { return std::numbers::pi * static_cast<double>(s.radius) * s.radius; };
    const auto side = [](const Cylinder& c) { return 2.0 * static_cast<double>(c.radius) * glm::distance(c.a, c.b); };
    // Averaged over all directions, a facet covers half of its area.
    const auto facet = [&](const Triangle& t) {
        const auto at = [&](std::uint32_t v) { return glm::dvec3(decodePosition(r.meshVertices[v], t.step())); };
        return 0.25 * glm::length(glm::cross(at(t.b) - at(t.a), at(t.c) - at(t.a)));
    };
    double covered = 0;
    if (r.copies.transforms.empty())
        covered = area(r.spheres, 0, r.spheres.size(), disc) + area(r.cylinders, 0, r.cylinders.size(), side) +
                  area(r.triangles, 0, r.triangles.size(), facet);
    for (const PrimitiveRun& run : r.copies.spheres)
        covered += countCopies(run) * area(r.spheres, run.first, run.count, disc);
    for (const PrimitiveRun& run : r.copies.cylinders)
        covered += countCopies(run) * area(r.cylinders, run.first, run.count, side);
    for (const PrimitiveRun& run : r.copies.triangles)
        covered += countCopies(run) * area(r.triangles, run.first, run.count, facet);
    const double times = covered / (std::numbers::pi * r.radius * r.radius);
    if (times > kMostCovered)
        throw Error("cannot draw molecule", "",
                    "its atoms, bonds and surfaces lie over one another " + std::to_string(std::llround(times)) +
                        " times, more than the limit of " + std::to_string(std::llround(kMostCovered)) +
                        " (draw fewer of them, or as thinner sticks)");
}

}  // namespace nacre
