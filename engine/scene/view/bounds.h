#pragma once
// The sphere that a view frames.

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <optional>
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

/// Bounds of balls that may be too many to store. Without any ball the centre is NaN.
/// @param eachBall  calls its argument with the centre and radius of each ball, Å; called twice
/// @param about  another centre
template <typename EachBall>
Bounds boundsOfEach(const EachBall& eachBall, const std::optional<glm::dvec3>& about = {}) {
    Box box;
    if (!about) eachBall([&](const glm::dvec3& center, double) { box.add(center); });
    Bounds bounds{about.value_or(box.center()), 0};
    eachBall([&](const glm::dvec3& center, double radius) {
        bounds.radius = glm::max(bounds.radius, glm::length(center - bounds.center) + radius);
    });
    return bounds;
}

/// @param balls  centre and radius of each, Å; at least one
inline Bounds computeBounds(std::span<const glm::dvec4> balls, const std::optional<glm::dvec3>& about = {}) {
    const auto each = [&](const auto& visit) {
        for (const glm::dvec4& ball : balls) visit(ball, ball.w);
    };
    return boundsOfEach(each, about);
}

/// Bounds of the same balls about another centre: a sphere that contains the first.
inline Bounds movedTo(const std::optional<glm::dvec3>& center, const Bounds& bounds) {
    return center ? Bounds{*center, bounds.radius + glm::length(*center - bounds.center)} : bounds;
}

}  // namespace nacre
