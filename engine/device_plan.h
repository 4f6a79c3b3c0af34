#pragma once
// What a real device is planned with, for whoever looks at plans instead of drawing.

#include <string>

#include "engine/device_options.h"
#include "engine/graph/encoded_format.h"
#include "engine/graph/plan.h"

namespace nacre {

struct DevicePlan {
    std::string name;  ///< of the device
    graph::PlanCaps caps;
    Visibility visibility{};  ///< the path in force
    std::string why;          ///< of `visibility`
    graph::EncodedFormat encoded;
};

/// Opens the device that the options name. @throws Error as Renderer does
DevicePlan planOf(const DeviceOptions& options);

}  // namespace nacre
