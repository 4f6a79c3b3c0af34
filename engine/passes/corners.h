#pragma once
// The polygons that spheres are drawn in, as a stream that vertices fetch: what a corner is costs a shader a third of
// its instructions otherwise.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace nacre::passes {

/// A polygon or pyramid among the corners, in the order of a triangle strip or of kPyramidIndices.
struct CornerRange {
    std::uint32_t first, count;
};

/// x, y on the plane of the outline, and how far in front of a sphere's centre it stands: all in its radii. Impostors
/// are circumscribed about the unit circle, and a little nearer than the sphere's nearest point, so that rounding never
/// lets the fixed-function test cut into it. Plates are inscribed, and z is not used.
constexpr CornerRange kImpostorSquare{0, 4}, kImpostorOctagon{4, 8}, kPyramid{12, 9}, kPlateSquare{21, 4},
    kPlateOctagon{25, 8};
constexpr std::size_t kCornerCount = 33;

std::array<glm::vec3, kCornerCount> cornerStream();

/// Facets of the pyramid: triangles of the apex and two corners behind it.
constexpr std::uint32_t kPyramidIndices = 24;
std::array<std::uint16_t, kPyramidIndices> pyramidIndices();

}  // namespace nacre::passes
