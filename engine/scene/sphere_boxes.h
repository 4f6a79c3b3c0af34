#pragma once
// Boxes about neighbouring spheres of a stream: tighter than balls where many of them are to be hidden.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/scene/representation.h"

namespace nacre {

/// About the centres of some spheres, as they are stored, Å.
struct SphereBox {
    glm::vec3 middle{};
    float radius = 0;  ///< of the largest
    glm::vec3 half{};
    float ball = 0;  ///< no centre is farther from the middle
};

/// Of a stream of spheres in the order of space.
struct SphereBoxes {
    static constexpr std::uint32_t kSpheres = 32;  ///< of a box
    static constexpr std::uint32_t kBoxes = 16;    ///< of a group

    std::vector<SphereBox> boxes;   ///< filled up with empty ones to a whole group
    std::vector<SphereBox> groups;  ///< about kBoxes of them each
    float reach = 0;                ///< no coordinate is larger, nor a radius; infinite, if one is no number
};

SphereBoxes sphereBoxesOf(std::span<const Sphere> spheres);

}  // namespace nacre
