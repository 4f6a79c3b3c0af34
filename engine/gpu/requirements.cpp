#include "engine/gpu/requirements.h"

#include <algorithm>
#include <array>

#include "engine/error.h"
#include "engine/gpu/instance.h"
#include "engine/graph/plan.h"

namespace nacre::gpu {
namespace {

#define NACRE_LIMIT(name, least, why) \
    RequiredLimit { &VkPhysicalDeviceLimits::name, least, #name, why }
constexpr std::array kLimits{
    NACRE_LIMIT(maxImageDimension2D, 4096, "pictures and the occlusion atlas"),
    NACRE_LIMIT(maxImageDimension3D, 256, "bricks of density maps"),
    NACRE_LIMIT(maxFramebufferWidth, 4096, "pictures"),
    NACRE_LIMIT(maxFramebufferHeight, 4096, "pictures"),
    NACRE_LIMIT(maxPushConstantsSize, 128, "the view of a geometry pass"),
    NACRE_LIMIT(maxBoundDescriptorSets, 2, "what a pass reads, and what counts its fragments"),
    NACRE_LIMIT(maxPerStageDescriptorSamplers, 4, "a brick of a density map, and the depths beside it"),
    NACRE_LIMIT(maxPerStageDescriptorSampledImages, 4, "a brick of a density map, and the depths beside it"),
    NACRE_LIMIT(maxPerStageDescriptorInputAttachments, 1, "encoded depth, or numbers of primitives"),
    NACRE_LIMIT(maxPerStageDescriptorStorageBuffers, 4, "shapes, looks and copies of `deferred`, and the counter"),
    NACRE_LIMIT(maxPerStageDescriptorUniformBuffers, 2, "effects, and a brick of a density map"),
    NACRE_LIMIT(maxUniformBufferRange, 16 * 48, "directions of the occlusion bake"),
    NACRE_LIMIT(maxStorageBufferRange, 1u << 27, "streams of 4 million spheres"),
    NACRE_LIMIT(maxColorAttachments, 2, "colour, and the nearest depth that `raster-order` keeps"),
    NACRE_LIMIT(maxFragmentOutputAttachments, 2, "colour, and the nearest depth that `raster-order` keeps"),
    NACRE_LIMIT(maxFragmentCombinedOutputResources, 4, "one colour and three storage buffers of `deferred`"),
    NACRE_LIMIT(maxVertexInputBindings, 2, "shapes and looks"),
    NACRE_LIMIT(maxVertexInputAttributes, 4, "a cylinder's ends, look and patch"),
    NACRE_LIMIT(maxVertexInputBindingStride, 32, "a cylinder"),
    NACRE_LIMIT(maxVertexOutputComponents, 20, "a cylinder in view space, its look and patch"),
    NACRE_LIMIT(maxFragmentInputComponents, 20, "a cylinder in view space, its look and patch"),
    NACRE_LIMIT(maxPerStageDescriptorStorageImages, 1, "numbers of primitives that compute writes"),
    NACRE_LIMIT(maxComputeWorkGroupInvocations, 128, "lists of tiles, which compute sorts"),
    NACRE_LIMIT(maxComputeSharedMemorySize, 9 * 1024, "lists of tiles, which compute sorts"),
    NACRE_LIMIT(subPixelPrecisionBits, 4, "outlines are grown by what a vertex may be moved"),
};
#undef NACRE_LIMIT

constexpr VkFormatFeatureFlags kColor = VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT;
constexpr VkFormatFeatureFlags kSampled = VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
constexpr VkFormatFeatureFlags kLinear = kSampled | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
constexpr VkFormatFeatureFlags kStored = VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT;
constexpr VkFormatFeatureFlags kDepth = VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT;

constexpr std::array kRequired{
    RequiredFormat{VK_FORMAT_R8G8B8A8_SRGB, kColor | kLinear, "pictures"},
    RequiredFormat{VK_FORMAT_R8_UNORM, kColor | VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT | kLinear,
                   "the occlusion atlas, glyphs, counts of fragments"},
    RequiredFormat{VK_FORMAT_D32_SFLOAT, kDepth | kSampled, "depth"},
    RequiredFormat{VK_FORMAT_R32_SFLOAT, kColor | kSampled,
                   "depth maps, distances, the nearest depth of `raster-order`"},
    RequiredFormat{VK_FORMAT_R32_UINT, kColor | kSampled | kStored, "numbers of primitives"},
    RequiredFormat{VK_FORMAT_R32G32_UINT, kColor | kSampled, "the identity layer"},
    RequiredFormat{VK_FORMAT_R16_SFLOAT, kLinear, "density maps"},
    RequiredFormat{VK_FORMAT_R16G16_SFLOAT, kLinear, "density maps that are known in part"},
    RequiredFormat{VK_FORMAT_R32G32B32A32_SFLOAT, kColor | kSampled, "the surface layer"},
};

constexpr std::array kExtensions{VK_KHR_CREATE_RENDERPASS_2_EXTENSION_NAME};

[[noreturn]] void refuse(const VkPhysicalDeviceProperties& device, const std::string& why) {
    throw Error("unsuitable device", device.deviceName, why);
}

}  // namespace

std::span<const RequiredLimit> requiredLimits() { return kLimits; }
std::span<const RequiredFormat> requiredFormats() { return kRequired; }
std::span<const char* const> requiredExtensions() { return kExtensions; }

void checkRequirements(const vk::raii::PhysicalDevice& device, bool window) {
    const VkPhysicalDeviceProperties properties = device.getProperties();
    if (properties.apiVersion < kRequiredVulkan) refuse(properties, "Vulkan 1.1 is the floor");
    for (const RequiredLimit& l : kLimits)
        if (properties.limits.*l.limit < l.least)
            refuse(properties, std::string(l.name) + " is " + std::to_string(properties.limits.*l.limit) + ", and " +
                                   std::to_string(l.least) + " are needed: " + l.why);
    for (const RequiredFormat& f : kRequired) {
        const VkFormatProperties has = device.getFormatProperties(static_cast<vk::Format>(f.format));
        if ((has.optimalTilingFeatures & f.features) != f.features)
            refuse(properties, "its support of " + graph::formatName(f.format) + " does not do for " + f.why);
    }
    const auto& available = listExtensions(device);
    std::vector<const char*> names(kExtensions.begin(), kExtensions.end());
    if (window) names.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    for (const char* name : names)
        if (std::none_of(available.begin(), available.end(),
                         [&](const auto& e) { return std::string_view(name) == e.extensionName.data(); }))
            refuse(properties, std::string(name) + " is missing");
}

}  // namespace nacre::gpu
