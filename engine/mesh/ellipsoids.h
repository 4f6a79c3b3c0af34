#pragma once
// Ellipsoids of triangles with a band along each principal ellipse.

#include <array>
#include <cstddef>
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

/// Pieces per side of an octant. Gives up to about two million triangles in all: 32 for up to 222 ellipsoids, 16 up to
/// 818, 8 up to 2793, 4 beyond. Triangles lie up to ellipsoidMeshError() of the longest axis inside.
int ellipsoidPieces(std::size_t count);
double ellipsoidMeshError(int pieces);

/// More would take over 2 GB.
constexpr std::size_t kMostEllipsoids = 200'000;

/// Makes a mesh whose vertices and normals are those of the ellipsoids. @param all  of several meshes together, which
/// decide the pieces
/// @throws Error beyond kMostEllipsoids in all
Mesh ellipsoidMesh(std::span<const Ellipsoid> ellipsoids, const glm::dvec3& origin, std::size_t all = 0);

}  // namespace nacre
