#pragma once
// Copies as primitives of their own, where a view needs a part of each.

#include <functional>

#include "engine/scene/build/representation.h"

namespace nacre {

/// More spheres, sticks and triangles than these are not written out.
constexpr std::size_t kMostWrittenOut = 4'000'000;

/// Writes out those copies of runs whose bounding spheres are wanted; the others go, and so do coarser levels of
/// meshes.
/// @param wanted  a sphere's centre and radius, Å @returns false, and changes nothing, if they were too many
bool writeOutCopies(Representation& scene, const std::function<bool(const glm::dvec3&, double)>& wanted);

}  // namespace nacre
