#pragma once
// Options that derive a picture's view from the molecule: --center, --orient, --look-at, --zoom-to, --uncover, and
// --clip with a selection.

#include <optional>

#include "engine/molecule/selection/selection.h"

namespace nacre::app {

struct Aim {
    bool principal = false;             ///< principal axes; else the camera's orientation
    std::optional<Selection> orientBy;  ///< their principal axes; empty: of everything drawn
    bool fromSide = false;              ///< the shortest axis to the right, the longest upwards
    std::optional<Selection> left;      ///< with `principal`: on the left
    std::optional<Selection> spares;    ///< stays whole under clipping planes
    std::optional<Selection> clip;      ///< has a clipping plane in front of it
    std::optional<Selection> center;    ///< its middle is the centre of picture and rotation
    std::optional<Selection> lookAt;    ///< faces the viewer
    std::optional<Selection> zoomTo;    ///< fills the picture

    /// Atoms to uncover; empty: zoomTo, if `uncovers`.
    std::optional<Selection> uncover;
    bool uncovers = true;
    /// No scale is given: the visible scene fills the picture.
    bool fits = false;
    bool placed = false;  ///< a saved view sets the molecule's position in the picture
    bool turns = false;   ///< pictures from other sides follow, and all must fit

    bool any() const { return principal || lookAt || zoomTo || uncover || center || clip; }
    /// The default.
    static Aim standard() {
        Aim aim;
        aim.fits = true;
        return aim;
    }
};

}  // namespace nacre::app
