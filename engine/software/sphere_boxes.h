#pragma once
// Boxes of consecutive spheres of a stream: tighter than balls, for culling many hidden spheres.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/scene/build/representation.h"

namespace nacre {

/// Bounds of some spheres' centres as stored, Å.
struct SphereBox {
    glm::vec3 middle{};
    float radius = 0;  ///< largest radius of a sphere
    glm::vec3 half{};
    float ball = 0;  ///< largest distance of a centre from the box's centre
};

/// Boxes of a stream of spheres in spatial order, or in their own order, which keeps runs of copies or models together.
struct SphereBoxes {
    static constexpr std::uint32_t kSpheres = 32;  ///< per box
    static constexpr std::uint32_t kBoxes = 16;    ///< on average, per group

    std::vector<SphereBox> boxes;        ///< padded with empty ones to whole groups
    std::vector<SphereBox> groups;       ///< of about kBoxes boxes each
    std::vector<Sphere> spheres;         ///< in the order of the boxes; empty: the stream's
    std::vector<std::uint32_t> numbers;  ///< of these spheres, in the stream
    std::vector<std::uint32_t> starts;   ///< of the runs, and the end of the last
    float reach = 0;                     ///< bound of all coordinates and radii; infinite if any is NaN
};

SphereBoxes makeSphereBoxes(std::span<const Sphere> spheres);
/// The boxes of a scene, in their own order if it has copies.
SphereBoxes makeSphereBoxes(const Representation& representation);

}  // namespace nacre
