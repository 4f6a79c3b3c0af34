#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/picture/description.h"

namespace nacre::app {

/// `nacre serve`.
struct ServeOptions {
    std::string address = "127.0.0.1";
    int port = 8080;                      ///< 0: any free port
    std::string root;                     ///< folder of input files; empty: none
    int workers = 1;                      ///< pictures drawn at the same time
    int queue = 64;                       ///< maximum number of requests waiting for a worker
    double seconds = 60;                  ///< maximum time of a request
    std::int64_t cacheMiB = 256;          ///< size of the picture cache on disk
    std::vector<std::string> sceneHosts;  ///< from which scenes may download, in addition to the databases
    PictureDescription picture;           ///< device, cache folder, memory, offline and allow-download for all requests
};

}  // namespace nacre::app
