#include "app/xr/headset.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

namespace nacre::app {
namespace {

constexpr XrViewConfigurationType kStereo = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
constexpr XrPosef kHere{{0, 0, 0, 1}, {0, 0, 0}};

Pose convertPose(const XrPosef& p) {
    const auto& [x, y, z, w] = p.orientation;
    return {{p.position.x, p.position.y, p.position.z}, glm::normalize(glm::dquat(w, x, y, z))};
}

XrPosef convertPose(const Pose& p) {
    const auto f = [](double value) { return static_cast<float>(value); };
    const glm::dquat& q = p.orientation;
    return {{f(q.x), f(q.y), f(q.z), f(q.w)}, {f(p.position.x), f(p.position.y), f(p.position.z)}};
}

XrFovf toFov(const EyePose& eye) {
    const auto angle = [](double tangent) { return static_cast<float>(std::atan(tangent)); };
    return {angle(eye.left), angle(eye.right), angle(eye.up), angle(eye.down)};
}

/// Checks both results of a call of XR_KHR_vulkan_enable2.
void checkVulkan(XrResult result, VkResult vulkan, const char* call) {
    checkXr(result, call);
    if (vulkan != VK_SUCCESS)
        throw Error("cannot show in a headset", "Vulkan", std::string(call) + " returned " + std::to_string(vulkan));
}

}  // namespace

Headset::Headset() : instance_(makeXrInstance()), xr_(instance_) {
    try {
        findSystem();
        makeActions();
    } catch (...) {
        xr_.destroyInstance(instance_);
        throw;
    }
}

Headset::~Headset() {
    end();
    xr_.destroyInstance(instance_);
}

void Headset::findSystem() {
    auto info = typed<XrSystemGetInfo>(XR_TYPE_SYSTEM_GET_INFO);
    info.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
    const XrResult found = xr_.getSystem(instance_, &info, &system_);
    if (found == XR_ERROR_FORM_FACTOR_UNAVAILABLE || found == XR_ERROR_FORM_FACTOR_UNSUPPORTED)
        throw Error("cannot show in a headset", "OpenXR",
                    "the runtime finds no headset: is it connected and switched on?");
    checkXr(found, "xrGetSystem");
}

XrPath Headset::path(const char* text) const {
    XrPath path = XR_NULL_PATH;
    checkXr(xr_.stringToPath(instance_, text, &path), "xrStringToPath");
    return path;
}

void Headset::makeActions() {
    hands_ = {path("/user/hand/left"), path("/user/hand/right")};
    auto set = typed<XrActionSetCreateInfo>(XR_TYPE_ACTION_SET_CREATE_INFO);
    std::strcpy(set.actionSetName, "molecule");
    std::strcpy(set.localizedActionSetName, "Molecule");
    checkXr(xr_.createActionSet(instance_, &set, &actions_), "xrCreateActionSet");
    const auto make = [&](const char* name, const char* words, XrActionType type) {
        auto info = typed<XrActionCreateInfo>(XR_TYPE_ACTION_CREATE_INFO);
        std::strcpy(info.actionName, name);
        std::strcpy(info.localizedActionName, words);
        info.actionType = type;
        info.countSubactionPaths = static_cast<std::uint32_t>(hands_.size());
        info.subactionPaths = hands_.data();
        XrAction action = XR_NULL_HANDLE;
        checkXr(xr_.createAction(actions_, &info, &action), "xrCreateAction");
        return action;
    };
    grip_ = make("hand", "Hand", XR_ACTION_TYPE_POSE_INPUT);
    hold_ = make("hold", "Hold the molecule", XR_ACTION_TYPE_BOOLEAN_INPUT);
    menuAction_ = make("reset", "Reset the view", XR_ACTION_TYPE_BOOLEAN_INPUT);
    // Runtimes map other controllers to the simple one.
    std::vector<XrActionSuggestedBinding> bindings;
    using Input = std::pair<XrAction, const char*>;
    for (const char* hand : {"/user/hand/left", "/user/hand/right"})
        for (const auto& [action, input] : {Input(grip_, "/input/grip/pose"), Input(hold_, "/input/select/click"),
                                            Input(menuAction_, "/input/menu/click")})
            bindings.push_back({action, path((std::string(hand) + input).c_str())});
    auto suggested = typed<XrInteractionProfileSuggestedBinding>(XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING);
    suggested.interactionProfile = path("/interaction_profiles/khr/simple_controller");
    suggested.countSuggestedBindings = static_cast<std::uint32_t>(bindings.size());
    suggested.suggestedBindings = bindings.data();
    checkXr(xr_.suggestInteractionProfileBindings(instance_, &suggested), "xrSuggestInteractionProfileBindings");
}

HeadsetSource Headset::source() {
    findSystem();
    auto wants = typed<XrGraphicsRequirementsVulkan2KHR>(XR_TYPE_GRAPHICS_REQUIREMENTS_VULKAN2_KHR);
    checkXr(xr_.getVulkanGraphicsRequirements2(instance_, system_, &wants), "xrGetVulkanGraphicsRequirements2KHR");
    if (wants.minApiVersionSupported > XR_MAKE_VERSION(1, 1, 0xffffffff))
        throw Error("cannot show in a headset", "OpenXR", "the runtime wants a newer Vulkan than 1.1");
    HeadsetSource source;
    source.instance = [this](const VkInstanceCreateInfo& vulkan, HeadsetSource::EntryPoint entry) {
        auto info = typed<XrVulkanInstanceCreateInfoKHR>(XR_TYPE_VULKAN_INSTANCE_CREATE_INFO_KHR);
        info.systemId = system_;
        info.pfnGetInstanceProcAddr = entry;
        info.vulkanCreateInfo = &vulkan;
        VkResult result = VK_SUCCESS;
        const XrResult made = xr_.createVulkanInstance(instance_, &info, &binding_.instance, &result);
        checkVulkan(made, result, "xrCreateVulkanInstanceKHR");
        return binding_.instance;
    };
    source.physical = [this](VkInstance vulkan) {
        auto info = typed<XrVulkanGraphicsDeviceGetInfoKHR>(XR_TYPE_VULKAN_GRAPHICS_DEVICE_GET_INFO_KHR);
        info.systemId = system_;
        info.vulkanInstance = vulkan;
        checkXr(xr_.getVulkanGraphicsDevice2(instance_, &info, &binding_.physicalDevice),
                "xrGetVulkanGraphicsDevice2KHR");
        return binding_.physicalDevice;
    };
    source.device = [this](VkPhysicalDevice physical, const VkDeviceCreateInfo& vulkan,
                           HeadsetSource::EntryPoint entry) {
        auto info = typed<XrVulkanDeviceCreateInfoKHR>(XR_TYPE_VULKAN_DEVICE_CREATE_INFO_KHR);
        info.systemId = system_;
        info.pfnGetInstanceProcAddr = entry;
        info.vulkanPhysicalDevice = physical;
        info.vulkanCreateInfo = &vulkan;
        VkResult result = VK_SUCCESS;
        const XrResult made = xr_.createVulkanDevice(instance_, &info, &binding_.device, &result);
        checkVulkan(made, result, "xrCreateVulkanDeviceKHR");
        binding_.queueFamilyIndex = vulkan.pQueueCreateInfos[0].queueFamilyIndex;
        return binding_.device;
    };
    return source;
}

void Headset::begin() {
    binding_.type = XR_TYPE_GRAPHICS_BINDING_VULKAN2_KHR;
    auto info = typed<XrSessionCreateInfo>(XR_TYPE_SESSION_CREATE_INFO);
    info.next = &binding_;
    info.systemId = system_;
    checkXr(xr_.createSession(instance_, &info, &session_), "xrCreateSession");
    try {
        makeSpaces();
        makeSwapchain();
        auto attached = typed<XrSessionActionSetsAttachInfo>(XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO);
        attached.countActionSets = 1;
        attached.actionSets = &actions_;
        checkXr(xr_.attachSessionActionSets(session_, &attached), "xrAttachSessionActionSets");
    } catch (...) {
        end();
        throw;
    }
}

void Headset::makeSpaces() {
    auto room = typed<XrReferenceSpaceCreateInfo>(XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
    room.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_LOCAL;
    room.poseInReferenceSpace = kHere;
    checkXr(xr_.createReferenceSpace(session_, &room, &room_), "xrCreateReferenceSpace");
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        auto grip = typed<XrActionSpaceCreateInfo>(XR_TYPE_ACTION_SPACE_CREATE_INFO);
        grip.action = grip_;
        grip.subactionPath = hands_[i];
        grip.poseInActionSpace = kHere;
        checkXr(xr_.createActionSpace(session_, &grip, &grips_[i]), "xrCreateActionSpace");
    }
}

void Headset::makeSwapchain() {
    std::uint32_t count = 0;
    std::array<XrViewConfigurationView, 2> views{};
    for (XrViewConfigurationView& view : views) view.type = XR_TYPE_VIEW_CONFIGURATION_VIEW;
    checkXr(xr_.enumerateViewConfigurationViews(instance_, system_, kStereo, 2, &count, views.data()),
            "xrEnumerateViewConfigurationViews");
    width_ = std::max(views[0].recommendedImageRectWidth, views[1].recommendedImageRectWidth);
    height_ = std::max(views[0].recommendedImageRectHeight, views[1].recommendedImageRectHeight);
    checkXr(xr_.enumerateSwapchainFormats(session_, 0, &count, nullptr), "xrEnumerateSwapchainFormats");
    std::vector<std::int64_t> formats(count);
    checkXr(xr_.enumerateSwapchainFormats(session_, count, &count, formats.data()), "xrEnumerateSwapchainFormats");
    constexpr std::array<std::int64_t, 2> kFormats{VK_FORMAT_R8G8B8A8_SRGB, VK_FORMAT_B8G8R8A8_SRGB};
    const auto format = std::ranges::find_first_of(kFormats, formats);
    if (format == kFormats.end())
        throw Error("cannot show in a headset", "OpenXR", "the runtime takes no images of 8 bits coded as sRGB");
    format_ = static_cast<int>(*format);
    auto info = typed<XrSwapchainCreateInfo>(XR_TYPE_SWAPCHAIN_CREATE_INFO);
    info.usageFlags = XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT;
    info.format = format_;
    info.sampleCount = 1;
    info.width = width_;
    info.height = height_;
    info.faceCount = 1;
    info.arraySize = 2;
    info.mipCount = 1;
    checkXr(xr_.createSwapchain(session_, &info, &swapchain_), "xrCreateSwapchain");
    checkXr(xr_.enumerateSwapchainImages(swapchain_, 0, &count, nullptr), "xrEnumerateSwapchainImages");
    images_.assign(count, typed<XrSwapchainImageVulkan2KHR>(XR_TYPE_SWAPCHAIN_IMAGE_VULKAN2_KHR));
    checkXr(xr_.enumerateSwapchainImages(swapchain_, count, &count,
                                         reinterpret_cast<XrSwapchainImageBaseHeader*>(images_.data())),
            "xrEnumerateSwapchainImages");
}

void Headset::end() noexcept {
    if (session_ != XR_NULL_HANDLE) xr_.destroySession(session_);  // also destroys its spaces and its swapchain
    session_ = XR_NULL_HANDLE;
    running_ = focused_ = lost_ = false;
}

void Headset::handleEvents() {
    for (;;) {
        auto event = typed<XrEventDataBuffer>(XR_TYPE_EVENT_DATA_BUFFER);
        if (checkXr(xr_.pollEvent(instance_, &event), "xrPollEvent") == XR_EVENT_UNAVAILABLE) return;
        if (event.type == XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING)
            throw Error("the headset failed", "OpenXR", "the runtime ends");
        if (event.type != XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) continue;
        const auto& changed = reinterpret_cast<const XrEventDataSessionStateChanged&>(event);
        if (changed.session != session_) continue;  // of an earlier session
        focused_ = changed.state == XR_SESSION_STATE_FOCUSED;
        switch (changed.state) {
            case XR_SESSION_STATE_READY: {
                auto info = typed<XrSessionBeginInfo>(XR_TYPE_SESSION_BEGIN_INFO);
                info.primaryViewConfigurationType = kStereo;
                checkXr(xr_.beginSession(session_, &info), "xrBeginSession");
                running_ = true;
                break;
            }
            case XR_SESSION_STATE_STOPPING:
                running_ = false;
                checkXr(xr_.endSession(session_), "xrEndSession");
                break;
            case XR_SESSION_STATE_EXITING:
                over_ = true;
                break;
            case XR_SESSION_STATE_LOSS_PENDING:
                lost_ = true;
                break;
            default:
                break;
        }
    }
}

void Headset::leave() {
    // If it is not running, the runtime sends no stop event.
    if (!running_ || XR_FAILED(xr_.requestExitSession(session_))) over_ = true;
}

Headset::Frame Headset::beginFrame() {
    auto state = typed<XrFrameState>(XR_TYPE_FRAME_STATE);
    checkXr(xr_.waitFrame(session_, nullptr, &state), "xrWaitFrame");
    checkXr(xr_.beginFrame(session_, nullptr), "xrBeginFrame");
    return {state.predictedDisplayTime, state.shouldRender == XR_TRUE};
}

std::optional<std::array<EyePose, 2>> Headset::eyes(const Frame& frame) {
    auto info = typed<XrViewLocateInfo>(XR_TYPE_VIEW_LOCATE_INFO);
    info.viewConfigurationType = kStereo;
    info.displayTime = frame.time;
    info.space = room_;
    auto state = typed<XrViewState>(XR_TYPE_VIEW_STATE);
    std::array<XrView, 2> views{};
    for (XrView& view : views) view.type = XR_TYPE_VIEW;
    std::uint32_t count = 0;
    checkXr(xr_.locateViews(session_, &info, &state, 2, &count, views.data()), "xrLocateViews");
    constexpr XrViewStateFlags kKnown = XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT;
    if ((state.viewStateFlags & kKnown) != kKnown) return {};
    std::array<EyePose, 2> eyes;
    for (std::size_t i = 0; i < 2; ++i) {
        const XrFovf& fov = views[i].fov;
        const auto tangent = [](float angle) { return std::tan(static_cast<double>(angle)); };
        static_cast<Pose&>(eyes[i]) = convertPose(views[i].pose);
        eyes[i].left = tangent(fov.angleLeft), eyes[i].right = tangent(fov.angleRight);
        eyes[i].down = tangent(fov.angleDown), eyes[i].up = tangent(fov.angleUp);
    }
    return eyes;
}

bool Headset::pressed(XrAction action, XrPath hand) const {
    auto info = typed<XrActionStateGetInfo>(XR_TYPE_ACTION_STATE_GET_INFO);
    info.action = action;
    info.subactionPath = hand;
    auto state = typed<XrActionStateBoolean>(XR_TYPE_ACTION_STATE_BOOLEAN);
    checkXr(xr_.getActionStateBoolean(session_, &info, &state), "xrGetActionStateBoolean");
    const bool down = state.isActive == XR_TRUE && state.currentState == XR_TRUE;
    return down && (action != menuAction_ || state.changedSinceLastSync == XR_TRUE);
}

std::optional<Hand> Headset::hand(const Frame& frame) {
    menu_ = false;
    if (!focused_) return {};
    const XrActiveActionSet active{actions_, XR_NULL_PATH};
    auto sync = typed<XrActionsSyncInfo>(XR_TYPE_ACTIONS_SYNC_INFO);
    sync.countActiveActionSets = 1;
    sync.activeActionSets = &active;
    if (checkXr(xr_.syncActions(session_, &sync), "xrSyncActions") == XR_SESSION_NOT_FOCUSED) return {};
    std::array<std::optional<Hand>, 2> hands;
    for (std::size_t i = 0; i < 2; ++i) {
        menu_ = menu_ || pressed(menuAction_, hands_[i]);
        auto at = typed<XrSpaceLocation>(XR_TYPE_SPACE_LOCATION);
        checkXr(xr_.locateSpace(grips_[i], room_, frame.time, &at), "xrLocateSpace");
        constexpr XrSpaceLocationFlags kKnown =
            XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;
        if ((at.locationFlags & kKnown) == kKnown) hands[i] = Hand{convertPose(at.pose), pressed(hold_, hands_[i])};
    }
    const auto holds = [&](std::size_t i) { return hands[i] && hands[i]->holds; };
    if (!holds(holding_) && holds(1 - holding_)) holding_ = 1 - holding_;
    return hands[holding_] ? hands[holding_] : hands[1 - holding_];
}

HeadsetImage Headset::take() {
    std::uint32_t index = 0;
    checkXr(xr_.acquireSwapchainImage(swapchain_, nullptr, &index), "xrAcquireSwapchainImage");
    auto wait = typed<XrSwapchainImageWaitInfo>(XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO);
    wait.timeout = XR_INFINITE_DURATION;
    checkXr(xr_.waitSwapchainImage(swapchain_, &wait), "xrWaitSwapchainImage");
    return {images_[index].image, format_, width_, height_};
}

void Headset::give() { checkXr(xr_.releaseSwapchainImage(swapchain_, nullptr), "xrReleaseSwapchainImage"); }

void Headset::endFrame(const Frame& frame, const std::optional<std::array<EyePose, 2>>& shown) {
    std::array<XrCompositionLayerProjectionView, 2> views{};
    auto layer = typed<XrCompositionLayerProjection>(XR_TYPE_COMPOSITION_LAYER_PROJECTION);
    layer.space = room_;
    layer.viewCount = 2;
    layer.views = views.data();
    for (std::uint32_t i = 0; shown && i < 2; ++i) {
        views[i].type = XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW;
        views[i].pose = convertPose((*shown)[i]);
        views[i].fov = toFov((*shown)[i]);
        views[i].subImage.swapchain = swapchain_;
        views[i].subImage.imageRect.extent = {static_cast<std::int32_t>(width_), static_cast<std::int32_t>(height_)};
        views[i].subImage.imageArrayIndex = i;
    }
    const auto* layers = reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer);
    auto end = typed<XrFrameEndInfo>(XR_TYPE_FRAME_END_INFO);
    end.displayTime = frame.time;
    end.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
    end.layerCount = shown ? 1 : 0;
    end.layers = &layers;
    checkXr(xr_.endFrame(session_, &end), "xrEndFrame");
}

}  // namespace nacre::app
