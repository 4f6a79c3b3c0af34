#pragma once

#include "app/picture/description.h"

namespace nacre::app {

/// What a window is asked for.
struct ViewOptions {
    PictureDescription first;  ///< that it shows at first; `size` is the window's
    bool restore = false;  ///< nothing is named: the start screen, which offers to go on where the last window was left
};

}  // namespace nacre::app
