#pragma once
// Meshes that the host draws on depth maps: positions, and triangles no finer than a map pixel.

#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <utility>
#include <vector>

#include "engine/scene/build/representation.h"

namespace nacre::occlusion {

struct OccluderMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;  ///< counter-clockwise seen from outside
    bool closed = false;                ///< back faces can be skipped
};

/// Triangles are numbered as by drawnTriangle(). Vertices in one cell with similar normals are merged to their mean, if
/// that leaves at most half of the triangles.
/// @param pixel  of the map, Å
OccluderMesh occluderMesh(const Representation& representation, std::uint32_t first, std::uint32_t count, float pixel);

/// The occluder meshes of a representation, each created once.
class OccluderMeshes {
public:
    OccluderMeshes() = default;
    /// Prepares the meshes drawn with an allowed error. @param error, pixel  Å
    OccluderMeshes(const Representation& representation, double error, float pixel);
    const OccluderMesh& of(const Representation& representation, std::uint32_t first, std::uint32_t count, float pixel);
    template <typename Visit>
    void each(const Visit& visit) const {
        for (const auto& [triangles, mesh] : meshes_) visit(mesh);
    }

private:
    std::map<std::pair<std::uint32_t, std::uint32_t>, OccluderMesh> meshes_;  // by first triangle and count
};

}  // namespace nacre::occlusion
