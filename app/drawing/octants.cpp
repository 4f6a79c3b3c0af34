// Ellipsoids of a drawing with the octants cut out that face the viewer.

#include <glm/matrix.hpp>

#include "app/drawing/drawing.h"
#include "engine/scene/build/atom_ellipsoids.h"

namespace nacre::app {
namespace {

/// Where a scene is seen from, as RepresentationOptions::viewer.
glm::dvec4 viewerOf(const View& view, const glm::dvec3& center) {
    const glm::dmat3 back = glm::transpose(view.rotation);
    if (view.projection == Projection::orthographic) return {back[2], 0};
    return {back * (glm::dvec3(0, 0, view.eyeDistance) - view.shift) + center, 1};
}

}  // namespace

/// Builds the scene again with the octants of ellipsoids cut out that face the viewer, who is known only now. The whole
/// ellipsoids have set the camera.
/// @param first, frame, now  as for the scene
void Drawing::cutOctants(const Molecule& first, const std::optional<Bounds>& frame, const Molecule* now) {
    const double framed = radius_, reach = scene_->radius;
    const bool reframed = reframed_;
    viewer_ = viewerOf(settings.view, scene_->center);
    facts_ = facts_->moved(first);
    rebuildScene(frame, now);
    radius_ = framed;
    scene_->radius = reach;
    reframed_ = reframed;
}

bool Drawing::octantsFace(const Camera& camera) const {
    if (!viewer_ || !scene_ || !facts_) return true;
    constexpr std::uint32_t kAnySize = 100;
    const View view = makeView(cameraFor(description_.stereo, camera), radius(), kAnySize, kAnySize);
    const Molecule& molecule = facts_->molecule();
    return facingOctants(molecule, *viewer_) == facingOctants(molecule, viewerOf(view, scene_->center));
}

}  // namespace nacre::app
