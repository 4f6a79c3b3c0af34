#pragma once
// Cartoons and surfaces of a representation. Used by representation.cpp.

#include <cstddef>
#include <cstdint>
#include <functional>

#include "engine/molecule/molecule.h"
#include "engine/scene/build/appearance.h"
#include "engine/scene/build/representation.h"

namespace nacre {

/// Adds an appearance's meshes, relative to the representation's centre: one per group of atoms, in the order of
/// groups.
/// @param findGroup  atoms that move together: in an assembly the list of copies, else the model
void addMeshes(const ResidueFacts& facts, const Appearance& appearance, const RepresentationOptions& options,
               const std::function<std::uint32_t(std::uint32_t)>& findGroup, Representation& representation);

/// Largest distance of a vertex from the centre, Å; 0 without meshes.
double meshReach(const Representation& representation);

}  // namespace nacre
