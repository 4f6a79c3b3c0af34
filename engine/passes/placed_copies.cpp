#include "engine/passes/placed_copies.h"

#include <cmath>
#include <glm/mat3x3.hpp>

namespace nacre::passes {
namespace {

/// Whether a sphere may show in the picture: on the inner side of the four planes through the eye and the picture's
/// edges, or nearer to them than its radius.
bool mayShow(const View& view, const glm::dvec3& center, double radius) {
    const double room = 2.0 / view.pixelsPerAngstrom;  // impostors reach a little beyond their spheres
    const double slope = view.eyeDistance > 0 ? 1.0 / view.eyeDistance : 0.0;
    // Beyond the edge that stands at `edge` on the plane z = 0.
    const auto beyond = [&](double across, double edge) {
        const double out = across - edge * (1.0 - center.z * slope);
        return out / std::sqrt(1.0 + edge * slope * edge * slope);
    };
    const auto shows = [&](double across, std::uint32_t pixels, double pan) {
        const double half = pixels / (2.0 * view.pixelsPerAngstrom) + room;
        return beyond(across, half - pan) <= radius && beyond(-across, half + pan) <= radius;
    };
    return shows(center.x, view.width, view.pan.x) && shows(center.y, view.height, view.pan.y);
}

std::uint64_t total(const std::vector<PlacedCopies::Call>& calls) {
    std::uint64_t sum = 0;
    for (const PlacedCopies::Call& call : calls) sum += call.count;
    return sum;
}

void addRows(const View& view, const glm::dmat4x3& transform, std::vector<glm::vec4>& rows) {
    const glm::dmat3 turn = view.rotation * glm::dmat3(transform[0], transform[1], transform[2]);
    const glm::dvec3 shift = view.rotation * transform[3];
    for (int i = 0; i < 3; ++i) rows.emplace_back(turn[0][i], turn[1][i], turn[2][i], shift[i]);
}

void addCalls(const Copies& copies, const std::vector<PrimitiveRun>& runs, const View& view,
              std::vector<PlacedCopies::Call>& calls) {
    for (const PrimitiveRun& run : runs)
        for (const std::uint32_t copy : copies.lists[run.list]) {
            const glm::dvec3 center = view.rotation * (copies.transforms[copy] * glm::dvec4(run.center, 1.0));
            if (mayShow(view, center, run.radius)) calls.push_back({copy, run.first, run.count});
        }
}

}  // namespace

std::uint64_t PlacedCopies::sphereCount() const { return total(spheres); }
std::uint64_t PlacedCopies::cylinderCount() const { return total(cylinders); }
std::uint64_t PlacedCopies::triangleCount() const { return total(triangles); }

PlacedCopies placeCopies(const Representation& r, const View& view) {
    PlacedCopies placed;
    if (r.copies.transforms.empty()) {
        addRows(view, glm::dmat4x3(1.0), placed.rows);
        placed.spheres = {{0, 0, static_cast<std::uint32_t>(r.spheres.size())}};
        if (!r.cylinders.empty()) placed.cylinders = {{0, 0, static_cast<std::uint32_t>(r.cylinders.size())}};
        if (!r.triangles.empty()) placed.triangles = {{0, 0, static_cast<std::uint32_t>(r.triangles.size())}};
        return placed;
    }
    placed.rows.reserve(3 * r.copies.transforms.size());
    for (const glm::dmat4x3& transform : r.copies.transforms) addRows(view, transform, placed.rows);
    addCalls(r.copies, r.copies.spheres, view, placed.spheres);
    addCalls(r.copies, r.copies.cylinders, view, placed.cylinders);
    addCalls(r.copies, r.copies.triangles, view, placed.triangles);
    return placed;
}

}  // namespace nacre::passes
