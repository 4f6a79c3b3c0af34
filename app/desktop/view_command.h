#pragma once

#include "app/cli/options.h"

namespace nacre::app {

/// Opens a window and stays until it is closed. @throws Error
void viewCommand(const ViewOptions& options);

}  // namespace nacre::app
