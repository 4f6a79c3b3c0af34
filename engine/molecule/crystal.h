#pragma once
// Symmetry of a crystal: positions of a molecule's copies around it.

#include <array>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

constexpr std::size_t kMostSymmetryCopies = 20'000;

/// Edges of the periodic box or the unit cell, Å; none if the file states neither.
std::optional<std::array<glm::dvec3, 3>> cellEdges(const FileSummary& file);

/// Origin of these edges, Å: the corner of a periodic box; of unit cells, the corner of the one that contains the
/// middle of the atoms.
glm::dvec3 cellCorner(const Molecule& molecule);

/// The copies in a range of cells, the molecule itself first. Cells are counted from the one that contains the
/// molecule's middle; a copy belongs to the cell of its middle.
/// @param low, high  first and last cell along each axis
/// @throws Error if the file states no cell or no space group, or there are too many copies
std::vector<glm::dmat4x3> crystalCopies(const Molecule& molecule, const std::array<int, 3>& low,
                                        const std::array<int, 3>& high);

/// The copies that have an atom within a distance (Å) of an atom of the molecule, itself first. @throws Error as above
std::vector<glm::dmat4x3> crystalMates(const Molecule& molecule, double distance);

/// The motion of one operation of the space group, shifted by whole cells: "3_655" is operation 3, cells 1, 0, 0.
/// Empty: there is no such operation. @param number  from 1, in the order of the International Tables: products of the
/// group's generators, then the centring @throws Error as above
std::optional<glm::dmat4x3> crystalMotion(const Molecule& molecule, std::size_t number,
                                          const std::array<int, 3>& cells);

}  // namespace nacre
