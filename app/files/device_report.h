#pragma once
// Report of a device, as one JSON object; the same from the program and the apps.

#include <nlohmann/json_fwd.hpp>

#include "engine/counted_traffic.h"
#include "engine/results.h"

namespace nacre::app {

/// The device, its path with the reason, its self-test, and its own properties.
nlohmann::ordered_json deviceJson(const DeviceInfo& device);

/// Bytes counted by the device and by the plan.
nlohmann::ordered_json trafficJson(const CountedTraffic& traffic);
/// Counts the bytes now, or reports why that is impossible.
CountedTraffic queryTraffic(const DeviceInfo& device, const DeviceOptions& options);

}  // namespace nacre::app
