#pragma once
// Selects the outline points that a mesh's coarser levels keep, and bounds the error.

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "engine/mesh/mesh.h"

namespace nacre {

/// The levels of a cartoon, without triangles yet.
std::vector<MeshLevel> cartoonLevels();

/// Drops the finest levels until all together have no more triangles than the mesh.
void dropFineLevels(Mesh& mesh);

/// Indices of the outline points that a coarser outline keeps, ascending.
using Picks = std::vector<std::uint32_t>;

/// All points of an outline. @param count  their number
Picks allPicks(std::size_t count);

/// Polygons of 3 to 8 corners and one of all points, with corners spread as evenly as the outline's points allow.
std::vector<Picks> makePolygons(std::size_t count);

/// Largest distance of omitted points from the polygon of the remaining ones.
/// @param outline  round, in units of its half axes; multiply by `axes` for Å
double sideError(std::span<const glm::dvec2> outline, const Picks& picks, const glm::dvec2& axes);

/// The first of makePolygons() within an error on a circle.
Picks circlePicks(std::size_t count, double radius, double most);

/// Distance of a hemisphere from a cone between its equator and pole, in radii: 1 - sqrt(1/2).
constexpr double kConeError = 0.2929;

}  // namespace nacre
