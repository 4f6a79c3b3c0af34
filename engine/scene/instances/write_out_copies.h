#pragma once
// Converts copies to separate primitives, for views that need a part of each.

#include <functional>

#include "engine/scene/build/representation.h"

namespace nacre {

/// Largest number of spheres, sticks and triangles that are written out.
constexpr std::size_t kMostWrittenOut = 4'000'000;

/// Writes out the copies of runs whose bounding spheres are wanted; drops the others and coarser levels of meshes.
/// @param wanted  a sphere's centre and radius, Å @returns false, and changes nothing, if there are too many
bool writeOutCopies(Representation& scene, const std::function<bool(const glm::dvec3&, double)>& wanted);

}  // namespace nacre
