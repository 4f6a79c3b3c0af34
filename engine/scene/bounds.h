#pragma once
// The sphere that a view frames.

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <span>

namespace nacre {

struct Bounds {
    glm::dvec3 center{};  ///< centre of the axis-aligned box of the balls' centres
    double radius = 0;    ///< max(|p - center| + r)
};

/// An axis-aligned box that grows.
struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
    void add(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    glm::dvec3 center() const { return (low + high) / 2.0; }
};

/// @param balls  centre and radius of each, Å; at least one
inline Bounds boundsOf(std::span<const glm::dvec4> balls) {
    Box box;
    for (const glm::dvec4& ball : balls) box.add(ball);
    Bounds bounds{box.center(), 0};
    for (const glm::dvec4& ball : balls)
        bounds.radius = glm::max(bounds.radius, glm::length(glm::dvec3(ball) - bounds.center) + ball.w);
    return bounds;
}

}  // namespace nacre
