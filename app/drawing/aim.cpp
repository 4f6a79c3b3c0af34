#include "app/drawing/aim.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/error.h"
#include "engine/scene/view/orientation.h"

namespace nacre::app {
namespace {

std::vector<glm::dvec4> selectedBalls(const Selection& selection, const char* what, const ResidueFacts& facts,
                                      const Representation& scene) {
    const std::vector<bool> chosen = selectAtoms(facts, selection);
    std::vector<glm::dvec4> balls = chosenBalls(scene, chosen);
    if (!balls.empty()) return balls;
    const bool any = std::find(chosen.begin(), chosen.end(), true) != chosen.end();
    throw Error(what, selection.text, any ? "none of its atoms is drawn" : "the molecule has no such atoms");
}

/// A plane in front of the zoom target, if a tenth of it or more is hidden.
std::optional<double> clipBefore(const std::vector<glm::dvec4>& target, const std::vector<glm::dvec4>& all,
                                 const glm::dmat3& rotation) {
    constexpr double kHidden = 0.1, kRoom = 0.3;  // Å
    if (hiddenShare(target, all, rotation) < kHidden) return std::nullopt;
    double front = -std::numeric_limits<double>::infinity();
    for (const glm::dvec4& ball : target) front = std::max(front, (rotation * glm::dvec3(ball)).z + ball.w);
    return std::round(-(front + kRoom) * 100) / 100;  // as people write it
}

}  // namespace

const std::optional<Selection>& uncoveredBy(const Aim& aim) {
    static const std::optional<Selection> kNothing;
    return aim.uncover ? aim.uncover : aim.uncovers ? aim.zoomTo : kNothing;
}

Aimed aimed(const Camera& camera, const Aim& aim, const ResidueFacts& facts, const Representation& scene,
            const Size& size) {
    Aimed result{camera, std::nullopt};
    if (!aim.any() && !aim.fits) return result;
    const std::vector<glm::dvec4> all = aim.any() ? drawnBalls(scene) : std::vector<glm::dvec4>();
    if (aim.principal) result.camera.orientation = principalOrientation(all, size.width >= size.height);
    if (aim.lookAt)
        result.camera.orientation = facingOrientation(selectedBalls(*aim.lookAt, "cannot look at", facts, scene), all,
                                                      glm::mat3_cast(result.camera.orientation));
    if ((aim.fits || (aim.principal && !aim.lookAt)) && !aim.zoomTo)
        result.camera = fitted(result.camera, scene, scene.radius, size.width, size.height, kLargestZoom);
    if (aim.zoomTo) {
        const std::vector<glm::dvec4> target = selectedBalls(*aim.zoomTo, "cannot zoom to", facts, scene);
        result.camera = closeUp(result.camera, target, scene.radius, kZoomMargin, kLargestZoom);
    }
    const std::optional<Selection>& shown = uncoveredBy(aim);
    if (!shown) return result;
    const glm::dmat3 rotation =
        rotationMatrix(result.camera.rotationDegrees) * glm::mat3_cast(result.camera.orientation);
    result.clipNear = clipBefore(selectedBalls(*shown, "cannot uncover", facts, scene), all, rotation);
    return result;
}

}  // namespace nacre::app
