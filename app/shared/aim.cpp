#include "app/shared/aim.h"

#include <algorithm>

#include "engine/error.h"
#include "engine/scene/orientation.h"

namespace nacre::app {
namespace {

std::vector<glm::dvec4> ballsOf(const Selection& selection, const char* what, const Molecule& molecule,
                                const Representation& scene) {
    const std::vector<bool> chosen = selectAtoms(molecule, selection);
    std::vector<glm::dvec4> balls = chosenBalls(scene, chosen);
    if (!balls.empty()) return balls;
    const bool any = std::find(chosen.begin(), chosen.end(), true) != chosen.end();
    throw Error(what, selection.text, any ? "none of its atoms is drawn" : "the molecule has no such atoms");
}

}  // namespace

Camera aimed(const Camera& camera, const Aim& aim, const Molecule& molecule, const Representation& scene,
             const Size& size) {
    if (!aim.any()) return camera;
    Camera result = camera;
    std::vector<glm::dvec4> all;
    if (aim.principal || aim.lookAt) all = drawnBalls(scene);
    if (aim.principal) result.orientation = principalOrientation(all, size.width >= size.height);
    if (aim.lookAt)
        result.orientation = facingOrientation(ballsOf(*aim.lookAt, "cannot look at", molecule, scene), all,
                                               glm::mat3_cast(result.orientation));
    if (aim.zoomTo)
        result = closeUp(result, ballsOf(*aim.zoomTo, "cannot zoom to", molecule, scene), scene.radius, kZoomMargin,
                         kLargestZoom);
    return result;
}

}  // namespace nacre::app
