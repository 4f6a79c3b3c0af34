#pragma once
// Where a picture looks from, beside its camera: what --orient, --look-at, --zoom-to and --uncover ask.

#include <optional>

#include "engine/molecule/selection/selection.h"

namespace nacre::app {

struct Aim {
    bool principal = false;           ///< principal axes; else the camera's orientation
    std::optional<Selection> lookAt;  ///< what faces the viewer
    std::optional<Selection> zoomTo;  ///< what fills the picture

    /// What hides is left out; empty: what hides zoomTo, if `uncovers`.
    std::optional<Selection> uncover;
    bool uncovers = true;
    /// Nothing is said of the scale: what is drawn fills the picture, as it is seen from there.
    bool fits = false;
    bool placed = false;  ///< a saved view says where the molecule stands in the picture
    bool turns = false;   ///< pictures from other sides follow: there is to be room for all of them

    bool any() const { return principal || lookAt || zoomTo || uncover; }
    /// Where nothing else is asked for.
    static Aim standard() {
        Aim aim;
        aim.fits = true;
        return aim;
    }
};

}  // namespace nacre::app
