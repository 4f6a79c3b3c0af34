#pragma once
// Where the spheres of a union of balls meet, its surface has creases, which a grid's cells cut off.

#include <glm/vec3.hpp>
#include <vector>

#include "engine/mesh/mesh.h"
#include "engine/mesh/surface_field.h"

namespace nacre {

/// Puts vertices onto the creases: on each edge between two balls' vertices where their spheres meet, and into each
/// triangle between three of them where all three do, unless another ball covers the place or it is farther off than a
/// cell. Each side has its own vertices there, so that normals and colours change at the crease; closed meshes stay
/// closed, if what stands at one place counts as one.
/// @param mesh  of the balls' union; of each vertex the atom on whose ball it lies
/// @param balls  at most one for each atom
/// @param shift  from the balls' places to the mesh's, Å
/// @param step   edge of the grid's cells, Å
void putCreases(Mesh& mesh, const std::vector<SurfaceBall>& balls, const glm::dvec3& shift, double step);

}  // namespace nacre
