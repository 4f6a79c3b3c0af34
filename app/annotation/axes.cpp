// The axes cross: arrows that turn with the view.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/annotation/room.h"

namespace nacre::app {
namespace {

// In em.
constexpr double kArm = 2.3, kName = 0.7, kHead = 0.7, kHeadRadius = 0.26, kShaftRadius = 0.075;

/// The convex hull, clockwise as seen, since y points down (A. M. Andrew, Inf. Process. Lett. 9 (1979) 216).
std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points) {
    std::ranges::sort(points,
                      [](const glm::dvec2& p, const glm::dvec2& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
    std::vector<glm::dvec2> hull;
    for (int half = 0; half < 2; ++half) {
        const std::size_t first = hull.size();
        for (const glm::dvec2& p : points) {
            while (hull.size() >= first + 2) {
                const glm::dvec2 a = hull[hull.size() - 1] - hull[hull.size() - 2], b = p - hull.back();
                if (a.x * b.y - a.y * b.x > 0) break;
                hull.pop_back();
            }
            hull.push_back(p);
        }
        hull.pop_back();  // the other half begins with it
        std::ranges::reverse(points);
    }
    return hull;
}

/// The visible side of a cone, or of a cylinder, whose radii are equal. @param way  a unit vector in view space
ShapeMark makeCone(const glm::dvec2& origin, const glm::dvec3& way, double from, double radius, double to, double end,
                   std::uint32_t color) {
    constexpr int kSides = 24;
    const glm::dvec3 aside = std::abs(way.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(way, aside)), v = glm::cross(way, u);
    std::vector<glm::dvec2> points;
    for (int i = 0; i < kSides; ++i) {
        const double angle = 2 * std::numbers::pi * i / kSides;
        const glm::dvec3 out = std::cos(angle) * u + std::sin(angle) * v;
        for (const glm::dvec3& p : {from * way + radius * out, to * way + end * out})
            points.emplace_back(origin + glm::dvec2(p.x, -p.y));
    }
    return {convexHull(std::move(points)), color};
}

}  // namespace

std::vector<PlacedAxis> makeAxes(const std::optional<std::array<glm::dvec3, 3>>& cell) {
    constexpr const char *kSpace[] = {"x", "y", "z"}, *kCell[] = {"a", "b", "c"};
    std::vector<PlacedAxis> axes;
    for (std::size_t i = 0; i < 3; ++i) {
        glm::dvec3 way(0);
        way[static_cast<int>(i)] = 1;
        if (cell) way = glm::normalize((*cell)[i]);
        axes.push_back({way, cell ? kCell[i] : kSpace[i], kAxisColors[i]});
    }
    return axes;
}

void layAxes(Room& room, const std::vector<PlacedAxis>& axes) {
    if (axes.empty()) return;
    const double em = room.size, reach = (kArm + 2 * kName) * em;
    const glm::dvec2 origin(room.margin + reach, room.view.height - room.margin - reach);
    struct Arm {
        const PlacedAxis* axis;
        glm::dvec3 way;  // in view space
    };
    std::vector<Arm> arms;
    glm::dvec2 middle(0);
    for (const PlacedAxis& axis : axes) {
        arms.push_back({&axis, room.view.rotation * axis.way});
        middle += glm::dvec2(arms.back().way);
    }
    std::ranges::stable_sort(arms, [](const Arm& a, const Arm& b) { return a.way.z < b.way.z; });
    for (const auto& [axis, way] : arms) {
        const double neck = (kArm - kHead) * em;
        room.marks.shapes.push_back(makeCone(origin, way, 0, kShaftRadius * em, neck, kShaftRadius * em, axis->color));
        room.marks.shapes.push_back(makeCone(origin, way, neck, kHeadRadius * em, kArm * em, 0, axis->color));
        // A name is beyond the tip of its axis, or beside an axis along the line of sight.
        const glm::dvec2 tip(way), away = tip - 0.15 * (middle - tip);
        const glm::dvec2 side = glm::length(away) > 1e-6 ? glm::normalize(away) : glm::dvec2(-1, 0);
        const glm::dvec2 at = origin + em * glm::dvec2(1, -1) * (kArm * tip + kName * side);
        room.ink = axis->color;
        room.put(axis->name, at + em * glm::dvec2(-room.widthOfRuns(axis->name, 1) / 2, 0.27), em);
    }
    room.ink = 0;
    room.taken.push_back({origin - reach, origin + reach});
}

}  // namespace nacre::app
