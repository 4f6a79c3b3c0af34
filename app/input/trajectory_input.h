#pragma once
// A structure with moving atoms.

#include <memory>
#include <string>
#include <vector>

#include "app/picture/input_options.h"
#include "engine/molecule/trajectory/motion.h"

namespace nacre::app {

/// Processing of frames. @throws Error if too few atoms are selected to fit
MotionOptions motionOptions(const TrajectoryOptions& options, const Molecule& molecule);

/// Opens the trajectory of some options; reports a file that ends within a frame, and notices of a saved view.
/// @throws Error if its atoms are not the molecule's, or nothing is selected to fit
std::unique_ptr<Motion> openMotion(const TrajectoryOptions& options, const Molecule& molecule);

/// Warns about frames fitted by molecules that the periodic box cuts, and about frames without the box needed to make
/// molecules whole. @returns whether it did
bool sayTorn(const Motion& motion, const std::string& path);

/// Moves the atoms to the options' frame. Does nothing without a trajectory. @throws Error
void moveToFrame(const TrajectoryOptions& options, Molecule& molecule);

/// @param positions  of the molecule's atoms
void movePositions(Molecule& molecule, const std::vector<glm::vec3>& positions);

}  // namespace nacre::app
