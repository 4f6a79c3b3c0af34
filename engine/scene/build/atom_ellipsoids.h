#pragma once
// Style::ellipsoids: sizes of atoms' displacements.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
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
    /// Radius of an atom's sphere, Å; inside its ellipsoid if it has axes.
    double ball(std::uint32_t atom) const;
    /// The largest distance from an atom's centre, Å.
    double reach(std::uint32_t atom) const;
    /// Lists atoms, except hydrogens, that are not drawn as ellipsoids.
    std::vector<std::string> warnings(std::span<const std::uint32_t> atoms) const;

private:
    double sphere(const Atom& atom) const;

    const Molecule& molecule_;
    double scale_;
};

/// Colour of an ellipsoid's bands. @param color  of the atom
std::uint32_t bandColor(std::uint32_t color);

}  // namespace nacre
