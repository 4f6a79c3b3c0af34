#pragma once
// Capabilities of a real device, for tools that plan its frames.

#include "engine/device_options.h"
#include "engine/graph/frame_caps.h"

namespace nacre {

/// Opens the device that the options name; its name is PlanCaps::name. @throws Error like Renderer
graph::FrameCaps deviceCaps(const DeviceOptions& options);

}  // namespace nacre
