#include "app/xr/calls.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace nacre::app {
namespace {

constexpr const char* kTask = "cannot show in a headset";

/// The loader's entry point. Its name has stayed the same since OpenXR 1.0.
PFN_xrGetInstanceProcAddr entryPoint() {
    static const PFN_xrGetInstanceProcAddr entry = [] {
        setenv("XR_LOADER_DEBUG", "none", 0);  // errors are reported by this application
        void* const library =
            dlopen("libopenxr_loader.so.1", RTLD_NOW | RTLD_LOCAL);  // never unloaded, nor are runtimes
        if (!library) throw Error(kTask, "OpenXR", "its loader is not installed (Debian: libopenxr-loader1)");
        return reinterpret_cast<PFN_xrGetInstanceProcAddr>(dlsym(library, "xrGetInstanceProcAddr"));
    }();
    return entry;
}

template <typename Call>
void find(XrInstance instance, const char* name, Call& call) {
    PFN_xrVoidFunction found = nullptr;
    checkXr(entryPoint()(instance, name, &found), name);
    call = reinterpret_cast<Call>(found);
}

std::vector<XrExtensionProperties> extensions() {
    PFN_xrEnumerateInstanceExtensionProperties enumerate = nullptr;
    find(XR_NULL_HANDLE, "xrEnumerateInstanceExtensionProperties", enumerate);
    std::uint32_t count = 0;
    checkXr(enumerate(nullptr, 0, &count, nullptr), "xrEnumerateInstanceExtensionProperties");
    std::vector all(count, typed<XrExtensionProperties>(XR_TYPE_EXTENSION_PROPERTIES));
    checkXr(enumerate(nullptr, count, &count, all.data()), "xrEnumerateInstanceExtensionProperties");
    return all;
}

}  // namespace

XrFailure::XrFailure(const std::string& call, XrResult failed)
    : Error("the headset failed", "OpenXR", call + " returned " + std::to_string(failed)), result(failed) {}

XrResult checkXr(XrResult result, const char* call) {
    if (XR_FAILED(result)) throw XrFailure(call, result);
    return result;
}

XrInstance makeXrInstance() {
    constexpr const char* kVulkan = XR_KHR_VULKAN_ENABLE2_EXTENSION_NAME;
    try {
        const auto all = extensions();
        if (std::ranges::none_of(all, [](const auto& e) { return std::strcmp(e.extensionName, kVulkan) == 0; }))
            throw Error(kTask, "OpenXR",
                        std::string("the runtime cannot show what Vulkan draws: it has no ") + kVulkan);
        PFN_xrCreateInstance create = nullptr;
        find(XR_NULL_HANDLE, "xrCreateInstance", create);
        auto info = typed<XrInstanceCreateInfo>(XR_TYPE_INSTANCE_CREATE_INFO);
        std::strcpy(info.applicationInfo.applicationName, "nacre");
        std::strcpy(info.applicationInfo.engineName, "nacre");
        info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
        info.enabledExtensionCount = 1;
        info.enabledExtensionNames = &kVulkan;
        XrInstance instance = XR_NULL_HANDLE;
        checkXr(create(&info, &instance), "xrCreateInstance");
        return instance;
    } catch (const XrFailure&) {
        throw Error(kTask, "OpenXR",
                    "no runtime is active: start the headset's software, such as Monado, SteamVR or WiVRn");
    }
}

XrCalls::XrCalls(XrInstance instance) {
    const auto get = [&](const char* name, auto& call) { find(instance, name, call); };
    get("xrDestroyInstance", destroyInstance);
    get("xrPollEvent", pollEvent);
    get("xrGetSystem", getSystem);
    get("xrEnumerateViewConfigurationViews", enumerateViewConfigurationViews);
    get("xrCreateSession", createSession);
    get("xrDestroySession", destroySession);
    get("xrBeginSession", beginSession);
    get("xrEndSession", endSession);
    get("xrRequestExitSession", requestExitSession);
    get("xrCreateReferenceSpace", createReferenceSpace);
    get("xrCreateActionSpace", createActionSpace);
    get("xrLocateSpace", locateSpace);
    get("xrEnumerateSwapchainFormats", enumerateSwapchainFormats);
    get("xrCreateSwapchain", createSwapchain);
    get("xrDestroySwapchain", destroySwapchain);
    get("xrEnumerateSwapchainImages", enumerateSwapchainImages);
    get("xrAcquireSwapchainImage", acquireSwapchainImage);
    get("xrWaitSwapchainImage", waitSwapchainImage);
    get("xrReleaseSwapchainImage", releaseSwapchainImage);
    get("xrWaitFrame", waitFrame);
    get("xrBeginFrame", beginFrame);
    get("xrEndFrame", endFrame);
    get("xrLocateViews", locateViews);
    get("xrStringToPath", stringToPath);
    get("xrCreateActionSet", createActionSet);
    get("xrCreateAction", createAction);
    get("xrSuggestInteractionProfileBindings", suggestInteractionProfileBindings);
    get("xrAttachSessionActionSets", attachSessionActionSets);
    get("xrSyncActions", syncActions);
    get("xrGetActionStateBoolean", getActionStateBoolean);
    get("xrGetVulkanGraphicsRequirements2KHR", getVulkanGraphicsRequirements2);
    get("xrCreateVulkanInstanceKHR", createVulkanInstance);
    get("xrGetVulkanGraphicsDevice2KHR", getVulkanGraphicsDevice2);
    get("xrCreateVulkanDeviceKHR", createVulkanDevice);
}

}  // namespace nacre::app
