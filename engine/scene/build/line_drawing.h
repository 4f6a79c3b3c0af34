#pragma once
// Bonds as lines of constant width. Used by representation.cpp.

#include "engine/scene/build/appearance.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/instances/assembly_scene.h"

namespace nacre {

/// Adds the lines of atoms in that style: half of a bond to an atom in another style, a cross for an atom without
/// bonds. Ignores bond orders. Each copy of an assembly has its own.
/// @param assembly  null: none @throws Error if there are too many
void addLines(const Molecule& molecule, const Appearance& appearance, double width, AssemblyScene* assembly,
              Representation& result);

}  // namespace nacre
