#include "app/files/device_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/error.h"

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

nlohmann::ordered_json trafficJson(const CountedTraffic& traffic) {
    if (!traffic.lacks.empty()) return {{"lacks", traffic.lacks}};
    const auto orNull = [](const std::optional<std::uint64_t>& bytes) {
        return bytes ? nlohmann::ordered_json(*bytes) : nlohmann::ordered_json();
    };
    nlohmann::ordered_json counters = nlohmann::ordered_json::array();
    for (const CountedBytes& c : traffic.counters)
        counters.push_back({{"name", c.name}, {"category", c.category}, {"bytes", c.bytes}});
    nlohmann::ordered_json regions = nlohmann::ordered_json::array();
    for (const CountedRegions& r : traffic.regions)
        regions.push_back({{"name", r.name}, {"sum", r.sum}, {"bytes", orNull(r.bytes)}});
    return {{"visibility", traffic.visibility},
            {"pixels", traffic.pixels},
            {"read", orNull(traffic.read)},
            {"planned_read", traffic.plannedRead},
            {"written", orNull(traffic.written)},
            {"planned_written", traffic.plannedWritten},
            {"counters", counters},
            {"regions", regions}};
}

CountedTraffic queryTraffic(const DeviceInfo& device, const DeviceOptions& options) {
    CountedTraffic traffic;
    traffic.lacks = kNoCounters;
    const auto has = [&](const char* name) { return std::ranges::binary_search(device.extensions, name); };
    if (!has("VK_KHR_performance_query") && !has("VK_ARM_performance_counters_by_region")) return traffic;
    try {
        return countTraffic(options);
    } catch (const Error& error) {
        traffic.lacks = error.what();
        return traffic;
    }
}

}  // namespace nacre::app
