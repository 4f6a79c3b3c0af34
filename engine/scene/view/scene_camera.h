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
    double room = 0;  ///< Å that anything may stand out of the planes, and is before the eye still
};

/// The view of a camera, turned and zoomed further as a user asks. Its depths hold what the planes leave.
/// @param hand   rotation in degrees, zoom and pan; its projection and angle are not asked for
/// @param ortho  instead of perspective, in the same scale at the target
/// @param reach  Å from the target that anything drawn has at most
SceneView viewOf(const SceneCamera& camera, const Camera& hand, bool ortho, double reach, std::uint32_t width,
                 std::uint32_t height);

/// The camera that sees a view's picture, in perspective: at the plane through the target in the same scale.
/// @param center  of the view's scene, in the file's frame @param whole  steps back until its planes cut away little of
/// what the view shows, and nothing of a scene that fills the picture
SceneCamera cameraOf(const View& view, const glm::dvec3& center, bool whole);

/// Leaves out what is wholly before or behind the planes: an eye may stand among atoms. Copies that the planes
/// meet are written out.
void dropOutside(Representation& scene, const SceneView& view);

/// The extreme points of some balls in 98 directions (T. Larsson, Fast and Tight Fitting Bounding Spheres, SIGRAD
/// 2008).
/// @param balls  centre and radius; at least one
std::vector<glm::dvec3> extremePoints(std::span<const glm::dvec4> balls);

/// Extreme points moved outwards, as Mol* makes room for what is drawn around them: along the points' principal axes,
/// and not farther from the centre than the sphere's radius and the room. @param sphere  about the points
std::vector<glm::dvec3> movedOut(std::span<const glm::dvec3> points, const Bounds& sphere, double room);

/// The least sphere about some balls, nearly: the mean of their extreme points, and what holds them.
/// @param balls  centre and radius; at least one
Bounds extremeSphere(std::span<const glm::dvec4> balls);

}  // namespace nacre
