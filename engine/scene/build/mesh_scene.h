#pragma once
// Cartoons, surfaces and ellipsoids of a representation. Used by representation.cpp.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/mat4x3.hpp>

#include "engine/molecule/molecule.h"
#include "engine/scene/build/appearance.h"
#include "engine/scene/build/representation.h"

namespace nacre {

/// Calls add(motion, classes) for each class of a group's copies: those of one rotation, which a distant viewer sees
/// alike.
/// @param add  receives the motion of one of them, and the number of classes; what it adds belongs to the class
using EachClass =
    std::function<void(std::uint32_t group, const std::function<void(const glm::dmat4x3&, std::size_t)>& add)>;

/// Adds an appearance's meshes, relative to the representation's centre: one per group of atoms, in the order of
/// groups; of ellipsoids with octants one per class.
/// @param findGroup  atoms that move together: in an assembly the list of copies, else the model
/// @param eachClass  of an assembly; else empty
void addMeshes(const ResidueFacts& facts, const Appearance& appearance, const RepresentationOptions& options,
               const std::function<std::uint32_t(std::uint32_t)>& findGroup, Representation& representation,
               const EachClass& eachClass = {});

/// Largest distance of a vertex from the centre, Å; 0 without meshes.
double meshReach(const Representation& representation);

}  // namespace nacre
