#pragma once
// Limits an isosurface to a distance from given places.

#include <glm/vec3.hpp>
#include <span>

#include "engine/mesh/isosurface.h"

namespace nacre {

/// Removes parts farther than `reach` from all places. Triangles and lines that cross that distance are cut there, to a
/// thousandth of an ångström. @param places  Å, about the surface's origin
void carve(Isosurface& surface, std::span<const glm::dvec3> places, double reach);

}  // namespace nacre
