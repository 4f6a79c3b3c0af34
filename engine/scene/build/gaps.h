#pragma once
// Dashes where a chain misses residues.

#include "engine/scene/build/appearance.h"
#include "engine/scene/build/representation.h"

namespace nacre {

/// Joins the ends of a chain's unbroken stretches, in the order of the file, where both ends are drawn as a cartoon or
/// backbone and residue numbers are missing between them.
void addGaps(const ResidueFacts& facts, const Appearance& appearance, Representation& scene);

}  // namespace nacre
