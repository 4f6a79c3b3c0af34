#pragma once
// Options that derive a picture's view from the molecule: --center, --orient, --look-at, --zoom-to and --uncover.

#include <optional>

#include "engine/molecule/selection/selection.h"

namespace nacre::app {

struct Aim {
    bool principal = false;           ///< principal axes; else the camera's orientation
    std::optional<Selection> axesOf;  ///< whose principal axes; empty: of all that is drawn
    bool fromSide = false;            ///< the shortest axis to the right, the longest upwards
    std::optional<Selection> left;    ///< of the side's view: what is on the left
    std::optional<Selection> spares;  ///< what clipping planes leave whole
    std::optional<Selection> clip;    ///< a plane in front of it
    std::optional<Selection> center;  ///< in the picture's centre, and rotated about
    std::optional<Selection> lookAt;  ///< faces the viewer
    std::optional<Selection> zoomTo;  ///< fills the picture

    /// Atoms to uncover; empty: zoomTo, if `uncovers`.
    std::optional<Selection> uncover;
    bool uncovers = true;
    /// No scale is given: the visible scene fills the picture.
    bool fits = false;
    bool placed = false;  ///< a saved view sets the molecule's position in the picture
    bool turns = false;   ///< pictures from other sides follow, and all of them must fit

    bool any() const { return principal || lookAt || zoomTo || uncover || center || clip; }
    /// The default.
    static Aim standard() {
        Aim aim;
        aim.fits = true;
        return aim;
    }
};

}  // namespace nacre::app
