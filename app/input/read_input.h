#pragma once
// From an input's name to a molecule, without network access: one, several superposed and joined, or a structure with
// moving atoms.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/picture/input_options.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/trajectory/motion.h"
#include "engine/volume/read_map.h"

namespace nacre::app {

/// A share of the machine's memory, in bytes. @param parts  the whole divided by this number
std::uint64_t memoryShare(unsigned parts);

/// A molecule as read, with hydrogens added if requested. @throws Error if they would not move with a trajectory
Molecule completed(const InputOptions& input, Molecule molecule);

/// The memory limit for a molecule or a map: `--memory`, else half of the machine's memory.
std::uint64_t memoryLimit(const InputOptions& input);
/// Limits for a density map: half of memoryLimit() for its values, half for its text.
MapLimits mapLimits(const InputOptions& input);

/// Reads a sample, a file or standard input, depending on `input.path`.
/// @param bytes     memory limit for the molecule
/// @param readFile  returns a file's bytes, if a path alone does not open it
/// @param onModel   for all models of a file: called after each with the share read, 0..1
/// @throws Error
Molecule readLocally(const InputOptions& input, std::uint64_t bytes,
                     const std::function<std::string(const std::string&)>& readFile = {},
                     const std::function<void(double)>& onModel = {});

/// Joins molecules in the order of the INPUTs, fitted as the options require.
/// @param tell  receives the result of each fit, one line
/// @throws Error if a fit has fewer than three pairs of atoms, or moves its reference
Molecule joinInputs(const InputOptions& input, std::vector<Molecule> molecules,
                    const std::function<void(const std::string&)>& tell);

/// Makes the INPUTs after the first its conformations: other models of one molecule. The result has the model that
/// `input.model` selects.
/// @param tell  receives one line for each that lacks counterparts of some atoms
/// @throws Error if there is no such model, or one has too few counterparts
Molecule joinConformations(const InputOptions& input, std::vector<Molecule> molecules,
                           const std::function<void(const std::string&)>& tell);

/// Processing of frames. @throws Error if too few atoms are selected to fit
MotionOptions motionOptions(const TrajectoryOptions& options, const Molecule& molecule);

/// Opens the trajectory of some options; reports a file that ends within a frame, and notices of a saved view.
/// @throws Error if its atoms are not the molecule's, or nothing is selected to fit
std::unique_ptr<Motion> openMotion(const TrajectoryOptions& options, const Molecule& molecule);

/// Warns about frames fitted by molecules that the periodic box cuts, and about frames without the box needed to make
/// molecules whole. @returns whether it did
bool sayTorn(const Motion& motion, const std::string& path);

/// Superposes models on the first by TrajectoryOptions::fit, without a trajectory: all models drawn together, or the
/// one that is drawn. @throws Error
void fitModels(const InputOptions& input, Molecule& molecule);

/// Moves the atoms to the frame in the options. Does nothing without a trajectory. @throws Error
void moveToFrame(const TrajectoryOptions& options, Molecule& molecule);

/// @param positions  of the molecule's atoms
void movePositions(Molecule& molecule, const std::vector<glm::vec3>& positions);

}  // namespace nacre::app
