#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace nacre {

/// The rigid motion p -> rotation * p + shift that superposes points with the least sum of squared distances.
struct Superposition {
    glm::dmat3 rotation{1.0};
    glm::dvec3 shift{};
    double rmsd = 0;  ///< root mean square of the remaining distances
    glm::dvec3 operator()(const glm::dvec3& p) const { return rotation * p + shift; }
};

/// By quaternion characteristic polynomial (Theobald 2005), gemmi's. Never mirrors.
/// @param fixed, moving  same length, at least one
Superposition superpose(std::span<const glm::dvec3> fixed, std::span<const glm::dvec3> moving);

}  // namespace nacre
