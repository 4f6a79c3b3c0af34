#pragma once
// HTTP by Foundation.

#include <string>

#include "app/download/http_host.h"

namespace nacre::app {

/// As HttpFetch: https alone, as the system asks for. Not on the main thread, which it would stop.
void fetchBySystem(const std::string& url, const HttpTake& take);

}  // namespace nacre::app
