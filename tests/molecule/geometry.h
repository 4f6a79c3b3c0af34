#pragma once
// Measures on molecules that the geometry tests share.

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>

#include "engine/molecule/molecule.h"

namespace nacre::test {

/// Index of the atom of that name in a residue. Throws if there is none, which fails the test that asked.
inline std::uint32_t atomIndex(const Molecule& molecule, std::uint32_t residue, std::string_view name) {
    const Residue& r = molecule.residues.at(residue);
    for (std::uint32_t i = r.firstAtom; i < r.firstAtom + r.atomCount; ++i)
        if (molecule.atoms[i].name.view() == name) return i;
    throw std::runtime_error("no atom " + std::string(name) + " in residue " + std::to_string(residue));
}

inline glm::dvec3 position(const Molecule& molecule, std::uint32_t residue, std::string_view name) {
    return glm::dvec3(molecule.atoms[atomIndex(molecule, residue, name)].position);
}

/// Angle a-b-c, degrees.
inline double angle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    return std::acos(glm::dot(glm::normalize(a - b), glm::normalize(c - b))) * 180 / std::numbers::pi;
}

/// Torsion a-b-c-d, degrees, -180 to 180, IUPAC sign.
inline double torsion(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d) {
    const glm::dvec3 first = glm::cross(b - a, c - b);
    const glm::dvec3 second = glm::cross(c - b, d - c);
    const double y = glm::dot(glm::cross(first, second), glm::normalize(c - b));
    return std::atan2(y, glm::dot(first, second)) * 180 / std::numbers::pi;
}

/// CIP descriptor of a centre whose three highest neighbours are given by falling priority: seen with the lowest one
/// pointing away, they run clockwise for R.
inline char chirality(glm::dvec3 centre, glm::dvec3 first, glm::dvec3 second, glm::dvec3 third) {
    return glm::dot(glm::cross(first - centre, second - centre), third - centre) > 0 ? 'S' : 'R';
}

}  // namespace nacre::test
