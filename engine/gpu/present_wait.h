#pragma once
// Tells when a presented image is on display: VK_KHR_present_id and VK_KHR_present_wait, or their second versions,
// which a surface supports or not.

#include <cstdint>
#include <functional>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "engine/gpu/frame_pace.h"
#include "engine/gpu/present_wait_2.h"

namespace nacre::gpu {

class Device;

/// The version of the extensions that a device has.
enum class PresentWait : std::uint8_t { none, first, second };

/// @param surfaceQueries  whether the instance has VK_KHR_get_surface_capabilities2 @param validate  whether validation
/// is on
PresentWait queryPresentWait(const vk::raii::PhysicalDevice& device, bool surfaceQueries, bool validate);

/// Features of a device that has a version, for its creation.
class PresentWaitFeatures {
public:
    explicit PresentWaitFeatures(PresentWait version);
    /// Adds extensions and features; this must live until the device is made.
    void add(std::vector<const char*>& extensions, vk::DeviceCreateInfo& info);

private:
    PresentWait version_;
    VkPhysicalDevicePresentIdFeaturesKHR id_;  // of both versions, which have the same members
    VkPhysicalDevicePresentWaitFeaturesKHR wait_;
};

/// Numbers the presents of a window, and waits for their display before a frame starts.
class DisplayWait {
public:
    /// @param clock  seconds; empty: the system's
    DisplayWait(const Device& device, std::function<double()> clock);

    /// Asks whether the surface supports it.
    void setSurface(vk::SurfaceKHR surface);
    /// For the creation of a swapchain.
    vk::SwapchainCreateFlagsKHR swapchainFlags() const;
    /// Presents go to another swapchain from now on. Numbers go on.
    void replaced() { first_ = last_ = 0; }

    /// The number of a present. @param next  continues the chain
    struct Number {
        VkPresentIdKHR link{};
        std::uint64_t number = 0;
    };
    /// Fills in the next number. @returns the chain of the present: `next` where nothing is numbered
    const void* begin(Number& number, const void* next);
    /// The present was accepted.
    void accepted(const Number& number);

    /// A frame starts: waits until the present before the last is on display, if that leaves the rate as it is.
    /// @returns of the swapchain: success, suboptimal, out of date or surface lost; or device lost
    vk::Result beforeFrame(vk::SwapchainKHR swapchain);
    WindowPace pace() const;

private:
    VkResult await(vk::SwapchainKHR swapchain, std::uint64_t number, std::uint64_t nanoseconds) const;

    const Device& device_;
    std::function<double()> clock_;
    PFN_vkWaitForPresent2KHR wait2_ = nullptr;
    PresentWait version_ = PresentWait::none;  ///< that the surface supports
    std::uint64_t numbers_ = 0;                ///< given so far
    std::uint64_t first_ = 0, last_ = 0;       ///< of this swapchain; 0: none
    FramePace pace_;
};

}  // namespace nacre::gpu
