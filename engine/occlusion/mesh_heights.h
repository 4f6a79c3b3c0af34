#pragma once
// Triangles on depth maps that the host draws: where maps are its memory. Those of a cartoon or a surface are smaller
// than a map's pixel, so to list them for tiles costs more than to draw them.

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "engine/scene/representation.h"

namespace nacre::occlusion {

/// One depth map among others: heights, Å, row by row from the top.
struct HeightMap {
    float* heights = nullptr;  ///< of its first pixel
    std::uint32_t pitch = 0;   ///< pixels from a row to the next
    std::uint32_t pixels = 0;  ///< across
    float perAngstrom = 1;     ///< pixels
};

class MeshHeights {
public:
    /// Raises a map to what stands higher. A pixel's centre meets a triangle as in shaders/common/hit.glsl, edges and
    /// both sides counted, and in the same arithmetic but for the unit, which is a pixel.
    /// @param rows  three: to the map's view
    void draw(const Representation& representation, const glm::vec4* rows, std::uint32_t first, std::uint32_t count,
              const HeightMap& map);

private:
    void place(const Representation& representation, std::span<const Triangle> triangles, const glm::vec4* rows,
               const HeightMap& map);

    std::vector<glm::vec3> corners_;  // of vertices: pixel of the map and height
};

}  // namespace nacre::occlusion
