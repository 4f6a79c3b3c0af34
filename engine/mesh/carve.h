#pragma once
// Limits an isosurface to a distance from some places.

#include <glm/vec3.hpp>
#include <span>

#include "engine/mesh/isosurface.h"

namespace nacre {

/// Removes what is farther than `reach` from all places, and cuts triangles and lines there: where they cross that
/// distance they end, to a thousandth of an ångström. @param places  Å, about the surface's origin
void carve(Isosurface& surface, std::span<const glm::dvec3> places, double reach);

}  // namespace nacre
