#pragma once
// One camera for all models of a file: a trajectory or an ensemble does not wobble from one model to the next.

#include <optional>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/molecule.h"
#include "engine/scene/appearance.h"
#include "engine/scene/bounds.h"

namespace nacre {

/// The bounds of what is drawn of a molecule and of the other models of its file (Molecule::others), as represent()
/// takes them; the same whichever model it is. Empty if there are no others, or the camera shall be the model's own.
/// @throws Error as represent() does
std::optional<Bounds> sharedFrame(const ResidueFacts& facts, const DrawnAtomsOptions& drawn,
                                  const RepresentationOptions& options);

}  // namespace nacre
