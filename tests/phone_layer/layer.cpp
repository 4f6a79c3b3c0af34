// A Vulkan layer that makes a software driver report what the least phone does: limits, features, formats, extensions,
// and the memory types of tile-based GPUs: one that the host sees coherently and does not cache, one that it caches and
// must invalidate, one that is lazily allocated. What the host may not see yet, it does not see here. Under the
// validation layer a program that asks for more is told. The environment variable NACRE_PHONE names the phone:
// "android" (of Arm's make), "mali" (the same, in raster order), "adreno" (adreno.h), "powervr" (whose compiler is not
// thread-safe) or "moltenvk" (1.4, restarts.h); with NACRE_PHONE_ARMS_DRIVER the first says that its driver is Arm's;
// NACRE_PHONE_DRIVER its driver's UUID, NACRE_PHONE_WRONG a fault of that, NACRE_PHONE_TILE the tile of the former
// (feedback.h); NACRE_PHONE_SHADERS may name a folder that takes every shader which the program hands over,
// as 1.spv, 2.spv, ...; NACRE_PHONE_FRAMES a file that is told of frames (frames.h), NACRE_PHONE_PIPELINES one that
// gets the thread which made a graphics pipeline, a line each, NACRE_PHONE_DRAWS one that gets the corners of each
// draw, and each timestamp; NACRE_PHONE_NO_CLOCK takes the queue's clock away; NACRE_PHONE_WORK one that gets what each
// submission takes of its device (clock.h). NACRE_PHONE_COUNTERS gives it performance counters (counters.h).
// NACRE_PHONE_RATES lets it offer fixed rates of compression: of 8-bit formats 2 and 5 bits per channel.
// NACRE_PHONE_REGIONS gives it counters of regions (regions.h). NACRE_PHONE_DENSITY gives it fragment density maps
// (density.h). NACRE_PHONE_VERTEX_BYTES is how many bytes of vertex outputs a render pass may have (vertices.h).
// NACRE_PHONE_PROFILE is a profile that it meets (profiles.h). Where NACRE_PHONE_FIRST is set, a second device before
// the first present ends the program: a start that keeps its user waiting.

#define VK_ENABLE_BETA_EXTENSIONS
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "tests/phone_layer/below.h"
#include "tests/phone_layer/clock.h"
#include "tests/phone_layer/counters.h"
#include "tests/phone_layer/density.h"
#include "tests/phone_layer/feedback.h"
#include "tests/phone_layer/floor.h"
#include "tests/phone_layer/frames.h"
#include "tests/phone_layer/memory.h"
#include "tests/phone_layer/regions.h"
#include "tests/phone_layer/restarts.h"
#include "tests/phone_layer/vertices.h"
#include "tests/support/layer_link.h"

namespace nacre::phone {
namespace {

constexpr const char* kPortability = VK_KHR_PORTABILITY_SUBSET_EXTENSION_NAME;
constexpr const char* kMergeFeedback = VK_EXT_SUBPASS_MERGE_FEEDBACK_EXTENSION_NAME;
constexpr const char* kFrameBoundary = VK_EXT_FRAME_BOUNDARY_EXTENSION_NAME;
constexpr const char* kLocalRead = VK_KHR_DYNAMIC_RENDERING_LOCAL_READ_EXTENSION_NAME;
constexpr const char* kCounterQueries = VK_KHR_PERFORMANCE_QUERY_EXTENSION_NAME;
constexpr const char* kCompression = VK_EXT_IMAGE_COMPRESSION_CONTROL_EXTENSION_NAME;
constexpr const char* kRegions = VK_ARM_PERFORMANCE_COUNTERS_BY_REGION_EXTENSION_NAME;
constexpr const char* kAddresses = VK_KHR_BUFFER_DEVICE_ADDRESS_EXTENSION_NAME;
constexpr const char* kDensity = VK_EXT_FRAGMENT_DENSITY_MAP_EXTENSION_NAME;
constexpr const char* kStoreNone = VK_EXT_LOAD_STORE_OP_NONE_EXTENSION_NAME;

VkInstance instance = VK_NULL_HANDLE;
VkDevice device = VK_NULL_HANDLE;
PFN_vkGetInstanceProcAddr nextInstanceCall = nullptr;
PFN_vkGetDeviceProcAddr nextDeviceCall = nullptr;
PFN_GetPhysicalDeviceProcAddr nextPhysicalDeviceCall = nullptr;

/// Where somebody listens: the validation layer here is older than the extension.
bool marksFrames() { return !molten() && std::getenv("NACRE_PHONE_FRAMES"); }

VKAPI_ATTR VkResult VKAPI_CALL CreateInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* allocator,
                                              VkInstance* made) {
    const auto* below =
        test::nextLayer<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    nextInstanceCall = below->pfnNextGetInstanceProcAddr;
    nextPhysicalDeviceCall = below->pfnNextGetPhysicalDeviceProcAddr;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(nextInstanceCall(nullptr, "vkCreateInstance"));
    const VkResult result = create(info, allocator, made);
    if (result != VK_SUCCESS) return result;
    instance = *made;
#define NACRE_FIND(name) next##name = reinterpret_cast<PFN_vk##name>(nextInstanceCall(instance, "vk" #name));
    NACRE_BELOW(NACRE_FIND)
    return result;
}

VKAPI_ATTR void VKAPI_CALL DestroyInstance(VkInstance of, const VkAllocationCallbacks* allocator) {
    nextDestroyInstance(of, allocator);
    instance = VK_NULL_HANDLE;
}

// --- what the device says of itself

VkPhysicalDeviceProperties seen(VkPhysicalDeviceProperties p) {
    const std::uint32_t asked = profile() ? profile()->vulkan : VK_MAKE_API_VERSION(0, 1, 1, 106);
    p.apiVersion = std::min(p.apiVersion, asked);
    p.deviceType = VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU;
    p.vendorID = molten() ? 0x106b : adreno() ? 0x5143 : powervr() ? 0x1010 : 0x13b5;
    const char* name = molten()    ? "the least iPhone"
                       : adreno()  ? "Adreno (TM) 660"
                       : powervr() ? "PowerVR Rogue GE8320"
                                   : "the least phone";
    std::strncpy(p.deviceName, name, sizeof(p.deviceName) - 1);
    if (adreno()) p.driverVersion = VK_MAKE_VERSION(512, 502, 0);
    applyFloor(p.limits);
    return p;
}

VKAPI_ATTR void VKAPI_CALL GetPhysicalDeviceProperties(VkPhysicalDevice of, VkPhysicalDeviceProperties* p) {
    nextGetPhysicalDeviceProperties(of, p);
    *p = seen(*p);
}

void tellDriver(VkPhysicalDeviceIDProperties& p) {
    if (const char* driver = std::getenv("NACRE_PHONE_DRIVER"))
        std::strncpy(reinterpret_cast<char*>(p.driverUUID), driver, VK_UUID_SIZE);
}

VKAPI_ATTR void VKAPI_CALL GetPhysicalDeviceProperties2(VkPhysicalDevice of, VkPhysicalDeviceProperties2* p) {
    nextGetPhysicalDeviceProperties2(of, p);
    p->properties = seen(p->properties);
    for (auto* s = static_cast<VkBaseOutStructure*>(p->pNext); s; s = s->pNext)
        if (s->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PORTABILITY_SUBSET_PROPERTIES_KHR)
            reinterpret_cast<VkPhysicalDevicePortabilitySubsetPropertiesKHR*>(s)->minVertexInputBindingStrideAlignment =
                4;
        else if (s->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MULTIVIEW_PROPERTIES)
            floorViews(*reinterpret_cast<VkPhysicalDeviceMultiviewProperties*>(s));
        else if (s->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAGMENT_DENSITY_MAP_PROPERTIES_EXT)
            fill(*reinterpret_cast<VkPhysicalDeviceFragmentDensityMapPropertiesEXT*>(s));
        else if (s->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PERFORMANCE_COUNTERS_BY_REGION_PROPERTIES_ARM)
            fill(*reinterpret_cast<VkPhysicalDevicePerformanceCountersByRegionPropertiesARM*>(s));
        else if (s->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ID_PROPERTIES)
            tellDriver(*reinterpret_cast<VkPhysicalDeviceIDProperties*>(s));
        else if (s->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES &&
                 (molten() || adreno() || powervr() || armsDriver()))
            reinterpret_cast<VkPhysicalDeviceDriverProperties*>(s)->driverID =
                molten()       ? VK_DRIVER_ID_MOLTENVK
                : powervr()    ? VK_DRIVER_ID_IMAGINATION_PROPRIETARY
                : armsDriver() ? VK_DRIVER_ID_ARM_PROPRIETARY
                               : VK_DRIVER_ID_QUALCOMM_PROPRIETARY;
}

VKAPI_ATTR void VKAPI_CALL GetPhysicalDeviceFeatures(VkPhysicalDevice of, VkPhysicalDeviceFeatures* f) {
    nextGetPhysicalDeviceFeatures(of, f);
    *f = floorFeatures(*f);
}

void portability(VkPhysicalDevicePortabilitySubsetFeaturesKHR& f) {
    void* next = f.pNext;
    f = VkPhysicalDevicePortabilitySubsetFeaturesKHR{};
    f.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PORTABILITY_SUBSET_FEATURES_KHR;
    f.pNext = next;
    f.constantAlphaColorBlendFactors = f.events = f.imageViewFormatReinterpretation = true;
    f.mutableComparisonSamplers = f.separateStencilMaskRef = f.vertexAttributeAccessBeyondStride = true;
}

VKAPI_ATTR void VKAPI_CALL GetPhysicalDeviceFeatures2(VkPhysicalDevice of, VkPhysicalDeviceFeatures2* f) {
    nextGetPhysicalDeviceFeatures2(of, f);
    f->features = floorFeatures(f->features);
    for (auto* s = static_cast<VkBaseOutStructure*>(f->pNext); s; s = s->pNext)
        if (s->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PORTABILITY_SUBSET_FEATURES_KHR)
            portability(*reinterpret_cast<VkPhysicalDevicePortabilitySubsetFeaturesKHR*>(s));
        else if (s->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBPASS_MERGE_FEEDBACK_FEATURES_EXT)
            reinterpret_cast<VkPhysicalDeviceSubpassMergeFeedbackFeaturesEXT*>(s)->subpassMergeFeedback = !molten();
        else if (s->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAGMENT_DENSITY_MAP_FEATURES_EXT)
            fill(*reinterpret_cast<VkPhysicalDeviceFragmentDensityMapFeaturesEXT*>(s));
        else if (s->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAME_BOUNDARY_FEATURES_EXT)
            reinterpret_cast<VkPhysicalDeviceFrameBoundaryFeaturesEXT*>(s)->frameBoundary = marksFrames();
        else if (s->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PERFORMANCE_QUERY_FEATURES_KHR)
            reinterpret_cast<VkPhysicalDevicePerformanceQueryFeaturesKHR*>(s)->performanceCounterQueryPools =
                countsBytes();
        else if (s->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PERFORMANCE_COUNTERS_BY_REGION_FEATURES_ARM)
            reinterpret_cast<VkPhysicalDevicePerformanceCountersByRegionFeaturesARM*>(s)->performanceCountersByRegion =
                countsRegions();
        else if (s->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_LOCAL_READ_FEATURES_KHR)
            reinterpret_cast<VkPhysicalDeviceDynamicRenderingLocalReadFeaturesKHR*>(s)->dynamicRenderingLocalRead =
                molten();
}

/// The rates that an image may be given, of whoever asks for one.
VKAPI_ATTR VkResult VKAPI_CALL GetPhysicalDeviceImageFormatProperties2(VkPhysicalDevice of,
                                                                       const VkPhysicalDeviceImageFormatInfo2* info,
                                                                       VkImageFormatProperties2* p) {
    const auto* control =
        chained<VkImageCompressionControlEXT>(info->pNext, VK_STRUCTURE_TYPE_IMAGE_COMPRESSION_CONTROL_EXT);
    const VkResult result = nextGetPhysicalDeviceImageFormatProperties2(of, info, p);
    const bool small = info->format == VK_FORMAT_R8_UNORM || info->format == VK_FORMAT_R8G8B8A8_SRGB;
    for (auto* s = static_cast<VkBaseOutStructure*>(p->pNext); s; s = s->pNext)
        if (s->sType == VK_STRUCTURE_TYPE_IMAGE_COMPRESSION_PROPERTIES_EXT && small && control &&
            control->flags == VK_IMAGE_COMPRESSION_FIXED_RATE_DEFAULT_EXT && std::getenv("NACRE_PHONE_RATES"))
            reinterpret_cast<VkImageCompressionPropertiesEXT*>(s)->imageCompressionFixedRateFlags =
                VK_IMAGE_COMPRESSION_FIXED_RATE_2BPC_BIT_EXT | VK_IMAGE_COMPRESSION_FIXED_RATE_5BPC_BIT_EXT;
    return result;
}

/// A queue may have no clock.
VKAPI_ATTR void VKAPI_CALL GetPhysicalDeviceQueueFamilyProperties(VkPhysicalDevice of, std::uint32_t* count,
                                                                  VkQueueFamilyProperties* families) {
    nextGetPhysicalDeviceQueueFamilyProperties(of, count, families);
    const bool none = std::getenv("NACRE_PHONE_NO_CLOCK") != nullptr;
    for (std::uint32_t i = 0; families && none && i < *count; ++i) families[i].timestampValidBits = 0;
}

VkFormatProperties seen(VkFormat format, VkFormatProperties p) {
    p.optimalTilingFeatures &= floorFormat(format);
    if (molten() && format == VK_FORMAT_R32_SFLOAT)  // Metal blends it
        p.optimalTilingFeatures |= VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT;
    if (takesMaps() && format == VK_FORMAT_R8G8_UNORM)
        p.optimalTilingFeatures |= VK_FORMAT_FEATURE_FRAGMENT_DENSITY_MAP_BIT_EXT;
    p.linearTilingFeatures &= VK_FORMAT_FEATURE_TRANSFER_SRC_BIT | VK_FORMAT_FEATURE_TRANSFER_DST_BIT;
    return p;
}

VKAPI_ATTR void VKAPI_CALL GetPhysicalDeviceFormatProperties(VkPhysicalDevice of, VkFormat format,
                                                             VkFormatProperties* p) {
    nextGetPhysicalDeviceFormatProperties(of, format, p);
    *p = seen(format, *p);
}

VKAPI_ATTR void VKAPI_CALL GetPhysicalDeviceFormatProperties2(VkPhysicalDevice of, VkFormat format,
                                                              VkFormatProperties2* p) {
    nextGetPhysicalDeviceFormatProperties2(of, format, p);
    p->formatProperties = seen(format, p->formatProperties);
    for (auto* s = static_cast<VkBaseOutStructure*>(p->pNext); s; s = s->pNext)
        if (s->sType == VK_STRUCTURE_TYPE_FORMAT_PROPERTIES_3) {
            auto& three = *reinterpret_cast<VkFormatProperties3*>(s);
            three.optimalTilingFeatures = p->formatProperties.optimalTilingFeatures;
            three.linearTilingFeatures = p->formatProperties.linearTilingFeatures;
        }
}

VKAPI_ATTR VkResult VKAPI_CALL EnumerateDeviceExtensionProperties(VkPhysicalDevice of, const char* layer,
                                                                  std::uint32_t* count, VkExtensionProperties* list) {
    if (layer) return nextEnumerateDeviceExtensionProperties(of, layer, count, list);
    std::vector<VkExtensionProperties> kept = test::listExtensions(nextEnumerateDeviceExtensionProperties, of);
    std::erase_if(kept, [](const VkExtensionProperties& e) {
        const std::string_view name = e.extensionName;
        const bool ordered = name == VK_EXT_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_EXTENSION_NAME;
        const bool rendering =
            name == VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME || name == VK_KHR_DEPTH_STENCIL_RESOLVE_EXTENSION_NAME;
        return !isFloorExtension(name) && !(molten() && rendering) && !(mali() && ordered) &&
               !(countsRegions() && name == kAddresses);
    });
    std::vector<const char*> added{kMergeFeedback};  // what no software driver has
    if (molten()) added = {kPortability, kLocalRead, kStoreNone};
    if (marksFrames()) added.push_back(kFrameBoundary);
    if (countsBytes()) added.push_back(kCounterQueries);
    if (takesMaps()) added.push_back(kDensity);
    if (countsRegions()) added.push_back(kRegions);
    if (std::getenv("NACRE_PHONE_RATES")) added.push_back(kCompression);
    for (const char* name : added) {
        VkExtensionProperties own{};
        std::strcpy(own.extensionName, name);
        own.specVersion = 1;
        kept.push_back(own);
    }
    return test::tellExtensions(kept, count, list);
}

// --- shaders

VKAPI_ATTR VkResult VKAPI_CALL CreateShaderModule(VkDevice of, const VkShaderModuleCreateInfo* info,
                                                  const VkAllocationCallbacks* allocator, VkShaderModule* shader) {
    static std::atomic<int> count = 0;
    if (const char* folder = std::getenv("NACRE_PHONE_SHADERS")) {
        std::ofstream file(std::string(folder) + "/" + std::to_string(++count) + ".spv", std::ios::binary);
        file.write(reinterpret_cast<const char*>(info->pCode), static_cast<std::streamsize>(info->codeSize));
        if (!file.flush()) std::abort();  // a test that looks at fewer would pass for nothing
    }
    const VkResult result = nextCreateShaderModule(of, info, allocator, shader);
    if (result == VK_SUCCESS) noteShader(*shader, *info);
    return result;
}

// --- a driver that is wrong

/// Threads in the compiler of a driver that stands one.
std::atomic<int> compiling{0};
struct InCompiler {
    InCompiler() {
        if (!powervr()) return;
        if (++compiling > 1) {
            std::fprintf(stderr, "phone: two threads make pipelines\n");
            std::abort();
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));  // so that another one would be caught
    }
    ~InCompiler() {
        if (powervr()) --compiling;
    }
};

VKAPI_ATTR VkResult VKAPI_CALL CreateComputePipelines(VkDevice of, VkPipelineCache cache, std::uint32_t count,
                                                      const VkComputePipelineCreateInfo* infos,
                                                      const VkAllocationCallbacks* allocator, VkPipeline* pipelines) {
    const InCompiler in;
    return nextCreateComputePipelines(of, cache, count, infos, allocator, pipelines);
}

/// NACRE_PHONE_WRONG=cache: the driver crashes here.
VKAPI_ATTR VkResult VKAPI_CALL CreatePipelineCache(VkDevice of, const VkPipelineCacheCreateInfo* info,
                                                   const VkAllocationCallbacks* allocator, VkPipelineCache* cache) {
    if (isWrong("cache")) std::abort();
    return nextCreatePipelineCache(of, info, allocator, cache);
}

/// NACRE_PHONE_WRONG=min: it blends by MIN as if that were MAX, and says nothing. =dispatch: it dispatches nothing.
VKAPI_ATTR VkResult VKAPI_CALL CreateGraphicsPipelines(VkDevice of, VkPipelineCache cache, std::uint32_t count,
                                                       const VkGraphicsPipelineCreateInfo* infos,
                                                       const VkAllocationCallbacks* allocator, VkPipeline* pipelines) {
    if (const char* file = std::getenv("NACRE_PHONE_PIPELINES"))
        for (std::uint32_t i = 0; i < count; ++i)
            std::ofstream(file, std::ios::app) << std::this_thread::get_id() << '\n';
    const InCompiler in;
    const auto create = [&](const VkGraphicsPipelineCreateInfo* wanted) {
        const VkResult result = nextCreateGraphicsPipelines(of, cache, count, wanted, allocator, pipelines);
        for (std::uint32_t i = 0; i < count; ++i)
            if (pipelines[i]) notePipeline(pipelines[i], wanted[i]);
        return result;
    };
    if (!isWrong("min")) return create(infos);
    std::vector<VkGraphicsPipelineCreateInfo> made(infos, infos + count);
    std::vector<VkPipelineColorBlendStateCreateInfo> states(count);
    std::vector<std::vector<VkPipelineColorBlendAttachmentState>> attachments(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!made[i].pColorBlendState) continue;
        states[i] = *made[i].pColorBlendState;
        attachments[i].assign(states[i].pAttachments, states[i].pAttachments + states[i].attachmentCount);
        for (VkPipelineColorBlendAttachmentState& a : attachments[i])
            if (a.colorBlendOp == VK_BLEND_OP_MIN) a.colorBlendOp = a.alphaBlendOp = VK_BLEND_OP_MAX;
        states[i].pAttachments = attachments[i].data();
        made[i].pColorBlendState = &states[i];
    }
    return create(made.data());
}

// --- render passes

VKAPI_ATTR VkResult VKAPI_CALL CreateRenderPass2KHR(VkDevice of, const VkRenderPassCreateInfo2* info,
                                                    const VkAllocationCallbacks* allocator, VkRenderPass* pass) {
    tellOfMerges(*info);
    const VkResult result = nextCreateRenderPass2KHR(of, info, allocator, pass);
    if (result == VK_SUCCESS) planEncoders(*info, *pass), noteMap(*pass, *info);
    return result;
}

// --- draws

/// Some phones lose the device over large instanced draws (Mali-G71 and some PowerVR, from 2^14 to 2^16 instances on).
/// This one does at once, so that a test cannot miss it.
void take(std::uint32_t instances) {
    if (instances <= 512) return;
    std::fprintf(stderr, "phone: %u instances in one draw\n", instances);
    std::abort();
}

/// Corners of one instance: what shape it is.
void tell(const char* kind, std::uint32_t corners) {
    if (const char* file = std::getenv("NACRE_PHONE_DRAWS"))
        std::ofstream(file, std::ios::app) << kind << corners << '\n';
}

VKAPI_ATTR void VKAPI_CALL CmdDraw(VkCommandBuffer commands, std::uint32_t vertices, std::uint32_t instances,
                                   std::uint32_t firstVertex, std::uint32_t firstInstance) {
    take(instances);
    tell("corners ", vertices);
    handOn(commands, std::uint64_t{vertices} * instances);
    work(double{1} * vertices * instances);
    nextCmdDraw(commands, vertices, instances, firstVertex, firstInstance);
}

VKAPI_ATTR void VKAPI_CALL CmdDrawIndexed(VkCommandBuffer commands, std::uint32_t indices, std::uint32_t instances,
                                          std::uint32_t firstIndex, std::int32_t offset, std::uint32_t firstInstance) {
    take(instances);
    tell("indices ", indices);
    handOn(commands, std::uint64_t{indices} * instances * passes::kPyramid.count / passes::kPyramidIndices);
    work(double{1} * indices * instances);
    nextCmdDrawIndexed(commands, indices, instances, firstIndex, offset, firstInstance);
}

// --- the first picture

std::atomic<int> presents{0}, devices{0};

VKAPI_ATTR VkResult VKAPI_CALL QueuePresentKHR(VkQueue queue, const VkPresentInfoKHR* info) {
    ++presents;
    return nextQueuePresentKHR(queue, info);
}

/// A device is made.
void startDevice() {
    if (++devices > 1 && presents == 0 && std::getenv("NACRE_PHONE_FIRST")) {
        std::fprintf(stderr, "phone: a second device before the first picture is shown\n");
        std::abort();
    }
}

// --- device and loader

VKAPI_ATTR VkResult VKAPI_CALL CreateDevice(VkPhysicalDevice of, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* made) {
    startDevice();
    const auto* below =
        test::nextLayer<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    const auto instanceCall = below->pfnNextGetInstanceProcAddr;
    nextDeviceCall = below->pfnNextGetDeviceProcAddr;
    // The driver knows nothing of these.
    std::vector<const char*> extensions(info->ppEnabledExtensionNames,
                                        info->ppEnabledExtensionNames + info->enabledExtensionCount);
    std::erase_if(extensions, [](std::string_view name) {
        return name == kPortability || name == kMergeFeedback || name == kFrameBoundary || name == kLocalRead ||
               name == kStoreNone || name == kCounterQueries || name == kRegions || name == kDensity;
    });
    VkDeviceCreateInfo real = *info;
    for (auto* s = reinterpret_cast<VkBaseOutStructure*>(&real); s->pNext;) {
        const VkStructureType type = s->pNext->sType;
        if (type == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBPASS_MERGE_FEEDBACK_FEATURES_EXT ||
            type == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAME_BOUNDARY_FEATURES_EXT ||
            type == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PERFORMANCE_QUERY_FEATURES_KHR ||
            type == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAGMENT_DENSITY_MAP_FEATURES_EXT ||
            type == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PERFORMANCE_COUNTERS_BY_REGION_FEATURES_ARM ||
            type == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_LOCAL_READ_FEATURES_KHR)
            s->pNext = s->pNext->pNext;
        else
            s = s->pNext;
    }
    real.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    real.ppEnabledExtensionNames = extensions.data();
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(instanceCall(instance, "vkCreateDevice"));
    const VkResult result = create(of, &real, allocator, made);
    if (result != VK_SUCCESS) return result;
    device = *made;
// A device without a window has no calls of swapchains, which another one beside it may have.
#define NACRE_FIND_DEVICE(name) \
    if (const auto call = nextDeviceCall(device, "vk" #name)) next##name = reinterpret_cast<PFN_vk##name>(call);
    NACRE_DEVICE_BELOW(NACRE_FIND_DEVICE)
    NACRE_FIND_DEVICE(CmdClearAttachments)
    NACRE_FIND_DEVICE(CmdUpdateBuffer)
    NACRE_FIND_DEVICE(GetBufferDeviceAddressKHR)
    return result;
}

PFN_vkVoidFunction deviceCall(std::string_view name) {
#define NACRE_GIVE(call) \
    if (name == "vk" #call) return reinterpret_cast<PFN_vkVoidFunction>(call);
    NACRE_DEVICE_BELOW(NACRE_GIVE)
    NACRE_GIVE(CmdSetRenderingAttachmentLocationsKHR)
    NACRE_GIVE(CmdSetRenderingInputAttachmentIndicesKHR)
    NACRE_GIVE(GetBufferDeviceAddressKHR)
    NACRE_GIVE(AcquireProfilingLockKHR)
    NACRE_GIVE(ReleaseProfilingLockKHR)
    return nullptr;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL GetDeviceProcAddr(VkDevice of, const char* name) {
    if (const auto own = deviceCall(name)) return own;
    if (std::string_view(name) == "vkGetDeviceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(GetDeviceProcAddr);
    return nextDeviceCall(of, name);
}

/// Functions that an older loader does not know.
PFN_vkVoidFunction physicalDeviceCall(std::string_view name) {
    if (name != "vkEnumeratePhysicalDeviceQueueFamilyPerformanceCountersByRegionARM" || !countsRegions())
        return nullptr;
    return reinterpret_cast<PFN_vkVoidFunction>(EnumeratePhysicalDeviceQueueFamilyPerformanceCountersByRegionARM);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL GetPhysicalDeviceProcAddr(VkInstance of, const char* name) {
    if (const auto own = physicalDeviceCall(name)) return own;
    return nextPhysicalDeviceCall ? nextPhysicalDeviceCall(of, name) : nullptr;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL GetInstanceProcAddr(VkInstance of, const char* name) {
    const std::string_view n(name);
    if (n == "vkGetInstanceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(GetInstanceProcAddr);
    if (n == "vkGetDeviceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(GetDeviceProcAddr);
    if (n == "vkCreateInstance") return reinterpret_cast<PFN_vkVoidFunction>(CreateInstance);
    if (n == "vkCreateDevice") return reinterpret_cast<PFN_vkVoidFunction>(CreateDevice);
#define NACRE_GIVE_TWICE(call) \
    if (n == "vk" #call || n == "vk" #call "KHR") return reinterpret_cast<PFN_vkVoidFunction>(call);
    NACRE_BELOW(NACRE_GIVE_TWICE)
    NACRE_GIVE_TWICE(EnumeratePhysicalDeviceQueueFamilyPerformanceQueryCountersKHR)
    NACRE_GIVE_TWICE(GetPhysicalDeviceQueueFamilyPerformanceQueryPassesKHR)
    if (const auto own = physicalDeviceCall(n)) return own;
    if (const auto own = deviceCall(n)) return own;
    return of ? nextInstanceCall(of, name) : nullptr;
}

}  // namespace
}  // namespace nacre::phone

extern "C" __attribute__((visibility("default"))) VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* version) {
    version->loaderLayerInterfaceVersion = 2;
    version->pfnGetInstanceProcAddr = nacre::phone::GetInstanceProcAddr;
    version->pfnGetDeviceProcAddr = nacre::phone::GetDeviceProcAddr;
    version->pfnGetPhysicalDeviceProcAddr = nacre::phone::GetPhysicalDeviceProcAddr;
    return VK_SUCCESS;
}
