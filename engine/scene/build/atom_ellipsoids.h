#pragma once
// Style::ellipsoids: sizes of atoms' displacements.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Ellipsoids that contain atoms with a given probability. An atom without a positive definite tensor is a sphere by
/// its B factor; without that, or for a hydrogen, a small ball.
class AtomEllipsoids {
public:
    /// @param percent  the probability
    AtomEllipsoids(const Molecule& molecule, double percent);

    /// Half axes, Å; empty for a sphere.
    std::optional<std::array<glm::dvec3, 3>> axes(std::uint32_t atom) const;
    /// Å from an atom's centre along a unit vector to where a bond can end in its ellipsoid; 0: at the centre of a
    /// sphere.
    double bondEnd(std::uint32_t atom, const glm::dvec3& way) const;
    /// The largest distance from an atom's centre, Å.
    double reach(std::uint32_t atom) const;
    /// Lists atoms, except hydrogens, that are not drawn as ellipsoids.
    std::vector<std::string> warnings(std::span<const std::uint32_t> atoms) const;

private:
    double sphere(const Atom& atom) const;

    const Molecule& molecule_;
    double scale_;
};

/// Colour of an ellipsoid's bands and lines. @param color  of the atom
std::uint32_t bandColor(std::uint32_t color);
}  // namespace nacre
