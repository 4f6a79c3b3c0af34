#pragma once
// Where a picture looks from: what --orient, --look-at and --zoom-to ask, and the camera that follows.

#include <optional>

#include "app/shared/option_values.h"
#include "engine/molecule/selection/selection.h"
#include "engine/scene/camera.h"
#include "engine/scene/representation.h"

namespace nacre::app {

struct Aim {
    bool principal = false;           ///< principal axes; else the camera's orientation
    std::optional<Selection> lookAt;  ///< what faces the viewer
    std::optional<Selection> zoomTo;  ///< what fills the picture

    /// What hides is left out; empty: what hides zoomTo, if `uncovers`.
    std::optional<Selection> uncover;
    bool uncovers = true;
    bool placed = false;  ///< a saved view says where the molecule stands in the picture
    bool turns = false;   ///< pictures from other sides follow: there is to be room for all of them

    bool any() const { return principal || lookAt || zoomTo || uncover; }
};

struct Aimed {
    Camera camera;
    /// Å from the centre away from the viewer, where a plane cuts away most of what hides the target.
    std::optional<double> clipNear;
};

/// What is to be seen whole, if anything.
const std::optional<Selection>& uncoveredBy(const Aim& aim);

/// The camera, aimed. Its rotation in degrees is applied last, its zoom is that of what is zoomed to.
/// @throws Error if a selection has no drawn atom
Aimed aimed(const Camera& camera, const Aim& aim, const Molecule& molecule, const Representation& scene,
            const Size& size);

/// Room around what is zoomed to, Å: a ligand with what touches it.
constexpr double kZoomMargin = 3;

}  // namespace nacre::app
