#pragma once
// Representations about the same centre, put one behind the other.

#include "engine/scene/build/representation.h"

namespace nacre {

/// Adds the primitives of a part to a whole; copies, legends and bounds stay those of the whole.
void appendPart(Representation& whole, const Representation& part);

}  // namespace nacre
