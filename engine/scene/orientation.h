#pragma once
// Views that follow from the molecule: its principal axes, the side from which a part of it is seen best, and the part
// that a picture closes in on.

#include <cstddef>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "engine/scene/camera.h"
#include "engine/scene/representation.h"

namespace nacre {

/// Centres of all drawn spheres in all copies, and their radii; Å, relative to Representation::center. Then the
/// vertices of meshes, of radius 0: they are shown whole, but hide nothing from a view that is sought.
std::vector<glm::dvec4> drawnBalls(const Representation& scene);

/// The same of the atoms of a choice, each where its first copy stands.
/// @param chosen  one value per atom of the file
std::vector<glm::dvec4> chosenBalls(const Representation& scene, const std::vector<bool>& chosen);

/// The rotation that lays the principal axes of some points (every point counts the same) along the picture's: the
/// longest across its longer side, the shortest towards the viewer. Signs are such that the points reach farther from
/// their mean to the right (of a picture that stands: upwards) and to the viewer; where they are as far both ways, such
/// that the axis runs along the largest of its components in the file's frame. Axes whose variances differ by less than
/// 1 % are no axes: there the file's frame decides.
/// @param wide  the picture is at least as wide as high
glm::dquat principalOrientation(const std::vector<glm::dvec4>& balls, bool wide);

/// The rotation by the shortest way from `from` that turns to the viewer the side from which most of the target is
/// seen: open, and broad. Among sides that are about equally good, the one that points out of the molecule prevails.
/// @param all  of the whole molecule, the target among them
glm::dquat facingOrientation(const std::vector<glm::dvec4>& target, const std::vector<glm::dvec4>& all,
                             const glm::dmat3& from);

/// The camera that has the target in the picture's middle, where its bounding sphere and `margin` Å around it fill the
/// picture as the molecule's does at zoom 1, then times the camera's zoom (at most `mostZoom`).
/// @param radius  of the scene, Å
Camera closeUp(Camera camera, const std::vector<glm::dvec4>& target, double radius, double margin, double mostZoom);

/// The camera that has a scene in the picture's middle and as large as it fits into 95 % of both sides, times the
/// camera's zoom. A molecule that lies along the picture is larger than at zoom 1, where its sphere fills the shorter
/// side. As it is for scenes of more than 10^7 spheres and vertices, copies counted.
/// @param radius  of the scene's view, Å @param width, height  of the picture
Camera fitted(Camera camera, const Representation& scene, double radius, std::uint32_t width, std::uint32_t height,
              double mostZoom);

/// How much of a target other atoms hide: the share of its atoms whose middle is covered, seen along the view's axis.
double hiddenShare(const std::vector<glm::dvec4>& target, const std::vector<glm::dvec4>& all,
                   const glm::dmat3& rotation);

}  // namespace nacre
