#pragma once
// How much of each of some spheres is seen from outside.

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/scene/representation.h"

namespace nacre {

/// Unit vectors to the corners, edges and faces of a cube.
std::span<const glm::vec3> cubeDirections();

/// A share of each sphere's area that is seen along parallel lines from these directions, Å², summed over them.
std::vector<float> exposedAreas(std::span<const Sphere> spheres);

}  // namespace nacre
