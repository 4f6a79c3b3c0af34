#pragma once
// A structure whose atoms move.

#include <memory>
#include <string>
#include <vector>

#include "app/picture/input_options.h"
#include "engine/molecule/trajectory/motion.h"

namespace nacre::app {

/// How frames are to be laid. @throws Error if too few atoms are selected to fit
MotionOptions motionOptions(const TrajectoryOptions& options, const Molecule& molecule);

/// Opens the trajectory of some options; says so if it ends within a frame, and what there is to say of one
/// that a saved view names.
/// @throws Error if its atoms are not those of the molecule, or nothing is selected to fit
std::unique_ptr<Motion> openMotion(const TrajectoryOptions& options, const Molecule& molecule);

/// Warns of frames that were read and are fitted by molecules that the periodic box cuts, and notes those without a box
/// that were to be made whole. @returns whether it did
bool sayTorn(const Motion& motion, const std::string& path);

/// Puts the atoms where the frame of the options has them. Without a trajectory nothing happens. @throws Error
void moveToFrame(const TrajectoryOptions& options, Molecule& molecule);

/// @param positions  of the molecule's atoms
void movePositions(Molecule& molecule, const std::vector<glm::vec3>& positions);

}  // namespace nacre::app
