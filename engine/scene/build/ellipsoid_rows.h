#pragma once
// Spheres of a scene that are ellipsoids.

#include <array>
#include <glm/vec3.hpp>

namespace nacre {

/// Turns a sphere into an ellipsoid that it contains: two rows of the map to the unit sphere whose axes are the
/// ellipsoid's. Read by the device (shaders/common/ellipsoid.glsl). 32 bytes.
struct EllipsoidRows {
    glm::vec3 first{};  ///< 1/Å; with `second` 0: the sphere stays one
    float third = 0;    ///< factor of the cross product of both that is the third row, Å
    glm::vec3 second{};
    float band = 0;  ///< half the width of a band along a principal ellipse, Å; 0: a plain sphere

    bool any() const { return third != 0; }
    /// Half axes, Å.
    std::array<glm::vec3, 3> axes() const;
    /// Radius of the largest ball inside, Å.
    float inner() const;
    /// The map: its length is 1 on the surface. @param p  from the centre
    glm::vec3 toUnit(const glm::vec3& p) const;
    /// The normal at a place on the surface. @param unit  that place under the map
    glm::vec3 gradient(const glm::vec3& unit) const;
    /// The place on the surface, from the centre, whose normal is given.
    glm::vec3 place(const glm::vec3& normal) const;
};

/// @param axes  half axes, Å: orthogonal
EllipsoidRows ellipsoidRows(const std::array<glm::dvec3, 3>& axes);
EllipsoidRows sphereRows(float radius);

}  // namespace nacre
