#pragma once
// Polygons that draw spheres, in a stream that the vertex stage fetches: computing a corner in the shader would cost a
// third of its instructions.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace nacre::passes {

/// A polygon or pyramid among the corners, in the order of a triangle strip or of kPyramidIndices.
struct CornerRange {
    std::uint32_t first, count;
};

/// x, y on the plane of the outline, and the distance in front of the sphere's centre, in radii. Impostors are
/// circumscribed about the unit circle and slightly nearer than the sphere's nearest point, so that rounding never lets
/// the fixed-function depth test clip the sphere. Plates are inscribed; their z is not used.
constexpr CornerRange kImpostorSquare{0, 4}, kImpostorOctagon{4, 8}, kPyramid{12, 9}, kPlateSquare{21, 4},
    kPlateOctagon{25, 8};
constexpr std::size_t kCornerCount = 33;

std::array<glm::vec3, kCornerCount> cornerStream();

/// Facets of the pyramid: triangles of the apex and two corners behind it.
constexpr std::uint32_t kPyramidIndices = 24;
std::array<std::uint16_t, kPyramidIndices> pyramidIndices();

}  // namespace nacre::passes
