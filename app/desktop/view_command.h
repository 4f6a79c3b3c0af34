#pragma once

#include "app/desktop/view_options.h"

namespace nacre::app {

/// Opens a window and returns when it is closed, or ended by a signal; saves its state in both cases. @throws Error
void viewCommand(const ViewOptions& options);

}  // namespace nacre::app
