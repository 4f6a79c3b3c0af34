#include "engine/scene/build/bond_cylinders.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace nacre {

BondStrands bondStrands(std::uint8_t order, bool inRing) {
    constexpr BondStrands::Strand kInner{0.3f, 0.05f};
    switch (order) {
        case 2:
            if (inRing) return {{{{0.0f, 0.12f}}}, 1, {0.29f, 0.07f}};
            return {{{{-0.13f, 0.08f}, {0.13f, 0.08f}}}, 2};
        case 3:
            return {{{{-0.155f, 0.055f}, {0.0f, 0.055f}, {0.155f, 0.055f}}}, 3};
        case 4:
        case 5:
            return {{{{0.0f, kBondRadius}}}, 1, kInner};
        default:
            return {{{{0.0f, kBondRadius}}}, 1};
    }
}

BondStrands licoriceStrands(std::uint8_t order, bool inRing) {
    constexpr float kStick = 0.25f;
    switch (order) {
        case 2:
            if (inRing) return {{{{0.0f, kStick}}}, 1, {0.43f, 0.09f}};
            return {{{{-0.14f, 0.11f}, {0.14f, 0.11f}}}, 2};
        case 3:
            return {{{{-0.175f, 0.075f}, {0.0f, 0.075f}, {0.175f, 0.075f}}}, 3};
        case 4:
        case 5:
            return {{{{0.0f, kStick}}}, 1, {0.43f, 0.08f}};
        default:
            return {{{{0.0f, kStick}}}, 1};
    }
}

BondStrands scaled(BondStrands strands, double factor) {
    if (factor == 1) return strands;
    const auto scale = [&](BondStrands::Strand& strand) {
        strand.offset *= static_cast<float>(factor);
        strand.radius *= static_cast<float>(factor);
    };
    for (BondStrands::Strand& strand : strands.strands) scale(strand);
    scale(strands.inner);
    return strands;
}

Dashes bondDashes(double length, double radiusA, double radiusB) {
    constexpr double kDash = 0.16;  // Å, about; a coordination of 2 Å gets three
    constexpr double kMost = 16;    // a file may state bonds of any length
    const double free = length - radiusA - radiusB;
    if (!(free > 0)) return {};
    const double count = std::clamp(std::round((free / kDash - 1) / 2), 1.0, kMost);
    const double dash = free / (2 * count + 1);
    return {radiusA + dash, dash, static_cast<int>(count)};
}

glm::dvec3 bondSide(const glm::dvec3& axis, const glm::dvec3& toward) {
    const glm::dvec3 across = toward - axis * glm::dot(axis, toward);
    const double length = glm::length(across);
    if (length > 1e-3) return across / length;
    // Nearly straight: the coordinate axis farthest from the bond gives a side that never degenerates.
    const glm::dvec3 size = glm::abs(axis);
    const glm::dvec3 other = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                             : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                  : glm::dvec3(0, 0, 1);
    return glm::normalize(glm::cross(axis, other));
}

}  // namespace nacre
