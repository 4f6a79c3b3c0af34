#pragma once
// Style::ellipsoids: how large an atom's displacements are drawn.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// The ellipsoids that hold atoms with a probability. An atom without a positive definite tensor is a sphere of its B
/// factor; one without that, or a hydrogen, a small ball.
class AtomEllipsoids {
public:
    /// @param percent  the probability
    AtomEllipsoids(const Molecule& molecule, double percent);

    /// Half axes, Å; empty for a sphere.
    std::optional<std::array<glm::dvec3, 3>> axes(std::uint32_t atom) const;
    /// Radius of the sphere of an atom, Å; one with axes has it inside its ellipsoid.
    double ball(std::uint32_t atom) const;
    /// The largest distance from an atom's centre, Å.
    double reach(std::uint32_t atom) const;
    /// Says which atoms are no ellipsoids, though they are not hydrogens.
    std::vector<std::string> warnings(std::span<const std::uint32_t> atoms) const;

private:
    double sphere(const Atom& atom) const;

    const Molecule& molecule_;
    double scale_;
};

/// Of the bands in the colour of an atom.
std::uint32_t bandColor(std::uint32_t color);

}  // namespace nacre
