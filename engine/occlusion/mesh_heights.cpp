#include "engine/occlusion/mesh_heights.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace nacre::occlusion {

void MeshHeights::draw(const OccluderMesh& mesh, std::size_t first, std::size_t end, const glm::vec4* rows,
                       const HeightMap& map) {
    corners_.resize(std::max(corners_.size(), mesh.positions.size()));
    const float middle = static_cast<float>(map.pixels) / 2;
    const glm::vec4 x = rows[0] * map.perAngstrom, y = rows[1] * -map.perAngstrom, z = rows[2];
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 p = mesh.positions[i];
        corners_[i] = {middle + (x.x * p.x + x.y * p.y + x.z * p.z + x.w),
                       middle + (y.x * p.x + y.y * p.y + y.z * p.z + y.w), z.x * p.x + z.y * p.y + z.z * p.z + z.w, 0};
    }
    // Mirrored copies turn front faces around: all are drawn.
    const bool mirrored = glm::dot(glm::cross(glm::vec3(rows[0]), glm::vec3(rows[1])), glm::vec3(rows[2])) < 0;
    triangleLanes().back().draw(corners_.data(), mesh.triangles.data() + first, end - first, mesh.closed && !mirrored,
                                map);
}

}  // namespace nacre::occlusion
