#pragma once
// HTTP by Foundation.

#include <string>

#include "app/download/http_host.h"

namespace nacre::app {

/// Like HttpFetch. Allows only https, as the system requires. Not for the main thread, which it would block.
void fetchBySystem(const std::string& url, const HttpTake& take);

}  // namespace nacre::app
