#pragma once
// Report of a device, as one JSON object; the same from the program and the apps.

#include <nlohmann/json_fwd.hpp>

#include "engine/results.h"

namespace nacre::app {

/// The device, its path with the reason, its self-test, and its own properties.
nlohmann::ordered_json deviceJson(const DeviceInfo& device);

}  // namespace nacre::app
