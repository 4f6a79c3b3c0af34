#include "app/files/device_report.h"

#include <nlohmann/json.hpp>

namespace nacre::app {

nlohmann::ordered_json deviceJson(const DeviceInfo& device) {
    nlohmann::ordered_json limits = nlohmann::ordered_json::object();
    for (const auto& [name, value] : device.limits) limits[name] = value;
    return {{"name", device.name},
            {"type", device.type},
            {"api_version", device.apiVersion},
            {"driver", device.driver},
            {"bundled_driver", device.bundled},
            {"visibility", device.visibility},
            {"why", device.why},
            {"motion_samples", device.motionSamples},
            {"motion_why", device.motionWhy},
            {"encoded_format", device.encodedFormat},
            {"lazy_memory", device.lazyMemory},
            {"timestamps", device.timestamps},
            {"raster_order", device.rasterOrder},
            {"tiles", device.tiles},
            {"dynamic_rendering", device.localRead},
            {"merge_feedback", device.mergeFeedback},
            {"self_test", device.selfTest},
            {"capability_set", device.capabilitySet},
            {"known_as", device.knownAs},
            {"known_by", device.knownBy},
            {"driver_key", device.driverKey},
            {"vendor_id", device.vendorId},
            {"device_id", device.deviceId},
            {"driver_version", device.driverVersion},
            {"memory_bytes", device.memoryBytes},
            {"memory_budget_bytes", device.budgetBytes},
            {"limits", limits},
            {"formats", device.formats},
            {"extensions", device.extensions}};
}

}  // namespace nacre::app
