#pragma once
// Finds spheres that other spheres hide from an infinitely distant viewer.

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/scene/build/representation.h"

namespace nacre {

/// For each sphere, whether others certainly cover all of it. Some hidden ones are not found.
/// @param spheres  opaque @param towards  unit vector to the viewer
std::vector<bool> hiddenSpheres(std::span<const Sphere> spheres, const glm::dvec3& towards);

}  // namespace nacre
