#pragma once
// Draws triangles on depth maps in host memory. Triangles of a cartoon or surface are smaller than a map pixel: drawing
// them costs less than listing them for tiles.

#include <glm/vec4.hpp>
#include <vector>

#include "engine/occlusion/occluder_mesh.h"
#include "engine/occlusion/triangle_heights.h"

namespace nacre::occlusion {

class MeshHeights {
public:
    /// Draws triangles: keeps the larger height per pixel. Tests pixel centres as shaders/common/hit.glsl does,
    /// including edges and both sides, with the same arithmetic but in pixels.
    /// @param rows  three rows of the transformation to the map's view
    /// @param first, end  of the mesh's triangles
    void draw(const OccluderMesh& mesh, std::size_t first, std::size_t end, const glm::vec4* rows,
              const HeightMap& map);

private:
    std::vector<glm::vec4> corners_;  // of vertices: map pixel and height
};

}  // namespace nacre::occlusion
