#pragma once
// A crystal's cell, and its conversion to Cartesian coordinates.

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace nacre {

struct UnitCell {
    glm::dvec3 lengths{1, 1, 1};    ///< a, b, c, Å
    glm::dvec3 angles{90, 90, 90};  ///< alpha, beta, gamma, degrees
    friend bool operator==(const UnitCell&, const UnitCell&) = default;

    bool isRectangular() const { return angles == glm::dvec3(90, 90, 90); }
    /// Whether the edges span a volume: finite positive lengths below 10^6 Å, and possible angles.
    bool isValid() const;
    /// Columns are a, b and c in Å: a along x, b in the xy plane, as in the PDB format.
    glm::dmat3 edges() const;
};

}  // namespace nacre
