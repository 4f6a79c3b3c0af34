#pragma once
// How one bond becomes cylinders. Used by representation.cpp; knows nothing of molecules.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace nacre {

constexpr float kBondRadius = 0.15f;  ///< Å, a single bond in ball-and-stick

/// The strands of one bond: shifted sideways by offset along the bond's side vector.
struct BondStrands {
    struct Strand {
        float offset = 0;  ///< Å along the side vector
        float radius = 0;  ///< Å
    };
    std::array<Strand, 3> strands{};  ///< from atom to atom
    int count = 0;
    /// A shorter line with round ends on the side vector's side; dashed, but for a double bond. Radius 0: none.
    Strand inner{};
};

/// Ball-and-stick. Single: one of 0.15 Å. Double: two of 0.08 Å; in a ring one and a line inside it. Triple: three of
/// 0.055 Å. Aromatic (4) and delocalised (5): one and a dashed line. No strand reaches farther than 0.21 Å from the
/// axis, which is inside the smallest ball, so every end is covered.
BondStrands bondStrands(std::uint8_t order, bool inRing = false);
/// Licorice: likewise, within its 0.25 Å.
BondStrands licoriceStrands(std::uint8_t order, bool inRing = false);

constexpr float kDashRadius = 0.09f;  ///< Å, of the dashes of a metal's coordination

/// Where dashes lie along a bond, as distances from its first atom, Å: `count` of them, each followed by a gap as
/// long as itself, and one gap before the first.
struct Dashes {
    double first = 0;   ///< start of the first
    double length = 0;  ///< of each
    int count = 0;
};

/// Dashes over the part of a bond that its two balls leave free; none if they leave nothing.
/// @param length of the bond, Å
/// @param radiusA, radiusB of the balls, Å
Dashes bondDashes(double length, double radiusA, double radiusB);

/// Unit vector across the bond, in the plane of the bond and `toward` (a sum of vectors to neighbours, any length).
/// Where that leaves no direction, a fixed one that depends on the axis alone.
/// @param axis unit vector along the bond
glm::dvec3 bondSide(const glm::dvec3& axis, const glm::dvec3& toward);

}  // namespace nacre
