#pragma once
// What was baked of ambient occlusion, on the host: for those who write it into files.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace nacre {

/// Texels as the device has them (engine/occlusion/atlas_layout.h): patches of spheres, of cylinders, and vertices.
/// All that it tells is how open a place is: 0 closed to 1.
struct BakedOcclusion {
    std::uint32_t sphereEdge = 0, around = 0, along = 0;  ///< texels across patches
    std::uint32_t width = 0;                              ///< of a row
    std::uint32_t sphereRows = 0, cylinderRows = 0;
    std::vector<std::uint8_t> texels;  ///< row by row; empty: there is nothing to bake, and all is open

    // Primitives by their places in the Representation that was set, after orderInSpace(); directions as it has them.

    /// @param normal  unit
    float ofSphere(std::uint32_t sphere, const glm::vec3& normal) const;
    /// @param axis, normal  unit, across each other @param share  0 at its first end, 1 at its second
    float ofCylinder(std::uint32_t cylinder, const glm::vec3& axis, const glm::vec3& normal, float share) const;
    /// Of a mesh's outer side.
    float ofVertex(std::uint32_t vertex) const;

private:
    float texel(std::uint64_t x, std::uint64_t y) const;
    float patch(std::uint64_t left, std::uint64_t top, float u, float v, std::uint32_t w, std::uint32_t h) const;
};

}  // namespace nacre
