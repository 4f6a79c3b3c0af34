#include "app/drawing/focus.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "app/drawing/scenes.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/selection/selection.h"

namespace nacre::app {
namespace {

constexpr double kBeside = 2;  // Å from the line of sight: nearer atoms are in the picture's middle

/// The line of sight through a picture's middle, in view space.
struct Sight {
    glm::dvec2 middle;       // its point on the plane z = 0
    double eyeDistance = 0;  // 0: orthographic

    glm::dvec3 at(double z) const {
        const double share = eyeDistance > 0 ? (eyeDistance - z) / eyeDistance : 1;
        return {middle * share, z};
    }
    double distance(const glm::dvec3& v) const { return glm::length(v - at(v.z)); }
};

/// Like findFocus(), for a view of the scene.
glm::dvec3 focusIn(const Molecule& molecule, const PictureDescription& d, const View& view, const glm::dvec3& center) {
    const Sight sight{-view.pan, view.eyeDistance};
    const auto toView = [&](std::uint32_t atom) {
        return view.rotation * (glm::dvec3(molecule.atoms[atom].position) - center);
    };
    double depth = 0;
    const std::optional<Selection>& target = d.aim.zoomTo ? d.aim.zoomTo : d.aim.uncover;
    std::size_t named = 0;
    if (target) {
        const std::vector<bool> chosen = selectAtoms(molecule, *target);
        for (std::uint32_t i = 0; i < chosen.size(); ++i)
            if (chosen[i] && std::isfinite(toView(i).z)) depth += toView(i).z, ++named;
    }
    if (named > 0) {
        depth /= static_cast<double>(named);
    } else {
        double front = -std::numeric_limits<double>::infinity(), closest = std::numeric_limits<double>::infinity();
        for (const std::uint32_t atom : drawnAtoms(molecule, d.drawn)) {
            const glm::dvec3 v = toView(atom);
            const double away = sight.distance(v);
            if (!std::isfinite(away) || v.z > -d.effects.clip.near || v.z < -d.effects.clip.far) continue;
            if (away <= kBeside && v.z > front) depth = front = v.z;
            if (front == -std::numeric_limits<double>::infinity() && away < closest) closest = away, depth = v.z;
        }
    }
    return sight.at(depth);
}

}  // namespace

glm::dvec3 findFocus(const Molecule& molecule, const PictureDescription& d, const Seen& seen,
                     const glm::dvec3& center) {
    if (const SceneCamera* camera = sceneCamera(molecule, d)) return camera->target;
    constexpr std::uint32_t kAnySize = 256;
    const View view = makeView(seen.camera, seen.radius, kAnySize, kAnySize);
    return glm::transpose(view.rotation) * focusIn(molecule, d, view, center) + center;
}

void focusLens(const Molecule& molecule, const PictureDescription& d, const glm::dvec3& center,
               RenderSettings& settings) {
    DepthOfField& lens = settings.effects.depthOfField;
    if (lens.strength <= 0 || lens.focus) return;
    if (const SceneCamera* camera = sceneCamera(molecule, d))
        lens.focus = -(settings.view.rotation * (camera->target - center)).z;
    else if (!d.aim.turns || d.aim.zoomTo || d.aim.uncover)  // a movie from all sides keeps its distance
        lens.focus = -focusIn(molecule, d, settings.view, center).z;
}

}  // namespace nacre::app
