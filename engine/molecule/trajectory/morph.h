#pragma once
// A trajectory that morphs a molecule from one conformation to another.

#include <memory>
#include <string>
#include <vector>

#include "engine/molecule/trajectory/trajectory.h"

namespace nacre {

constexpr std::size_t kMostMorphAtoms = 200'000, kMostMorphPositions = 20'000'000;

/// Positions of a molecule's atoms at their counterparts in another molecule.
struct Conformation {
    std::vector<glm::vec3> positions;  ///< Å, by atom of the first molecule
    std::size_t matched = 0;           ///< atoms that have a counterpart
};

/// Pairs atoms of two molecules by index if both have the same list of names, else as in matchAtoms(), and ligands and
/// ions by chain, number and name. The other molecule is superposed on the first without the pairs that moved
/// (superposePruned()). Atoms without a counterpart move with those around them.
/// @param name  of the other, for errors @throws Error if fewer than three atoms or less than a third have a
/// counterpart
Conformation fitConformation(const Molecule& molecule, const Molecule& other, const std::string& name);

/// Moves from key to key by rotating each atom's surroundings, not along straight lines: the surroundings turn by the
/// rotation that superposes them, and the positions have differences as near as possible to the rotated ones
/// (as-rigid-as-possible interpolation: M. Alexa, D. Cohen-Or, D. Levin, SIGGRAPH 2000). Bond lengths change only by
/// the difference between both keys; at a key every atom is exactly in place. Format "morph".
/// @param molecule  its bonds determine what turns together; at most kMostMorphAtoms, kMostMorphPositions in all keys
/// @param keys  two or more, Å, by atom @param places  of the frames: 0 is the first key, 1 the second
/// @throws Error for more
std::unique_ptr<Trajectory> morphThrough(const Molecule& molecule, std::vector<std::vector<glm::vec3>> keys,
                                         std::vector<double> places);

/// As above from model to model (trajectoryOfModels()). @param model  the molecule's own @param back  finally returns
/// to the first @param name  for errors @throws Error also if there is only one model, or one with other atoms
std::unique_ptr<Trajectory> morphOfModels(const std::shared_ptr<const Molecule>& molecule, int model,
                                          std::vector<double> places, bool back, const std::string& name);

}  // namespace nacre
