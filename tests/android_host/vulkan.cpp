#include "tests/android_host/vulkan.h"

#include <dlfcn.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <utility>

#include "tests/android_host/vulkan_state.h"

namespace nacre::test {
namespace {

std::mutex mutex;
std::map<VkSurfaceKHR, std::pair<VkInstance, ANativeWindow*>> surfaces;
std::map<VkDevice, DeviceRecord> devices;
std::map<VkQueue, VkDevice> queues;
std::map<VkSwapchainKHR, SwapchainRecord> swapchains;
std::map<VkPhysicalDevice, VkInstance> owners;  // several threads have an instance each
std::map<VkInstance, VkDebugUtilsMessengerEXT> messengers;
std::mutex faultsMutex;
std::vector<std::string> faults;
std::atomic<bool> broken{false}, validated{false};
std::atomic<int> refused{0}, losses{0}, made{0};

template <typename Function>
Function loaders(VkInstance instance, const char* name) {
    return reinterpret_cast<Function>(loaderFunction(instance, name));
}
#define NACRE_LOADERS(instance, name) loaders<PFN_##name>(instance, #name)
#define NACRE_DEVICES(device, name) reinterpret_cast<PFN_##name>(devices.at(device).procedure(device, #name))

PFN_vkVoidFunction findProcedure(VkDevice device, const char* name) {
    const std::lock_guard lock(mutex);
    return devices.at(device).procedure(device, name);
}

VKAPI_ATTR VkBool32 VKAPI_CALL complain(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                        const VkDebugUtilsMessengerCallbackDataEXT* data, void*) {
    Faults::add(std::string("validation: ") + (data->pMessage ? data->pMessage : ""));
    return VK_FALSE;
}

VkSurfaceTransformFlagBitsKHR toTransform(int quarterTurns) {
    constexpr VkSurfaceTransformFlagBitsKHR kTransforms[] = {
        VK_SURFACE_TRANSFORM_IDENTITY_BIT_KHR, VK_SURFACE_TRANSFORM_ROTATE_90_BIT_KHR,
        VK_SURFACE_TRANSFORM_ROTATE_180_BIT_KHR, VK_SURFACE_TRANSFORM_ROTATE_270_BIT_KHR};
    return kTransforms[quarterTurns];
}

// --- instance

VKAPI_ATTR VkResult VKAPI_CALL enumerateExtensions(const char* layer, std::uint32_t* count,
                                                   VkExtensionProperties* properties) {
    const VkResult result =
        NACRE_LOADERS(VK_NULL_HANDLE, vkEnumerateInstanceExtensionProperties)(layer, count, properties);
    for (std::uint32_t i = 0; properties && i < *count; ++i)
        if (std::strcmp(properties[i].extensionName, VK_EXT_HEADLESS_SURFACE_EXTENSION_NAME) == 0)
            std::strcpy(properties[i].extensionName, VK_KHR_ANDROID_SURFACE_EXTENSION_NAME);
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* allocator,
                                              VkInstance* instance) {
    if (broken) return VK_ERROR_INCOMPATIBLE_DRIVER;
    std::vector<const char*> extensions(info->ppEnabledExtensionNames,
                                        info->ppEnabledExtensionNames + info->enabledExtensionCount);
    bool window = false;
    for (const char*& name : extensions)
        if (std::strcmp(name, VK_KHR_ANDROID_SURFACE_EXTENSION_NAME) == 0) {
            name = VK_EXT_HEADLESS_SURFACE_EXTENSION_NAME;
            window = true;
        }
    VkInstanceCreateInfo changed = *info;
    std::vector<const char*> layers(info->ppEnabledLayerNames, info->ppEnabledLayerNames + info->enabledLayerCount);
    for (const char* layer : layers)
        if (std::strcmp(layer, "VK_LAYER_KHRONOS_validation") == 0) validated = true;
    // What draws into windows is watched; headless renders, which only say what to expect, are tested elsewhere.
    if (window) layers.push_back("VK_LAYER_KHRONOS_validation");
    changed.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    changed.ppEnabledExtensionNames = extensions.data();
    changed.enabledLayerCount = static_cast<std::uint32_t>(layers.size());
    changed.ppEnabledLayerNames = layers.data();
    const VkResult result = NACRE_LOADERS(VK_NULL_HANDLE, vkCreateInstance)(&changed, allocator, instance);
    if (result != VK_SUCCESS) return result;
    const std::lock_guard lock(mutex);
    if (!window) return result;
    VkDebugUtilsMessengerCreateInfoEXT messages{};
    messages.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    messages.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    messages.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    messages.pfnUserCallback = complain;
    NACRE_LOADERS(*instance, vkCreateDebugUtilsMessengerEXT)(*instance, &messages, nullptr, &messengers[*instance]);
    return result;
}

VKAPI_ATTR void VKAPI_CALL destroyInstance(VkInstance instance, const VkAllocationCallbacks* allocator) {
    {
        const std::lock_guard lock(mutex);
        if (const auto it = messengers.find(instance); it != messengers.end()) {
            NACRE_LOADERS(instance, vkDestroyDebugUtilsMessengerEXT)(instance, it->second, nullptr);
            messengers.erase(it);
        }
    }
    NACRE_LOADERS(instance, vkDestroyInstance)(instance, allocator);
}

// --- surfaces

VKAPI_ATTR void VKAPI_CALL destroySurface(VkInstance instance, VkSurfaceKHR surface,
                                          const VkAllocationCallbacks* allocator) {
    {
        const std::lock_guard lock(mutex);
        if (const auto it = surfaces.find(surface); it != surfaces.end()) {
            ANativeWindow& window = *it->second.second;
            const std::lock_guard windowLock(window.mutex);
            --window.surfaces;
            surfaces.erase(it);
        }
    }
    NACRE_LOADERS(instance, vkDestroySurfaceKHR)(instance, surface, allocator);
}

VKAPI_ATTR VkResult VKAPI_CALL surfaceCapabilities(VkPhysicalDevice device, VkSurfaceKHR surface,
                                                   VkSurfaceCapabilitiesKHR* caps) {
    const std::lock_guard lock(mutex);
    const auto [instance, window] = surfaces.at(surface);
    const VkResult result = NACRE_LOADERS(instance, vkGetPhysicalDeviceSurfaceCapabilitiesKHR)(device, surface, caps);
    const std::lock_guard windowLock(window->mutex);
    if (!window->alive) return VK_ERROR_SURFACE_LOST_KHR;
    caps->currentExtent = {static_cast<std::uint32_t>(window->width), static_cast<std::uint32_t>(window->height)};
    caps->currentTransform = toTransform(window->quarterTurns);
    caps->supportedTransforms |= caps->currentTransform;
    return result;
}

// --- devices

VKAPI_ATTR VkResult VKAPI_CALL enumerateDevices(VkInstance instance, std::uint32_t* count, VkPhysicalDevice* found) {
    const VkResult result = NACRE_LOADERS(instance, vkEnumeratePhysicalDevices)(instance, count, found);
    const std::lock_guard lock(mutex);
    for (std::uint32_t i = 0; found && i < *count; ++i) owners[found[i]] = instance;
    return result;
}

VkInstance findOwner(VkPhysicalDevice device) {
    const std::lock_guard lock(mutex);
    return owners.at(device);
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* device) {
    deviceIsMade();
    const VkInstance owner = findOwner(physical);
    const std::lock_guard lock(mutex);
    const VkResult result = NACRE_LOADERS(owner, vkCreateDevice)(physical, info, allocator, device);
    if (result == VK_SUCCESS)
        devices[*device] = {owner, physical, info->pQueueCreateInfos[0].queueFamilyIndex,
                            NACRE_LOADERS(owner, vkGetDeviceProcAddr)};
    ++made;
    return result;
}

VKAPI_ATTR void VKAPI_CALL destroyDevice(VkDevice device, const VkAllocationCallbacks* allocator) {
    const std::lock_guard lock(mutex);
    NACRE_DEVICES(device, vkDestroyDevice)(device, allocator);
    std::erase_if(queues, [&](const auto& entry) { return entry.second == device; });
    devices.erase(device);
}

VKAPI_ATTR void VKAPI_CALL getQueue(VkDevice device, std::uint32_t family, std::uint32_t index, VkQueue* queue) {
    const std::lock_guard lock(mutex);
    NACRE_DEVICES(device, vkGetDeviceQueue)(device, family, index, queue);
    queues[*queue] = device;
}

// --- swapchains

VKAPI_ATTR VkResult VKAPI_CALL createSwapchain(VkDevice device, const VkSwapchainCreateInfoKHR* info,
                                               const VkAllocationCallbacks* allocator, VkSwapchainKHR* swapchain) {
    const std::lock_guard lock(mutex);
    ANativeWindow& window = *surfaces.at(info->surface).second;
    const std::lock_guard windowLock(window.mutex);
    if (!window.alive) return VK_ERROR_SURFACE_LOST_KHR;
    SwapchainRecord record{device, &window, info->imageFormat, info->imageExtent, 0, {}};
    for (int turns = 0; turns < 4; ++turns)
        if (info->preTransform == toTransform(turns)) record.quarterTurns = turns;
    const bool sideways = record.quarterTurns % 2 != 0;
    const VkExtent2D wanted = {static_cast<std::uint32_t>(sideways ? window.height : window.width),
                               static_cast<std::uint32_t>(sideways ? window.width : window.height)};
    if (record.extent.width != wanted.width || record.extent.height != wanted.height)
        Faults::add("a swapchain of another size than the display's");
    VkSwapchainCreateInfoKHR changed = *info;
    changed.preTransform = VK_SURFACE_TRANSFORM_IDENTITY_BIT_KHR;
    changed.imageUsage |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    const VkResult result = NACRE_DEVICES(device, vkCreateSwapchainKHR)(device, &changed, allocator, swapchain);
    if (result != VK_SUCCESS) return result;
    std::uint32_t count = 0;
    NACRE_DEVICES(device, vkGetSwapchainImagesKHR)(device, *swapchain, &count, nullptr);
    record.images.resize(count);
    NACRE_DEVICES(device, vkGetSwapchainImagesKHR)(device, *swapchain, &count, record.images.data());
    swapchains[*swapchain] = std::move(record);
    return result;
}

VKAPI_ATTR void VKAPI_CALL destroySwapchain(VkDevice device, VkSwapchainKHR swapchain,
                                            const VkAllocationCallbacks* allocator) {
    const std::lock_guard lock(mutex);
    NACRE_DEVICES(device, vkDestroySwapchainKHR)(device, swapchain, allocator);
    swapchains.erase(swapchain);
}

VKAPI_ATTR VkResult VKAPI_CALL acquire(VkDevice device, VkSwapchainKHR swapchain, std::uint64_t timeout,
                                       VkSemaphore semaphore, VkFence fence, std::uint32_t* index) {
    PFN_vkAcquireNextImageKHR next = nullptr;
    {
        const std::lock_guard lock(mutex);
        ANativeWindow& window = *swapchains.at(swapchain).window;
        const std::lock_guard windowLock(window.mutex);
        if (!window.alive) return VK_ERROR_SURFACE_LOST_KHR;
        DeviceRecord& record = devices.at(device);
        if (losses > 0 && !record.lost) --losses, record.lost = true;
        if (record.lost) return VK_ERROR_DEVICE_LOST;
        if (refused > 0) {
            --refused;
            return VK_ERROR_OUT_OF_DATE_KHR;
        }
        next = NACRE_DEVICES(device, vkAcquireNextImageKHR);
    }
    imageIsAwaited();
    return next(device, swapchain, timeout, semaphore, fence, index);
}

VKAPI_ATTR VkResult VKAPI_CALL waitForFences(VkDevice device, std::uint32_t count, const VkFence* fences, VkBool32 all,
                                             std::uint64_t timeout) {
    fenceIsAwaited();
    return reinterpret_cast<PFN_vkWaitForFences>(findProcedure(device, "vkWaitForFences"))(device, count, fences, all,
                                                                                           timeout);
}

VKAPI_ATTR VkResult VKAPI_CALL submit(VkQueue queue, std::uint32_t count, const VkSubmitInfo* infos, VkFence fence) {
    commandsAreSubmitted();
    VkDevice device = VK_NULL_HANDLE;
    {
        const std::lock_guard lock(mutex);
        device = queues.at(queue);
    }
    return reinterpret_cast<PFN_vkQueueSubmit>(findProcedure(device, "vkQueueSubmit"))(queue, count, infos, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL present(VkQueue queue, const VkPresentInfoKHR* info) {
    const std::lock_guard lock(mutex);
    const VkDevice device = queues.at(queue);
    const SwapchainRecord& record = swapchains.at(info->pSwapchains[0]);
    const std::vector<std::uint8_t> texels =
        readBack(devices.at(device), device, queue, record.images[info->pImageIndices[0]], record.extent, *info);
    VkPresentInfoKHR changed = *info;
    changed.waitSemaphoreCount = 0;
    const VkResult result = NACRE_DEVICES(device, vkQueuePresentKHR)(queue, &changed);
    ANativeWindow& window = *record.window;
    const std::lock_guard windowLock(window.mutex);
    if (!window.alive) Faults::add("a frame for a window that is gone");
    window.picture = upright(texels, record);
    ++window.frames;
    const bool fits = record.quarterTurns == window.quarterTurns &&
                      window.picture.width == static_cast<std::uint32_t>(window.width) &&
                      window.picture.height == static_cast<std::uint32_t>(window.height);
    return result == VK_SUCCESS && !fits ? VK_SUBOPTIMAL_KHR : result;
}

// --- names

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceFunction(VkDevice device, const char* name);

struct Replacement {
    const char* name;
    PFN_vkVoidFunction function;
};
#define NACRE_REPLACE(name, ours) \
    { #name, reinterpret_cast < PFN_vkVoidFunction>(static_cast <PFN_##name>(ours)) }

PFN_vkVoidFunction findReplacement(const char* name) {
    static const Replacement kReplacements[] = {
        NACRE_REPLACE(vkEnumerateInstanceExtensionProperties, enumerateExtensions),
        NACRE_REPLACE(vkCreateInstance, createInstance),
        NACRE_REPLACE(vkDestroyInstance, destroyInstance),
        NACRE_REPLACE(vkCreateAndroidSurfaceKHR, vkCreateAndroidSurfaceKHR),
        NACRE_REPLACE(vkDestroySurfaceKHR, destroySurface),
        NACRE_REPLACE(vkGetPhysicalDeviceSurfaceCapabilitiesKHR, surfaceCapabilities),
        NACRE_REPLACE(vkEnumeratePhysicalDevices, enumerateDevices),
        NACRE_REPLACE(vkCreateDevice, createDevice),
        NACRE_REPLACE(vkDestroyDevice, destroyDevice),
        NACRE_REPLACE(vkGetDeviceQueue, getQueue),
        NACRE_REPLACE(vkCreateSwapchainKHR, createSwapchain),
        NACRE_REPLACE(vkDestroySwapchainKHR, destroySwapchain),
        NACRE_REPLACE(vkAcquireNextImageKHR, acquire),
        NACRE_REPLACE(vkQueuePresentKHR, present),
        NACRE_REPLACE(vkQueueSubmit, submit),
        NACRE_REPLACE(vkWaitForFences, waitForFences),
        NACRE_REPLACE(vkGetDeviceProcAddr, deviceFunction),
        NACRE_REPLACE(vkGetInstanceProcAddr, vkGetInstanceProcAddr)};
    for (const Replacement& r : kReplacements)
        if (std::strcmp(r.name, name) == 0) return r.function;
    return nullptr;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceFunction(VkDevice device, const char* name) {
    if (const PFN_vkVoidFunction ours = findReplacement(name)) return ours;
    return findProcedure(device, name);
}

}  // namespace

PFN_vkVoidFunction loaderFunction(VkInstance instance, const char* name) {
    static const auto get = [] {
        void* loader = dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL);
        if (!loader) {
            std::fprintf(stderr, "no libvulkan.so.1: %s\n", dlerror());
            std::abort();
        }
        return reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(loader, "vkGetInstanceProcAddr"));
    }();
    return get(instance, name);
}

void setVulkanBroken(bool now) { broken = now; }
bool validationAsked() { return validated; }
void refuseFrames(int count) { refused = count; }
void loseDevices(int count) { losses = count; }
int devicesMade() { return made; }

void Faults::add(const std::string& fault) {
    const std::lock_guard lock(faultsMutex);
    if (faults.size() < 50) faults.push_back(fault);
}

std::vector<std::string> Faults::take() {
    const std::lock_guard lock(faultsMutex);
    return std::exchange(faults, {});
}

}  // namespace nacre::test

extern "C" {

VKAPI_ATTR VkResult VKAPI_CALL vkCreateAndroidSurfaceKHR(VkInstance instance, const VkAndroidSurfaceCreateInfoKHR* info,
                                                         const VkAllocationCallbacks* allocator,
                                                         VkSurfaceKHR* surface) {
    using namespace nacre::test;
    const std::lock_guard lock(mutex);
    ANativeWindow& window = *info->window;
    const std::lock_guard windowLock(window.mutex);
    if (!window.alive) {
        Faults::add("a surface for a window that is gone");
        return VK_ERROR_SURFACE_LOST_KHR;
    }
    if (window.surfaces > 0) return VK_ERROR_NATIVE_WINDOW_IN_USE_KHR;
    VkHeadlessSurfaceCreateInfoEXT headless{};
    headless.sType = VK_STRUCTURE_TYPE_HEADLESS_SURFACE_CREATE_INFO_EXT;
    const VkResult result =
        NACRE_LOADERS(instance, vkCreateHeadlessSurfaceEXT)(instance, &headless, allocator, surface);
    if (result != VK_SUCCESS) return result;
    ++window.surfaces;
    surfaces[*surface] = {instance, &window};
    return result;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL vkGetInstanceProcAddr(VkInstance instance, const char* name) {
    if (const PFN_vkVoidFunction ours = nacre::test::findReplacement(name)) return ours;
    return nacre::test::loaderFunction(instance, name);
}

}  // extern "C"
