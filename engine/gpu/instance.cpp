#include "engine/gpu/instance.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <optional>
#include <utility>

#include "engine/error.h"
#include "engine/gpu/bundled_driver.h"

namespace nacre::gpu {
namespace {

std::atomic<std::uint64_t> instances{0};  ///< made so far

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

bool hasExtension(const std::vector<vk::ExtensionProperties>& list, const char* name) {
    return std::any_of(list.begin(), list.end(),
                       [&](const auto& e) { return std::strcmp(e.extensionName.data(), name) == 0; });
}

VKAPI_ATTR VkBool32 VKAPI_CALL collect(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                       const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    // One vertex shader serves several fragment shaders. Drivers link the stages and drop unused outputs.
    const bool unread = data->pMessageIdName && std::strstr(data->pMessageIdName, "Shader-OutputNotConsumed");
    if (!unread) static_cast<ValidationLog*>(user)->add(data->pMessage ? data->pMessage : "");
    return VK_FALSE;
}

/// Preference among devices if none is named.
int rank(vk::PhysicalDeviceType type) {
    switch (type) {
        case vk::PhysicalDeviceType::eDiscreteGpu:
            return 0;
        case vk::PhysicalDeviceType::eIntegratedGpu:
            return 1;
        case vk::PhysicalDeviceType::eVirtualGpu:
            return 2;
        default:
            return 3;
    }
}

std::string lower(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

vk::raii::Instance instanceWith(const vk::raii::Context& context, const InstanceExtensions& found,
                                const std::vector<const char*>& extensions, const std::vector<const char*>& layers,
                                const HeadsetSource* headset = nullptr) {
    constexpr vk::ValidationFeatureEnableEXT kEnable[] = {vk::ValidationFeatureEnableEXT::eSynchronizationValidation};
    const vk::ValidationFeaturesEXT features(kEnable, {});
    const vk::ApplicationInfo application("nacre", 1, "nacre", 1, VK_API_VERSION_1_1);
    vk::InstanceCreateInfo info({}, &application, layers, extensions);
    if (found.portability) info.flags = vk::InstanceCreateFlagBits::eEnumeratePortabilityKHR;
    if (!layers.empty()) info.pNext = &features;
    try {
        ++instances;
        if (headset) return {context, headset->instance(info, entryPoint(context))};
        return vk::raii::Instance(context, info);
    } catch (const vk::ExtensionNotPresentError&) {
        throw;
    } catch (const vk::SystemError& e) {
        throw Error("cannot start Vulkan", "",
                    std::string(e.what()) + " (is a driver installed? Debian's software driver: mesa-vulkan-drivers)");
    }
}

/// Creates an instance without querying the loader first: a query loads and unloads every driver. @returns nothing if
/// the loader lacks something
std::optional<vk::raii::Instance> usualInstance(const vk::raii::Context& context, InstanceExtensions& found) {
    const InstanceExtensions usual{true, true};
    try {
        std::optional<vk::raii::Instance> instance = instanceWith(
            context, usual, {VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME}, {});
        found = usual;
        return instance;
    } catch (const vk::ExtensionNotPresentError&) {
        return {};
    }
}

vk::raii::Instance createInstance(const vk::raii::Context& context, bool validate, InstanceExtensions& found,
                                  const std::vector<std::string>& wanted, const HeadsetSource* headset = nullptr) {
    if (!validate && wanted.empty() && !headset)
        if (std::optional<vk::raii::Instance> instance = usualInstance(context, found)) return std::move(*instance);
    const auto available = context.enumerateInstanceExtensionProperties();
    std::vector<const char*> extensions, layers;
    found.debugUtils = hasExtension(available, VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    found.portability = hasExtension(available, VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME);
    if (found.debugUtils) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    if (found.portability) extensions.push_back(VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME);
    for (const std::string& name : wanted) {
        if (!hasExtension(available, name.c_str()))
            throw Error("cannot open a window", name, "this Vulkan installation lacks the extension");
        extensions.push_back(name.c_str());
    }
    found.surfaceQueries = !wanted.empty() && hasExtension(available, VK_KHR_GET_SURFACE_CAPABILITIES_2_EXTENSION_NAME);
    found.surfaceMaintenance =
        found.surfaceQueries && hasExtension(available, VK_EXT_SURFACE_MAINTENANCE_1_EXTENSION_NAME);
    if (found.surfaceQueries) extensions.push_back(VK_KHR_GET_SURFACE_CAPABILITIES_2_EXTENSION_NAME);
    if (found.surfaceMaintenance) extensions.push_back(VK_EXT_SURFACE_MAINTENANCE_1_EXTENSION_NAME);
    if (validate) {
        const auto present = context.enumerateInstanceLayerProperties();
        if (std::none_of(present.begin(), present.end(),
                         [](const auto& l) { return std::strcmp(l.layerName.data(), kValidationLayer) == 0; }))
            throw Error("cannot validate", kValidationLayer,
                        "the layer is not installed (Debian: vulkan-validationlayers)");
        layers.push_back(kValidationLayer);
        extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
    }
    return instanceWith(context, found, extensions, layers, headset);
}

/// Whether the system's drivers have a device. @param instance  receives their instance
bool findsDevice(const vk::raii::Context& context, bool validate, InstanceExtensions& found,
                 const std::vector<std::string>& wanted, vk::raii::Instance& instance) {
    try {
        instance = createInstance(context, validate, found, wanted);
        return !vk::raii::PhysicalDevices(instance).empty();
    } catch (const Error&) {
        return false;
    } catch (const vk::SystemError&) {
        return false;
    }
}

}  // namespace

HeadsetSource::EntryPoint entryPoint(const vk::raii::Context& context) {
    return context.getDispatcher()->vkGetInstanceProcAddr;
}

vk::raii::Instance makeInstance(const vk::raii::Context& context, bool validate, InstanceExtensions& found,
                                const std::vector<std::string>& wanted, const HeadsetSource* headset) {
    if (headset) return createInstance(context, validate, found, wanted, headset);
    if (hasBundledDriver()) {
        static std::mutex deciding;  // the loader reads the environment, which BundledDriver changes
        const std::lock_guard lock(deciding);
        vk::raii::Instance instance{nullptr};
        if (!BundledDriver::taken() && findsDevice(context, validate, found, wanted, instance)) return instance;
        found = {};
        const BundledDriver driver;
        return createInstance(context, validate, found, wanted);
    }
    return createInstance(context, validate, found, wanted);
}

const std::vector<vk::ExtensionProperties>& listExtensions(const vk::raii::PhysicalDevice& device) {
    // The loader clears a megabyte per query, and a device is queried twenty times.
    struct Known {
        VkPhysicalDevice device = VK_NULL_HANDLE;
        std::uint64_t instances = 0;  // handles may be reused after their instance is destroyed
        std::vector<vk::ExtensionProperties> list;
    };
    thread_local Known known;
    const auto handle = static_cast<VkPhysicalDevice>(*device);
    if (const std::uint64_t made = instances; known.device != handle || known.instances != made)
        known = {handle, made, device.enumerateDeviceExtensionProperties()};
    return known.list;
}

vk::raii::DebugUtilsMessengerEXT makeMessenger(const vk::raii::Instance& instance, ValidationLog& messages) {
    using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
    using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
    // The type of Vulkan-Hpp's callback differs between versions; C's does not.
    VkDebugUtilsMessengerCreateInfoEXT info = {};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    info.messageSeverity = static_cast<VkFlags>(Severity::eWarning | Severity::eError);
    info.messageType = static_cast<VkFlags>(Type::eValidation | Type::ePerformance);
    info.pfnUserCallback = collect;
    info.pUserData = &messages;
    return {instance, vk::DebugUtilsMessengerCreateInfoEXT(info)};
}

vk::raii::PhysicalDevice pickDevice(const vk::raii::Instance& instance, const std::string& wanted) {
    vk::raii::PhysicalDevices devices(instance);
    std::string names;
    int best = -1;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const auto properties = devices[i].getProperties();
        const std::string name = properties.deviceName.data();
        names += (names.empty() ? "" : ", ") + std::to_string(i) + " = " + name;
        const bool matches =
            wanted.empty() || wanted == std::to_string(i) || lower(name).find(lower(wanted)) != std::string::npos;
        if (!matches) continue;
        const auto at = static_cast<std::size_t>(best);
        if (best < 0 || rank(properties.deviceType) < rank(devices[at].getProperties().deviceType))
            best = static_cast<int>(i);
    }
    if (devices.empty())
        throw Error("cannot start Vulkan", "", "no Vulkan device (Debian's software driver: mesa-vulkan-drivers)");
    if (best < 0) throw Error("no such device", wanted, "there are " + names);
    return std::move(devices[static_cast<std::size_t>(best)]);
}

}  // namespace nacre::gpu
