#include "engine/scene/build/ellipsoid_rows.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace nacre {

std::array<glm::vec3, 3> EllipsoidRows::axes() const {
    std::array<glm::vec3, 3> all{first, second, glm::cross(first, second) * third};
    for (glm::vec3& axis : all) axis /= glm::dot(axis, axis);
    return all;
}

float EllipsoidRows::inner() const {
    const auto [a, b, c] = axes();
    return std::min({glm::length(a), glm::length(b), glm::length(c)});
}

glm::vec3 EllipsoidRows::toUnit(const glm::vec3& p) const {
    return {glm::dot(first, p), glm::dot(second, p), glm::dot(glm::cross(first, second) * third, p)};
}

glm::vec3 EllipsoidRows::gradient(const glm::vec3& unit) const {
    return glm::normalize(first * unit.x + second * unit.y + glm::cross(first, second) * (third * unit.z));
}

glm::vec3 EllipsoidRows::place(const glm::vec3& normal) const {
    glm::vec3 sum(0);
    float square = 0;
    for (const glm::vec3& axis : axes()) {
        const float share = glm::dot(axis, normal);
        sum += axis * share;
        square += share * share;
    }
    return sum / std::sqrt(square);
}

EllipsoidRows ellipsoidRows(const std::array<glm::dvec3, 3>& axes) {
    constexpr double kHalfWidth = 0.045;  // of a band, of the mean axis
    const double a = glm::length(axes[0]), b = glm::length(axes[1]), c = glm::length(axes[2]);
    return {glm::vec3(axes[0] / (a * a)), static_cast<float>(a * b / c), glm::vec3(axes[1] / (b * b)),
            static_cast<float>(kHalfWidth * std::cbrt(a * b * c))};
}

EllipsoidRows sphereRows(float radius) { return {glm::vec3(1 / radius, 0, 0), radius, glm::vec3(0, 1 / radius, 0), 0}; }

}  // namespace nacre
