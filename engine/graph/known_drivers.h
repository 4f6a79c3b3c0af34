#pragma once
// Which capability set a real device is: a table of drivers and devices, as data, each row with its source.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "engine/graph/capability_sets.h"

namespace nacre::graph {

/// What a device tells of itself.
struct DriverIdentity {
    std::uint32_t vendor = 0;   ///< VkPhysicalDeviceProperties::vendorID
    VkDriverId driver{};        ///< 0 where VK_KHR_driver_properties is missing
    std::string device;         ///< VkPhysicalDeviceProperties::deviceName
    std::uint32_t version = 0;  ///< VkPhysicalDeviceProperties::driverVersion, as the driver packs it
    std::uint32_t vulkan = 0;   ///< VkPhysicalDeviceProperties::apiVersion
    bool portable = false;      ///< VK_KHR_portability_subset: Vulkan on another interface
    bool software = false;      ///< VK_PHYSICAL_DEVICE_TYPE_CPU
    bool lazyMemory = false;    ///< has lazily allocated memory
};

/// Which devices and drivers a row is about.
struct DriverPattern {
    std::uint32_t vendor = 0;                 ///< 0: any
    VkDriverId driver{};                      ///< 0: any
    std::string_view name{};                  ///< what the device's name has in it, before its number; empty: anything
    std::uint32_t least = 0, most = 0xffffu;  ///< that number: "Adreno (TM) 540"
    std::uint32_t before = 0;                 ///< driver versions below this one; 0: any
    std::uint32_t beforeVulkan = 0;           ///< Vulkan versions below this one; 0: any
};

struct KnownDriver {
    DriverPattern of;
    const char* set = "";  ///< name of the capability set
    Fact fact;
};

/// The first row that fits counts.
std::span<const KnownDriver> knownDrivers();

struct DeviceClass {
    const CapabilitySet* set = nullptr;
    DeviceKind kind{};
    const KnownDriver* row = nullptr;  ///< null: no row fits, and what memory the device has decides
};

DeviceClass classOf(const DriverIdentity& identity);

/// What a driver does wrong, or badly, beside its capability set.
enum class Quirk : std::uint8_t {
    noLocalRead,      ///< no dynamic rendering with local reads
    dispatchesApart,  ///< dispatches behind draws crash in the same command buffer
};
struct KnownQuirk {
    DriverPattern of;
    Quirk quirk{};
    Fact fact;
};
std::span<const KnownQuirk> knownQuirks();
/// Whether any row says so.
bool has(Quirk quirk, const DriverIdentity& identity);

}  // namespace nacre::graph
