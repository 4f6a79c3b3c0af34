#pragma once
// A headset through OpenXR: its session, poses, hands and swapchain images.

#include <array>
#include <optional>
#include <vector>

#include "app/xr/calls.h"
#include "app/xr/eyes.h"
#include "engine/device_options.h"
#include "engine/settings.h"

namespace nacre::app {

/// A tracked hand and its trigger.
struct Hand {
    Pose pose;
    bool holds = false;  ///< trigger
};

class Headset {
public:
    /// @throws Error without loader, runtime, XR_KHR_vulkan_enable2 or headset
    Headset();
    ~Headset();
    Headset(const Headset&) = delete;

    /// For the renderer's device. The device must live from before begin() until after end().
    HeadsetSource source();
    /// Starts a session with the last device that source() created. @throws Error
    void begin();
    /// Ends the session, if there is one. Call before the device is destroyed.
    void end() noexcept;

    /// Handles the runtime's events. @throws Error
    void handleEvents();
    /// Whether the runtime wants frames.
    bool running() const { return running_; }
    /// Whether the user or the runtime ended the session.
    bool over() const { return over_; }
    /// Whether the session is lost or about to be. Call end(); the next session may succeed.
    bool lost() const { return lost_; }
    /// Requests the end of the session.
    void leave();

    /// A frame of the display.
    struct Frame {
        XrTime time = 0;  ///< time of display
        bool shows = false;
    };
    /// Waits until the next frame can start, and starts it.
    Frame beginFrame();
    /// Left and right eye at a frame's time; none while the head is not tracked.
    std::optional<std::array<EyePose, 2>> eyes(const Frame& frame);
    /// The hand that holds; of two, the one that held before. If none holds, any tracked hand.
    std::optional<Hand> hand(const Frame& frame);
    /// Whether the last call of hand() found the menu button newly pressed.
    bool menu() const { return menu_; }
    /// Acquires the next image. Draw into it until give().
    HeadsetImage take();
    void give();
    /// @param shown  the eyes drawn in the last image; none: nothing is shown
    void endFrame(const Frame& frame, const std::optional<std::array<EyePose, 2>>& shown);

    std::uint32_t width() const { return width_; }
    std::uint32_t height() const { return height_; }

private:
    void findSystem();
    void makeActions();
    void makeSwapchain();
    void makeSpaces();
    XrPath path(const char* text) const;
    bool pressed(XrAction action, XrPath hand) const;

    XrInstance instance_ = XR_NULL_HANDLE;
    XrCalls xr_;
    XrSystemId system_ = XR_NULL_SYSTEM_ID;
    XrGraphicsBindingVulkan2KHR binding_{};
    XrActionSet actions_ = XR_NULL_HANDLE;
    XrAction grip_ = XR_NULL_HANDLE, hold_ = XR_NULL_HANDLE, menuAction_ = XR_NULL_HANDLE;
    std::array<XrPath, 2> hands_{};
    // Of a session:
    XrSession session_ = XR_NULL_HANDLE;
    XrSpace room_ = XR_NULL_HANDLE;
    std::array<XrSpace, 2> grips_{};
    XrSwapchain swapchain_ = XR_NULL_HANDLE;
    std::vector<XrSwapchainImageVulkan2KHR> images_;
    int format_ = 0;
    std::uint32_t width_ = 0, height_ = 0;
    bool running_ = false, focused_ = false, over_ = false, lost_ = false, menu_ = false;
    std::size_t holding_ = 0;  // the hand that held last
};

}  // namespace nacre::app
