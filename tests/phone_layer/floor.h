#pragma once
// The least device that has to do, as numbers; and devices of profiles, which have more (profiles.h).
//
// Limits, features and extensions: the profile VP_ANDROID_baseline_2022, version 2 (Khronos' Vulkan-Profiles). Where
// the Vulkan 1.1 specification's required limits are lower than the profile's, the lower number stands, since it is
// what devices outside the profile have: maxFragmentCombinedOutputResources 4.
// Formats: the specification's tables of mandatory format support. One thing goes beyond both: D32_SFLOAT as a depth
// attachment, which the specification asks for unless X8_D24_UNORM_PACK32 is one.
// MoltenVK: the portability subset of an iOS GPU of family 3 (LunarG's sample configuration for it) on top.

#include <vulkan/vulkan.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "tests/phone_layer/profiles.h"

namespace nacre::phone {

struct AtMost {
    std::uint32_t VkPhysicalDeviceLimits::*limit;
    std::uint32_t value;
    const char* name;
};
#define NACRE_LIMIT(name, value) \
    { &VkPhysicalDeviceLimits::name, value, #name }
/// A device may allow more; none that counts allows less.
inline const AtMost kLimits[] = {NACRE_LIMIT(maxImageDimension1D, 4096),
                                 NACRE_LIMIT(maxImageDimension2D, 4096),
                                 NACRE_LIMIT(maxImageDimension3D, 512),
                                 NACRE_LIMIT(maxImageDimensionCube, 4096),
                                 NACRE_LIMIT(maxImageArrayLayers, 256),
                                 NACRE_LIMIT(maxTexelBufferElements, 65536),
                                 NACRE_LIMIT(maxUniformBufferRange, 16384),
                                 NACRE_LIMIT(maxStorageBufferRange, 134217728),
                                 NACRE_LIMIT(maxPushConstantsSize, 128),
                                 NACRE_LIMIT(maxMemoryAllocationCount, 4096),
                                 NACRE_LIMIT(maxSamplerAllocationCount, 4000),
                                 NACRE_LIMIT(maxBoundDescriptorSets, 4),
                                 NACRE_LIMIT(maxPerStageDescriptorSamplers, 16),
                                 NACRE_LIMIT(maxPerStageDescriptorUniformBuffers, 12),
                                 NACRE_LIMIT(maxPerStageDescriptorStorageBuffers, 4),
                                 NACRE_LIMIT(maxPerStageDescriptorSampledImages, 16),
                                 NACRE_LIMIT(maxPerStageDescriptorStorageImages, 4),
                                 NACRE_LIMIT(maxPerStageDescriptorInputAttachments, 4),
                                 NACRE_LIMIT(maxPerStageResources, 44),
                                 NACRE_LIMIT(maxDescriptorSetSamplers, 48),
                                 NACRE_LIMIT(maxDescriptorSetUniformBuffers, 36),
                                 NACRE_LIMIT(maxDescriptorSetStorageBuffers, 24),
                                 NACRE_LIMIT(maxDescriptorSetSampledImages, 48),
                                 NACRE_LIMIT(maxDescriptorSetStorageImages, 12),
                                 NACRE_LIMIT(maxDescriptorSetInputAttachments, 4),
                                 NACRE_LIMIT(maxVertexInputAttributes, 16),
                                 NACRE_LIMIT(maxVertexInputBindings, 16),
                                 NACRE_LIMIT(maxVertexInputAttributeOffset, 2047),
                                 NACRE_LIMIT(maxVertexInputBindingStride, 2048),
                                 NACRE_LIMIT(maxVertexOutputComponents, 64),
                                 NACRE_LIMIT(maxFragmentInputComponents, 64),
                                 NACRE_LIMIT(maxFragmentOutputAttachments, 4),
                                 NACRE_LIMIT(maxFragmentCombinedOutputResources, 4),
                                 NACRE_LIMIT(maxComputeSharedMemorySize, 16384),
                                 NACRE_LIMIT(maxComputeWorkGroupInvocations, 128),
                                 NACRE_LIMIT(subPixelPrecisionBits, 4),
                                 NACRE_LIMIT(maxDrawIndirectCount, 1),
                                 NACRE_LIMIT(maxViewports, 1),
                                 NACRE_LIMIT(maxFramebufferWidth, 4096),
                                 NACRE_LIMIT(maxFramebufferHeight, 4096),
                                 NACRE_LIMIT(maxFramebufferLayers, 256),
                                 NACRE_LIMIT(maxColorAttachments, 4)};
#undef NACRE_LIMIT

/// The profile that the phone meets besides: NACRE_PHONE_PROFILE; null: none.
inline const Profile* profile() {
    const char* wanted = std::getenv("NACRE_PHONE_PROFILE");
    const auto found = std::find_if(std::begin(kProfiles), std::end(kProfiles),
                                    [&](const Profile* p) { return wanted && p->name == wanted; });
    if (wanted && found == std::end(kProfiles)) std::abort();
    return found == std::end(kProfiles) ? nullptr : *found;
}

/// Lowers a device's limits to the floor, or to the profile's where those are higher, and raises its alignments.
inline void applyFloor(VkPhysicalDeviceLimits& limits) {
    const VkPhysicalDeviceLimits has = limits;
    for (const AtMost& l : kLimits) limits.*l.limit = std::min(limits.*l.limit, l.value);
    for (std::uint32_t i = 0; i < 3; ++i) {
        constexpr std::uint32_t kGroup[] = {128, 128, 64};
        limits.maxComputeWorkGroupCount[i] = std::min(limits.maxComputeWorkGroupCount[i], 65535u);
        limits.maxComputeWorkGroupSize[i] = std::min(limits.maxComputeWorkGroupSize[i], kGroup[i]);
    }
    for (std::uint32_t& side : limits.maxViewportDimensions) side = std::min(side, 4096u);
    limits.minTexelBufferOffsetAlignment = limits.minUniformBufferOffsetAlignment = 256;
    limits.minStorageBufferOffsetAlignment = 256;
    limits.bufferImageGranularity = 4096;
    limits.pointSizeRange[1] = std::min(limits.pointSizeRange[1], 511.0f);
    limits.maxSamplerAnisotropy = 1;
    for (const Profile* p = profile(); p; p = p->base)
        for (const ProfileLimit& l : p->limits)
            limits.*l.limit = std::min(has.*l.limit, std::max(limits.*l.limit, l.least));
}

/// What Vulkan 1.1 asks of every device with multiview.
inline void floorViews(VkPhysicalDeviceMultiviewProperties& views) {
    views.maxMultiviewViewCount = std::min(views.maxMultiviewViewCount, 6u);
    views.maxMultiviewInstanceIndex = std::min(views.maxMultiviewInstanceIndex, (1u << 27) - 1);
}

/// The profile's features; whatever else a driver has is hidden.
inline VkPhysicalDeviceFeatures floorFeatures(const VkPhysicalDeviceFeatures& has) {
    VkPhysicalDeviceFeatures f{};
    f.depthBiasClamp = has.depthBiasClamp;
    f.fragmentStoresAndAtomics = has.fragmentStoresAndAtomics;
    f.fullDrawIndexUint32 = has.fullDrawIndexUint32;
    f.imageCubeArray = has.imageCubeArray;
    f.independentBlend = has.independentBlend;
    f.robustBufferAccess = has.robustBufferAccess;
    f.sampleRateShading = has.sampleRateShading;
    f.shaderSampledImageArrayDynamicIndexing = has.shaderSampledImageArrayDynamicIndexing;
    f.shaderStorageImageArrayDynamicIndexing = has.shaderStorageImageArrayDynamicIndexing;
    f.shaderUniformBufferArrayDynamicIndexing = has.shaderUniformBufferArrayDynamicIndexing;
    f.shaderStorageBufferArrayDynamicIndexing = has.shaderStorageBufferArrayDynamicIndexing;
    f.shaderInt16 = has.shaderInt16;
    f.largePoints = has.largePoints;
    for (const Profile* p = profile(); p; p = p->base)
        for (const auto feature : p->features) f.*feature = has.*feature;
    return f;
}

/// Of the profile's extensions those that drivers may lack and the instance does not bring.
inline bool isFloorExtension(std::string_view name) {
    for (const char* known :
         {VK_KHR_SWAPCHAIN_EXTENSION_NAME, VK_KHR_MAINTENANCE_1_EXTENSION_NAME,
          VK_KHR_DESCRIPTOR_UPDATE_TEMPLATE_EXTENSION_NAME, VK_KHR_GET_MEMORY_REQUIREMENTS_2_EXTENSION_NAME,
          VK_KHR_DEDICATED_ALLOCATION_EXTENSION_NAME, VK_KHR_STORAGE_BUFFER_STORAGE_CLASS_EXTENSION_NAME,
          VK_KHR_VARIABLE_POINTERS_EXTENSION_NAME, VK_KHR_DRIVER_PROPERTIES_EXTENSION_NAME,
          VK_KHR_CREATE_RENDERPASS_2_EXTENSION_NAME, VK_KHR_SAMPLER_MIRROR_CLAMP_TO_EDGE_EXTENSION_NAME,
          // What that one needs; part of Vulkan 1.1 otherwise.
          VK_KHR_MULTIVIEW_EXTENSION_NAME, VK_KHR_MAINTENANCE_2_EXTENSION_NAME})
        if (name == known) return true;
    const Profile* p = profile();
    return p && p->has(name);
}

/// What optimal tiling of a format is good for at least.
inline VkFormatFeatureFlags floorFormat(VkFormat format) {
    constexpr VkFormatFeatureFlags kCopied =
        VK_FORMAT_FEATURE_TRANSFER_SRC_BIT | VK_FORMAT_FEATURE_TRANSFER_DST_BIT | VK_FORMAT_FEATURE_BLIT_SRC_BIT;
    constexpr VkFormatFeatureFlags kSampled = kCopied | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
    constexpr VkFormatFeatureFlags kDrawn =
        kSampled | VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT | VK_FORMAT_FEATURE_BLIT_DST_BIT;
    constexpr VkFormatFeatureFlags kBlended =
        kDrawn | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT | VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT;
    constexpr VkFormatFeatureFlags kStored = VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT;
    switch (format) {
        case VK_FORMAT_R8_UNORM:
        case VK_FORMAT_R8G8_UNORM:
        case VK_FORMAT_R8G8B8A8_SRGB:
        case VK_FORMAT_B8G8R8A8_UNORM:
        case VK_FORMAT_B8G8R8A8_SRGB:
        case VK_FORMAT_A2B10G10R10_UNORM_PACK32:
        case VK_FORMAT_R16_SFLOAT:
        case VK_FORMAT_R16G16_SFLOAT:
            return kBlended;
        case VK_FORMAT_R8G8B8A8_UNORM:
        case VK_FORMAT_R16G16B16A16_SFLOAT:
            return kBlended | kStored;
        case VK_FORMAT_R32_UINT:
        case VK_FORMAT_R32_SINT:
            return kDrawn | kStored | VK_FORMAT_FEATURE_STORAGE_IMAGE_ATOMIC_BIT;
        case VK_FORMAT_R32_SFLOAT:
        case VK_FORMAT_R32G32_UINT:
        case VK_FORMAT_R32G32_SFLOAT:
        case VK_FORMAT_R32G32B32A32_UINT:
        case VK_FORMAT_R32G32B32A32_SFLOAT:
            return kDrawn | kStored;
        case VK_FORMAT_D16_UNORM:
        case VK_FORMAT_D32_SFLOAT:
            return kSampled | VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT;
        default:
            return 0;
    }
}

}  // namespace nacre::phone
