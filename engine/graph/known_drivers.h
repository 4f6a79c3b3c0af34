#pragma once
// Maps real devices to capability sets: a table of drivers and devices, each row with its source.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "engine/graph/capability_sets.h"

namespace nacre::graph {

/// Identification that a device reports.
struct DriverIdentity {
    std::uint32_t vendor = 0;   ///< VkPhysicalDeviceProperties::vendorID
    VkDriverId driver{};        ///< 0 where VK_KHR_driver_properties is missing
    std::string device;         ///< VkPhysicalDeviceProperties::deviceName
    std::uint32_t version = 0;  ///< VkPhysicalDeviceProperties::driverVersion, as the driver packs it
    std::uint32_t vulkan = 0;   ///< VkPhysicalDeviceProperties::apiVersion
    bool portable = false;      ///< VK_KHR_portability_subset: Vulkan on top of another API
    bool software = false;      ///< VK_PHYSICAL_DEVICE_TYPE_CPU
    bool lazyMemory = false;    ///< has lazily allocated memory
};

/// Devices and drivers that a row matches.
struct DriverPattern {
    std::uint32_t vendor = 0;                 ///< 0: any
    VkDriverId driver{};                      ///< 0: any
    std::string_view name{};                  ///< text in the device's name, before its number; empty: any
    std::uint32_t least = 0, most = 0xffffu;  ///< range of that number: "Adreno (TM) 540"
    std::uint32_t before = 0;                 ///< driver versions below this one; 0: any
    std::uint32_t beforeVulkan = 0;           ///< Vulkan versions below this one; 0: any
};

struct KnownDriver {
    DriverPattern of;
    const char* set = "";  ///< name of the capability set
    Fact fact;
};

/// The first matching row counts.
std::span<const KnownDriver> knownDrivers();

struct DeviceClass {
    const CapabilitySet* set = nullptr;
    DeviceKind kind{};
    const KnownDriver* row = nullptr;  ///< null: no row matches; the device's memory types decide
};

DeviceClass classifyDriver(const DriverIdentity& identity);

/// Driver bugs, weaknesses and habits besides the capability set.
enum class Quirk : std::uint8_t {
    noLocalRead,      ///< no dynamic rendering with local reads
    dispatchesApart,  ///< dispatches after draws in one command buffer crash
    heapPerTile,      ///< allocates and frees heap memory for each tile of a frame
    /// Keys shaders of a pipeline cache by the address of the render pass, and confuses a new render pass with a
    /// destroyed one at that address: no cache is used.
    cacheMixesRenderPasses,
    noPipelineCache,  ///< vkCreatePipelineCache crashes
    oneCompiler,      ///< its compiler is not thread-safe: one pipeline at a time in the whole process
    keepsOrder,       ///< a fragment reads its own attachment in order, where no extension promises it
};
struct KnownQuirk {
    DriverPattern of;
    Quirk quirk{};
    Fact fact;
};
std::span<const KnownQuirk> knownQuirks();
/// Whether any matching row lists the quirk.
bool has(Quirk quirk, const DriverIdentity& identity);
/// All quirks of matching rows, a bit each.
std::uint32_t findQuirks(const DriverIdentity& identity);

}  // namespace nacre::graph
