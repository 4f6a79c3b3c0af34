#pragma once
// Direction vectors that are defined for any coordinates.

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace nacre {

/// v normalised; `otherwise` if its length is zero or not finite.
inline glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& otherwise) {
    const double length = glm::length(v);
    return length > 1e-9 && std::isfinite(length) ? v / length : otherwise;
}

/// The component of v perpendicular to a unit vector.
inline glm::dvec3 across(const glm::dvec3& v, const glm::dvec3& unit) { return v - unit * glm::dot(v, unit); }

/// A unit vector perpendicular to another.
inline glm::dvec3 anyAcross(const glm::dvec3& unit) {
    const glm::dvec3 other = std::abs(unit.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(across(other, unit));
}

}  // namespace nacre
