#include "engine/passes/corners.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace nacre::passes {
namespace {

/// The facets of a pyramid touch the sphere this many radii from its axis: at radius rho they are (1 - rho kLean) /
/// sqrt(1 - kLean^2) radii in front of the centre, never behind the surface.
constexpr float kLean = 0.6f;
constexpr float kSquareInset = 0.70710678f, kOctagonInset = 0.92387953f;  // cosine of half a side's angle

/// Strip order: the left pair, then pairs by rising x, with positive y second.
void addSquare(glm::vec3*& at, float reach) {
    for (const float x : {-reach, reach})
        for (const float y : {-reach, reach}) *at++ = {x, y, 1.001f};
}
void addOctagon(glm::vec3*& at, float reach) {
    const float t = 0.41421356f * reach;  // tan 22.5 degrees
    for (const auto& [x, y] : {std::pair(-reach, t), {-t, reach}, {t, reach}, {reach, t}})
        for (const float side : {-y, y}) *at++ = {x, side, 1.001f};
}
void addPyramid(glm::vec3*& at) {
    const float rim = std::sqrt(1 - kLean * kLean);
    *at++ = {0, 0, 1 / rim + 2e-3f};  // the same number as in shaders/sphere.vert
    for (int i = 0; i < 8; ++i) {
        const float angle = (static_cast<float>(i) + 0.5f) * std::numbers::pi_v<float> / 4;
        *at++ = {std::cos(angle) / kOctagonInset, std::sin(angle) / kOctagonInset, (1 - kLean) / rim + 2e-3f};
    }
}

}  // namespace

std::array<glm::vec3, kCornerCount> cornerStream() {
    std::array<glm::vec3, kCornerCount> corners;
    glm::vec3* at = corners.data();
    addSquare(at, 1);
    addOctagon(at, 1);
    addPyramid(at);
    addSquare(at, kSquareInset);
    addOctagon(at, kOctagonInset);
    return corners;
}

std::array<std::uint16_t, kPyramidIndices> pyramidIndices() {
    std::array<std::uint16_t, kPyramidIndices> indices{};
    for (std::uint16_t facet = 0; facet < 8; ++facet) {
        indices[3 * facet + 1] = static_cast<std::uint16_t>(facet + 1);
        indices[3 * facet + 2] = static_cast<std::uint16_t>((facet + 1) % 8 + 1);
    }
    return indices;
}

}  // namespace nacre::passes
