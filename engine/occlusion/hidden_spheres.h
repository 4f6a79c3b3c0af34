#pragma once
// Finds spheres that other spheres hide from an infinitely distant viewer.

#include <glm/vec3.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "engine/scene/build/representation.h"

namespace nacre {

/// For each sphere, whether others certainly cover all of it. Some hidden ones are not found.
/// @param spheres  opaque @param towards  unit vector to the viewer
/// @param stop  when requested, returns early: those that follow are not found
std::vector<bool> hiddenSpheres(std::span<const Sphere> spheres, const glm::dvec3& towards,
                                const std::stop_token& stop = {});

}  // namespace nacre
