#pragma once
// Bytes that a frame reads and writes in memory, as the device counts them (VK_KHR_performance_query,
// VK_ARM_performance_counters_by_region), and as its plan has them.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/device_options.h"

namespace nacre {

struct CountedBytes {
    std::string name, category;  ///< from the driver
    std::uint64_t bytes = 0;
};

/// A counter of the frame's regions, summed. The driver tells no unit.
struct CountedRegions {
    std::string name;                    ///< from the driver
    std::uint64_t sum = 0;               ///< as counted
    std::optional<std::uint64_t> bytes;  ///< where the name speaks of bytes, or of beats, which are 16 bytes
};

inline constexpr const char* kNoCounters =
    "the driver has neither VK_KHR_performance_query nor VK_ARM_performance_counters_by_region";

struct CountedTraffic {
    std::string lacks;         ///< why nothing was counted; empty: bytes were counted
    std::string visibility;    ///< path of the frame
    std::uint32_t pixels = 0;  ///< per side
    /// Counters of memory outside the chip; none: the driver has none.
    std::optional<std::uint64_t> read, written;
    std::uint64_t plannedRead = 0, plannedWritten = 0;  ///< attachments, and vertex outputs that go through memory
    std::vector<CountedBytes> counters;                 ///< every counter of bytes
    std::vector<CountedRegions> regions;                ///< every counter of regions
};

/// Draws a frame of the self-test's largest scene and counts. @throws Error if the device cannot draw it
CountedTraffic countTraffic(const DeviceOptions& options);

/// The direction that a counter of memory outside the chip counts.
enum class TrafficWay : std::uint8_t { neither, read, written };
TrafficWay trafficWay(const std::string& name, const std::string& category, const std::string& description);

/// Bytes that a counter of this name counted; none: it counts something else.
std::optional<std::uint64_t> countedBytes(const std::string& name, std::uint64_t sum);

/// "raster-order at 720x720: 3.1 MB read, planned 3.0; 5.1 MB written, planned 5.0"
std::string describe(const CountedTraffic& traffic);

}  // namespace nacre
