#pragma once
// What a device is, for those who have no such device: one object of JSON, the same from the program and from the apps.

#include <nlohmann/json_fwd.hpp>

#include "engine/results.h"

namespace nacre::app {

/// What it is, the path that it takes and why, its self-test, and what it says of itself.
nlohmann::ordered_json deviceJson(const DeviceInfo& device);

}  // namespace nacre::app
