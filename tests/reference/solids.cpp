#include "tests/reference/solids.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace nacre::reference {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

struct Interval {
    double low, high;
};

/// t at which |offset + t * slope| <= radius. Works from the point of closest approach: nothing large cancels.
std::optional<Interval> withinDistance(const glm::dvec3& offset, const glm::dvec3& slope, double radius) {
    const double square = glm::dot(slope, slope);
    if (square == 0.0) {
        if (glm::length(offset) > radius) return std::nullopt;
        return Interval{-kUnbounded, kUnbounded};
    }
    const double middle = -glm::dot(offset, slope) / square;
    const glm::dvec3 closest = offset + middle * slope;
    const double rest = radius * radius - glm::dot(closest, closest);
    if (rest < 0.0) return std::nullopt;
    const double half = std::sqrt(rest / square);
    return Interval{middle - half, middle + half};
}

/// t at which 0 <= offset + t * slope <= length.
std::optional<Interval> betweenPlanes(double offset, double slope, double length) {
    if (slope == 0.0) {
        if (offset < 0.0 || offset > length) return std::nullopt;
        return Interval{-kUnbounded, kUnbounded};
    }
    const double first = -offset / slope, second = (length - offset) / slope;
    return Interval{std::min(first, second), std::max(first, second)};
}

}  // namespace

std::optional<Crossing> cross(const Line& line, const Ball& ball) {
    if (!(ball.radius > 0.0)) return std::nullopt;
    const glm::dvec3 offset = line.origin - ball.center;
    const auto inside = withinDistance(offset, line.direction, ball.radius);
    if (!inside) return std::nullopt;
    const glm::dvec3 normal = glm::normalize(offset + inside->low * line.direction);
    return Crossing{inside->low, inside->high, normal, 0.0};
}

std::optional<Crossing> cross(const Line& line, const Rod& rod) {
    const double length = glm::length(rod.b - rod.a);
    if (!(rod.radius > 0.0) || !(length > 0.0)) return std::nullopt;
    const glm::dvec3 axis = (rod.b - rod.a) / length;
    const glm::dvec3 offset = line.origin - rod.a;
    const double height = glm::dot(offset, axis), climb = glm::dot(line.direction, axis);
    const glm::dvec3 radial = offset - height * axis, drift = line.direction - climb * axis;

    const auto round = withinDistance(radial, drift, rod.radius);
    const auto slab = betweenPlanes(height, climb, length);
    if (!round || !slab) return std::nullopt;
    const double enter = std::max(round->low, slab->low), leave = std::min(round->high, slab->high);
    if (enter > leave) return std::nullopt;

    const bool byCap = slab->low > round->low;
    const glm::dvec3 normal = byCap ? (climb > 0.0 ? -axis : axis) : glm::normalize(radial + enter * drift);
    return Crossing{enter, leave, normal, std::clamp((height + enter * climb) / length, 0.0, 1.0)};
}

}  // namespace nacre::reference
