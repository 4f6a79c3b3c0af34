#pragma once
// What a device can do, and every vendor quirk: nothing outside caps.cpp asks for a vendor or driver.

#include <string>
#include <vulkan/vulkan_raii.hpp>

#include "engine/device_options.h"
#include "engine/graph/capability_sets.h"
#include "engine/graph/encoded_format.h"
#include "engine/graph/known_drivers.h"
#include "engine/graph/plan.h"

namespace nacre::gpu {

/// Of the path that draws by tiles.
struct TileCaps {
    bool texels = false;      ///< texel buffers hold whole streams
    std::uint32_t lanes = 0;  ///< of a subgroup
    bool shade = false;       ///< compute shades faster than fragments are drawn
    bool drawsEdges = false;  ///< from the lists, too
    std::string lacks;        ///< what the path needs and the device has not; empty: nothing
};

struct Caps {
    std::string deviceName, driverName;
    std::string type;  ///< "discrete", "integrated", "virtual", "software", "other"
    std::uint32_t apiVersion = 0;
    std::uint32_t driverVersion = 0;
    float snapPixels = 1.0f / 16;  ///< how far the rasteriser may move a vertex
    std::uint32_t maxImageSize = 4096;
    bool localRead = false;           ///< render passes with inputs are carried out by dynamic rendering
    bool dispatchesApart = false;     ///< quirk: no dispatch in a command buffer behind a draw
    bool mergeFeedback = false;       ///< the driver tells what it makes of subpasses
    bool blendsFloats = false;        ///< colour attachments of 32 bits a channel
    std::uint32_t timestampBits = 0;  ///< of the queue's clock; 0: it has none
    double nanosecondsPerTick = 1;    ///< of that clock
    std::uint64_t maxStorageBufferBytes = 1u << 27;
    std::uint64_t maxBufferBytes = UINT64_MAX;  ///< of any buffer, where the device says so (VK_KHR_maintenance4)
    graph::PlanCaps plan;
    graph::EncodedFormat encoded;      ///< of pictures
    graph::EncodedFormat encodedMaps;  ///< of a bake's maps: it blends
    TileCaps tiles;
    /// Quirk: a pipeline cache is not to be used. SwiftShader looks shaders up in it by the address of the render pass,
    /// and takes those of one that is gone for those of another that was made in its place.
    bool cacheMixesRenderPasses = false;
    bool software = false;  ///< a CPU draws: triangles cost more than fragments
    std::string driverKey;  ///< of device, driver and its version: hexadecimal digits
    Visibility visibility = Visibility::encoded;
    std::string visibilityReason;
    std::string capabilitySet;  ///< what the plan's caps started from
    graph::Fact knownAs{};      ///< what the table of drivers says of it; null where it has no row
};

/// What a device tells of itself, for the tables of known drivers.
graph::DriverIdentity identityOf(const vk::raii::PhysicalDevice& device);

/// @param options what the user asked for; `automatic` leaves the choice to the device
/// @throws Error if the device cannot do what was asked for
Caps capsOf(const vk::raii::PhysicalDevice& device, const DeviceOptions& options = {});

/// The queue family that draws and computes. @throws Error if there is none
std::uint32_t graphicsAndCompute(const vk::raii::PhysicalDevice& device);

bool hasExtension(const vk::raii::PhysicalDevice& device, const char* name);

/// Whether the validation layer that is installed, if any, was made for this version of Vulkan or a later one. What it
/// does not know it takes for a mistake.
bool validationKnows(std::uint32_t version);

/// Whether submissions may say that they end a frame which nobody presents. @param validate  under validation
bool marksFrames(const vk::raii::PhysicalDevice& device, bool validate);

/// Whether the device tells when what was presented is done with, and takes images back that were not drawn into.
/// Its instance must have been made with VK_EXT_surface_maintenance1.
bool maintainsSwapchains(const vk::raii::PhysicalDevice& device);

/// Whether the driver tells what it makes of subpasses.
bool tellsOfMerges(const vk::raii::PhysicalDevice& device);

/// Whether fragments may read their own attachment in raster order.
bool readsInRasterOrder(const vk::raii::PhysicalDevice& device);

}  // namespace nacre::gpu
