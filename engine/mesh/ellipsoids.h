#pragma once
// Ellipsoids of triangles with a band along each principal ellipse.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "engine/mesh/mesh.h"

namespace nacre {

struct Ellipsoid {
    glm::dvec3 center{};               ///< Å
    std::array<glm::dvec3, 3> axes{};  ///< half axes, Å: orthogonal, right-handed
    std::uint32_t atom = 0;            ///< below kEllipsoidBand
};

/// Of a band: Mesh::atoms names its atom with this.
constexpr std::uint32_t kEllipsoidBand = 0x80000000u;

/// About two million triangles together, as far as the steps allow: an octant's sides have 32 pieces in up to 222
/// ellipsoids, 16 in 818, 8 in 2793, 4 beyond. Triangles lie inside by up to ellipsoidMeshError() of the longest axis.
int ellipsoidPieces(std::size_t count);
double ellipsoidMeshError(int pieces);

/// More would take over 2 GB.
constexpr std::size_t kMostEllipsoids = 200'000;

/// Vertices and their normals lie on the ellipsoids. @throws Error beyond kMostEllipsoids
Mesh ellipsoidMesh(std::span<const Ellipsoid> ellipsoids, const glm::dvec3& origin);

}  // namespace nacre
