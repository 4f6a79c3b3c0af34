#pragma once
// Directions that exist whatever the coordinates are.

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace nacre {

/// v at length 1; if it has no direction, `otherwise`.
inline glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& otherwise) {
    const double length = glm::length(v);
    return length > 1e-9 && std::isfinite(length) ? v / length : otherwise;
}

/// What of v is perpendicular to a unit vector.
inline glm::dvec3 across(const glm::dvec3& v, const glm::dvec3& unit) { return v - unit * glm::dot(v, unit); }

/// Some unit vector perpendicular to one.
inline glm::dvec3 anyAcross(const glm::dvec3& unit) {
    const glm::dvec3 other = std::abs(unit.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(across(other, unit));
}

}  // namespace nacre
