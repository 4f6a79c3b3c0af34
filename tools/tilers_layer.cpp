// A Vulkan layer for tools/tilers: asks the driver for the statistics of every pipeline (VK_KHR_pipeline_executable_
// properties) once the pipeline is given its name, and appends them to the file that NACRE_STATISTICS names, a line of
// JSON for each shader. Which pipeline is made and named it says on standard error, too, where drivers' compilers print
// what they know besides: one at a time. With NACRE_AS_ARM PanVK says that it is Arm's driver: it reads attachments in
// raster order, and blends no R32F. With NACRE_AS_OTHER a driver says that it is RADV: Nacre then applies none of its
// quirks.

#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <mutex>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "tests/support/layer_link.h"

namespace {

VkInstance instance = VK_NULL_HANDLE;
VkDevice device = VK_NULL_HANDLE;
// Pipelines are made and named on several threads: what one prints never stands amid what another's compiler does.
std::mutex oneAtATime;
PFN_vkGetInstanceProcAddr nextInstanceCall = nullptr;
PFN_vkGetDeviceProcAddr nextDeviceCall = nullptr;

// Looked up in time: later the loader would give this layer's own.
PFN_vkGetPhysicalDeviceProperties2 nextProperties = nullptr;
PFN_vkGetPhysicalDeviceFeatures2 nextFeatures = nullptr;
PFN_vkGetPhysicalDeviceFormatProperties nextFormat = nullptr;
PFN_vkEnumerateDeviceExtensionProperties nextExtensions = nullptr;

template <typename Call>
Call next(const char* name) {
    return reinterpret_cast<Call>(nextDeviceCall(device, name));
}
const bool asArm = std::getenv("NACRE_AS_ARM") != nullptr, asOther = std::getenv("NACRE_AS_OTHER") != nullptr;
constexpr const char* kOrder = VK_EXT_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_EXTENSION_NAME;

VKAPI_ATTR void VKAPI_CALL getProperties(VkPhysicalDevice of, VkPhysicalDeviceProperties2* p) {
    nextProperties(of, p);
    for (auto* s = static_cast<VkBaseOutStructure*>(p->pNext); s; s = s->pNext)
        if (s->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES)
            reinterpret_cast<VkPhysicalDeviceDriverProperties*>(s)->driverID =
                asArm ? VK_DRIVER_ID_ARM_PROPRIETARY : VK_DRIVER_ID_MESA_RADV;
}

VKAPI_ATTR void VKAPI_CALL getFeatures(VkPhysicalDevice of, VkPhysicalDeviceFeatures2* f) {
    nextFeatures(of, f);
    for (auto* s = static_cast<VkBaseOutStructure*>(f->pNext); s; s = s->pNext)
        if (s->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_FEATURES_EXT)
            reinterpret_cast<VkPhysicalDeviceRasterizationOrderAttachmentAccessFeaturesEXT*>(s)
                ->rasterizationOrderColorAttachmentAccess = true;
}

VKAPI_ATTR void VKAPI_CALL getFormat(VkPhysicalDevice of, VkFormat format, VkFormatProperties* p) {
    nextFormat(of, format, p);
    if (format == VK_FORMAT_R32_SFLOAT) p->optimalTilingFeatures &= ~VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT;
}

VKAPI_ATTR VkResult VKAPI_CALL getExtensions(VkPhysicalDevice of, const char* layer, std::uint32_t* count,
                                             VkExtensionProperties* list) {
    std::uint32_t all = 0;
    nextExtensions(of, nullptr, &all, nullptr);
    std::vector<VkExtensionProperties> known(all);
    nextExtensions(of, nullptr, &all, known.data());
    if (layer) known.clear();
    VkExtensionProperties own{};
    std::strcpy(own.extensionName, kOrder);
    known.push_back(own);
    *count = list ? std::min<std::uint32_t>(*count, known.size()) : known.size();
    if (list) std::copy_n(known.begin(), *count, list);
    return VK_SUCCESS;
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* allocator,
                                              VkInstance* made) {
    const auto* below =
        nacre::test::nextLayer<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    nextInstanceCall = below->pfnNextGetInstanceProcAddr;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(nextInstanceCall(nullptr, "vkCreateInstance"));
    const VkResult result = create(info, allocator, made);
    if (result != VK_SUCCESS) return result;
    instance = *made;
    const auto find = [](auto& call, const char* name) {
        call = reinterpret_cast<std::remove_reference_t<decltype(call)>>(nextInstanceCall(instance, name));
    };
    find(nextProperties, "vkGetPhysicalDeviceProperties2");
    find(nextFeatures, "vkGetPhysicalDeviceFeatures2");
    find(nextFormat, "vkGetPhysicalDeviceFormatProperties");
    find(nextExtensions, "vkEnumerateDeviceExtensionProperties");
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice of, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* made) {
    const auto* below =
        nacre::test::nextLayer<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    const auto instanceCall = below->pfnNextGetInstanceProcAddr;
    nextDeviceCall = below->pfnNextGetDeviceProcAddr;
    std::vector<const char*> extensions(info->ppEnabledExtensionNames,
                                        info->ppEnabledExtensionNames + info->enabledExtensionCount);
    extensions.push_back(VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME);
    if (asArm) std::erase_if(extensions, [](std::string_view name) { return name == kOrder; });
    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR tells{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR, const_cast<void*>(info->pNext),
        true};
    VkDeviceCreateInfo real = *info;
    real.pNext = &tells;
    real.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    real.ppEnabledExtensionNames = extensions.data();
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(instanceCall(instance, "vkCreateDevice"));
    const VkResult result = create(of, &real, allocator, made);
    if (result == VK_SUCCESS) device = *made;
    return result;
}

template <typename Info, typename Call>
VkResult createPipelines(const char* name, VkDevice of, VkPipelineCache cache, std::uint32_t count, const Info* infos,
                         const VkAllocationCallbacks* allocator, VkPipeline* pipelines) {
    std::vector<Info> asked(infos, infos + count);
    for (Info& info : asked) info.flags |= VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR;
    const std::lock_guard lock(oneAtATime);
    std::fprintf(stderr, "nacre pipeline begun\n");
    const VkResult result = next<Call>(name)(of, cache, count, asked.data(), allocator, pipelines);
    std::fprintf(stderr, "nacre pipeline made %p\n", static_cast<void*>(pipelines[0]));
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createGraphics(VkDevice of, VkPipelineCache cache, std::uint32_t count,
                                              const VkGraphicsPipelineCreateInfo* infos,
                                              const VkAllocationCallbacks* allocator, VkPipeline* pipelines) {
    return createPipelines<VkGraphicsPipelineCreateInfo, PFN_vkCreateGraphicsPipelines>(
        "vkCreateGraphicsPipelines", of, cache, count, infos, allocator, pipelines);
}

VKAPI_ATTR VkResult VKAPI_CALL createCompute(VkDevice of, VkPipelineCache cache, std::uint32_t count,
                                             const VkComputePipelineCreateInfo* infos,
                                             const VkAllocationCallbacks* allocator, VkPipeline* pipelines) {
    return createPipelines<VkComputePipelineCreateInfo, PFN_vkCreateComputePipelines>(
        "vkCreateComputePipelines", of, cache, count, infos, allocator, pipelines);
}

std::string quoted(std::string_view text) {
    std::string out = "\"";
    for (const char c : text)
        if (c != '"' && c != '\\' && static_cast<unsigned char>(c) >= 0x20) out += c;
    return out + '"';
}

std::string formatValue(const VkPipelineExecutableStatisticKHR& s) {
    switch (s.format) {
        case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_BOOL32_KHR:
            return s.value.b32 ? "1" : "0";
        case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_INT64_KHR:
            return std::to_string(s.value.i64);
        case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR:
            return std::to_string(s.value.u64);
        default:
            return std::to_string(s.value.f64);
    }
}

void tell(VkPipeline pipeline, const char* name) {
    const std::lock_guard lock(oneAtATime);
    std::fprintf(stderr, "nacre pipeline named %p %s\n", static_cast<void*>(pipeline), name);
    const char* file = std::getenv("NACRE_STATISTICS");
    if (!file) return;
    const auto executables = next<PFN_vkGetPipelineExecutablePropertiesKHR>("vkGetPipelineExecutablePropertiesKHR");
    const auto statistics = next<PFN_vkGetPipelineExecutableStatisticsKHR>("vkGetPipelineExecutableStatisticsKHR");
    const VkPipelineInfoKHR of{VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR, nullptr, pipeline};
    std::uint32_t count = 0;
    executables(device, &of, &count, nullptr);
    std::vector<VkPipelineExecutablePropertiesKHR> shaders(
        count, {VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR, nullptr, 0, "", "", 0});
    executables(device, &of, &count, shaders.data());
    std::ofstream out(file, std::ios::app);
    for (std::uint32_t i = 0; i < count; ++i) {
        const VkPipelineExecutableInfoKHR shader{VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR, nullptr, pipeline, i};
        std::uint32_t values = 0;
        statistics(device, &shader, &values, nullptr);
        std::vector<VkPipelineExecutableStatisticKHR> list(
            values, {VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR, nullptr, "", "", {}, {}});
        statistics(device, &shader, &values, list.data());
        const char* stage = shaders[i].stages & VK_SHADER_STAGE_FRAGMENT_BIT  ? "fragment"
                            : shaders[i].stages & VK_SHADER_STAGE_COMPUTE_BIT ? "compute"
                                                                              : "vertex";
        out << "{\"pipeline\": " << quoted(name) << ", \"stage\": \"" << stage
            << "\", \"shader\": " << quoted(shaders[i].name) << ", \"statistics\": {";
        for (std::uint32_t s = 0; s < values; ++s)
            out << (s ? ", " : "") << quoted(list[s].name) << ": " << formatValue(list[s]);
        out << "}}\n";
    }
}

VKAPI_ATTR VkResult VKAPI_CALL setName(VkDevice of, const VkDebugUtilsObjectNameInfoEXT* info) {
    if (info->objectType == VK_OBJECT_TYPE_PIPELINE)
        tell(reinterpret_cast<VkPipeline>(info->objectHandle), info->pObjectName);
    const auto below = next<PFN_vkSetDebugUtilsObjectNameEXT>("vkSetDebugUtilsObjectNameEXT");
    return below ? below(of, info) : VK_SUCCESS;
}

PFN_vkVoidFunction own(std::string_view name) {
    const auto is = [&](std::string_view call) { return name == call || name == std::string(call) + "KHR"; };
    if ((asArm || asOther) && is("vkGetPhysicalDeviceProperties2"))
        return reinterpret_cast<PFN_vkVoidFunction>(getProperties);
    if (asArm && is("vkGetPhysicalDeviceFeatures2")) return reinterpret_cast<PFN_vkVoidFunction>(getFeatures);
    if (asArm && name == "vkGetPhysicalDeviceFormatProperties") return reinterpret_cast<PFN_vkVoidFunction>(getFormat);
    if (asArm && name == "vkEnumerateDeviceExtensionProperties")
        return reinterpret_cast<PFN_vkVoidFunction>(getExtensions);
    if (name == "vkCreateGraphicsPipelines") return reinterpret_cast<PFN_vkVoidFunction>(createGraphics);
    if (name == "vkCreateComputePipelines") return reinterpret_cast<PFN_vkVoidFunction>(createCompute);
    if (name == "vkSetDebugUtilsObjectNameEXT") return reinterpret_cast<PFN_vkVoidFunction>(setName);
    return nullptr;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDeviceProcAddr(VkDevice of, const char* name) {
    if (const auto call = own(name)) return call;
    if (std::string_view(name) == "vkGetDeviceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(getDeviceProcAddr);
    return nextDeviceCall(of, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getInstanceProcAddr(VkInstance of, const char* name) {
    const std::string_view n(name);
    if (n == "vkGetInstanceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(getInstanceProcAddr);
    if (n == "vkGetDeviceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(getDeviceProcAddr);
    if (n == "vkCreateInstance") return reinterpret_cast<PFN_vkVoidFunction>(createInstance);
    if (n == "vkCreateDevice") return reinterpret_cast<PFN_vkVoidFunction>(createDevice);
    if (const auto call = own(n)) return call;
    return of ? nextInstanceCall(of, name) : nullptr;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* version) {
    version->loaderLayerInterfaceVersion = 2;
    version->pfnGetInstanceProcAddr = getInstanceProcAddr;
    version->pfnGetDeviceProcAddr = getDeviceProcAddr;
    version->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
