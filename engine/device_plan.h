#pragma once
// The capabilities that plans for a real device are made with, for tools that print plans.

#include <string>

#include "engine/device_options.h"
#include "engine/graph/encoded_format.h"
#include "engine/graph/plan.h"
#include "engine/graph/visibility.h"

namespace nacre {

struct DevicePlan {
    std::string name;  ///< of the device
    graph::PlanCaps caps;
    Visibility visibility{};  ///< the chosen path
    std::string why;          ///< reason for `visibility`
    graph::EncodedFormat encoded;
    graph::SampleChoice motion;  ///< of a window's frames in motion
    bool shadesByTiles = false;  ///< `tiles` as compute that shades, too
};

/// Opens the device that the options name. @throws Error like Renderer
DevicePlan planOf(const DeviceOptions& options);

}  // namespace nacre
