#pragma once
// Views computed from the molecule: along its principal axes, from the best side of a part, and close-ups of a part.

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"

namespace nacre {

/// Centres and radii of all drawn spheres in all copies; Å, relative to Representation::center. Mesh vertices and ends
/// of lines follow with radius 0: framing includes them, but they hide nothing in the search for a view.
std::vector<glm::dvec4> drawnBalls(const Representation& scene);

/// As above for chosen atoms, each in its first copy.
/// @param chosen  one value per atom of the file
std::vector<glm::dvec4> chosenBalls(const Representation& scene, const std::vector<bool>& chosen);

/// The rotation that aligns the principal axes of some points (equal weights) with the picture's: the longest along its
/// longer side, the shortest towards the viewer. Signs: points extend farther from their mean to the right (in a tall
/// picture: upwards) and to the viewer; if equally far, the axis has its largest component in the file's frame
/// positive. If variances of axes differ by less than 1 %, the file's frame decides.
/// @param wide  the picture is at least as wide as high
glm::dquat principalOrientation(const std::vector<glm::dvec4>& balls, bool wide);

/// Whether points lie in a slab: their smallest spread is less than half of the others.
bool isSlab(const std::vector<glm::dvec4>& balls);
/// The rotation that shows a slab from its edge: its longest axis to the right, its shortest upwards.
glm::dquat edgeOnOrientation(const std::vector<glm::dvec4>& slab);

/// The rotation, by the shortest way from `from`, that turns the best side of the target to the viewer: unobstructed
/// and broad. Among sides that are about equal, prefers one that points out of the molecule.
/// @param all  of the whole molecule, target included
glm::dquat facingOrientation(const std::vector<glm::dvec4>& target, const std::vector<glm::dvec4>& all,
                             const glm::dmat3& from);

/// The camera with the target in the picture's centre. Its bounding sphere plus a margin of `margin` Å fills the
/// picture as the molecule does at zoom 1, times the camera's zoom (at most `mostZoom`), whatever its scale was.
/// @param radius  of the scene, Å
Camera closeUp(Camera camera, const std::vector<glm::dvec4>& target, double radius, double margin, double mostZoom);

/// The camera that centres a scene and fits its projection into 95 % of both sides, times the camera's zoom. The result
/// is larger than at zoom 1, which fits the bounding sphere. Keeps the camera's centre and scale, if given. Returns the
/// camera unchanged for scenes of more than 10^7 spheres and vertices, copies included.
/// @param radius  of the scene's view, Å
/// @param width, height  of the picture
/// @param beside  maps and primitives about the same centre, also fitted; or null
Camera fitted(Camera camera, const Representation& scene, const Representation* beside, double radius,
              std::uint32_t width, std::uint32_t height, double mostZoom);

/// Fraction of a target's atoms whose centres other atoms cover, along the view axis.
double hiddenShare(const std::vector<glm::dvec4>& target, const std::vector<glm::dvec4>& all,
                   const glm::dmat3& rotation);

/// Columns: unit vectors in the directions of largest, middle and least spread; their signs are arbitrary.
/// @param points  at least one
glm::dmat3 findPrincipalAxes(std::span<const glm::dvec3> points);

}  // namespace nacre
