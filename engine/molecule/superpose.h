#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace nacre {

/// The rigid motion p -> rotation * p + shift that superposes points with the least sum of squared distances.
struct Superposition {
    glm::dmat3 rotation{1.0};
    glm::dvec3 shift{};
    double rmsd = 0;  ///< root mean square of the remaining distances
    glm::dvec3 operator()(const glm::dvec3& p) const { return rotation * p + shift; }
};

/// By gemmi's quaternion characteristic polynomial (Theobald 2005). Never mirrors.
/// @param fixed, moving  same length, at least one
Superposition superpose(std::span<const glm::dvec3> fixed, std::span<const glm::dvec3> moving);

/// A superposition of the pairs that fit, without the outliers.
struct PrunedSuperposition {
    Superposition motion;            ///< of the kept pairs
    double rmsdOfAll = 0;            ///< of the superposition of all pairs
    std::vector<std::uint8_t> kept;  ///< by pair: 1 if kept
    std::size_t count = 0;           ///< number of kept pairs
};

/// Rejects outliers as PyMOL's `align` does: superposes, rejects the pairs farther apart than twice the RMSD (and
/// than 0.1 Å), and repeats that up to five times, until none is rejected.
/// @param fixed, moving  same length, at least one
PrunedSuperposition superposePruned(std::span<const glm::dvec3> fixed, std::span<const glm::dvec3> moving);

}  // namespace nacre
