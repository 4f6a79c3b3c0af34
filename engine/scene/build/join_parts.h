#pragma once
// Appends representations about the same centre.

#include "engine/scene/build/representation.h"

namespace nacre {

/// Adds the primitives of a part to a whole; copies, legends and bounds stay those of the whole.
void appendPart(Representation& whole, const Representation& part);

}  // namespace nacre
