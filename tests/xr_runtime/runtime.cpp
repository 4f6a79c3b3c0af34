#include "tests/xr_runtime/runtime.h"

#include <algorithm>
#include <cstring>
#include <deque>
#include <map>
#include <optional>

#include "tests/xr_runtime/loader_negotiation.h"

namespace xr_runtime {
namespace {

constexpr std::uint32_t kImages = 3;

template <typename Structure>
Structure typed(VkStructureType type) {
    Structure structure{};
    structure.sType = type;
    return structure;
}

template <typename Handle>
Handle toHandle(std::uintptr_t number) {
    return reinterpret_cast<Handle>(number);
}

struct LentImage {
    VkImage image{};
    VkDeviceMemory memory{};
};

struct State {
    bool instance = false, askedRequirements = false, askedViews = false;
    VkInstance vulkan{};
    VkDevice device{};
    VkPhysicalDevice physical{};
    VkQueue queue{};
    std::uint32_t family = 0;
    // The session:
    std::uintptr_t session = 0;
    bool lost = false, running = false, stopping = false;
    XrSessionState state = XR_SESSION_STATE_UNKNOWN;
    std::vector<LentImage> images;
    std::uint32_t acquired = 0;
    bool taken = false, waited = false, released = false;  // an image, in this frame
    std::array<std::vector<std::uint8_t>, 2> pixels;
    bool begun = false;  // a frame
    int number = 0;      // of all frames
    XrTime time = 1'000'000'000;
    bool attached = false;
    std::deque<XrEventDataSessionStateChanged> events;
    std::vector<std::string> paths{""};
    std::vector<std::string> actions{""};                         // by handle
    std::vector<std::pair<int, XrPath>> spaces{{0, 0}};           // kind: 1 room, 2 hand
    std::map<std::pair<std::string, XrPath>, std::string> bound;  // action and hand: input
    std::array<Hand, 2> hands{}, handsBefore{};
};

State& s() {
    static State state;
    return state;
}

XrResult fault(const char* what, XrResult result = XR_ERROR_CALL_ORDER_INVALID) {
    runtime().faults.emplace_back(what);
    return result;
}

/// Results of every call of a session.
std::optional<XrResult> refused(XrSession session) {
    if (!s().session || session != toHandle<XrSession>(s().session))
        return fault("no such session", XR_ERROR_HANDLE_INVALID);
    if (s().lost) return XR_ERROR_SESSION_LOST;
    return {};
}

XrResult copyText(const std::string& from, char* to, std::size_t size) {
    std::strncpy(to, from.c_str(), size - 1);
    to[size - 1] = 0;
    return XR_SUCCESS;
}

// --- Vulkan, with the program's device

std::uint32_t memoryType(std::uint32_t bits, VkMemoryPropertyFlags wanted) {
    VkPhysicalDeviceMemoryProperties all;
    vkGetPhysicalDeviceMemoryProperties(s().physical, &all);
    for (std::uint32_t i = 0; i < all.memoryTypeCount; ++i)
        if ((bits & 1u << i) && (all.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
    return 0;
}

template <typename Record>
void submit(const Record& record) {
    VkCommandPool pool{};
    const VkCommandPoolCreateInfo pools{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, nullptr, 0, s().family};
    vkCreateCommandPool(s().device, &pools, nullptr, &pool);
    VkCommandBuffer commands{};
    const VkCommandBufferAllocateInfo one{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr, pool,
                                          VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
    vkAllocateCommandBuffers(s().device, &one, &commands);
    const auto begin = typed<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
    vkBeginCommandBuffer(commands, &begin);
    record(commands);
    vkEndCommandBuffer(commands);
    auto info = typed<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
    info.commandBufferCount = 1;
    info.pCommandBuffers = &commands;
    vkQueueSubmit(s().queue, 1, &info, VK_NULL_HANDLE);
    vkQueueWaitIdle(s().queue);
    vkDestroyCommandPool(s().device, pool, nullptr);
}

void change(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to) {
    auto barrier = typed<VkImageMemoryBarrier>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER);
    barrier.srcAccessMask = barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 2};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0,
                         nullptr, 0, nullptr, 1, &barrier);
}

constexpr VkImageLayout kLent = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;

LentImage makeImage(const XrSwapchainCreateInfo& wanted) {
    LentImage lent;
    auto info = typed<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = static_cast<VkFormat>(wanted.format);
    info.extent = {wanted.width, wanted.height, 1};
    info.mipLevels = 1;
    info.arrayLayers = wanted.arraySize;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    vkCreateImage(s().device, &info, nullptr, &lent.image);
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(s().device, lent.image, &needs);
    const VkMemoryAllocateInfo memory{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, nullptr, needs.size,
                                      memoryType(needs.memoryTypeBits, 0)};
    vkAllocateMemory(s().device, &memory, nullptr, &lent.memory);
    vkBindImageMemory(s().device, lent.image, lent.memory, 0);
    submit([&](VkCommandBuffer c) { change(c, lent.image, VK_IMAGE_LAYOUT_UNDEFINED, kLent); });
    return lent;
}

void readLayers(VkImage image) {
    const VkDeviceSize layer = VkDeviceSize{4} * runtime().width * runtime().height;
    auto info = typed<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
    info.size = 2 * layer;
    info.usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    VkBuffer buffer{};
    vkCreateBuffer(s().device, &info, nullptr, &buffer);
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(s().device, buffer, &needs);
    const VkMemoryAllocateInfo wanted{
        VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, nullptr, needs.size,
        memoryType(needs.memoryTypeBits, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT)};
    VkDeviceMemory memory{};
    vkAllocateMemory(s().device, &wanted, nullptr, &memory);
    vkBindBufferMemory(s().device, buffer, memory, 0);
    submit([&](VkCommandBuffer c) {
        change(c, image, kLent, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        const VkBufferImageCopy copy{
            0, 0, 0, {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 2}, {0, 0, 0}, {runtime().width, runtime().height, 1}};
        vkCmdCopyImageToBuffer(c, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer, 1, &copy);
        change(c, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, kLent);
    });
    void* mapped = nullptr;
    vkMapMemory(s().device, memory, 0, VK_WHOLE_SIZE, 0, &mapped);
    const auto* bytes = static_cast<const std::uint8_t*>(mapped);
    for (std::size_t i = 0; i < 2; ++i) s().pixels[i].assign(bytes + i * layer, bytes + (i + 1) * layer);
    if (runtime().format == VK_FORMAT_B8G8R8A8_SRGB)
        for (std::vector<std::uint8_t>& pixels : s().pixels)
            for (std::size_t p = 0; p < pixels.size(); p += 4) std::swap(pixels[p], pixels[p + 2]);
    vkDestroyBuffer(s().device, buffer, nullptr);
    vkFreeMemory(s().device, memory, nullptr);
}

// --- instance and system

XrResult XRAPI_CALL enumerateExtensions(const char*, std::uint32_t capacity, std::uint32_t* count,
                                        XrExtensionProperties* list) {
    *count = runtime().vulkan ? 1 : 0;
    if (capacity == 0 || *count == 0) return XR_SUCCESS;
    list[0].extensionVersion = 2;
    return copyText(XR_KHR_VULKAN_ENABLE2_EXTENSION_NAME, list[0].extensionName, sizeof(list[0].extensionName));
}

XrResult XRAPI_CALL createInstance(const XrInstanceCreateInfo*, XrInstance* instance) {
    s() = {};
    s().instance = true;
    *instance = toHandle<XrInstance>(1);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL destroyInstance(XrInstance) {
    if (s().session) fault("the instance is destroyed before its session");
    s().instance = false;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL getInstanceProperties(XrInstance, XrInstanceProperties* properties) {
    properties->runtimeVersion = XR_MAKE_VERSION(1, 0, 0);
    return copyText("test headset", properties->runtimeName, sizeof(properties->runtimeName));
}

XrResult XRAPI_CALL pollEvent(XrInstance, XrEventDataBuffer* buffer) {
    if (s().events.empty()) return XR_EVENT_UNAVAILABLE;
    std::memcpy(buffer, &s().events.front(), sizeof(s().events.front()));
    s().events.pop_front();
    return XR_SUCCESS;
}

XrResult XRAPI_CALL getSystem(XrInstance, const XrSystemGetInfo* info, XrSystemId* system) {
    if (info->formFactor != XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY) return XR_ERROR_FORM_FACTOR_UNSUPPORTED;
    if (!runtime().connected) return XR_ERROR_FORM_FACTOR_UNAVAILABLE;
    *system = 1;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL enumerateViews(XrInstance, XrSystemId, XrViewConfigurationType, std::uint32_t capacity,
                                   std::uint32_t* count, XrViewConfigurationView* views) {
    *count = 2;
    for (std::uint32_t i = 0; i < std::min(capacity, 2u); ++i) {
        views[i].recommendedImageRectWidth = views[i].maxImageRectWidth = runtime().width;
        views[i].recommendedImageRectHeight = views[i].maxImageRectHeight = runtime().height;
        views[i].recommendedSwapchainSampleCount = views[i].maxSwapchainSampleCount = 1;
    }
    return XR_SUCCESS;
}

XrResult XRAPI_CALL graphicsRequirements(XrInstance, XrSystemId, XrGraphicsRequirementsVulkan2KHR* wants) {
    s().askedRequirements = true;
    wants->minApiVersionSupported = XR_MAKE_VERSION(1, 0, 0);
    wants->maxApiVersionSupported = XR_MAKE_VERSION(1, 3, 0);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL createVulkanInstance(XrInstance, const XrVulkanInstanceCreateInfoKHR* info, VkInstance* made,
                                         VkResult* result) {
    const auto create =
        reinterpret_cast<PFN_vkCreateInstance>(info->pfnGetInstanceProcAddr(nullptr, "vkCreateInstance"));
    *result = create(info->vulkanCreateInfo, info->vulkanAllocator, made);
    s().vulkan = *made;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL graphicsDevice(XrInstance, const XrVulkanGraphicsDeviceGetInfoKHR* info, VkPhysicalDevice* found) {
    std::uint32_t one = 1;
    vkEnumeratePhysicalDevices(info->vulkanInstance, &one, found);
    s().physical = *found;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL createVulkanDevice(XrInstance, const XrVulkanDeviceCreateInfoKHR* info, VkDevice* made,
                                       VkResult* result) {
    *result = vkCreateDevice(info->vulkanPhysicalDevice, info->vulkanCreateInfo, info->vulkanAllocator, made);
    return XR_SUCCESS;
}

// --- session

XrResult XRAPI_CALL createSession(XrInstance, const XrSessionCreateInfo* info, XrSession* session) {
    const auto* binding = static_cast<const XrGraphicsBindingVulkan2KHR*>(info->next);
    if (!s().askedRequirements)
        return fault("a session without xrGetVulkanGraphicsRequirements2KHR",
                     XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING);
    if (s().session) return fault("a second session");
    if (binding->instance != s().vulkan || binding->physicalDevice != s().physical)
        return fault("another Vulkan than that of the runtime", XR_ERROR_GRAPHICS_DEVICE_INVALID);
    s().device = binding->device;
    s().family = binding->queueFamilyIndex;
    vkGetDeviceQueue(s().device, s().family, binding->queueIndex, &s().queue);
    s().session = 100 + static_cast<std::uintptr_t>(++runtime().sessions);
    s().lost = s().running = s().stopping = s().attached = s().begun = s().taken = false;
    *session = toHandle<XrSession>(s().session);
    runtime().announce(XR_SESSION_STATE_IDLE);
    runtime().announce(XR_SESSION_STATE_READY);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL destroySession(XrSession) {
    vkDeviceWaitIdle(s().device);
    for (const LentImage& lent : s().images) {
        vkDestroyImage(s().device, lent.image, nullptr);
        vkFreeMemory(s().device, lent.memory, nullptr);
    }
    s().images.clear();
    s().session = 0;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL beginSession(XrSession session, const XrSessionBeginInfo* info) {
    if (const auto no = refused(session)) return *no;
    if (s().state != XR_SESSION_STATE_READY) return fault("xrBeginSession before READY", XR_ERROR_SESSION_NOT_READY);
    if (info->primaryViewConfigurationType != XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO)
        return XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED;
    s().running = true;
    for (const XrSessionState state :
         {XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED})
        runtime().announce(state);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL endSession(XrSession session) {
    if (const auto no = refused(session)) return *no;
    if (s().state != XR_SESSION_STATE_STOPPING)
        return fault("xrEndSession before STOPPING", XR_ERROR_SESSION_NOT_STOPPING);
    s().running = false;
    runtime().announce(XR_SESSION_STATE_IDLE);
    if (s().stopping) runtime().announce(XR_SESSION_STATE_EXITING);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL requestExit(XrSession session) {
    if (const auto no = refused(session)) return *no;
    runtime().stop();
    return XR_SUCCESS;
}

// --- spaces and actions

XrResult addSpace(int kind, XrPath hand, XrSpace* space) {
    s().spaces.emplace_back(kind, hand);
    *space = toHandle<XrSpace>(s().spaces.size() - 1);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL createReferenceSpace(XrSession session, const XrReferenceSpaceCreateInfo* info, XrSpace* space) {
    if (const auto no = refused(session)) return *no;
    if (info->referenceSpaceType != XR_REFERENCE_SPACE_TYPE_LOCAL) return XR_ERROR_REFERENCE_SPACE_UNSUPPORTED;
    return addSpace(1, 0, space);
}

XrResult XRAPI_CALL createActionSpace(XrSession session, const XrActionSpaceCreateInfo* info, XrSpace* space) {
    if (const auto no = refused(session)) return *no;
    return addSpace(2, info->subactionPath, space);
}

std::size_t findHand(XrPath path) { return s().paths.at(path) == "/user/hand/right" ? 1 : 0; }

XrResult XRAPI_CALL locateSpace(XrSpace space, XrSpace, XrTime time, XrSpaceLocation* location) {
    if (s().lost) return XR_ERROR_SESSION_LOST;
    const auto& [kind, path] = s().spaces.at(reinterpret_cast<std::uintptr_t>(space));
    location->locationFlags = 0;
    if (kind != 2 || !runtime().hands) return XR_SUCCESS;
    const Hand hand = runtime().hands(time)[findHand(path)];
    if (!hand.tracked) return XR_SUCCESS;
    location->locationFlags = XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;
    location->pose = hand.pose;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL stringToPath(XrInstance, const char* text, XrPath* path) {
    const auto known = std::ranges::find(s().paths, text);
    *path = static_cast<XrPath>(known - s().paths.begin());
    if (known == s().paths.end()) s().paths.emplace_back(text);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL createActionSet(XrInstance, const XrActionSetCreateInfo*, XrActionSet* set) {
    *set = toHandle<XrActionSet>(7);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL createAction(XrActionSet, const XrActionCreateInfo* info, XrAction* action) {
    if (s().attached)
        return fault("an action is made after its set was attached", XR_ERROR_ACTIONSETS_ALREADY_ATTACHED);
    s().actions.emplace_back(info->actionName);
    *action = toHandle<XrAction>(s().actions.size() - 1);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL suggestBindings(XrInstance, const XrInteractionProfileSuggestedBinding* suggested) {
    if (s().paths.at(suggested->interactionProfile) != "/interaction_profiles/khr/simple_controller")
        return XR_ERROR_PATH_UNSUPPORTED;
    for (std::uint32_t i = 0; i < suggested->countSuggestedBindings; ++i) {
        const auto& [action, path] = suggested->suggestedBindings[i];
        const std::string& input = s().paths.at(path);
        const std::size_t hand = input.find("/input/");
        XrPath user = 0;
        stringToPath(nullptr, input.substr(0, hand).c_str(), &user);
        s().bound[{s().actions.at(reinterpret_cast<std::uintptr_t>(action)), user}] = input.substr(hand);
    }
    return XR_SUCCESS;
}

XrResult XRAPI_CALL attachActionSets(XrSession session, const XrSessionActionSetsAttachInfo*) {
    if (const auto no = refused(session)) return *no;
    if (s().attached) return fault("action sets are attached twice", XR_ERROR_ACTIONSETS_ALREADY_ATTACHED);
    s().attached = true;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL syncActions(XrSession session, const XrActionsSyncInfo*) {
    if (const auto no = refused(session)) return *no;
    if (!s().attached) return fault("actions of a set that is not attached", XR_ERROR_ACTIONSET_NOT_ATTACHED);
    if (s().state != XR_SESSION_STATE_FOCUSED) return XR_SESSION_NOT_FOCUSED;
    s().handsBefore = s().hands;
    if (runtime().hands) s().hands = runtime().hands(s().time);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL getBoolean(XrSession session, const XrActionStateGetInfo* info, XrActionStateBoolean* state) {
    if (const auto no = refused(session)) return *no;
    const std::string& action = s().actions.at(reinterpret_cast<std::uintptr_t>(info->action));
    const std::string& input = s().bound[{action, info->subactionPath}];
    const std::size_t i = findHand(info->subactionPath);
    const auto value = [&](const Hand& hand) { return input == "/input/select/click" ? hand.select : hand.menu; };
    state->isActive = s().hands[i].tracked ? XR_TRUE : XR_FALSE;
    state->currentState = value(s().hands[i]) ? XR_TRUE : XR_FALSE;
    state->changedSinceLastSync = value(s().hands[i]) != value(s().handsBefore[i]) ? XR_TRUE : XR_FALSE;
    return XR_SUCCESS;
}

// --- swapchain

XrResult XRAPI_CALL swapchainFormats(XrSession session, std::uint32_t capacity, std::uint32_t* count,
                                     std::int64_t* formats) {
    if (const auto no = refused(session)) return *no;
    *count = 2;
    if (capacity < 2) return XR_SUCCESS;
    formats[0] = VK_FORMAT_R16G16B16A16_SFLOAT;
    formats[1] = runtime().format;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL createSwapchain(XrSession session, const XrSwapchainCreateInfo* info, XrSwapchain* swapchain) {
    if (const auto no = refused(session)) return *no;
    if (info->format != runtime().format || info->arraySize != 2) return XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED;
    for (std::uint32_t i = 0; i < kImages; ++i) s().images.push_back(makeImage(*info));
    *swapchain = toHandle<XrSwapchain>(9);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL destroySwapchain(XrSwapchain) { return XR_SUCCESS; }

XrResult XRAPI_CALL swapchainImages(XrSwapchain, std::uint32_t capacity, std::uint32_t* count,
                                    XrSwapchainImageBaseHeader* images) {
    *count = kImages;
    for (std::uint32_t i = 0; i < std::min(capacity, kImages); ++i)
        reinterpret_cast<XrSwapchainImageVulkan2KHR*>(images)[i].image = s().images[i].image;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL acquireImage(XrSwapchain, const XrSwapchainImageAcquireInfo*, std::uint32_t* index) {
    if (s().lost) return XR_ERROR_SESSION_LOST;
    if (s().taken) return fault("two images at a time");
    s().taken = true;
    s().waited = false;
    *index = s().acquired = (s().acquired + 1) % kImages;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL waitImage(XrSwapchain, const XrSwapchainImageWaitInfo*) {
    if (!s().taken) return fault("waits for an image that was not acquired");
    s().waited = true;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL releaseImage(XrSwapchain, const XrSwapchainImageReleaseInfo*) {
    if (s().lost) return XR_ERROR_SESSION_LOST;
    if (!s().taken || !s().waited) return fault("releases an image that was not waited for");
    s().taken = false;
    s().released = true;
    readLayers(s().images[s().acquired].image);
    return XR_SUCCESS;
}

// --- frames

XrResult XRAPI_CALL waitFrame(XrSession session, const XrFrameWaitInfo*, XrFrameState* state) {
    if (runtime().before) runtime().before(s().number);
    if (const auto no = refused(session)) return *no;
    if (!s().running) return fault("a frame of a session that does not run", XR_ERROR_SESSION_NOT_RUNNING);
    ++s().number;
    s().time += runtime().period;
    state->predictedDisplayTime = s().time + runtime().lead;
    state->predictedDisplayPeriod = runtime().period;
    state->shouldRender =
        s().state == XR_SESSION_STATE_VISIBLE || s().state == XR_SESSION_STATE_FOCUSED ? XR_TRUE : XR_FALSE;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL beginFrame(XrSession session, const XrFrameBeginInfo*) {
    if (const auto no = refused(session)) return *no;
    if (s().begun) return fault("a frame begins before the last one ends", XR_FRAME_DISCARDED);
    s().begun = true;
    s().released = false;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL locateViews(XrSession session, const XrViewLocateInfo* info, XrViewState* state, std::uint32_t,
                                std::uint32_t* count, XrView* views) {
    if (const auto no = refused(session)) return *no;
    *count = 2;
    state->viewStateFlags = 0;
    if (!runtime().tracked) return XR_SUCCESS;
    state->viewStateFlags = XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT;
    const std::array<XrView, 2> eyes = runtime().eyes(info->displayTime);
    std::copy(eyes.begin(), eyes.end(), views);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL endFrame(XrSession session, const XrFrameEndInfo* info) {
    if (const auto no = refused(session)) return *no;
    if (!s().begun) return fault("a frame ends that was not begun");
    s().begun = false;
    ShownFrame frame{info->displayTime, info->layerCount > 0, {}, {}, {}};
    if (frame.layered) {
        const auto& layer = *reinterpret_cast<const XrCompositionLayerProjection*>(info->layers[0]);
        if (layer.type != XR_TYPE_COMPOSITION_LAYER_PROJECTION || layer.viewCount != 2) return XR_ERROR_LAYER_INVALID;
        if (s().taken || !s().released) return fault("shows an image that was not released", XR_ERROR_LAYER_INVALID);
        for (std::uint32_t i = 0; i < 2; ++i) {
            const XrCompositionLayerProjectionView& view = layer.views[i];
            if (view.subImage.imageArrayIndex != i)
                return fault("an eye shows the other one's layer", XR_ERROR_LAYER_INVALID);
            frame.poses[i] = view.pose;
            frame.fovs[i] = view.fov;
        }
        frame.pixels = s().pixels;
    }
    runtime().frames.push_back(std::move(frame));
    return XR_SUCCESS;
}

// --- what the loader asks

XrResult XRAPI_CALL getProcAddr(XrInstance, const char* name, PFN_xrVoidFunction* function);

template <typename Call>
PFN_xrVoidFunction any(Call call) {
    return reinterpret_cast<PFN_xrVoidFunction>(call);
}

const std::map<std::string, PFN_xrVoidFunction>& calls() {
    static const std::map<std::string, PFN_xrVoidFunction> all{
        {"xrGetInstanceProcAddr", any(getProcAddr)},
        {"xrEnumerateInstanceExtensionProperties", any(enumerateExtensions)},
        {"xrCreateInstance", any(createInstance)},
        {"xrDestroyInstance", any(destroyInstance)},
        {"xrGetInstanceProperties", any(getInstanceProperties)},
        {"xrPollEvent", any(pollEvent)},
        {"xrGetSystem", any(getSystem)},
        {"xrEnumerateViewConfigurationViews", any(enumerateViews)},
        {"xrGetVulkanGraphicsRequirements2KHR", any(graphicsRequirements)},
        {"xrCreateVulkanInstanceKHR", any(createVulkanInstance)},
        {"xrGetVulkanGraphicsDevice2KHR", any(graphicsDevice)},
        {"xrCreateVulkanDeviceKHR", any(createVulkanDevice)},
        {"xrCreateSession", any(createSession)},
        {"xrDestroySession", any(destroySession)},
        {"xrBeginSession", any(beginSession)},
        {"xrEndSession", any(endSession)},
        {"xrRequestExitSession", any(requestExit)},
        {"xrCreateReferenceSpace", any(createReferenceSpace)},
        {"xrCreateActionSpace", any(createActionSpace)},
        {"xrLocateSpace", any(locateSpace)},
        {"xrStringToPath", any(stringToPath)},
        {"xrCreateActionSet", any(createActionSet)},
        {"xrCreateAction", any(createAction)},
        {"xrSuggestInteractionProfileBindings", any(suggestBindings)},
        {"xrAttachSessionActionSets", any(attachActionSets)},
        {"xrSyncActions", any(syncActions)},
        {"xrGetActionStateBoolean", any(getBoolean)},
        {"xrEnumerateSwapchainFormats", any(swapchainFormats)},
        {"xrCreateSwapchain", any(createSwapchain)},
        {"xrDestroySwapchain", any(destroySwapchain)},
        {"xrEnumerateSwapchainImages", any(swapchainImages)},
        {"xrAcquireSwapchainImage", any(acquireImage)},
        {"xrWaitSwapchainImage", any(waitImage)},
        {"xrReleaseSwapchainImage", any(releaseImage)},
        {"xrWaitFrame", any(waitFrame)},
        {"xrBeginFrame", any(beginFrame)},
        {"xrLocateViews", any(locateViews)},
        {"xrEndFrame", any(endFrame)},
    };
    return all;
}

XrResult XRAPI_CALL getProcAddr(XrInstance, const char* name, PFN_xrVoidFunction* function) {
    const auto found = calls().find(name);
    *function = found == calls().end() ? nullptr : found->second;
    return *function ? XR_SUCCESS : XR_ERROR_FUNCTION_UNSUPPORTED;
}

}  // namespace

Runtime& runtime() {
    static Runtime one;
    return one;
}

void Runtime::announce(XrSessionState state) {
    XrEventDataSessionStateChanged event{};
    event.type = XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED;
    event.session = toHandle<XrSession>(s().session);
    event.state = s().state = state;
    event.time = s().time;
    s().events.push_back(event);
}

void Runtime::loseSession() { s().lost = true; }

void Runtime::stop() {
    s().stopping = true;
    announce(XR_SESSION_STATE_VISIBLE);
    announce(XR_SESSION_STATE_SYNCHRONIZED);
    announce(XR_SESSION_STATE_STOPPING);
}

void Runtime::reset() { *this = {}; }

}  // namespace xr_runtime

/// The loader's way in.
extern "C" __attribute__((visibility("default"))) XrResult XRAPI_CALL
xrNegotiateLoaderRuntimeInterface(const XrNegotiateLoaderInfo* loader, XrNegotiateRuntimeRequest* request) {
    if (loader->minInterfaceVersion > XR_CURRENT_LOADER_RUNTIME_VERSION) return XR_ERROR_INITIALIZATION_FAILED;
    request->runtimeInterfaceVersion = XR_CURRENT_LOADER_RUNTIME_VERSION;
    request->runtimeApiVersion = XR_CURRENT_API_VERSION;
    request->getInstanceProcAddr = xr_runtime::getProcAddr;
    return XR_SUCCESS;
}
