#pragma once

#include <string>

namespace nacre {

/// How a pixel's nearest surface is found; every path draws the same picture.
enum class Visibility {
    automatic,  ///< the device's caps choose
    encoded,    ///< the paper's: encoded depth in colour, three subpasses
    fragdepth,  ///< gl_FragDepth, one subpass
};

struct DeviceOptions {
    bool validate = false;  ///< Khronos validation layer, with synchronization validation
    std::string device;     ///< number as `nacre devices` lists it, or part of a name; empty: the best there is
    Visibility visibility = Visibility::automatic;
};

}  // namespace nacre
