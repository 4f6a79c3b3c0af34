#pragma once
// The view of a scene file's camera.

#include "engine/effects.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/build/scene_guide.h"
#include "engine/scene/view/camera.h"

namespace nacre {

struct SceneView {
    View view;        ///< about the camera's target
    Clip clip;        ///< planes of the camera: Å from the target, away from the viewer
    double room = 0;  ///< Å by which anything may extend beyond the planes, and is still in front of the eye
};

/// The view of a camera, further rotated and zoomed by the user. Its depth range covers all that the planes leave.
/// @param hand   rotation in degrees, zoom and pan; its projection and angle are ignored
/// @param ortho  orthographic instead of perspective, with the same scale at the target
/// @param reach  largest distance of the scene from the target, Å
SceneView makeView(const SceneCamera& camera, const Camera& hand, bool ortho, double reach, std::uint32_t width,
                   std::uint32_t height);

/// The perspective camera with a view's picture: it has the same scale at the plane through the target.
/// @param center  of the view's scene, in the file's frame @param whole  steps back until its planes cut away little of
/// the view, and nothing of a scene that fills the picture
SceneCamera makeCamera(const View& view, const glm::dvec3& center, bool whole);

/// Omits primitives that are entirely before or behind the planes: an eye may be among atoms. Copies that cross a plane
/// are written out.
void dropOutside(Representation& scene, const SceneView& view);

/// The extreme points of some balls in 98 directions (T. Larsson, Fast and Tight Fitting Bounding Spheres, SIGRAD
/// 2008).
/// @param balls  centre and radius; at least one
std::vector<glm::dvec3> extremePoints(std::span<const glm::dvec4> balls);

/// Extreme points moved outwards, as Mol* makes room for drawn shapes around them: along the points' principal axes,
/// and at most by the sphere's radius and the room from the centre. @param sphere  about the points
std::vector<glm::dvec3> movedOut(std::span<const glm::dvec3> points, const Bounds& sphere, double room);

/// Approximately the smallest sphere around some balls: centred on the mean of their extreme points, and large enough
/// for all.
/// @param balls  centre and radius; at least one
Bounds extremeSphere(std::span<const glm::dvec4> balls);

}  // namespace nacre
