#pragma once
// Random numbers and directions of the reference renderers.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <random>

namespace nacre::reference {

/// Same sequence on every standard library, unlike std::uniform_real_distribution.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    /// In [0, 1).
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    std::size_t below(std::size_t count) {
        return std::min(static_cast<std::size_t>(unit() * static_cast<double>(count)), count - 1);
    }

private:
    std::mt19937_64 engine_;
};

/// A direction above a surface, even over the unit disc and lifted to the hemisphere: density cos / pi (Nusselt's
/// analogue). @param square, turn  even over [0, 1)
inline glm::dvec3 cosineDirection(const glm::dvec3& normal, double square, double turn) {
    const glm::dvec3 size = glm::abs(normal);
    glm::dvec3 least(0.0);
    least[size.x <= size.y && size.x <= size.z ? 0 : (size.y <= size.z ? 1 : 2)] = 1.0;
    const glm::dvec3 across = glm::normalize(glm::cross(least, normal)), upward = glm::cross(normal, across);
    const double reach = std::sqrt(square), angle = 2.0 * std::numbers::pi * turn;
    return reach * std::cos(angle) * across + reach * std::sin(angle) * upward + std::sqrt(1.0 - square) * normal;
}

}  // namespace nacre::reference
