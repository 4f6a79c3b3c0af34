#pragma once
// Finished ambient occlusion in host memory, for writers of files.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace nacre {

/// Texels as on the device (engine/occlusion/atlas_layout.h): patches of spheres and cylinders, and vertices.
/// Values are openness: 0 closed, 1 open.
struct BakedOcclusion {
    std::uint32_t sphereEdge = 0, around = 0, along = 0;  ///< width of patches, texels
    std::uint32_t width = 0;                              ///< texels per row
    std::uint32_t sphereRows = 0, cylinderRows = 0;
    std::vector<std::uint8_t> texels;  ///< row by row; empty: nothing was baked, everything is open

    // Primitives are counted as in the Representation that was set, after orderInSpace(); directions are in its axes.

    /// @param normal  unit vector
    float ofSphere(std::uint32_t sphere, const glm::vec3& normal) const;
    /// @param axis, normal  unit vectors, perpendicular @param share  position along the axis, 0 to 1
    float ofCylinder(std::uint32_t cylinder, const glm::vec3& axis, const glm::vec3& normal, float share) const;
    /// Of a mesh. @param inner  the inner side
    float ofVertex(std::uint32_t vertex, bool inner = false) const;

private:
    float texel(std::uint64_t x, std::uint64_t y) const;
    float patch(std::uint64_t left, std::uint64_t top, float u, float v, std::uint32_t w, std::uint32_t h) const;
};

/// Share of the ambient light that reaches a point, as in pictures (shaders/common/shading.glsl).
/// @param base  linear base colour @param open  0 closed to 1
float reachingLight(const glm::vec3& base, float open);

}  // namespace nacre
