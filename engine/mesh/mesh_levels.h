#pragma once
// Which of the points around a solid its coarser levels keep, and how far what they leave out stands off.

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "engine/mesh/mesh.h"

namespace nacre {

/// The levels of a cartoon, without triangles yet.
std::vector<MeshLevel> cartoonLevels();

/// Leaves out the finest levels, until all together have no more triangles than the mesh itself.
void dropFineLevels(Mesh& mesh);

/// Numbers of points of an outline, ascending: those that a coarser one has.
using Picks = std::vector<std::uint32_t>;

/// Every point of an outline. @param count  how many it has
Picks allPicks(std::size_t count);

/// Polygons of 3 to 8 corners, and at last all of them: as evenly over an outline as its points lie.
std::vector<Picks> polygonsOf(std::size_t count);

/// How far the points that are left out stand from the polygon of the others, at most.
/// @param outline  round, in units of its half axes; Å are those times `axes`
double sideError(std::span<const glm::dvec2> outline, const Picks& picks, const glm::dvec2& axes);

/// The first of polygonsOf() that keeps within an error about a circle.
Picks circlePicks(std::size_t count, double radius, double most);

/// How far a ball's half stands off a cone from its equator to its pole, in radii: 1 - sqrt(1/2).
constexpr double kConeError = 0.2929;

}  // namespace nacre
