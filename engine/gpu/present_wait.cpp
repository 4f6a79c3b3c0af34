#include "engine/gpu/present_wait.h"

#include <chrono>

#include "engine/gpu/device.h"

namespace nacre::gpu {
namespace {

constexpr std::uint64_t kLongestWait = 100'000'000;  // nanoseconds: a hidden window shows nothing

double systemSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

PresentWait queryPresentWait(const vk::raii::PhysicalDevice& device, bool surfaceQueries, bool validate) {
    const auto supports = [&](const char* id, const char* wait, PresentWait version) {
        if (!hasExtension(device, id) || !hasExtension(device, wait)) return false;
        const bool second = version == PresentWait::second;
        VkPhysicalDevicePresentWaitFeaturesKHR waits{second
                                                         ? VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_WAIT_2_FEATURES_KHR
                                                         : VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_WAIT_FEATURES_KHR,
                                                     nullptr, false};
        VkPhysicalDevicePresentIdFeaturesKHR ids{second ? VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_ID_2_FEATURES_KHR
                                                        : VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_ID_FEATURES_KHR,
                                                 &waits, false};
        VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &ids, {}};
        device.getDispatcher()->vkGetPhysicalDeviceFeatures2(*device, &features);
        return ids.presentId && waits.presentWait;
    };
    if (surfaceQueries && (!validate || validationKnows(VK_MAKE_API_VERSION(0, 1, 4, 317))) &&
        supports(VK_KHR_PRESENT_ID_2_EXTENSION_NAME, VK_KHR_PRESENT_WAIT_2_EXTENSION_NAME, PresentWait::second))
        return PresentWait::second;
    return supports(VK_KHR_PRESENT_ID_EXTENSION_NAME, VK_KHR_PRESENT_WAIT_EXTENSION_NAME, PresentWait::first)
               ? PresentWait::first
               : PresentWait::none;
}

PresentWaitFeatures::PresentWaitFeatures(PresentWait version)
    : version_(version),
      id_{version == PresentWait::second ? VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_ID_2_FEATURES_KHR
                                         : VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_ID_FEATURES_KHR,
          &wait_, true},
      wait_{version == PresentWait::second ? VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_WAIT_2_FEATURES_KHR
                                           : VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_WAIT_FEATURES_KHR,
            nullptr, true} {}

void PresentWaitFeatures::add(std::vector<const char*>& extensions, vk::DeviceCreateInfo& info) {
    if (version_ == PresentWait::none) return;
    const bool second = version_ == PresentWait::second;
    extensions.push_back(second ? VK_KHR_PRESENT_ID_2_EXTENSION_NAME : VK_KHR_PRESENT_ID_EXTENSION_NAME);
    extensions.push_back(second ? VK_KHR_PRESENT_WAIT_2_EXTENSION_NAME : VK_KHR_PRESENT_WAIT_EXTENSION_NAME);
    wait_.pNext = const_cast<void*>(info.pNext);
    info.pNext = &id_;
}

DisplayWait::DisplayWait(const Device& device, std::function<double()> clock)
    : device_(device), clock_(clock ? std::move(clock) : systemSeconds) {
    if (device.presentWait() == PresentWait::second)
        wait2_ = reinterpret_cast<PFN_vkWaitForPresent2KHR>(device->getProcAddr("vkWaitForPresent2KHR"));
}

void DisplayWait::setSurface(vk::SurfaceKHR surface) {
    version_ = device_.presentWait();
    if (version_ != PresentWait::second) return;
    VkSurfaceCapabilitiesPresentWait2KHR waits{VK_STRUCTURE_TYPE_SURFACE_CAPABILITIES_PRESENT_WAIT_2_KHR, nullptr,
                                               false};
    VkSurfaceCapabilitiesPresentId2KHR ids{VK_STRUCTURE_TYPE_SURFACE_CAPABILITIES_PRESENT_ID_2_KHR, &waits, false};
    const VkPhysicalDeviceSurfaceInfo2KHR asked{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SURFACE_INFO_2_KHR, nullptr,
                                                static_cast<VkSurfaceKHR>(surface)};
    VkSurfaceCapabilities2KHR caps{VK_STRUCTURE_TYPE_SURFACE_CAPABILITIES_2_KHR, &ids, {}};
    const vk::raii::PhysicalDevice& physical = device_.physical();
    const VkResult result =
        physical.getDispatcher()->vkGetPhysicalDeviceSurfaceCapabilities2KHR(*physical, &asked, &caps);
    if (result != VK_SUCCESS || !wait2_ || !ids.presentId2Supported || !waits.presentWait2Supported)
        version_ = PresentWait::none;
}

vk::SwapchainCreateFlagsKHR DisplayWait::swapchainFlags() const {
    if (version_ != PresentWait::second) return {};
    return vk::SwapchainCreateFlagsKHR(VK_SWAPCHAIN_CREATE_PRESENT_ID_2_BIT_KHR |
                                       VK_SWAPCHAIN_CREATE_PRESENT_WAIT_2_BIT_KHR);
}

const void* DisplayWait::begin(Number& number, const void* next) {
    if (version_ == PresentWait::none) return next;
    number.number = ++numbers_;
    number.link = {
        version_ == PresentWait::second ? VK_STRUCTURE_TYPE_PRESENT_ID_2_KHR : VK_STRUCTURE_TYPE_PRESENT_ID_KHR, next,
        1, &number.number};
    return &number.link;
}

void DisplayWait::accepted(const Number& number) {
    if (number.number == 0) return;
    last_ = number.number;
    if (first_ == 0) first_ = last_;
}

VkResult DisplayWait::await(vk::SwapchainKHR swapchain, std::uint64_t number, std::uint64_t nanoseconds) const {
    if (version_ == PresentWait::first)
        return device_->getDispatcher()->vkWaitForPresentKHR(**device_, static_cast<VkSwapchainKHR>(swapchain), number,
                                                             nanoseconds);
    const VkPresentWait2InfoKHR info{VK_STRUCTURE_TYPE_PRESENT_WAIT_2_INFO_KHR, nullptr, number, nanoseconds};
    return wait2_(**device_, static_cast<VkSwapchainKHR>(swapchain), &info);
}

vk::Result DisplayWait::beforeFrame(vk::SwapchainKHR swapchain) {
    if (last_ == 0) return vk::Result::eSuccess;
    VkResult result = VK_SUCCESS;
    bool queued = false;
    if (pace_.state() != WindowPace::State::resting) {
        result = await(swapchain, last_, 0);
        queued = result == VK_TIMEOUT;
        if (queued && pace_.waits() && last_ > first_) {
            result = await(swapchain, last_ - 1, kLongestWait);
            if (result == VK_TIMEOUT) pace_.timedOut();
        }
    }
    if (result == VK_TIMEOUT) result = VK_SUCCESS;
    pace_.start(clock_(), queued);
    return static_cast<vk::Result>(result);
}

WindowPace DisplayWait::pace() const {
    if (version_ == PresentWait::none) return {};
    return {pace_.state(), 1000 * pace_.secondsToDisplay()};
}

}  // namespace nacre::gpu
