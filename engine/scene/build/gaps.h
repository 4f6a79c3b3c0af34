#pragma once
// Dashes where a chain is broken.

#include "engine/scene/build/appearance.h"
#include "engine/scene/build/representation.h"

namespace nacre {

/// Joins the ends of a chain's unbroken stretches if both ends are drawn as a cartoon or backbone, and either residue
/// numbers are missing between them or the ends are at most 10 Å apart.
void addGaps(const ResidueFacts& facts, const Appearance& appearance, Representation& scene);

}  // namespace nacre
