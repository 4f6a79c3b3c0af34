#pragma once
// One camera for all models of a file, so that a trajectory or ensemble does not jump.

#include <optional>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/molecule.h"
#include "engine/scene/build/appearance.h"
#include "engine/scene/view/bounds.h"

namespace nacre {

/// The bounds of the drawn atoms of a molecule and of its file's other models (Molecule::others), for represent().
/// Every model has the same. Empty if there are no others, or the camera frames the model alone. @throws Error as
/// represent()
std::optional<Bounds> sharedFrame(const ResidueFacts& facts, const DrawnAtomsOptions& drawn,
                                  const RepresentationOptions& options);

}  // namespace nacre
