#pragma once
// Ellipsoids of triangles with a band along each principal ellipse, whole or with an octant cut out as ORTEP draws
// them.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "engine/mesh/mesh.h"

namespace nacre {

struct Ellipsoid {
    glm::dvec3 center{};               ///< Å
    std::array<glm::dvec3, 3> axes{};  ///< half axes, Å: orthogonal, right-handed
    std::uint32_t atom = 0;            ///< below kEllipsoidFace
    /// The octant that is cut out: 1 or -1 along each axis. Empty: none. Its three faces, in the principal planes, have
    /// lines along an axis.
    std::optional<glm::dvec3> cut = {};
};

/// Mesh::atoms names the atom of a band, or of a line on a face of the cut, with this.
constexpr std::uint32_t kEllipsoidBand = 0x80000000u;
/// Likewise between the lines of a face.
constexpr std::uint32_t kEllipsoidFace = 0x40000000u;

/// Pieces per side of an octant. Gives up to about two million triangles of whole ellipsoids in all: 32 for up to 204,
/// 16 up to 698, 8 up to 2118, 4 beyond. Triangles lie up to ellipsoidMeshError() of the longest axis inside.
int ellipsoidPieces(std::size_t count);
double ellipsoidMeshError(int pieces);

/// More would take over 2 GB.
constexpr std::size_t kMostEllipsoids = 200'000;

/// Makes a mesh whose vertices and normals are those of the ellipsoids.
/// @param meshes  of this size that a scene has: ellipsoidPieces() counts the ellipsoids of all
/// @throws Error beyond kMostEllipsoids in all
Mesh ellipsoidMesh(std::span<const Ellipsoid> ellipsoids, const glm::dvec3& origin, std::size_t meshes = 1);

}  // namespace nacre
