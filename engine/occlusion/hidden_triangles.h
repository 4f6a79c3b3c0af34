#pragma once
// Which triangles of meshes lie behind others for a viewer infinitely far away, as a depth map of the host shows them.

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "engine/occlusion/occluder_mesh.h"

namespace nacre::occlusion {

class HiddenTriangles {
public:
    HiddenTriangles() = default;
    /// @param meshes  none of them translucent @param towards  the viewer; unit @param radius  of the scene, Å
    /// @param pixels  width of the map, as the meshes are made for
    HiddenTriangles(const OccluderMeshes& meshes, const glm::dvec3& towards, double radius, std::uint32_t pixels);

    /// Whether all pixels that a triangle covers, and those around them, show something clearly before it: by more than
    /// the meshes' own error. Never without meshes.
    bool hides(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) const;

private:
    static constexpr int kAround = 2;        // pixels: outlines of the meshes lie within one
    static constexpr float kDeepPixels = 2;  // behind what a pixel shows

    std::uint32_t pixels_ = 0;
    float perAngstrom_ = 1, deep_ = 0;
    glm::vec4 rows_[3]{};
    std::vector<float> lowest_;  // height, Å, that is shown by all pixels around one
};

}  // namespace nacre::occlusion
