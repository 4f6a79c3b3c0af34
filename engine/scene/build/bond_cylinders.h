#pragma once
// Turns one bond into cylinders. Used by representation.cpp; knows nothing about molecules.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace nacre {

constexpr float kBondRadius = 0.15f;  ///< of a single bond in ball-and-stick, Å

/// The strands of one bond: each shifted by `offset` along the bond's side vector.
struct BondStrands {
    struct Strand {
        float offset = 0;  ///< Å along the side vector
        float radius = 0;  ///< Å
    };
    std::array<Strand, 3> strands{};  ///< from atom to atom
    int count = 0;
    /// A shorter line with round ends, on the side vector's side; dashed except for a double bond. Radius 0: none.
    Strand inner{};
};

/// Ball-and-stick. Single: one strand of 0.15 Å. Double: two of 0.08 Å; in a ring one and a line inside it. Triple:
/// three of 0.055 Å. Aromatic (4) and delocalised (5): one and a dashed line. No strand extends beyond 0.21 Å from the
/// axis: that is inside the smallest ball, so every end is covered.
BondStrands bondStrands(std::uint8_t order, bool inRing = false);
/// Strands of licorice: the same forms, within its 0.25 Å.
BondStrands licoriceStrands(std::uint8_t order, bool inRing = false);

/// Scales all lengths across the bond: offsets and radii.
BondStrands scaled(BondStrands strands, double factor);

constexpr float kDashRadius = 0.09f;  ///< of the dashes of metal coordination, Å

/// Positions of dashes along a bond, as distances from its first atom, Å: `count` dashes, each followed by a gap of the
/// same length, with one gap before the first.
struct Dashes {
    double first = 0;   ///< start of the first
    double length = 0;  ///< of each
    int count = 0;
};

/// Dashes over the part of a bond between its two balls; none if there is no such part.
/// @param length of the bond, Å
/// @param radiusA, radiusB of the balls, Å
Dashes bondDashes(double length, double radiusA, double radiusB);

/// Unit vector across the bond, in the plane of the bond and `toward` (a sum of vectors to neighbours, any length). If
/// `toward` has no direction across: a fixed one that depends on the axis alone.
/// @param axis unit vector along the bond
glm::dvec3 bondSide(const glm::dvec3& axis, const glm::dvec3& toward);

}  // namespace nacre
