#pragma once

#include "app/picture/description.h"

namespace nacre::app {

/// Options of a window.
struct ViewOptions {
    PictureDescription first;  ///< initial contents; `size` is the window's
    bool restore = false;      ///< without input: the start screen, which offers to restore the last session
};

/// Opens a window and returns when it is closed, or ended by a signal; saves its state in both cases. @throws Error
void viewCommand(const ViewOptions& options);

}  // namespace nacre::app
