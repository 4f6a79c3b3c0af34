#pragma once
// How one bond becomes cylinders. Used by representation.cpp; knows nothing of molecules.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace nacre {

constexpr float kBondRadius = 0.15f;  ///< Å, a single bond in ball-and-stick

/// The cylinders of one bond: shifted sideways by offset along the bond's side vector.
struct BondStrands {
    struct Strand {
        float offset;  ///< Å along the side vector
        float radius;  ///< Å
    };
    std::array<Strand, 3> strands{};
    int count = 0;
};

/// Single: one of 0.15 Å. Double: two of 0.08 Å. Triple: three of 0.055 Å. Aromatic (4), drawn as one and a half: a
/// full strand outside and a thin one on the side vector's side, where the ring's middle is. No strand reaches
/// farther than 0.21 Å from the axis, which is inside the smallest ball, so every end is covered.
BondStrands bondStrands(std::uint8_t order);

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
