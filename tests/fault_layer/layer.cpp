// The layer's side towards the Vulkan loader (its interface, version 2).

#define VK_USE_PLATFORM_XCB_KHR
#define VK_USE_PLATFORM_XLIB_KHR
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <vector>

#include "tests/fault_layer/display.h"
#include "tests/fault_layer/hooks.h"
#include "tests/support/layer_link.h"

namespace nacre::faults {
namespace {

#define NACRE_TAG(call, how, of)                                         \
    struct call##Tag {                                                   \
        [[maybe_unused]] static constexpr const char* name = "vk" #call; \
        [[maybe_unused]] static constexpr Fails fails = Fails::how;      \
        static constexpr const char* kind = of;                          \
    };                                                                   \
    using call##Hook = Hook<call##Tag, PFN_vk##call>;
NACRE_DEVICE_CALLS(NACRE_TAG)
NACRE_INSTANCE_CALLS(NACRE_TAG)

VkInstance instance = VK_NULL_HANDLE;
VkDevice device = VK_NULL_HANDLE;
VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
PFN_vkGetInstanceProcAddr nextInstanceCall = nullptr;
PFN_vkGetDeviceProcAddr nextDeviceCall = nullptr;

// Looked up while the instance is made: later the loader would give this layer's own.
PFN_vkDestroyInstance nextDestroyInstance = nullptr;
PFN_vkEnumerateDeviceExtensionProperties nextDeviceExtensions = nullptr;
PFN_vkGetPhysicalDeviceFeatures2 nextFeatures2 = nullptr;

template <typename Function>
void findBelow(Function& function, const char* name) {
    function = reinterpret_cast<Function>(nextInstanceCall(instance, name));
}

VKAPI_ATTR VkBool32 VKAPI_CALL listen(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                      const VkDebugUtilsMessengerCallbackDataEXT* data, void*) {
    heard(data->pMessage);
    return VK_FALSE;
}

/// Of its own, since the program's ends before the instance does.
void startListening() {
    if (!CreateDebugUtilsMessengerEXTHook::next) return;
    VkDebugUtilsMessengerCreateInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    info.pfnUserCallback = listen;
    CreateDebugUtilsMessengerEXTHook::next(instance, &info, nullptr, &messenger);
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* allocator,
                                              VkInstance* made_) {
    readEnvironment();
    const auto* below =
        test::nextLayer<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    nextInstanceCall = below->pfnNextGetInstanceProcAddr;
    if (const auto told = verdict("vkCreateInstance", true, false)) return *told;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(nextInstanceCall(nullptr, "vkCreateInstance"));
    const VkResult result = create(info, allocator, made_);
    if (result != VK_SUCCESS) return result;
    instance = *made_;
    made("Instance", 1);
#define NACRE_NEXT_INSTANCE(call, how, of) findBelow(call##Hook::next, "vk" #call);
    NACRE_INSTANCE_CALLS(NACRE_NEXT_INSTANCE)
    findBelow(nextDestroyInstance, "vkDestroyInstance");
    findBelow(nextDeviceExtensions, "vkEnumerateDeviceExtensionProperties");
    findBelow(nextFeatures2, "vkGetPhysicalDeviceFeatures2");
    startListening();
    return VK_SUCCESS;
}

VKAPI_ATTR void VKAPI_CALL destroyInstance(VkInstance gone, const VkAllocationCallbacks* allocator) {
    if (!gone) return;
    if (messenger) DestroyDebugUtilsMessengerEXTHook::next(gone, messenger, nullptr);
    messenger = VK_NULL_HANDLE;
    nextDestroyInstance(gone, allocator);
    instance = VK_NULL_HANDLE;
    made("Instance", -1);
    instanceGone();
}

/// Whether the driver knows nothing of it: an extension that only this layer has, or its features.
bool ownExtension(std::string_view name) {
    return name == VK_EXT_DEVICE_FAULT_EXTENSION_NAME || isDisplayExtension(name);
}
bool ownFeatures(VkStructureType type) {
    return (type == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FAULT_FEATURES_EXT && offersFaultData()) ||
           isDisplayFeature(type);
}

/// A copy of a device's wishes without the extensions that only this layer has.
struct Wishes {
    VkDeviceCreateInfo info;
    std::vector<const char*> extensions;
    BentChain chain;

    explicit Wishes(const VkDeviceCreateInfo& asked) : info(asked) {
        for (std::uint32_t i = 0; i < asked.enabledExtensionCount; ++i)
            if (!ownExtension(asked.ppEnabledExtensionNames[i])) extensions.push_back(asked.ppEnabledExtensionNames[i]);
        info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
        info.ppEnabledExtensionNames = extensions.data();
        chain.bend(&info, [](VkStructureType type) {
            return type == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FAULT_FEATURES_EXT || isDisplayFeature(type);
        });
    }
};

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* made_) {
    const auto* below =
        test::nextLayer<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    const PFN_vkGetInstanceProcAddr next = below->pfnNextGetInstanceProcAddr;
    nextDeviceCall = below->pfnNextGetDeviceProcAddr;
    newDevice();
    if (const auto told = verdict("vkCreateDevice", true, true)) return *told;
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(next(instance, "vkCreateDevice"));
    const Wishes wishes(*info);
    const VkResult result = create(physical, &wishes.info, allocator, made_);
    if (result != VK_SUCCESS) return result;
    device = *made_;
    made("Device", 1);
// A device without a window has no calls of swapchains, which another one beside it may have.
#define NACRE_NEXT_DEVICE(call, how, of)                            \
    if (const auto next##call = nextDeviceCall(device, "vk" #call)) \
        call##Hook::next = reinterpret_cast<PFN_vk##call>(next##call);
    NACRE_DEVICE_CALLS(NACRE_NEXT_DEVICE)
    return VK_SUCCESS;
}

VKAPI_ATTR void VKAPI_CALL destroyDevice(VkDevice gone, const VkAllocationCallbacks* allocator) {
    if (!gone) return;
    reinterpret_cast<PFN_vkDestroyDevice>(nextDeviceCall(gone, "vkDestroyDevice"))(gone, allocator);
    device = VK_NULL_HANDLE;
    made("Device", -1);
}

// --- extensions: VK_EXT_device_fault, made up, and what is hidden

VKAPI_ATTR VkResult VKAPI_CALL deviceExtensions(VkPhysicalDevice physical, const char* layer, std::uint32_t* count,
                                                VkExtensionProperties* list) {
    if (layer) return nextDeviceExtensions(physical, layer, count, list);
    std::vector<VkExtensionProperties> all = test::listExtensions(nextDeviceExtensions, physical);
    VkExtensionProperties fault{};
    std::strcpy(fault.extensionName, VK_EXT_DEVICE_FAULT_EXTENSION_NAME);
    if (offersFaultData()) all.push_back(fault);
    addDisplayExtensions(all);
    std::erase_if(all, [](const VkExtensionProperties& e) { return hides(e.extensionName); });
    return test::tellExtensions(all, count, list);
}

VKAPI_ATTR void VKAPI_CALL features2(VkPhysicalDevice physical, VkPhysicalDeviceFeatures2* features) {
    BentChain chain;
    chain.bend(features, ownFeatures);
    nextFeatures2(physical, features);
    for (VkBaseOutStructure* own : chain.removed())  // each has one feature
        reinterpret_cast<VkPhysicalDevicePresentIdFeaturesKHR*>(own)->presentId = VK_TRUE;
}

VKAPI_ATTR VkResult VKAPI_CALL surfaceCapabilities(VkPhysicalDevice physical, VkSurfaceKHR surface,
                                                   VkSurfaceCapabilitiesKHR* capabilities) {
    const VkResult result = GetPhysicalDeviceSurfaceCapabilitiesKHRHook::run(physical, surface, capabilities);
    if (windowSize().width > 0) capabilities->currentExtent = windowSize();
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL surfaceCapabilities2(VkPhysicalDevice physical,
                                                    const VkPhysicalDeviceSurfaceInfo2KHR* surface,
                                                    VkSurfaceCapabilities2KHR* capabilities) {
    tellDisplay(capabilities->pNext);
    return surfaceCapabilities(physical, surface->surface, &capabilities->surfaceCapabilities);
}

// --- a display by its own clock

VKAPI_ATTR VkResult VKAPI_CALL createSwapchain(VkDevice of, const VkSwapchainCreateInfoKHR* info,
                                               const VkAllocationCallbacks* allocator, VkSwapchainKHR* swapchain) {
    VkSwapchainCreateInfoKHR below = *info;
    if (hasDisplay()) below.flags &= ~displayFlags();
    const VkResult result = CreateSwapchainKHRHook::run(of, &below, allocator, swapchain);
    if (result == VK_SUCCESS) newSwapchain(info->flags, info->minImageCount);
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL acquireNextImage(VkDevice of, VkSwapchainKHR swapchain, std::uint64_t timeout,
                                                VkSemaphore semaphore, VkFence fence, std::uint32_t* index) {
    awaitImage();
    return AcquireNextImageKHRHook::run(of, swapchain, timeout, semaphore, fence, index);
}

VKAPI_ATTR VkResult VKAPI_CALL queuePresent(VkQueue queue, const VkPresentInfoKHR* info) {
    VkPresentInfoKHR below = *info;
    BentChain chain;
    chain.bend(&below, isPresentNumber);
    const VkResult result = QueuePresentKHRHook::run(queue, &below);
    if (result >= 0) presented(chain.removed());
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL waitForPresent(VkDevice, VkSwapchainKHR, std::uint64_t number, std::uint64_t timeout) {
    if (const auto told = verdict("vkWaitForPresentKHR", true, true)) return *told;
    return awaitDisplay(number, timeout);
}

VKAPI_ATTR VkResult VKAPI_CALL waitForPresent2(VkDevice of, VkSwapchainKHR swapchain, const VkPresentWait2InfoKHR* w) {
    return waitForPresent(of, swapchain, w->presentId, w->timeout);
}

VKAPI_ATTR VkResult VKAPI_CALL faultInfo(VkDevice, VkDeviceFaultCountsEXT* counts, VkDeviceFaultInfoEXT* info) {
    if (!info) {
        counts->addressInfoCount = 1;
        counts->vendorInfoCount = 1;
        counts->vendorBinarySize = 0;
        return VK_SUCCESS;
    }
    std::strcpy(info->description, "page fault\nof the fault layer");
    if (counts->addressInfoCount) {
        VkDeviceFaultAddressInfoEXT& address = info->pAddressInfos[0];
        address.addressType = VK_DEVICE_FAULT_ADDRESS_TYPE_WRITE_INVALID_EXT;
        address.reportedAddress = 0xdead0000;
        address.addressPrecision = 4096;
    }
    if (counts->vendorInfoCount) {
        VkDeviceFaultVendorInfoEXT& vendor = info->pVendorInfos[0];
        std::strcpy(vendor.description, "shader core");
        vendor.vendorFaultCode = 7;
        vendor.vendorFaultData = 9;
    }
    return VK_SUCCESS;
}

// --- what the loader asks for

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceCall(VkDevice asked, const char* name) {
    const std::string_view wanted = name;
    if (wanted == "vkGetDeviceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(&deviceCall);
    if (wanted == "vkDestroyDevice") return reinterpret_cast<PFN_vkVoidFunction>(&destroyDevice);
    if (hasDisplay()) {
        const std::pair<std::string_view, PFN_vkVoidFunction> own[] = {
            {"vkCreateSwapchainKHR", reinterpret_cast<PFN_vkVoidFunction>(&createSwapchain)},
            {"vkAcquireNextImageKHR", reinterpret_cast<PFN_vkVoidFunction>(&acquireNextImage)},
            {"vkQueuePresentKHR", reinterpret_cast<PFN_vkVoidFunction>(&queuePresent)},
            {"vkWaitForPresentKHR", reinterpret_cast<PFN_vkVoidFunction>(&waitForPresent)},
            {"vkWaitForPresent2KHR", reinterpret_cast<PFN_vkVoidFunction>(&waitForPresent2)}};
        for (const auto& [known, function] : own)
            if (wanted == known) return function;
    }
    if (wanted == "vkGetDeviceFaultInfoEXT" && offersFaultData())
        return reinterpret_cast<PFN_vkVoidFunction>(&faultInfo);
#define NACRE_FIND(call, how, of) \
    if (wanted == "vk" #call && call##Hook::next) return reinterpret_cast<PFN_vkVoidFunction>(&call##Hook::run);
    NACRE_DEVICE_CALLS(NACRE_FIND)
    return nextDeviceCall ? nextDeviceCall(asked, name) : nullptr;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL instanceCall(VkInstance asked, const char* name) {
    const std::string_view wanted = name;
    const std::pair<std::string_view, PFN_vkVoidFunction> own[] = {
        {"vkGetInstanceProcAddr", reinterpret_cast<PFN_vkVoidFunction>(&instanceCall)},
        {"vkGetDeviceProcAddr", reinterpret_cast<PFN_vkVoidFunction>(&deviceCall)},
        {"vkCreateInstance", reinterpret_cast<PFN_vkVoidFunction>(&createInstance)},
        {"vkDestroyInstance", reinterpret_cast<PFN_vkVoidFunction>(&destroyInstance)},
        {"vkCreateDevice", reinterpret_cast<PFN_vkVoidFunction>(&createDevice)},
        {"vkDestroyDevice", reinterpret_cast<PFN_vkVoidFunction>(&destroyDevice)},
        {"vkEnumerateDeviceExtensionProperties", reinterpret_cast<PFN_vkVoidFunction>(&deviceExtensions)},
        {"vkGetPhysicalDeviceFeatures2", reinterpret_cast<PFN_vkVoidFunction>(&features2)},
        {"vkGetPhysicalDeviceSurfaceCapabilitiesKHR", reinterpret_cast<PFN_vkVoidFunction>(&surfaceCapabilities)},
        {"vkGetPhysicalDeviceSurfaceCapabilities2KHR", reinterpret_cast<PFN_vkVoidFunction>(&surfaceCapabilities2)}};
    for (const auto& [known, function] : own)
        if (wanted == known) return function;
    NACRE_INSTANCE_CALLS(NACRE_FIND)
    NACRE_DEVICE_CALLS(NACRE_FIND)
    return nextInstanceCall ? nextInstanceCall(asked, name) : nullptr;
}

}  // namespace

void letFinish() {
    if (device && DeviceWaitIdleHook::next) DeviceWaitIdleHook::next(device);
}

}  // namespace nacre::faults

extern "C" __attribute__((visibility("default"))) VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* layer) {
    layer->loaderLayerInterfaceVersion = std::min(layer->loaderLayerInterfaceVersion, 2u);
    layer->pfnGetInstanceProcAddr = nacre::faults::instanceCall;
    layer->pfnGetDeviceProcAddr = nacre::faults::deviceCall;
    layer->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
