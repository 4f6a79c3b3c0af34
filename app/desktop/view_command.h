#pragma once

#include "app/desktop/view_options.h"

namespace nacre::app {

/// Opens a window and stays until it is closed, or a signal ends it: then, too, its state is kept. @throws Error
void viewCommand(const ViewOptions& options);

}  // namespace nacre::app
