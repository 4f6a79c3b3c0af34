#pragma once

#include <cstdint>
#include <string>

#include "app/picture/description.h"

namespace nacre::app {

/// `nacre serve`.
struct ServeOptions {
    std::string address = "127.0.0.1";
    int port = 8080;              ///< 0: one that is free
    std::string root;             ///< folder whose files are inputs; empty: none
    int workers = 1;              ///< pictures drawn at the same time
    int queue = 64;               ///< requests that wait for a worker, at most
    double seconds = 60;          ///< that a request waits for its picture
    std::int64_t cacheMiB = 256;  ///< pictures kept on disk
    PictureDescription picture;   ///< device, cache folder, memory, offline and allow-download of all requests
};

}  // namespace nacre::app
