#pragma once
// Cartoons and surfaces of a representation. Used by representation.cpp.

#include <cstdint>
#include <functional>
#include <vector>

#include "engine/molecule/molecule.h"
#include "engine/scene/appearance.h"
#include "engine/scene/representation.h"

namespace nacre {

/// Adds the meshes that an appearance asks for, relative to the representation's centre: of each group of atoms one by
/// itself, groups in their order.
/// @param groupOf    what an atom moves with: of an assembly the list of its copies, else its model
void addMeshes(const ResidueFacts& facts, const Appearance& appearance, const RepresentationOptions& options,
               const std::function<std::uint32_t(std::uint32_t)>& groupOf, Representation& representation);

/// The farthest that a vertex is from the centre, Å; 0 without meshes.
double meshReach(const Representation& representation);

}  // namespace nacre
