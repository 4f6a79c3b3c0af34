#pragma once
// Bonds as lines of constant width. Used by representation.cpp.

#include "engine/scene/appearance.h"
#include "engine/scene/assembly_scene.h"
#include "engine/scene/representation.h"

namespace nacre {

/// Adds the lines of what has that style: of a bond to an atom of another style half, of an atom without bonds a
/// cross. Orders are not told apart. Of an assembly each copy has its own.
/// @param assembly  null: there is none @throws Error if they are too many
void addLines(const Molecule& molecule, const Appearance& appearance, double width, AssemblyScene* assembly,
              Representation& result);

}  // namespace nacre
