#pragma once
// The way of a molecule from one conformation to another, as a trajectory.

#include <memory>
#include <string>
#include <vector>

#include "engine/molecule/trajectory/trajectory.h"

namespace nacre {

constexpr std::size_t kMostMorphAtoms = 200'000, kMostMorphPositions = 20'000'000;

/// A molecule's atoms where another molecule has their counterparts.
struct Conformation {
    std::vector<glm::vec3> positions;  ///< Å, by atom of the first molecule
    std::size_t matched = 0;           ///< atoms that have a counterpart
};

/// Atoms of two molecules are paired by their names where both are the same list, else as in matchAtoms(), ligands and
/// ions by chain, number and name. The other molecule is superposed on the first without the pairs that moved
/// (superposePruned()). Atoms without a counterpart go with those around them.
/// @param name  of the other, for errors @throws Error if fewer than three atoms or less than a third have a
/// counterpart
Conformation conformationOf(const Molecule& molecule, const Molecule& other, const std::string& name);

/// Goes from key to key by interpolated frames of each atom's surroundings, not on straight lines: the surroundings
/// turn by the rotation that superposes them, and positions are those whose differences come nearest to the turned ones
/// (as-rigid-as-possible interpolation: M. Alexa, D. Cohen-Or, D. Levin, SIGGRAPH 2000). Bonds keep their lengths but
/// for what the two ends differ; at a key every atom is exactly there. Format "morph".
/// @param molecule  its bonds tell what turns together; at most kMostMorphAtoms, kMostMorphPositions in all keys
/// @param keys  two or more, Å, by atom @param places  of the frames: 0 is the first key, 1 the second
/// @throws Error for more
std::unique_ptr<Trajectory> morphThrough(const Molecule& molecule, std::vector<std::vector<glm::vec3>> keys,
                                         std::vector<double> places);

/// As above from model to model (trajectoryOfModels()). @param model  the molecule's own @param back  at last to the
/// first @param name  for errors @throws Error as well if there is one model, or one of other atoms
std::unique_ptr<Trajectory> morphOfModels(const std::shared_ptr<const Molecule>& molecule, int model,
                                          std::vector<double> places, bool back, const std::string& name);

}  // namespace nacre
