#include "engine/occlusion/directions.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace nacre {
namespace {

/// One end of each axis.
std::vector<glm::dvec3> fibonacciHemisphere(int count) {
    std::vector<glm::dvec3> points;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (i + 0.5) / count;
        const double angle = 2.0 * std::numbers::pi * std::fmod(i / std::numbers::phi, 1.0);
        const double flat = std::sqrt(std::max(0.0, 1.0 - z * z));
        points.emplace_back(flat * std::cos(angle), flat * std::sin(angle), z);
    }
    return points;
}

/// Sorts the axes: each is the one farthest from all axes before it.
void spreadPrefixes(std::vector<glm::dvec3>& axes) {
    std::vector<double> nearest(axes.size(), 0.0);  // cosine of the angle to the axes placed so far
    for (std::size_t placed = 1; placed < axes.size(); ++placed) {
        std::size_t farthest = placed;
        for (std::size_t i = placed; i < axes.size(); ++i) {
            nearest[i] = std::max(nearest[i], std::abs(glm::dot(axes[i], axes[placed - 1])));
            if (nearest[i] < nearest[farthest]) farthest = i;
        }
        std::swap(axes[placed], axes[farthest]);
        std::swap(nearest[placed], nearest[farthest]);
    }
}

}  // namespace

std::vector<glm::dmat3> occlusionDirections(int count) {
    std::vector<glm::dvec3> axes = fibonacciHemisphere((count + 1) / 2);
    spreadPrefixes(axes);
    std::vector<glm::dmat3> frames;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const glm::dvec3 w = axes[i / 2] * (i % 2 == 0 ? 1.0 : -1.0);
        const glm::dvec3 helper = std::abs(w.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
        const glm::dvec3 x = glm::normalize(glm::cross(helper, w)), y = glm::cross(w, x);
        const double roll =
            2.0 * std::numbers::pi * std::fmod(static_cast<double>(i) * std::pow(std::numbers::phi, 3), 1.0);
        const glm::dvec3 u = x * std::cos(roll) + y * std::sin(roll);
        frames.push_back(glm::transpose(glm::dmat3(u, glm::cross(w, u), w)));
    }
    return frames;
}

}  // namespace nacre
