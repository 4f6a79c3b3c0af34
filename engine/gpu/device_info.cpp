#include "engine/gpu/device_info.h"

#include <algorithm>

#include "engine/devices.h"
#include "engine/gpu/bundled_driver.h"
#include "engine/gpu/capture_hook.h"
#include "engine/gpu/instance.h"

namespace nacre {
namespace {

/// "4.1"
std::string megabytes(std::uint64_t bytes) {
    const std::uint64_t tenths = (bytes * 10 + 500'000) / 1'000'000;
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

}  // namespace

DeviceInfo gpu::describeDevice(const Caps& caps) {
    DeviceInfo info;
    info.name = caps.deviceName;
    info.driver = caps.driverName;
    info.type = caps.type;
    info.apiVersion = std::to_string(VK_API_VERSION_MAJOR(caps.apiVersion)) + "." +
                      std::to_string(VK_API_VERSION_MINOR(caps.apiVersion)) + "." +
                      std::to_string(VK_API_VERSION_PATCH(caps.apiVersion));
    info.encodedFormat = graph::formatName(caps.encoded.format) + (caps.encoded.ordered ? " in raster order" : "");
    info.lazyMemory = caps.plan.transient;
    info.timestamps = caps.timestampBits > 0;
    info.rasterOrder = caps.plan.rasterOrder != graph::RasterOrder::none;
    info.localRead = caps.localRead;
    info.mergeFeedback = caps.mergeFeedback;
    info.driverKey = caps.driverKey;
    info.capabilitySet = caps.capabilitySet;
    if (caps.knownAs.what) info.knownAs = caps.knownAs.what, info.knownBy = caps.knownAs.source;
    return info;
}

namespace {

std::vector<std::pair<std::string, std::uint64_t>> listLimits(const vk::PhysicalDeviceLimits& l) {
    return {{"max_image_dimension_2d", l.maxImageDimension2D},
            {"max_color_attachments", l.maxColorAttachments},
            {"max_fragment_output_attachments", l.maxFragmentOutputAttachments},
            {"max_fragment_combined_output_resources", l.maxFragmentCombinedOutputResources},
            {"max_per_stage_input_attachments", l.maxPerStageDescriptorInputAttachments},
            {"max_per_stage_storage_buffers", l.maxPerStageDescriptorStorageBuffers},
            {"max_bound_descriptor_sets", l.maxBoundDescriptorSets},
            {"max_push_constants_size", l.maxPushConstantsSize},
            {"max_storage_buffer_range", l.maxStorageBufferRange},
            {"max_texel_buffer_elements", l.maxTexelBufferElements},
            {"max_memory_allocations", l.maxMemoryAllocationCount},
            {"max_compute_shared_memory_size", l.maxComputeSharedMemorySize},
            {"max_compute_work_group_invocations", l.maxComputeWorkGroupInvocations},
            {"min_storage_buffer_offset_alignment", l.minStorageBufferOffsetAlignment},
            {"sub_pixel_precision_bits", l.subPixelPrecisionBits},
            {"timestamp_period_picoseconds", static_cast<std::uint64_t>(l.timestampPeriod * 1000.0f)}};
}

/// ", compressed to 2, 3, 4 bits per channel on demand": rates that the driver offers for such a texture and render
/// target (VK_EXT_image_compression_control). Nacre asks for none: without that, images lose nothing.
std::string describeFixedRates(const vk::raii::PhysicalDevice& device, vk::Format format) {
    vk::ImageCompressionControlEXT control(vk::ImageCompressionFlagBitsEXT::eFixedRateDefault);
    const vk::PhysicalDeviceImageFormatInfo2 image(
        format, vk::ImageType::e2D, vk::ImageTiling::eOptimal,
        vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eColorAttachment, {}, &control);
    std::string text;
    try {
        const auto answer =
            device.getImageFormatProperties2<vk::ImageFormatProperties2, vk::ImageCompressionPropertiesEXT>(image);
        const auto rates =
            static_cast<std::uint32_t>(answer.get<vk::ImageCompressionPropertiesEXT>().imageCompressionFixedRateFlags);
        for (std::uint32_t bits = 1; bits <= 24; ++bits)
            if (rates >> (bits - 1) & 1) text += (text.empty() ? "" : ", ") + std::to_string(bits);
    } catch (const vk::FormatNotSupportedError&) {
        return {};
    }
    return text.empty() ? "" : ", compressed to " + text + " bits per channel on demand";
}

/// Formats that the renderer may use as render targets.
std::vector<std::string> listFormats(const vk::raii::PhysicalDevice& device) {
    using F = vk::FormatFeatureFlagBits;
    std::vector<std::string> all;
    const bool controls = gpu::hasExtension(device, VK_EXT_IMAGE_COMPRESSION_CONTROL_EXTENSION_NAME);
    for (const vk::Format format :
         {vk::Format::eR8Unorm, vk::Format::eR8G8B8A8Srgb, vk::Format::eR32Sfloat, vk::Format::eR32Uint,
          vk::Format::eR16G16B16A16Sfloat, vk::Format::eR16G16Sfloat, vk::Format::eA2B10G10R10UnormPack32,
          vk::Format::eR8G8B8A8Unorm, vk::Format::eD32Sfloat, vk::Format::eX8D24UnormPack32, vk::Format::eD16Unorm}) {
        const vk::FormatFeatureFlags features = device.getFormatProperties(format).optimalTilingFeatures;
        std::string text;
        const auto add = [&](F feature, const char* name) {
            if (features & feature) text += (text.empty() ? "" : ", ") + std::string(name);
        };
        add(F::eSampledImage, "sampled");
        add(F::eStorageImage, "storage");
        add(F::eColorAttachment, "colour");
        add(F::eColorAttachmentBlend, "blended");
        add(F::eDepthStencilAttachment, "depth");
        if (controls && (features & F::eColorAttachment)) text += describeFixedRates(device, format);
        all.push_back(vk::to_string(format) + ": " + (text.empty() ? "none" : text));
    }
    return all;
}

void addMemory(const vk::raii::PhysicalDevice& device, DeviceInfo& info) {
    const vk::PhysicalDeviceMemoryProperties memory = device.getMemoryProperties();
    vk::PhysicalDeviceMemoryBudgetPropertiesEXT budget{};
    if (gpu::hasExtension(device, VK_EXT_MEMORY_BUDGET_EXTENSION_NAME))
        budget = device
                     .getMemoryProperties2<vk::PhysicalDeviceMemoryProperties2,
                                           vk::PhysicalDeviceMemoryBudgetPropertiesEXT>()
                     .get<vk::PhysicalDeviceMemoryBudgetPropertiesEXT>();
    for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i) {
        if (!(memory.memoryHeaps[i].flags & vk::MemoryHeapFlagBits::eDeviceLocal)) continue;
        info.memoryBytes += memory.memoryHeaps[i].size;
        info.budgetBytes += budget.heapBudget[i];
    }
}

}  // namespace

DeviceInfo gpu::describeDevice(const Caps& caps, const vk::raii::PhysicalDevice& device) {
    DeviceInfo info = describeDevice(caps);
    info.bundled = BundledDriver::taken();
    const vk::PhysicalDeviceProperties properties = device.getProperties();
    info.vendorId = properties.vendorID;
    info.deviceId = properties.deviceID;
    info.driverVersion = properties.driverVersion;
    info.limits = listLimits(properties.limits);
    info.formats = listFormats(device);
    for (const vk::ExtensionProperties& extension : listExtensions(device))
        info.extensions.emplace_back(extension.extensionName.data());
    std::sort(info.extensions.begin(), info.extensions.end());
    addMemory(device, info);
    return info;
}

std::string describe(const DriverFeedback& feedback) {
    std::string text;
    const auto line = [&](const std::string& words) { text += (text.empty() ? "" : "\n") + words; };
    for (const MergedSubpasses& m : feedback.merges)
        line(m.name + ": " + std::to_string(m.planned) + " subpasses as " + std::to_string(m.carried) +
             (m.why.empty() ? "" : " (" + m.why + ")"));
    for (const TransientImage& image : feedback.transients)
        line(image.name + ": " + megabytes(image.committedBytes) + " of " + megabytes(image.bytes) + " MB committed");
    return text;
}

bool capturesBuilt() { return gpu::CaptureHook::built(); }

}  // namespace nacre
