#pragma once
// Where a line crosses the two solids that a molecule is drawn with. Both are convex, so a line meets each in one
// interval. Double precision throughout.

#include <glm/vec3.hpp>
#include <optional>

namespace nacre::reference {

/// Points origin + t * direction. The direction has unit length, so that t is in the unit of the coordinates (Å).
struct Line {
    glm::dvec3 origin;
    glm::dvec3 direction;
};

struct Ball {
    glm::dvec3 center;
    double radius;
};

/// A solid cylinder from a to b with flat ends.
struct Rod {
    glm::dvec3 a, b;
    double radius;
};

/// The part of a line that lies inside a solid: enter <= t <= leave; either may be negative.
struct Crossing {
    double enter, leave;
    glm::dvec3 normal;   ///< outward unit normal where the line enters
    double along = 0.0;  ///< rods: 0 at a, 1 at b, where the line enters
};

/// Empty if the line misses the ball, or if its radius is not positive.
std::optional<Crossing> cross(const Line& line, const Ball& ball);

/// Empty if the line misses the rod, or if the rod has no volume.
std::optional<Crossing> cross(const Line& line, const Rod& rod);

}  // namespace nacre::reference
