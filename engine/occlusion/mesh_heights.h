#pragma once
// Draws triangles on depth maps by the host, where maps are in its memory. Triangles of a cartoon or surface are
// smaller than a map's pixel: drawing them costs less than listing them for tiles.

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
    std::uint32_t pitch = 0;   ///< pixels per row of the buffer
    std::uint32_t pixels = 0;  ///< width
    float perAngstrom = 1;     ///< pixels
};

/// Triangles numbered as by drawnTriangle().
struct HeightRun {
    std::uint32_t first = 0, count = 0;
    bool closed = false;  ///< they belong to closed meshes: backs lie behind fronts and are left out
};

/// Whether each edge of some triangles belongs to another one that runs the other way.
bool isClosed(std::span<const Triangle> triangles);
std::span<const Triangle> trianglesOf(const Representation& representation, std::uint32_t first, std::uint32_t count);

class MeshHeights {
public:
    /// Draws triangles: keeps the larger height per pixel. A pixel's centre meets a triangle as in
    /// shaders/common/hit.glsl, edges and both sides included, with the same arithmetic but in pixels.
    /// @param rows  three: to the map's view
    void draw(const Representation& representation, const glm::vec4* rows, const HeightRun& run, const HeightMap& map);

private:
    void place(const Representation& representation, std::span<const Triangle> triangles, const glm::vec4* rows,
               const HeightMap& map);

    std::vector<glm::vec3> corners_;  // of vertices: pixel of the map and height
};

}  // namespace nacre::occlusion
