#pragma once
// Anisotropic displacements of atoms about their mean positions.

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "engine/molecule/molecule.h"

namespace nacre {

constexpr double kEightPiSquared = 78.95683520871486;  ///< B = 8 pi^2 U
constexpr double kLargestDisplacement = 1000;          ///< Å^2; ANISOU holds no more

glm::dmat3 tensorMatrix(const Displacement& u);
Displacement toDisplacement(const glm::dmat3& u);

/// Eigenvalues of a symmetric matrix, largest first, with orthonormal eigenvectors.
struct PrincipalAxes {
    std::array<double, 3> values{};
    std::array<glm::dvec3, 3> ways{};
};
PrincipalAxes principalAxes(glm::dmat3 symmetric);

/// Root mean square displacements along the principal axes, Å, shortest last, right-handed; empty if the tensor is not
/// positive definite.
std::optional<std::array<glm::dvec3, 3>> displacementAxes(const Displacement& u);

/// Ratio of the ellipsoid that contains an atom with a given probability to its root mean square displacements: the
/// quantile of the chi distribution with three degrees of freedom, 1.5382 at 50 %.
/// @param percent  above 0, below 100
double probabilityScale(double percent);

/// Rotates an atom's displacement, if it has one, along with the atom. @param rotation  or another linear map
void turnDisplacement(Molecule& molecule, std::size_t atom, const glm::dmat3& rotation);

}  // namespace nacre
