#pragma once
// OpenXR functions. The loader is loaded when a headset is first used.

#include <string>

#define XR_NO_PROTOTYPES
#define XR_USE_GRAPHICS_API_VULKAN
#include <vulkan/vulkan_core.h>
//
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include "engine/error.h"

namespace nacre::app {

/// A failed call.
class XrFailure : public Error {
public:
    XrFailure(const std::string& call, XrResult result);
    XrResult result;
};

/// Functions of an instance.
struct XrCalls {
    explicit XrCalls(XrInstance instance);

    PFN_xrDestroyInstance destroyInstance{};
    PFN_xrPollEvent pollEvent{};
    PFN_xrGetSystem getSystem{};
    PFN_xrEnumerateViewConfigurationViews enumerateViewConfigurationViews{};
    PFN_xrCreateSession createSession{};
    PFN_xrDestroySession destroySession{};
    PFN_xrBeginSession beginSession{};
    PFN_xrEndSession endSession{};
    PFN_xrRequestExitSession requestExitSession{};
    PFN_xrCreateReferenceSpace createReferenceSpace{};
    PFN_xrCreateActionSpace createActionSpace{};
    PFN_xrLocateSpace locateSpace{};
    PFN_xrEnumerateSwapchainFormats enumerateSwapchainFormats{};
    PFN_xrCreateSwapchain createSwapchain{};
    PFN_xrDestroySwapchain destroySwapchain{};
    PFN_xrEnumerateSwapchainImages enumerateSwapchainImages{};
    PFN_xrAcquireSwapchainImage acquireSwapchainImage{};
    PFN_xrWaitSwapchainImage waitSwapchainImage{};
    PFN_xrReleaseSwapchainImage releaseSwapchainImage{};
    PFN_xrWaitFrame waitFrame{};
    PFN_xrBeginFrame beginFrame{};
    PFN_xrEndFrame endFrame{};
    PFN_xrLocateViews locateViews{};
    PFN_xrStringToPath stringToPath{};
    PFN_xrCreateActionSet createActionSet{};
    PFN_xrCreateAction createAction{};
    PFN_xrSuggestInteractionProfileBindings suggestInteractionProfileBindings{};
    PFN_xrAttachSessionActionSets attachSessionActionSets{};
    PFN_xrSyncActions syncActions{};
    PFN_xrGetActionStateBoolean getActionStateBoolean{};
    // XR_KHR_vulkan_enable2
    PFN_xrGetVulkanGraphicsRequirements2KHR getVulkanGraphicsRequirements2{};
    PFN_xrCreateVulkanInstanceKHR createVulkanInstance{};
    PFN_xrGetVulkanGraphicsDevice2KHR getVulkanGraphicsDevice2{};
    PFN_xrCreateVulkanDeviceKHR createVulkanDevice{};
};

/// An instance with XR_KHR_vulkan_enable2. @throws Error without loader, runtime or that extension
XrInstance makeXrInstance();

/// A zeroed OpenXR structure with its type set.
template <typename Structure>
Structure typed(XrStructureType type) {
    Structure structure{};
    structure.type = type;
    return structure;
}

/// @throws XrFailure  @returns the result
XrResult checkXr(XrResult result, const char* call);

}  // namespace nacre::app
