#pragma once
// Pictures over HTTP/1.1; docs/serve.md describes the interface.

#include "app/serve/serve_options.h"

namespace nacre::app {

/// `nacre serve`: until SIGINT or SIGTERM. @throws Error if there is no device, or the port is taken
void serveCommand(const ServeOptions& options);

}  // namespace nacre::app
