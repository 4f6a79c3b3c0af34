#pragma once
// Capabilities of a device, with every vendor quirk. Only caps.cpp asks for a vendor or driver.

#include <string>
#include <vulkan/vulkan_raii.hpp>

#include "engine/device_options.h"
#include "engine/graph/capability_sets.h"
#include "engine/graph/frame_caps.h"
#include "engine/graph/known_drivers.h"

namespace nacre::gpu {

using graph::TileCaps;

struct Caps : graph::FrameCaps {
    std::string deviceName, driverName;
    std::string type;  ///< "discrete", "integrated", "virtual", "software", "other"
    std::uint32_t apiVersion = 0;
    std::uint32_t driverVersion = 0;
    float snapPixels = 1.0f / 16;  ///< maximum distance by which the rasteriser moves a vertex
    std::uint32_t maxImageSize = 4096;
    bool localRead = false;           ///< render passes with input attachments use dynamic rendering
    bool mergeFeedback = false;       ///< the driver reports how it merges subpasses
    std::uint32_t timestampBits = 0;  ///< of the queue's timestamps; 0: no timestamps
    double nanosecondsPerTick = 1;    ///< per timestamp tick
    std::uint64_t maxStorageBufferBytes = 1u << 27;
    std::uint64_t maxBufferBytes = UINT64_MAX;  ///< per buffer, where the device reports it (VK_KHR_maintenance4)
    graph::EncodedFormat encodedMaps;           ///< for the bake's maps, which are blended
    std::uint32_t quirks = 0;                   ///< of the driver, a bit each
    bool has(graph::Quirk quirk) const { return (quirks >> static_cast<unsigned>(quirk) & 1) != 0; }
    bool fastPowers = true;      ///< powers take a few instructions
    bool gathersTexels = false;  ///< shaders interpolate texels themselves: a word costs as much as a texel
    /// Memory that the host reads fast is not the device's own: a graphics card reads it through its bus.
    bool apartMemory = false;
    /// Submissions return at once, and timestamps cost nothing: bakes are cut into short, timed submissions.
    bool asynchronous = true;
    std::string driverKey;      ///< device, driver and driver version as hexadecimal digits
    std::string capabilitySet;  ///< base of the plan's caps
    graph::Fact knownAs{};      ///< its row in the table of known drivers; null where it has none
};

/// The identity that a device reports, for the tables of known drivers.
graph::DriverIdentity driverIdentity(const vk::raii::PhysicalDevice& device);

/// @param options user's choices; `automatic` leaves the choice to the device
/// @throws Error if the device cannot do what the options ask for
Caps queryCaps(const vk::raii::PhysicalDevice& device, const DeviceOptions& options = {});

/// The queue family that draws and computes. @throws Error if there is none
std::uint32_t graphicsAndCompute(const vk::raii::PhysicalDevice& device);

bool hasExtension(const vk::raii::PhysicalDevice& device, const char* name);

/// Whether an installed validation layer (if any) knows this version of Vulkan or a later one. An older layer reports
/// what it does not know as an error.
bool validationKnows(std::uint32_t version);

/// Whether submissions can mark the end of a frame that is not presented. @param validate  whether validation is on
bool marksFrames(const vk::raii::PhysicalDevice& device, bool validate);

/// Whether the device reports when a presented image is free, and takes back images that were not drawn into. Its
/// instance needs VK_EXT_surface_maintenance1.
bool maintainsSwapchains(const vk::raii::PhysicalDevice& device);

/// Whether the driver reports how it merges subpasses.
bool tellsOfMerges(const vk::raii::PhysicalDevice& device);

/// Number of views that a pass can draw at once; 1: the device has no multiview.
std::uint32_t viewsAtOnce(const vk::raii::PhysicalDevice& device);

/// Fragment density maps for images that are no subsampled ones, such as those of a headset's runtime.
struct DensityMaps {
    std::uint32_t texel = 0;  ///< pixels per side of a map's texel; 0: there are none
    const char* lacks = nullptr;
};
DensityMaps queryDensityMaps(const vk::raii::PhysicalDevice& device);

/// Whether fragments can read their own attachment in raster order.
bool readsInRasterOrder(const vk::raii::PhysicalDevice& device);

}  // namespace nacre::gpu
