#pragma once
// A structure whose atoms move.

#include <memory>

#include "app/shared/input_options.h"
#include "engine/molecule/trajectory/motion.h"

namespace nacre::app {

/// Opens the trajectory of some options; says so if it ends within a frame.
/// @throws Error if its atoms are not those of the molecule, or nothing is selected to fit
std::unique_ptr<Motion> openMotion(const TrajectoryOptions& options, const Molecule& molecule);

/// Puts the atoms where the frame of the options has them. Without a trajectory nothing happens. @throws Error
void moveToFrame(const TrajectoryOptions& options, Molecule& molecule);

/// @param positions  of the molecule's atoms
void movePositions(Molecule& molecule, const std::vector<glm::vec3>& positions);

}  // namespace nacre::app
