#pragma once

#include "app/cli/command_spec.h"
#include "app/serve/serve_options.h"

namespace nacre::app {

/// Options of `nacre serve`.
void addServe(CommandSpec& command, ServeOptions& options);

}  // namespace nacre::app
