#include "engine/gpu/caps.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <span>

#include "engine/error.h"
#include "engine/gpu/context.h"
#include "engine/gpu/dynamic_rendering.h"
#include "engine/gpu/frame_boundary.h"
#include "engine/gpu/instance.h"

namespace nacre::gpu {
namespace {

std::string typeName(vk::PhysicalDeviceType type) {
    switch (type) {
        case vk::PhysicalDeviceType::eDiscreteGpu:
            return "discrete";
        case vk::PhysicalDeviceType::eIntegratedGpu:
            return "integrated";
        case vk::PhysicalDeviceType::eVirtualGpu:
            return "virtual";
        case vk::PhysicalDeviceType::eCpu:
            return "software";
        default:
            return "other";
    }
}

std::string hexadecimal(std::span<const std::uint8_t> bytes) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t byte : bytes) text += {kDigits[byte >> 4], kDigits[byte & 15]};
    return text;
}

bool blends(const vk::raii::PhysicalDevice& device, vk::Format format) {
    return static_cast<bool>(device.getFormatProperties(format).optimalTilingFeatures &
                             vk::FormatFeatureFlagBits::eColorAttachmentBlend);
}

bool hasLazyMemory(const vk::raii::PhysicalDevice& device) {
    const auto memory = device.getMemoryProperties();
    for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i)
        if (memory.memoryTypes[i].propertyFlags & vk::MemoryPropertyFlagBits::eLazilyAllocated) return true;
    return false;
}

/// Whether no memory is both the device's own and fast for the host to read.
bool keepsMemoryApart(const vk::raii::PhysicalDevice& device) {
    constexpr auto kShared = vk::MemoryPropertyFlagBits::eDeviceLocal | vk::MemoryPropertyFlagBits::eHostVisible |
                             vk::MemoryPropertyFlagBits::eHostCached;
    const auto memory = device.getMemoryProperties();
    for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i)
        if ((memory.memoryTypes[i].propertyFlags & kShared) == kShared) return false;
    return true;
}

/// The finest rung that the device blends. R32F keeps depth exactly, but neither Mali nor Adreno 5xx blends it;
/// RGBA16F blends everywhere (the Vulkan specification's table of mandatory format support).
graph::EncodedFormat findBlendedFormat(const vk::raii::PhysicalDevice& device, EncodedDepth wanted) {
    for (const graph::EncodedFormat& format : graph::encodedFormats()) {
        if (wanted != EncodedDepth::automatic && wanted != format.rung) continue;
        if (blends(device, static_cast<vk::Format>(format.format))) return format;
        if (wanted == format.rung)
            throw Error("cannot encode depth", std::string(format.name), "this device does not blend that format");
    }
    throw Error("unsuitable device", device.getProperties().deviceName.data(), "it blends no format for encoded depth");
}

/// Where R32F does not blend, it is written in raster order if possible.
graph::EncodedFormat chooseEncodedFormat(const vk::raii::PhysicalDevice& device, EncodedDepth wanted,
                                         bool rasterOrder) {
    const bool finest = wanted == EncodedDepth::automatic || wanted == EncodedDepth::r32f;
    if (finest && rasterOrder && !blends(device, vk::Format::eR32Sfloat)) return graph::encodedInOrder();
    return findBlendedFormat(device, wanted);
}

bool set(const char* variable) {
    const char* value = std::getenv(variable);
    return value && *value && std::string_view(value) != "0";
}

/// Switches for unreliable drivers and for captures; they do not change the picture.
///   NACRE_NO_MERGE=1      every pass is its own render pass: no subpasses, no input attachments
///   NACRE_NO_DYNAMIC_RENDERING=1  render passes are VkRenderPasses, whatever the device supports
///   NACRE_NO_FOVEATION=1  headsets get a fragment for each pixel, whatever the device supports
///   NACRE_BAKE_BY_PAIRS=1  the bake tests two texels at a time, as for drivers that load uniforms one by one
///   NACRE_MULTIVIEW=1     lavapipe draws both eyes in one frame: right where nothing is far beyond the picture's edge
///   NACRE_DEVICE_LISTS=0, 1, N  the host or the device lists the primitives of tiles, whatever is faster; N: entries
///                            of a round
///   NACRE_NO_SUBGROUPS=1  compute draws tiles without subgroup operations, as on the least phone
///   NACRE_NO_TRANSIENT=1  every attachment has memory and is stored, so that a capture shows it
void applyEnvironment(graph::PlanCaps& plan) {
    if (set("NACRE_NO_MERGE")) plan.merge = false;
    if (set("NACRE_BAKE_BY_PAIRS")) plan.loadsUniforms = true;
    if (set("NACRE_NO_TRANSIENT")) {
        plan.transient = false;
        plan.storeAll = true;
    }
}

#ifdef NACRE_SOFTWARE
/// Lanes of the subgroup that draws a tile; 0: subgroups do not exchange values, or are too wide.
std::uint32_t findLanes(const vk::raii::PhysicalDevice& device) {
    using Can = vk::SubgroupFeatureFlagBits;
    constexpr auto kNeeded = Can::eBasic | Can::eVote | Can::eBallot | Can::eShuffle;
    const auto subgroups = device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceSubgroupProperties>()
                               .get<vk::PhysicalDeviceSubgroupProperties>();
    const std::uint32_t lanes = subgroups.subgroupSize;
    const bool exchanges = (subgroups.supportedOperations & kNeeded) == kNeeded &&
                           (subgroups.supportedStages & vk::ShaderStageFlagBits::eCompute);
    return exchanges && lanes >= 4 && lanes <= 32 && (lanes & (lanes - 1)) == 0 && !set("NACRE_NO_SUBGROUPS") ? lanes
                                                                                                              : 0;
}

/// Adds what passes by the lanes of a subgroup can do (engine/tiles/lanes).
void addLanes(TileCaps& caps, const vk::raii::PhysicalDevice& device, const vk::PhysicalDeviceLimits& limits) {
    constexpr std::uint32_t kPixels = 1u << 26;  // of a picture, which later passes read as texels
    caps.texels = limits.maxTexelBufferElements >= limits.maxStorageBufferRange / sizeof(std::uint32_t);
    // Colour and four storage buffers of the stage that shades.
    if (caps.texels || limits.maxFragmentCombinedOutputResources >= 5) caps.lanes = findLanes(device);
    if (caps.lanes == 0) return;
    // Inputs: shapes, rows of copies, looks, lists, numbers, tiles of bins. One output.
    caps.drawsEdges = caps.texels || limits.maxPerStageDescriptorStorageBuffers >= 7;
    caps.shade = limits.maxPerStageDescriptorStorageBuffers >= 8 && limits.maxTexelBufferElements >= kPixels;
}
#endif

TileCaps queryTileCaps(const vk::raii::PhysicalDevice& device, bool software) {
    const vk::PhysicalDeviceLimits limits = device.getProperties().limits;
    TileCaps caps;
#ifdef NACRE_SOFTWARE
    addLanes(caps, device, limits);
#endif
    caps.lists = !software || caps.lanes == 0;
    if (software) caps.shade = caps.texels && caps.lanes > 0;
    // An entry has two words in one buffer, which bins' words share.
    constexpr std::uint32_t kMost = 1u << 25, kBytes = 16;
    caps.entries = std::min(caps.lanes > 0 ? kMost : caps.entries, limits.maxStorageBufferRange / kBytes);
    return caps;
}

}  // namespace

std::uint32_t graphicsAndCompute(const vk::raii::PhysicalDevice& physical) {
    constexpr vk::QueueFlags kWanted = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
    const auto families = physical.getQueueFamilyProperties();
    for (std::uint32_t i = 0; i < families.size(); ++i)
        if ((families[i].queueFlags & kWanted) == kWanted) return i;
    throw Error("unsuitable device", physical.getProperties().deviceName.data(),
                "no queue does both graphics and compute");
}

bool hasExtension(const vk::raii::PhysicalDevice& device, const char* name) {
    for (const auto& e : listExtensions(device))
        if (std::string_view(e.extensionName.data()) == name) return true;
    return false;
}

bool tellsOfMerges(const vk::raii::PhysicalDevice& device) {
    using Features = vk::PhysicalDeviceSubpassMergeFeedbackFeaturesEXT;
    return hasExtension(device, VK_EXT_SUBPASS_MERGE_FEEDBACK_EXTENSION_NAME) &&
           device.getFeatures2<vk::PhysicalDeviceFeatures2, Features>().get<Features>().subpassMergeFeedback;
}

bool validationKnows(std::uint32_t version) {
    for (const vk::LayerProperties& layer : makeContext().enumerateInstanceLayerProperties())
        if (std::string_view(layer.layerName.data()) == "VK_LAYER_KHRONOS_validation")
            return layer.specVersion >= version;
    return true;
}

bool marksFrames(const vk::raii::PhysicalDevice& device, bool validate) {
    if (!hasExtension(device, VK_EXT_FRAME_BOUNDARY_EXTENSION_NAME)) return false;
    if (validate && !validationKnows(VK_MAKE_API_VERSION(0, 1, 3, 259))) return false;
    VkPhysicalDeviceFrameBoundaryFeaturesEXT boundary{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAME_BOUNDARY_FEATURES_EXT,
                                                      nullptr, false};
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &boundary, {}};
    device.getDispatcher()->vkGetPhysicalDeviceFeatures2(*device, &features);
    return boundary.frameBoundary;
}

bool maintainsSwapchains(const vk::raii::PhysicalDevice& device) {
    using Features = vk::PhysicalDeviceSwapchainMaintenance1FeaturesEXT;
    return hasExtension(device, VK_EXT_SWAPCHAIN_MAINTENANCE_1_EXTENSION_NAME) &&
           device.getFeatures2<vk::PhysicalDeviceFeatures2, Features>().get<Features>().swapchainMaintenance1;
}

bool readsInRasterOrder(const vk::raii::PhysicalDevice& device) {
    if (!hasExtension(device, VK_EXT_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_EXTENSION_NAME) &&
        !hasExtension(device, VK_ARM_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_EXTENSION_NAME))  // the older name
        return false;
    using Features = vk::PhysicalDeviceRasterizationOrderAttachmentAccessFeaturesEXT;
    return device.getFeatures2<vk::PhysicalDeviceFeatures2, Features>()
        .get<Features>()
        .rasterizationOrderColorAttachmentAccess;
}

DensityMaps queryDensityMaps(const vk::raii::PhysicalDevice& device) {
    constexpr std::uint32_t kTexel = 32;  // 2 degrees of a headset's picture
    if (set("NACRE_NO_FOVEATION")) return {0, "switched off by NACRE_NO_FOVEATION"};
    if (!hasExtension(device, VK_EXT_FRAGMENT_DENSITY_MAP_EXTENSION_NAME))
        return {0, "the driver has no VK_EXT_fragment_density_map"};
    using Features = vk::PhysicalDeviceFragmentDensityMapFeaturesEXT;
    const auto features = device.getFeatures2<vk::PhysicalDeviceFeatures2, Features>().get<Features>();
    if (!features.fragmentDensityMap || !features.fragmentDensityMapNonSubsampledImages)
        return {0, "the driver takes density maps for subsampled images alone, and a headset's are none"};
    // R8G8_UNORM is one of their formats everywhere ("Required Format Support"). Turnip 25.0.7 takes it unlisted.
    using Properties = vk::PhysicalDeviceFragmentDensityMapPropertiesEXT;
    const auto limits = device.getProperties2<vk::PhysicalDeviceProperties2, Properties>().get<Properties>();
    const vk::Extent2D &least = limits.minFragmentDensityTexelSize, &most = limits.maxFragmentDensityTexelSize;
    const std::uint32_t texel = std::min({std::max({kTexel, least.width, least.height}), most.width, most.height});
    if (texel < std::max(least.width, least.height))
        return {0, "the texels of the driver's density maps are no squares"};
    return {texel, nullptr};
}

std::uint32_t viewsAtOnce(const vk::raii::PhysicalDevice& device) {
    using Features = vk::PhysicalDeviceMultiviewFeatures;
    using Properties = vk::PhysicalDeviceMultiviewProperties;
    if (!device.getFeatures2<vk::PhysicalDeviceFeatures2, Features>().get<Features>().multiview) return 1;
    return device.getProperties2<vk::PhysicalDeviceProperties2, Properties>().get<Properties>().maxMultiviewViewCount;
}

graph::DriverIdentity driverIdentity(const vk::raii::PhysicalDevice& device) {
    const vk::PhysicalDeviceProperties properties = device.getProperties();
    graph::DriverIdentity identity;
    identity.vendor = properties.vendorID;
    identity.device = properties.deviceName.data();
    identity.version = properties.driverVersion;
    identity.vulkan = properties.apiVersion;
    identity.software = properties.deviceType == vk::PhysicalDeviceType::eCpu;
    identity.portable = hasExtension(device, "VK_KHR_portability_subset");
    identity.lazyMemory = hasLazyMemory(device);
    if (hasExtension(device, VK_KHR_DRIVER_PROPERTIES_EXTENSION_NAME))
        identity.driver = static_cast<VkDriverId>(
            device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>()
                .get<vk::PhysicalDeviceDriverProperties>()
                .driverID);
    return identity;
}

Caps queryCaps(const vk::raii::PhysicalDevice& device, const DeviceOptions& options) {
    const auto chain = device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceIDProperties>();
    const auto& properties = chain.get<vk::PhysicalDeviceProperties2>().properties;
    Caps caps;
    caps.deviceName = properties.deviceName.data();
    caps.type = typeName(properties.deviceType);
    caps.apiVersion = properties.apiVersion;
    caps.driverVersion = properties.driverVersion;
    const graph::DriverIdentity identity = driverIdentity(device);
    if (hasExtension(device, VK_KHR_DRIVER_PROPERTIES_EXTENSION_NAME)) {
        const auto driver = device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>()
                                .get<vk::PhysicalDeviceDriverProperties>();
        caps.driverName = std::string(driver.driverName.data()) + " " + driver.driverInfo.data();
    }
    caps.snapPixels = std::ldexp(1.0f, -static_cast<int>(properties.limits.subPixelPrecisionBits));
    caps.blendsFloats = blends(device, vk::Format::eR32G32B32A32Sfloat);
    caps.maxImageSize = properties.limits.maxImageDimension2D;
    const auto& id = chain.get<vk::PhysicalDeviceIDProperties>();
    caps.driverKey = hexadecimal(id.driverUUID) + hexadecimal(id.deviceUUID) + std::to_string(caps.driverVersion);
    caps.localRead = readsLocally(device, options.validate);
    caps.mergeFeedback = tellsOfMerges(device);
    caps.timestampBits = device.getQueueFamilyProperties()[graphicsAndCompute(device)].timestampValidBits;
    caps.nanosecondsPerTick = properties.limits.timestampPeriod;
    caps.maxStorageBufferBytes = properties.limits.maxStorageBufferRange;
    if (hasExtension(device, VK_KHR_MAINTENANCE_4_EXTENSION_NAME))
        caps.maxBufferBytes =
            device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceMaintenance4Properties>()
                .get<vk::PhysicalDeviceMaintenance4Properties>()
                .maxBufferSize;

    const graph::DeviceClass known = graph::classifyDriver(identity);
    caps.plan = known.set->plan;
    caps.capabilitySet = known.set->plan.name;
    if (known.row) caps.knownAs = known.row->fact;
    caps.plan.name = caps.deviceName;
    if (readsInRasterOrder(device))
        caps.plan.rasterOrder = graph::RasterOrder::promised;
    else
        caps.plan.rasterOrder = caps.plan.tileSubpasses && graph::has(graph::Quirk::keepsOrder, identity)
                                    ? graph::RasterOrder::assumed
                                    : graph::RasterOrder::none;
    caps.plan.transient = identity.lazyMemory;
    // MoltenVK offers it but stores anyway.
    caps.plan.storeNone = hasExtension(device, VK_EXT_LOAD_STORE_OP_NONE_EXTENSION_NAME) && !identity.portable;
    caps.quirks = graph::findQuirks(identity);
    caps.plan.maxColorAttachments = std::min(properties.limits.maxColorAttachments, 8u);
    caps.plan.maxInputAttachments = std::min(properties.limits.maxPerStageDescriptorInputAttachments, 8u);
    // lavapipe 22.3 draws clipped primitives in the first view alone (tests/renderer/eyes_test.cpp).
    const bool losesViews = identity.driver == VK_DRIVER_ID_MESA_LLVMPIPE && !set("NACRE_MULTIVIEW");
    caps.plan.maxViews = losesViews ? 1 : viewsAtOnce(device);
    const DensityMaps maps = queryDensityMaps(device);
    caps.plan.densityTexel = maps.texel;
    if (maps.lacks) caps.lacksDensityMaps = maps.lacks;
    caps.plan.placesSamples = properties.limits.standardSampleLocations;
    applyEnvironment(caps.plan);
    caps.encoded = chooseEncodedFormat(device, options.encoded, caps.plan.rasterOrder == graph::RasterOrder::promised);
    caps.encodedMaps = caps.encoded.ordered ? findBlendedFormat(device, EncodedDepth::automatic) : caps.encoded;
    caps.kind = known.kind;
    caps.tiles = queryTileCaps(device, identity.software);
    if (identity.software) {
        constexpr double kNever = std::numeric_limits<double>::infinity();
        caps.plan.geometry = {false, kNever, kNever, kNever};  // a triangle costs a hundred fragments
        caps.plan.conservativeDepth = false;                   // none tests early if the shader writes depth
        caps.fastPowers = caps.asynchronous = false;
        caps.gathersTexels = caps.tiles.texels;
    }
    caps.apartMemory = caps.type == "discrete" && keepsMemoryApart(device);
    if (const char* lists = std::getenv("NACRE_DEVICE_LISTS")) {
        const unsigned long entries = std::strtoul(lists, nullptr, 10);
        caps.tiles.lists = entries > 0 || caps.tiles.lanes == 0;
        if (entries > 1) caps.tiles.entries = std::min(static_cast<std::uint32_t>(entries), caps.tiles.entries);
    }
    caps.visibility = options.visibility;
    caps.multisampling = options.multisampling;
    caps.lacksRasterOrder = options.capture
                                ? "RenderDoc hides VK_EXT_rasterization_order_attachment_access: capture another path"
                                : "VK_EXT_rasterization_order_attachment_access is missing";
    return caps;
}

}  // namespace nacre::gpu
