#pragma once
// Draws triangles on a depth map in one thread, with as many lanes as the processor has.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace nacre::occlusion {

/// One of several depth maps: heights, Å, row by row from the top.
struct HeightMap {
    float* heights = nullptr;  ///< of the map's first pixel
    std::uint32_t pitch = 0;   ///< pixels per row of the buffer
    std::uint32_t pixels = 0;  ///< width, at least 4
    float perAngstrom = 1;     ///< pixels per Å
};

/// Keeps the larger height per pixel. @param corners  of all vertices: map pixel, height, and an unused word
/// @param fronts  draw only front faces
using DrawTriangles = void (*)(const glm::vec4* corners, const glm::uvec3* triangles, std::size_t count, bool fronts,
                               const HeightMap& map);

struct TriangleLanes {
    std::uint32_t lanes = 0;
    DrawTriangles draw = nullptr;
};

/// Lane counts that this processor can use, ascending: 4, then 8. All give bit-identical heights.
std::span<const TriangleLanes> triangleLanes();

}  // namespace nacre::occlusion
