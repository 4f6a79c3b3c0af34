// A Vulkan layer that makes a software driver look like a desktop GPU: a discrete device without raster order, and
// without memory that the host reads fast. Frames and bakes then have the passes of a GPU. A test that expects those of
// a software device fails under this layer, as it would on a GPU.

#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <cstring>
#include <string_view>
#include <vector>

#include "tests/support/layer_link.h"

namespace nacre::gpu_layer {
namespace {

VkInstance instance = VK_NULL_HANDLE;
PFN_vkGetInstanceProcAddr nextInstanceCall = nullptr;
PFN_vkGetDeviceProcAddr nextDeviceCall = nullptr;

// Looked up in time: later the loader would give this layer's own.
PFN_vkGetPhysicalDeviceProperties nextProperties = nullptr;
PFN_vkGetPhysicalDeviceProperties2 nextProperties2 = nullptr;
PFN_vkEnumerateDeviceExtensionProperties nextExtensions = nullptr;
PFN_vkGetPhysicalDeviceMemoryProperties nextMemory = nullptr;

template <typename Call>
void find(Call& next, const char* name) {
    next = reinterpret_cast<Call>(nextInstanceCall(instance, name));
}

VKAPI_ATTR VkResult VKAPI_CALL CreateInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* allocator,
                                              VkInstance* made) {
    nextInstanceCall =
        test::nextLayer<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO)
            ->pfnNextGetInstanceProcAddr;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(nextInstanceCall(nullptr, "vkCreateInstance"));
    const VkResult result = create(info, allocator, made);
    if (result != VK_SUCCESS) return result;
    instance = *made;
    find(nextProperties, "vkGetPhysicalDeviceProperties");
    find(nextProperties2, "vkGetPhysicalDeviceProperties2");
    find(nextMemory, "vkGetPhysicalDeviceMemoryProperties");
    find(nextExtensions, "vkEnumerateDeviceExtensionProperties");
    return result;
}

void pose(VkPhysicalDeviceProperties& p) {
    p.deviceType = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU;
    std::strncpy(p.deviceName, "a software driver as a GPU", sizeof(p.deviceName) - 1);
}

VKAPI_ATTR void VKAPI_CALL GetPhysicalDeviceProperties(VkPhysicalDevice of, VkPhysicalDeviceProperties* p) {
    nextProperties(of, p);
    pose(*p);
}

VKAPI_ATTR void VKAPI_CALL GetPhysicalDeviceProperties2(VkPhysicalDevice of, VkPhysicalDeviceProperties2* p) {
    nextProperties2(of, p);
    pose(p->properties);
}

VKAPI_ATTR void VKAPI_CALL GetPhysicalDeviceMemoryProperties(VkPhysicalDevice of, VkPhysicalDeviceMemoryProperties* p) {
    nextMemory(of, p);
    for (std::uint32_t i = 0; i < p->memoryTypeCount; ++i)
        p->memoryTypes[i].propertyFlags &= ~VkMemoryPropertyFlags{VK_MEMORY_PROPERTY_HOST_CACHED_BIT};
}

VKAPI_ATTR VkResult VKAPI_CALL EnumerateDeviceExtensionProperties(VkPhysicalDevice of, const char* layer,
                                                                  std::uint32_t* count, VkExtensionProperties* list) {
    if (layer) return nextExtensions(of, layer, count, list);
    std::vector<VkExtensionProperties> kept = test::listExtensions(nextExtensions, of);
    std::erase_if(kept, [](const VkExtensionProperties& e) {
        return std::string_view(e.extensionName).find("rasterization_order_attachment_access") !=
               std::string_view::npos;
    });
    return test::tellExtensions(kept, count, list);
}

VKAPI_ATTR VkResult VKAPI_CALL CreateDevice(VkPhysicalDevice of, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* made) {
    const auto* next =
        test::nextLayer<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    nextDeviceCall = next->pfnNextGetDeviceProcAddr;
    const auto create =
        reinterpret_cast<PFN_vkCreateDevice>(next->pfnNextGetInstanceProcAddr(instance, "vkCreateDevice"));
    return create(of, info, allocator, made);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL GetDeviceProcAddr(VkDevice of, const char* name) {
    if (std::string_view(name) == "vkGetDeviceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(GetDeviceProcAddr);
    return nextDeviceCall(of, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL GetInstanceProcAddr(VkInstance of, const char* name) {
#define NACRE_GIVE(call)                                                                    \
    if (std::string_view(name) == "vk" #call || std::string_view(name) == "vk" #call "KHR") \
        return reinterpret_cast<PFN_vkVoidFunction>(call);
    NACRE_GIVE(GetInstanceProcAddr)
    NACRE_GIVE(GetDeviceProcAddr)
    NACRE_GIVE(CreateInstance)
    NACRE_GIVE(CreateDevice)
    NACRE_GIVE(GetPhysicalDeviceProperties)
    NACRE_GIVE(GetPhysicalDeviceProperties2)
    NACRE_GIVE(GetPhysicalDeviceMemoryProperties)
    NACRE_GIVE(EnumerateDeviceExtensionProperties)
    return of ? nextInstanceCall(of, name) : nullptr;
}

}  // namespace
}  // namespace nacre::gpu_layer

extern "C" __attribute__((visibility("default"))) VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* version) {
    version->loaderLayerInterfaceVersion = 2;
    version->pfnGetInstanceProcAddr = nacre::gpu_layer::GetInstanceProcAddr;
    version->pfnGetDeviceProcAddr = nacre::gpu_layer::GetDeviceProcAddr;
    version->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
