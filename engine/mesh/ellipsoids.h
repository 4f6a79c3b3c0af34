#pragma once
// Ellipsoids of triangles with a band along each principal ellipse, for files.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "engine/mesh/mesh.h"

namespace nacre {

struct Ellipsoid {
    glm::dvec3 center{};               ///< Å
    std::array<glm::dvec3, 3> axes{};  ///< half axes, Å: orthogonal, right-handed
    double band = 0;                   ///< half the width of a band, Å; at most a fifth of an axis across it
};

/// Adds an ellipsoid. Its vertices lie on it, with its normals; triangles lie up to 6 % of the half axis there inside
/// with 4 pieces, and a quarter of that with twice as many.
/// @param pieces  per side of an octant @param own, ofBands  values of Mesh::atoms
void addEllipsoid(Mesh& mesh, const Ellipsoid& ellipsoid, int pieces, std::uint32_t own, std::uint32_t ofBands);
std::size_t trianglesPerEllipsoid(int pieces);

/// Pieces that give up to about two million triangles in all: 32 for up to 222 ellipsoids, 16 up to 818, 8 up to 2793,
/// 4 beyond.
int ellipsoidPieces(std::size_t count);

}  // namespace nacre
