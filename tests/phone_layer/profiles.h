#pragma once
// Written by tools/phone_profiles from github.com/KhronosGroup/Vulkan-Profiles: what profiles of phones ask for.

#include <vulkan/vulkan.h>

#include <algorithm>
#include <span>
#include <string_view>

// clang-format off
namespace nacre::phone {

struct ProfileLimit {
    std::uint32_t VkPhysicalDeviceLimits::*limit;
    std::uint32_t least;
};
struct Profile {
    std::string_view name;  ///< in NACRE_PHONE_PROFILE
    std::uint32_t vulkan;
    std::span<const ProfileLimit> limits;
    std::span<VkBool32 VkPhysicalDeviceFeatures::*const> features;
    std::span<const std::string_view> extensions;
    const Profile* base = nullptr;  ///< the lists have only what this profile asks for beyond it

    bool has(std::string_view extension) const {
        return std::ranges::find(extensions, extension) != extensions.end() || (base && base->has(extension));
    }
};
using L = VkPhysicalDeviceLimits;
using F = VkPhysicalDeviceFeatures;

// VP_ANDROID_vulkan_profile_2022
inline constexpr ProfileLimit kAndroid2022Limits[] = {
    {&L::maxBoundDescriptorSets, 4u}, {&L::maxColorAttachments, 4u}, {&L::maxComputeSharedMemorySize, 16384u},
    {&L::maxComputeWorkGroupInvocations, 128u}, {&L::maxDescriptorSetInputAttachments, 4u},
    {&L::maxDescriptorSetSampledImages, 48u}, {&L::maxDescriptorSetSamplers, 48u},
    {&L::maxDescriptorSetStorageBuffers, 24u}, {&L::maxDescriptorSetStorageBuffersDynamic, 4u},
    {&L::maxDescriptorSetStorageImages, 12u}, {&L::maxDescriptorSetUniformBuffers, 36u},
    {&L::maxDescriptorSetUniformBuffersDynamic, 8u}, {&L::maxDrawIndexedIndexValue, 4294967295u},
    {&L::maxFragmentCombinedOutputResources, 8u}, {&L::maxFragmentInputComponents, 64u},
    {&L::maxFragmentOutputAttachments, 4u}, {&L::maxFramebufferHeight, 4096u}, {&L::maxFramebufferLayers, 256u},
    {&L::maxFramebufferWidth, 4096u}, {&L::maxImageArrayLayers, 256u}, {&L::maxImageDimension1D, 4096u},
    {&L::maxImageDimension2D, 4096u}, {&L::maxImageDimension3D, 512u}, {&L::maxImageDimensionCube, 4096u},
    {&L::maxMemoryAllocationCount, 4096u}, {&L::maxPerStageDescriptorInputAttachments, 4u},
    {&L::maxPerStageDescriptorSampledImages, 16u}, {&L::maxPerStageDescriptorSamplers, 16u},
    {&L::maxPerStageDescriptorStorageBuffers, 4u}, {&L::maxPerStageDescriptorStorageImages, 4u},
    {&L::maxPerStageDescriptorUniformBuffers, 12u}, {&L::maxPerStageResources, 44u}, {&L::maxPushConstantsSize, 128u},
    {&L::maxSamplerAllocationCount, 4000u}, {&L::maxStorageBufferRange, 134217728u},
    {&L::maxTexelBufferElements, 65536u}, {&L::maxTexelOffset, 7u}, {&L::maxUniformBufferRange, 16384u},
    {&L::maxVertexInputAttributeOffset, 2047u}, {&L::maxVertexInputAttributes, 16u},
    {&L::maxVertexInputBindingStride, 2048u}, {&L::maxVertexInputBindings, 16u}, {&L::maxVertexOutputComponents, 64u},
};
inline constexpr VkBool32 F::*kAndroid2022Features[] = {
    &F::depthBiasClamp, &F::fragmentStoresAndAtomics, &F::fullDrawIndexUint32, &F::imageCubeArray,
    &F::independentBlend, &F::largePoints, &F::robustBufferAccess, &F::sampleRateShading, &F::shaderInt16,
    &F::shaderSampledImageArrayDynamicIndexing, &F::shaderStorageBufferArrayDynamicIndexing,
    &F::shaderStorageImageArrayDynamicIndexing, &F::shaderUniformBufferArrayDynamicIndexing,
    &F::textureCompressionASTC_LDR, &F::textureCompressionETC2,
};
inline constexpr std::string_view kAndroid2022Extensions[] = {
    "VK_ANDROID_external_memory_android_hardware_buffer", "VK_EXT_queue_family_foreign",
    "VK_EXT_swapchain_colorspace", "VK_GOOGLE_display_timing", "VK_KHR_android_surface", "VK_KHR_create_renderpass2",
    "VK_KHR_dedicated_allocation", "VK_KHR_descriptor_update_template", "VK_KHR_driver_properties",
    "VK_KHR_external_fence", "VK_KHR_external_fence_capabilities", "VK_KHR_external_fence_fd",
    "VK_KHR_external_memory", "VK_KHR_external_memory_capabilities", "VK_KHR_external_semaphore",
    "VK_KHR_external_semaphore_capabilities", "VK_KHR_external_semaphore_fd", "VK_KHR_get_memory_requirements2",
    "VK_KHR_get_physical_device_properties2", "VK_KHR_get_surface_capabilities2", "VK_KHR_incremental_present",
    "VK_KHR_maintenance1", "VK_KHR_sampler_mirror_clamp_to_edge", "VK_KHR_storage_buffer_storage_class",
    "VK_KHR_surface", "VK_KHR_swapchain", "VK_KHR_variable_pointers",
};
inline constexpr Profile kAndroid2022{"android-2022", VK_MAKE_API_VERSION(0, 1, 1, 106),
    kAndroid2022Limits, kAndroid2022Features, kAndroid2022Extensions};

// VP_ANDROID_vulkan_profile_2025
inline constexpr ProfileLimit kAndroid2025Limits[] = {
    {&L::maxColorAttachments, 8u}, {&L::maxComputeWorkGroupInvocations, 256u},
    {&L::maxDescriptorSetInputAttachments, 8u}, {&L::maxDescriptorSetSampledImages, 256u},
    {&L::maxDescriptorSetSamplers, 256u}, {&L::maxDescriptorSetStorageBuffers, 210u},
    {&L::maxDescriptorSetStorageBuffersDynamic, 8u}, {&L::maxDescriptorSetStorageImages, 126u},
    {&L::maxDescriptorSetUniformBuffers, 216u}, {&L::maxFragmentInputComponents, 112u},
    {&L::maxFragmentOutputAttachments, 8u}, {&L::maxImageDimension3D, 2048u},
    {&L::maxPerStageDescriptorInputAttachments, 8u}, {&L::maxPerStageDescriptorSampledImages, 48u},
    {&L::maxPerStageDescriptorSamplers, 32u}, {&L::maxPerStageDescriptorStorageBuffers, 35u},
    {&L::maxPerStageDescriptorStorageImages, 8u}, {&L::maxPerStageDescriptorUniformBuffers, 36u},
    {&L::maxPerStageResources, 224u}, {&L::maxUniformBufferRange, 65536u}, {&L::maxVertexOutputComponents, 128u},
};
inline constexpr VkBool32 F::*kAndroid2025Features[] = {
    &F::drawIndirectFirstInstance, &F::occlusionQueryPrecise, &F::shaderStorageImageExtendedFormats,
    &F::shaderStorageImageReadWithoutFormat,
};
inline constexpr std::string_view kAndroid2025Extensions[] = {
    "VK_EXT_debug_report", "VK_EXT_host_query_reset", "VK_EXT_index_type_uint8", "VK_EXT_scalar_block_layout",
    "VK_EXT_separate_stencil_usage", "VK_KHR_bind_memory2", "VK_KHR_device_group", "VK_KHR_device_group_creation",
    "VK_KHR_external_memory_fd", "VK_KHR_image_format_list", "VK_KHR_maintenance2", "VK_KHR_maintenance3",
    "VK_KHR_multiview", "VK_KHR_relaxed_block_layout", "VK_KHR_sampler_ycbcr_conversion",
    "VK_KHR_shader_draw_parameters", "VK_KHR_shader_float16_int8", "VK_KHR_shader_float_controls",
    "VK_KHR_vulkan_memory_model",
};
inline constexpr Profile kAndroid2025{"android-2025", VK_MAKE_API_VERSION(0, 1, 1, 128),
    kAndroid2025Limits, kAndroid2025Features, kAndroid2025Extensions, &kAndroid2022};

// VP_ANDROID_15_requirements
inline constexpr ProfileLimit kAndroid15Limits[] = {
    {&L::maxColorAttachments, 8u}, {&L::maxPerStageDescriptorSampledImages, 128u},
    {&L::maxPerStageDescriptorSamplers, 128u}, {&L::maxPerStageDescriptorStorageBuffers, 12u},
    {&L::maxPerStageDescriptorUniformBuffers, 13u},
};
inline constexpr VkBool32 F::*kAndroid15Features[] = {
    &F::drawIndirectFirstInstance, &F::samplerAnisotropy, &F::shaderImageGatherExtended,
    &F::shaderStorageImageExtendedFormats, &F::shaderStorageImageReadWithoutFormat,
    &F::shaderStorageImageWriteWithoutFormat,
};
inline constexpr std::string_view kAndroid15Extensions[] = {
    "VK_ANDROID_external_format_resolve", "VK_EXT_4444_formats", "VK_EXT_custom_border_color",
    "VK_EXT_device_memory_report", "VK_EXT_external_memory_acquire_unmodified", "VK_EXT_index_type_uint8",
    "VK_EXT_load_store_op_none", "VK_EXT_primitive_topology_list_restart", "VK_EXT_provoking_vertex",
    "VK_EXT_scalar_block_layout", "VK_EXT_surface_maintenance1", "VK_EXT_swapchain_maintenance1",
    "VK_GOOGLE_surfaceless_query", "VK_KHR_16bit_storage", "VK_KHR_maintenance5", "VK_KHR_shader_float16_int8",
    "VK_KHR_vertex_attribute_divisor",
};
inline constexpr Profile kAndroid15{"android-15", VK_MAKE_API_VERSION(0, 1, 3, 273),
    kAndroid15Limits, kAndroid15Features, kAndroid15Extensions, &kAndroid2022};

// VP_ANDROID_16_requirements
inline constexpr ProfileLimit kAndroid16Limits[] = {
    {&L::maxComputeWorkGroupInvocations, 256u}, {&L::maxDescriptorSetStorageBuffers, 96u},
    {&L::maxDescriptorSetUniformBuffers, 90u}, {&L::maxFragmentCombinedOutputResources, 16u},
    {&L::maxImageArrayLayers, 2048u}, {&L::maxImageDimension1D, 8192u}, {&L::maxImageDimension2D, 8192u},
    {&L::maxImageDimensionCube, 8192u}, {&L::maxPerStageDescriptorUniformBuffers, 15u},
    {&L::maxPerStageResources, 200u}, {&L::maxUniformBufferRange, 65536u}, {&L::maxVertexOutputComponents, 72u},
};
inline constexpr std::string_view kAndroid16Extensions[] = {
    "VK_EXT_host_image_copy", "VK_EXT_image_2d_view_of_3d", "VK_EXT_pipeline_protected_access",
    "VK_EXT_pipeline_robustness", "VK_EXT_transform_feedback", "VK_KHR_8bit_storage", "VK_KHR_load_store_op_none",
    "VK_KHR_maintenance6", "VK_KHR_map_memory2", "VK_KHR_shader_expect_assume", "VK_KHR_shader_float_controls2",
    "VK_KHR_shader_maximal_reconvergence", "VK_KHR_shader_subgroup_rotate",
    "VK_KHR_shader_subgroup_uniform_control_flow", "VK_KHR_swapchain_mutable_format",
};
inline constexpr Profile kAndroid16{"android-16", VK_MAKE_API_VERSION(0, 1, 3, 276),
    kAndroid16Limits, {}, kAndroid16Extensions, &kAndroid15};

// VP_ANDROID_17_requirements
inline constexpr ProfileLimit kAndroid17Limits[] = {
    {&L::maxDescriptorSetStorageImages, 144u},
};
inline constexpr VkBool32 F::*kAndroid17Features[] = {
    &F::dualSrcBlend, &F::multiDrawIndirect, &F::shaderInt64, &F::shaderStorageImageWriteWithoutFormat,
};
inline constexpr std::string_view kAndroid17Extensions[] = {
    "VK_ANDROID_external_format_resolve", "VK_EXT_calibrated_timestamps", "VK_EXT_custom_border_color",
    "VK_EXT_debug_utils", "VK_EXT_descriptor_indexing", "VK_EXT_device_address_binding_report",
    "VK_EXT_device_memory_report", "VK_EXT_external_memory_acquire_unmodified", "VK_EXT_graphics_pipeline_library",
    "VK_EXT_hdr_metadata", "VK_EXT_image_2d_view_of_3d", "VK_EXT_image_compression_control",
    "VK_EXT_image_compression_control_swapchain", "VK_EXT_present_mode_fifo_latest_ready", "VK_EXT_present_timing",
    "VK_EXT_primitive_topology_list_restart", "VK_EXT_provoking_vertex", "VK_EXT_surface_maintenance1",
    "VK_EXT_swapchain_maintenance1", "VK_EXT_transform_feedback", "VK_GOOGLE_surfaceless_query",
    "VK_KHR_maintenance7", "VK_KHR_maintenance8", "VK_KHR_maintenance9", "VK_KHR_pipeline_binary",
    "VK_KHR_pipeline_library", "VK_KHR_present_id2", "VK_KHR_present_wait2", "VK_KHR_shader_maximal_reconvergence",
    "VK_KHR_shader_quad_control", "VK_KHR_shader_subgroup_uniform_control_flow", "VK_KHR_swapchain_mutable_format",
    "VK_KHR_workgroup_memory_explicit_layout",
};
inline constexpr Profile kAndroid17{"android-17", VK_MAKE_API_VERSION(0, 1, 4, 335),
    kAndroid17Limits, kAndroid17Features, kAndroid17Extensions, &kAndroid2025};

// VP_KHR_roadmap_2026
inline constexpr ProfileLimit kRoadmap2026Limits[] = {
    {&L::maxBoundDescriptorSets, 7u}, {&L::maxColorAttachments, 8u}, {&L::maxComputeSharedMemorySize, 32768u},
    {&L::maxComputeWorkGroupInvocations, 256u}, {&L::maxDescriptorSetInputAttachments, 8u},
    {&L::maxDescriptorSetSampledImages, 1800u}, {&L::maxDescriptorSetSamplers, 576u},
    {&L::maxDescriptorSetStorageBuffers, 1800u}, {&L::maxDescriptorSetStorageImages, 144u},
    {&L::maxDescriptorSetUniformBuffers, 1800u}, {&L::maxFragmentCombinedOutputResources, 16u},
    {&L::maxFragmentInputComponents, 112u}, {&L::maxFragmentOutputAttachments, 8u}, {&L::maxFramebufferHeight, 8192u},
    {&L::maxFramebufferWidth, 8192u}, {&L::maxGeometryOutputComponents, 128u}, {&L::maxImageArrayLayers, 2048u},
    {&L::maxImageDimension1D, 8192u}, {&L::maxImageDimension2D, 8192u}, {&L::maxImageDimensionCube, 8192u},
    {&L::maxPerStageDescriptorInputAttachments, 8u}, {&L::maxPerStageDescriptorSampledImages, 200u},
    {&L::maxPerStageDescriptorSamplers, 64u}, {&L::maxPerStageDescriptorStorageBuffers, 200u},
    {&L::maxPerStageDescriptorStorageImages, 16u}, {&L::maxPerStageDescriptorUniformBuffers, 200u},
    {&L::maxPerStageResources, 200u}, {&L::maxTessellationControlPerVertexInputComponents, 128u},
    {&L::maxTessellationControlPerVertexOutputComponents, 128u},
    {&L::maxTessellationControlTotalOutputComponents, 4096u}, {&L::maxTessellationEvaluationInputComponents, 128u},
    {&L::maxTessellationEvaluationOutputComponents, 128u}, {&L::maxUniformBufferRange, 65536u},
    {&L::maxVertexOutputComponents, 124u},
};
inline constexpr VkBool32 F::*kRoadmap2026Features[] = {
    &F::depthBiasClamp, &F::depthClamp, &F::drawIndirectFirstInstance, &F::fragmentStoresAndAtomics,
    &F::fullDrawIndexUint32, &F::imageCubeArray, &F::independentBlend, &F::multiDrawIndirect,
    &F::occlusionQueryPrecise, &F::robustBufferAccess, &F::sampleRateShading, &F::samplerAnisotropy,
    &F::shaderImageGatherExtended, &F::shaderInt16, &F::shaderSampledImageArrayDynamicIndexing,
    &F::shaderStorageBufferArrayDynamicIndexing, &F::shaderStorageImageArrayDynamicIndexing,
    &F::shaderStorageImageExtendedFormats, &F::shaderUniformBufferArrayDynamicIndexing,
};
inline constexpr std::string_view kRoadmap2026Extensions[] = {
    "VK_KHR_compute_shader_derivatives", "VK_KHR_cooperative_matrix", "VK_KHR_copy_memory_indirect",
    "VK_KHR_depth_clamp_zero_one", "VK_KHR_dynamic_rendering", "VK_KHR_dynamic_rendering_local_read",
    "VK_KHR_fragment_shading_rate", "VK_KHR_get_surface_capabilities2", "VK_KHR_index_type_uint8",
    "VK_KHR_load_store_op_none", "VK_KHR_maintenance5", "VK_KHR_maintenance7", "VK_KHR_maintenance8",
    "VK_KHR_maintenance9", "VK_KHR_map_memory2", "VK_KHR_pipeline_binary", "VK_KHR_present_id2",
    "VK_KHR_present_mode_fifo_latest_ready", "VK_KHR_present_wait2", "VK_KHR_push_descriptor", "VK_KHR_robustness2",
    "VK_KHR_shader_clock", "VK_KHR_shader_expect_assume", "VK_KHR_shader_float_controls2",
    "VK_KHR_shader_maximal_reconvergence", "VK_KHR_shader_quad_control", "VK_KHR_shader_subgroup_rotate",
    "VK_KHR_shader_subgroup_uniform_control_flow", "VK_KHR_shader_untyped_pointers", "VK_KHR_surface",
    "VK_KHR_surface_maintenance1", "VK_KHR_swapchain", "VK_KHR_swapchain_maintenance1",
    "VK_KHR_vertex_attribute_divisor", "VK_KHR_workgroup_memory_explicit_layout",
};
inline constexpr Profile kRoadmap2026{"roadmap-2026", VK_MAKE_API_VERSION(0, 1, 4, 328),
    kRoadmap2026Limits, kRoadmap2026Features, kRoadmap2026Extensions};

inline constexpr const Profile* kProfiles[] = {
    &kAndroid2022, &kAndroid2025, &kAndroid15, &kAndroid16, &kAndroid17, &kRoadmap2026,
};

}  // namespace nacre::phone
// clang-format on
