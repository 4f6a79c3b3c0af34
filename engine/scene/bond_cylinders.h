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

/// Unit vector across the bond, in the plane of the bond and `toward` (a sum of vectors to neighbours, any length).
/// Where that leaves no direction, a fixed one that depends on the axis alone.
/// @param axis unit vector along the bond
glm::dvec3 bondSide(const glm::dvec3& axis, const glm::dvec3& toward);

}  // namespace nacre
