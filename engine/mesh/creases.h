#pragma once
// Sharp creases where the spheres of a union of balls meet; marching cubes would bevel them.

#include <glm/vec3.hpp>
#include <vector>

#include "engine/mesh/mesh.h"
#include "engine/mesh/surface_field.h"

namespace nacre {

/// Moves vertices onto the creases: on each edge between vertices of two balls, to where the spheres meet; in each
/// triangle between three balls, to where all three meet. Skips points that another ball covers or that are farther
/// than a cell. Each side gets its own vertices there, so that normals and colours change at the crease. Closed meshes
/// stay closed if vertices at one position count as one.
/// @param mesh  of the balls' union; each vertex names the atom of its ball
/// @param balls  at most one per atom
/// @param shift  from the balls' positions to the mesh's, Å
/// @param step   edge of the grid's cells, Å
void putCreases(Mesh& mesh, const std::vector<SurfaceBall>& balls, const glm::dvec3& shift, double step);

}  // namespace nacre
