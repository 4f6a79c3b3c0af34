#pragma once
// Finds mesh triangles that are hidden from an infinitely distant viewer, with a depth map drawn on the host.

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "engine/occlusion/occluder_mesh.h"

namespace nacre::occlusion {

class HiddenTriangles {
public:
    HiddenTriangles() = default;
    /// @param meshes  opaque @param towards  unit vector to the viewer @param radius  of the scene, Å
    /// @param pixels  width of the map; matches the resolution of the meshes
    HiddenTriangles(const OccluderMeshes& meshes, const glm::dvec3& towards, double radius, std::uint32_t pixels);

    /// Whether something covers the triangle and a border around it, and is nearer by more than the meshes' error.
    /// False without meshes.
    bool hides(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) const;

private:
    static constexpr int kAround = 2;        // border, pixels: mesh outlines are within one
    static constexpr float kDeepPixels = 2;  // minimum depth behind the nearest surface, pixels

    std::uint32_t pixels_ = 0;
    float perAngstrom_ = 1, deep_ = 0;
    glm::vec4 rows_[3]{};
    std::vector<float> lowest_;  // lowest height around each pixel, Å
};

}  // namespace nacre::occlusion
