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
    /// @param percent  the probability @param viewer  as Appearance::viewer
    AtomEllipsoids(const Molecule& molecule, double percent, const std::optional<glm::dvec4>& viewer = {});

    /// Half axes, Å; empty for a sphere.
    std::optional<std::array<glm::dvec3, 3>> axes(std::uint32_t atom) const;
    /// The octant that is cut out (Ellipsoid::cut): the one towards the viewer. Empty: none.
    std::optional<glm::dvec3> cut(std::uint32_t atom) const;
    /// Radius of an atom's sphere, Å. If the atom has axes, the sphere is inside its ellipsoid, and kCutBall if that is
    /// cut.
    double ball(std::uint32_t atom) const;
    /// Å from an atom's centre along a unit vector to where a bond can end unseen: in the ellipsoid, if that is cut in
    /// another octant. 0: at the centre.
    double bondEnd(std::uint32_t atom, const glm::dvec3& way) const;
    /// As above for copies whose cuts differ: in the ellipsoid, or where it was before the cut.
    double bondEndInCopies(std::uint32_t atom, const glm::dvec3& way) const;
    /// The largest distance from an atom's centre, Å.
    double reach(std::uint32_t atom) const;
    /// Lists atoms, except hydrogens, that are not drawn as ellipsoids.
    std::vector<std::string> warnings(std::span<const std::uint32_t> atoms) const;

private:
    double sphere(const Atom& atom) const;

    const Molecule& molecule_;
    double scale_;
    std::optional<glm::dvec4> viewer_;
};

/// Å: too small to be seen at the corner of the cut. Such balls do not count among the sizes of a scene's primitives.
constexpr float kCutBall = 1e-4f;
/// The radius that AtomEllipsoids::ball() would be without a cut, Å. @param reach  of an atom with axes
double ballOfWhole(const Molecule& molecule, std::uint32_t atom, double reach);

/// For each atom a number of the octant of its axes that faces a viewer; kNoOctant without axes.
std::vector<std::uint8_t> facingOctants(const Molecule& molecule, const glm::dvec4& viewer);
constexpr std::uint8_t kNoOctant = 8;

/// Colour of an ellipsoid's bands and lines. @param color  of the atom
std::uint32_t bandColor(std::uint32_t color);
/// Colour between the lines on the faces of a cut.
std::uint32_t faceColor(std::uint32_t color);

}  // namespace nacre
