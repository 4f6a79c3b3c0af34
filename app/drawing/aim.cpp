#include "app/drawing/aim.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <limits>

#include "engine/error.h"
#include "engine/molecule/ligands.h"
#include "engine/molecule/selection/selection.h"
#include "engine/scene/view/orientation.h"

namespace nacre::app {
namespace {

std::vector<glm::dvec4> selectedBalls(const Selection& selection, const char* what, const ResidueFacts& facts,
                                      const Representation& scene) {
    if (selection.text == "ligand")
        if (auto main = chosenBalls(scene, selectAtoms(facts, parseSelection("mainligand"))); !main.empty())
            return main;
    const std::vector<bool> chosen = selectAtoms(facts, selection);
    std::vector<glm::dvec4> balls = chosenBalls(scene, chosen);
    if (!balls.empty()) return balls;
    const bool any = std::find(chosen.begin(), chosen.end(), true) != chosen.end();
    throw Error(what, selection.text, any ? "none of its atoms is drawn" : "the molecule has no such atoms");
}

/// Atoms of a bilayer: of lipids that lie in a slab; empty if there is none.
std::vector<glm::dvec4> findBilayer(const ResidueFacts& facts, const Representation& scene) {
    constexpr std::size_t kFewest = 40;  // lipids
    const Molecule& m = facts.molecule();
    std::vector<bool> lipids(m.atoms.size());
    std::size_t count = 0;
    for (const Residue& residue : m.residues) {
        if (!isLipid(residue.name.view())) continue;
        ++count;
        std::fill_n(lipids.begin() + residue.firstAtom, residue.atomCount, true);
    }
    if (count < kFewest) return {};
    std::vector<glm::dvec4> balls = chosenBalls(scene, lipids);
    return balls.size() >= kFewest && isSlab(balls) ? balls : std::vector<glm::dvec4>();
}

// About the vertical axis: the side that faced the viewer faces right.
const glm::dquat kQuarterTurn = glm::angleAxis(glm::radians(90.0), glm::dvec3(0, 1, 0));
const glm::dquat kHalfTurn = glm::angleAxis(glm::radians(180.0), glm::dvec3(0, 1, 0));

/// Whether a part's centre is to the right of another's.
bool isRight(const std::vector<glm::dvec4>& part, const std::vector<glm::dvec4>& other, const glm::dquat& orientation) {
    const glm::dvec3 way = computeBounds(part).center - computeBounds(other).center;
    return (orientation * way).x > 0;
}

/// Depth of a plane in front of some balls, Å from the centre away from the viewer.
double planeBefore(const std::vector<glm::dvec4>& target, const glm::dmat3& rotation) {
    constexpr double kRoom = 0.3;  // Å
    double front = -std::numeric_limits<double>::infinity();
    for (const glm::dvec4& ball : target) front = std::max(front, (rotation * glm::dvec3(ball)).z + ball.w);
    return std::round(-(front + kRoom) * 100) / 100;  // short in saved views
}

/// A plane in front of the zoom target, if a tenth of it or more is hidden.
std::optional<double> clipBefore(const std::vector<glm::dvec4>& target, const std::vector<glm::dvec4>& all,
                                 const glm::dmat3& rotation) {
    constexpr double kHidden = 0.1;
    if (hiddenShare(target, all, rotation) < kHidden) return std::nullopt;
    return planeBefore(target, rotation);
}

}  // namespace

const std::optional<Selection>& uncoveredBy(const Aim& aim) {
    static const std::optional<Selection> kNothing;
    return aim.uncover ? aim.uncover : aim.uncovers ? aim.zoomTo : kNothing;
}

Aimed aimed(const Camera& camera, const Aim& aim, const ResidueFacts& facts, const AimScene& shown, const Size& size) {
    const Representation& scene = shown.scene;
    Aimed result{.camera = camera};
    if (!aim.any() && !aim.fits) return result;
    const std::vector<glm::dvec4> all = aim.any() ? drawnBalls(scene) : std::vector<glm::dvec4>();
    if (aim.principal) {
        const auto axesTarget = aim.orientBy ? selectedBalls(*aim.orientBy, "cannot orient", facts, scene) : all;
        const bool wide = !aim.fromSide && size.width >= size.height;
        const auto bilayer = aim.orientBy || aim.fromSide ? std::vector<glm::dvec4>() : findBilayer(facts, scene);
        result.camera.orientation =
            bilayer.empty() ? principalOrientation(axesTarget, wide) : edgeOnOrientation(bilayer);
        if (aim.fromSide) result.camera.orientation = kQuarterTurn * result.camera.orientation;
        if (aim.left &&
            isRight(selectedBalls(*aim.left, "cannot orient", facts, scene), axesTarget, result.camera.orientation))
            result.camera.orientation = kHalfTurn * result.camera.orientation;
    }
    if (aim.lookAt)
        result.camera.orientation = facingOrientation(selectedBalls(*aim.lookAt, "cannot look at", facts, scene), all,
                                                      glm::mat3_cast(result.camera.orientation));
    if ((aim.fits || (aim.principal && !aim.lookAt)) && !aim.zoomTo)
        result.camera = fitted(result.camera, scene, shown.beside, shown.radius, size.width, size.height, kLargestZoom);
    const glm::dmat3 rotation =
        rotationMatrix(result.camera.rotationDegrees) * glm::mat3_cast(result.camera.orientation);
    if (aim.zoomTo) {
        const std::vector<glm::dvec4> target = selectedBalls(*aim.zoomTo, "cannot zoom to", facts, scene);
        result.camera = closeUp(result.camera, target, shown.radius, kZoomMargin, kLargestZoom);
        result.depth = -(rotation * computeBounds(target).center).z;
    }
    if (aim.clip)
        result.clipBefore = planeBefore(selectedBalls(*aim.clip, "cannot clip in front of", facts, scene), rotation);
    const std::optional<Selection>& target = uncoveredBy(aim);
    if (!target) return result;
    result.clipNear = clipBefore(selectedBalls(*target, "cannot uncover", facts, scene), all, rotation);
    return result;
}

}  // namespace nacre::app
